/// \file
/// Whether primitives are closed, planar, outward and maximal, and outlines to make them from.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "rounding/shapes/circle.h"
#include "rounding/shapes/polyhedron.h"
#include "rounding/shapes/trihedral.h"
#include "tests/rounding/support.h"

namespace quoin::rounding::testing {

using Loop = Outline;
using Polygons = std::vector<Region>;
using Edge = std::pair<std::uint32_t, std::uint32_t>;

inline Rational half() { return Rational(1, 2); }
inline std::size_t loop_count(const Polyhedron& p) { return p.faces.loop_start.size() - 1; }

/// The first thing that is wrong with a boundary; nothing when it is closed, planar, oriented and its faces maximal.
inline std::string fault(const Polyhedron& p) {
  if (std::set(p.points.begin(), p.points.end()).size() != p.points.size()) return "a point is there twice";
  if (p.faces.face_start.size() != p.planes.size() + 1 || p.faces.face_start.back() != loop_count(p) ||
      p.faces.loop_start.back() != p.faces.corners.size())
    return "lists do not fit";

  std::map<Edge, std::uint32_t> faces;
  std::vector<bool> used(p.points.size());
  for (std::uint32_t f = 0; f < p.face_count(); ++f) {
    const std::string face = "face " + std::to_string(f);
    const WidePlane& plane = p.planes[f];
    if (plane != wide_plane({plane.n[0], plane.n[1], plane.n[2]}, plane.d)) return face + ": not in lowest terms";

    Vector area{0, 0, 0};
    bool on = true, single = true;
    p.faces.for_edges(f, [&](std::uint32_t u, std::uint32_t v) {
      on = on && value(plane, p.points[u]) == 0;
      single = single && u != v && faces.try_emplace({u, v}, f).second;
      area = area + cross(p.points[u], p.points[v]);
      used[u] = true;
    });
    if (!on) return face + ": a corner off its plane";
    if (!single) return face + ": an edge is there twice";
    const Vector n{plane.n[0], plane.n[1], plane.n[2]};
    if (cross(area, n) != Vector{0, 0, 0} || dot(area, n) <= 0) return face + ": turned round";
    if (p.faces.face_start[f] == p.faces.face_start[f + 1]) return face + ": no loop";

    for (std::uint32_t j = p.faces.face_start[f]; j < p.faces.face_start[f + 1]; ++j) {
      const auto l = p.faces.loop(j);
      if (l.size() < 3) return face + ": a loop of two";
      Vector part{0, 0, 0};
      for (std::size_t i = 0; i < l.size(); ++i) {
        const Vector &a = p.points[l[i]], &b = p.points[l[(i + 1) % l.size()]], &c = p.points[l[(i + 2) % l.size()]];
        part = part + cross(a, b);
        if (cross(b - a, c - b) == Vector{0, 0, 0}) return face + ": a straight corner";
      }
      if ((dot(part, n) > 0) != (j == p.faces.face_start[f])) return face + ": a loop turned round";
    }
  }

  for (const auto& [edge, f] : faces) {
    const auto other = faces.find({edge.second, edge.first});
    if (other == faces.end()) return "an open edge";
    if (p.planes[other->second] == p.planes[f]) return "two neighbours on one plane";
  }

  if (std::find(used.begin(), used.end(), false) != used.end()) return "a point on no face";
  if (volume(p) <= 0) return "inside out";
  return "";
}

/// Vertices - edges + faces - loops beyond the first: 2 for a ball.
inline long euler(const Polyhedron& p) {
  return static_cast<long>(p.points.size()) - static_cast<long>(p.faces.corners.size() / 2) +
         2 * static_cast<long>(p.face_count()) - static_cast<long>(loop_count(p));
}

inline Polyhedron made(const Result<Polyhedron>& r) {
  EXPECT_TRUE(r.has_value()) << r.error().message;
  return r ? r.value() : Polyhedron{};
}
/// A sound primitive.
inline Polyhedron sound(const Result<Polyhedron>& r, long characteristic = 2) {
  const Polyhedron p = made(r);
  EXPECT_EQ(fault(p), "");
  EXPECT_EQ(euler(p), characteristic);
  return p;
}
template <class T>
inline void expect_refusal(const Result<T>& r) {
  ASSERT_FALSE(r.has_value());
  EXPECT_EQ(r.error().code, ErrorCode::bad_primitive);
  EXPECT_GT(r.error().message.size(), 10u);
}

inline Rational positive(std::mt19937_64& random) { return magnitude(random_rational(random, 40)) + Rational(1, 1000); }

inline Loop reversed(Loop l) {
  std::reverse(l.begin(), l.end());
  return l;
}
inline Loop square(const Rational& x, const Rational& y, const Rational& size) {
  return {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
}
/// A star-shaped polygon about (x, y), of radius at most `radius`.
inline Loop star(std::mt19937_64& random, const Rational& x, const Rational& y, const Rational& radius) {
  Loop l;
  const auto n = 3 + below(random, 9);
  for (std::uint64_t i = 0; i < n; ++i) {
    const PlanePoint p = circle_point(Rational(360 * i, n) + Rational(below(random, 20), 10), 1 << 6);
    const Rational r = radius * (1 + Rational(below(random, 100))) / 100;
    l.push_back({x + p[0] * r, y + p[1] * r});
  }
  return l;
}

}  // namespace quoin::rounding::testing
