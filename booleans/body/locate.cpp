#include "booleans/body/locate.h"

#include <algorithm>

#include "exact/predicates.h"

namespace quoin::booleans {
namespace {

using exact::Rational;
using RationalPoint = std::array<Rational, 3>;

RationalPoint rational(const exact::Point& p) {
  return {exact::coordinate(p, 0), exact::coordinate(p, 1), exact::coordinate(p, 2)};
}

Rational value(const exact::Plane& plane, const RationalPoint& p) {
  ++exact::counters().rational;
  Rational r = exact::to_integer(plane.d);
  for (std::size_t k = 0; k < 3; ++k) r += plane.n[k] * p[k];
  return r;
}

/// Does the projection of the face along axis k cover the point, shifted by (-eps, -eps^2) in the two other axes (u,
/// v)? `on_edge` tells whether the point lies on the projection of an edge.
bool covers(const Body& body, std::uint32_t face, const RationalPoint& p, std::size_t k, bool& on_edge) {
  const std::size_t u = (k + 1) % 3, v = (k + 2) % 3;
  bool odd = false;
  on_edge = false;
  body.for_edges(face, [&](std::uint32_t i, std::uint32_t j) {
    const RationalPoint a = rational(body.point(i)), b = rational(body.point(j));
    const Rational turn = (b[u] - a[u]) * (p[v] - a[v]) - (b[v] - a[v]) * (p[u] - a[u]);
    if (turn == 0 && p[u] >= std::min(a[u], b[u]) && p[u] <= std::max(a[u], b[u]) && p[v] >= std::min(a[v], b[v]) &&
        p[v] <= std::max(a[v], b[v]))
      on_edge = true;

    if ((a[v] >= p[v]) == (b[v] >= p[v])) return;
    // The edge's u at height p_v is at least p_u: left of an upward edge, right of a downward one, or on it.
    if (b[v] > a[v] ? turn >= 0 : turn <= 0) odd = !odd;
  });
  return odd;
}

bool in_range(const Rational& x, std::int32_t low, std::int32_t high) { return x >= low && x <= high; }

}  // namespace

int locate(const Body& body, const RationalPoint& point) {
  if (!body.is_packed) return locate(packed(body), point);

  int winding = body.full_at_infinity ? 1 : 0;
  for (std::uint32_t f = 0; f < body.face_count(); ++f) {
    const Box box = face_box(body, f);
    if (!in_range(point[1], box.low[1], box.high[1]) || !in_range(point[2], box.low[2], box.high[2]) ||
        point[0] < box.low[0])
      continue;

    const exact::Plane plane = body.plane(f);
    const Rational at = value(plane, point);
    bool on_edge = false;
    if (at == 0) {
      if (covers(body, f, point, exact::longest_component(plane.n), on_edge) || on_edge) return 0;
      continue;
    }

    // The face lies towards -x of the point when its plane's value and its normal's x have one sign.
    const std::int64_t nx = plane.n[0];
    if (nx == 0 || (at > 0) != (nx > 0) || !covers(body, f, point, 0, on_edge)) continue;
    winding += nx < 0 ? 1 : -1;  // coming from -x: entering through a face that looks towards -x
  }
  return winding > 0 ? 1 : -1;
}

std::optional<Box> bounds(const Body& body) {
  if (body.face_count() == 0) return std::nullopt;
  Box box;
  body.for_runs([&](std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t f = begin; f < end; ++f)
      body.for_corners(f, [&](std::uint32_t v) { box.add(body.approximation(v)); });
  });
  return box;
}

}  // namespace quoin::booleans
