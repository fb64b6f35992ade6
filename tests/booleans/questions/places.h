// Places that are hard to ask about, and second ways to answer.
#pragma once

#include <optional>

#include "booleans/body/canonical.h"
#include "booleans/body/locate.h"
#include "tests/booleans/support.h"

namespace quoin::booleans::testing {

using exact::Rational;
using RationalPlace = std::array<Rational, 3>;

inline RationalPlace place_of(const Body& body, std::uint32_t v) {
  const exact::Point p = body.point(v);
  return {exact::coordinate(p, 0), exact::coordinate(p, 1), exact::coordinate(p, 2)};
}

/// Points on corners, edges and faces as often as elsewhere.
inline RationalPlace any_place(Random& random, const Body& body) {
  RationalPlace p{0, 0, 0};
  std::int64_t weight = 0;
  const auto f = static_cast<std::uint32_t>(random.below(body.face_count()));
  RationalPlace last = p;
  body.for_corners(f, [&](std::uint32_t v) {
    last = place_of(body, v);
    const auto w = static_cast<std::int64_t>(random.below(3));
    for (std::size_t k = 0; k < 3; ++k) p[k] += w * last[k];
    weight += w;
  });
  for (std::size_t k = 0; k < 3; ++k) p[k] = weight == 0 ? Rational(last[k] + random.between(-2, 2)) : p[k] / weight;
  if (random.one_in(3)) p[random.below(3)] += Rational(random.between(-3, 3)) / 2;
  return p;
}

inline Rational value_at(const exact::Plane& plane, const RationalPlace& p) {
  Rational r = exact::to_integer(plane.d);
  for (std::size_t k = 0; k < 3; ++k) r += plane.n[k] * p[k];
  return r;
}
inline Rational slope_along(const exact::Plane& plane, const RationalPlace& d) {
  return plane.n[0] * d[0] + plane.n[1] * d[1] + plane.n[2] * d[2];
}
inline RationalPlace point_along(const RationalPlace& p, const RationalPlace& d, const Rational& t) {
  return {Rational(p[0] + t * d[0]), Rational(p[1] + t * d[1]), Rational(p[2] + t * d[2])};
}

/// Does a closed face of a canonical form hold a point? By turns about its projected edges.
inline bool face_holds(const Boundary& form, std::size_t face, const RationalPlace& p) {
  if (value_at(form.planes[face], p) != 0) return false;
  const std::size_t k = exact::longest_component(form.planes[face].n), i = (k + 1) % 3, j = (k + 2) % 3;
  const auto at = [&](std::uint32_t v, std::size_t axis) {
    return exact::coordinate(form.vertices[v], static_cast<int>(axis));
  };
  for (const std::uint32_t v : form.faces.corners_of(face))
    if (at(v, i) == p[i] && at(v, j) == p[j]) return true;
  int turns = 0;
  bool on_edge = false;
  form.faces.for_edges(face, [&](std::uint32_t u, std::uint32_t v) {
    const Rational ui = at(u, i) - p[i], uj = at(u, j) - p[j], vi = at(v, i) - p[i], vj = at(v, j) - p[j];
    const Rational cross = ui * vj - vi * uj;
    if (cross == 0 && ui * vi <= 0 && uj * vj <= 0) on_edge = true;
    if (uj <= 0 && vj > 0 && cross > 0) ++turns;
    if (uj > 0 && vj <= 0 && cross < 0) --turns;
  });
  return on_edge || turns != 0;
}

}  // namespace quoin::booleans::testing
