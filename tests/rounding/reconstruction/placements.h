/// \file
/// Shapes under random motions, and what their reconstruction must be.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "booleans/body/fault.h"
#include "booleans/body/measure.h"
#include "booleans/boolean.h"
#include "booleans/embedding.h"
#include "rounding/motions/realize.h"
#include "rounding/reconstruction/reconstruct.h"
#include "rounding/shapes/hull.h"
#include "rounding/shapes/primitives.h"
#include "tests/rounding/support.h"

namespace quoin::rounding::testing {

using booleans::Body;
using booleans::Canonical;

inline Shape shape(const Result<Polyhedron>& r) {
  EXPECT_TRUE(r.has_value()) << r.error().message;
  return Shape(r ? r.value() : Polyhedron{});
}
inline Placement placed(const Shape& s, const AffineMap& to_grid = {}) { return {&s, {}, to_grid}; }
inline AffineMap scaled(const AffineMap& map, const Rational& factor) {
  return composed(map, {{Vector{factor, 0, 0}, Vector{0, factor, 0}, Vector{0, 0, factor}}, {0, 0, 0}});
}
inline AffineMap shift(const Vector& by) { return {AffineMap{}.linear, by}; }
/// Some rotation by long numbers, and a shift.
inline AffineMap random_motion(std::mt19937_64& random) {
  return {matrix(quaternion(Integer(random() >> 32) + 1, Integer(random() >> 32), Integer(random() >> 32),
                            -Integer(random() >> 32))),
          {Rational(between(random, -1'000'000, 1'000'000), 997), Rational(between(random, -1'000'000, 1'000'000), 991),
           between(random, -1'000'000, 1'000'000)}};
}
inline Reconstruction made(const std::vector<Placement>& placements, const ReconstructionOptions& options = {}) {
  auto r = reconstruct(placements, options);
  EXPECT_TRUE(r.has_value()) << r.error().code << ' ' << r.error().message << ' ' << r.error().where;
  if (!r) return Reconstruction{std::vector<Reconstructed>(placements.size())};
  EXPECT_EQ(r.value().primitives.size(), placements.size());
  return std::move(r).value();
}
inline Reconstructed made(const Placement& placement, const ReconstructionOptions& options = {}) {
  return made(std::vector{placement}, options).primitives[0];
}

/// Clean by the proofs of booleans/; faces on one plane are joined before the second.
inline void expect_clean(const Body& body) {
  EXPECT_EQ(booleans::fault(body), std::nullopt);
  const Body joined = booleans::body_of(booleans::canonical(body));
  EXPECT_EQ(booleans::fault(joined), std::nullopt);
  EXPECT_EQ(booleans::embedding_fault(joined), std::nullopt);
  EXPECT_EQ(booleans::volume(joined), booleans::volume(body));
}

inline Vector vertex(const exact::Point& p) {
  return {exact::coordinate(p, 0), exact::coordinate(p, 1), exact::coordinate(p, 2)};
}
inline WidePlane wide(const exact::Plane& p) { return {{p.n[0], p.n[1], p.n[2]}, exact::to_integer(p.d)}; }
inline std::vector<Vector> carried(const Placement& placement) {
  std::vector<Vector> points;
  for (const Vector& p : placement.shape->polyhedron.points) points.push_back(placement.to_grid(p));
  return points;
}
/// The largest squared distance of a carried point to the nearest vertex, for shapes much larger than it.
inline Rational squared_movement(const Placement& placement, const Canonical& form) {
  std::vector<Vector> vertices;
  for (const exact::Point& v : form.vertices) vertices.push_back(vertex(v));

  Rational most = 0;
  for (const Vector& p : carried(placement)) {
    // Those near in doubles.
    std::vector<double> distance;
    for (const Vector& v : vertices) distance.push_back(exact::to_double(dot(v - p, v - p)));
    const double least = *std::min_element(distance.begin(), distance.end());

    Rational nearest = -1;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      if (distance[i] > least * 1.001 + 1e-300) continue;
      const Rational d = dot(vertices[i] - p, vertices[i] - p);
      if (nearest < 0 || d < nearest) nearest = d;
    }
    most = std::max(most, nearest);
  }
  return most;
}

/// Second way: the conditions of a simple convex polyhedron. How many pairs of a plane and a vertex not of its face are
/// there, and how many of these vertices are strictly below?
struct Conditions {
  std::size_t all = 0, hold = 0;
};
inline Conditions conditions(const Canonical& form) {
  Conditions c;
  for (std::uint32_t f = 0; f < form.face_count(); ++f) {
    const WidePlane plane = wide(form.planes[f]);
    const auto begin = form.faces.corners.begin() + form.faces.loop_start[form.faces.face_start[f]];
    const auto end = form.faces.corners.begin() + form.faces.loop_start[form.faces.face_start[f + 1]];

    for (std::uint32_t v = 0; v < form.vertices.size(); ++v) {
      if (std::find(begin, end, v) != end) {
        EXPECT_EQ(value(plane, vertex(form.vertices[v])), 0);
        continue;
      }
      ++c.all;
      c.hold += value(plane, vertex(form.vertices[v])) < 0 ? 1 : 0;
    }
  }
  return c;
}

/// Third way, from planes alone: those of a block in the order of opposite pairs. C1 and the 24 conditions.
inline bool is_block(const std::array<WidePlane, 6>& planes, const std::array<WidePlane, 6>& before) {
  const auto row = [](const WidePlane& p) { return Vector{p.n[0], p.n[1], p.n[2]}; };
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t corner = 0; corner < 4; ++corner) {
      const std::array<std::size_t, 3> at{i ^ 1, (i / 2 + 1) % 3 * 2 + corner % 2, (i / 2 + 2) % 3 * 2 + corner / 2};
      const auto rows = [&](const auto& p) { return Matrix{row(p[at[0]]), row(p[at[1]]), row(p[at[2]])}; };
      const Matrix m = rows(planes);
      if (sign_of(determinant(m)) != sign_of(determinant(rows(before))) || determinant(m) == 0) return false;
      if (value(planes[i], inverse({m, {0, 0, 0}})({-planes[at[0]].d, -planes[at[1]].d, -planes[at[2]].d})) >= 0)
        return false;
    }
  return true;
}

inline std::vector<Shape> convex_ones(const Rational& size) {
  std::vector<Shape> all;
  all.push_back(shape(convex_hull(std::vector<Vector>{{0, 0, 0}, {size, 0, 0}, {0, size, 0}, {1, 2, size}})));
  all.push_back(shape(frustum(3, size, size, size, Fit::inscribed)));
  all.push_back(shape(wedge({size, size, size / 3}, size / 5)));
  all.push_back(shape(block({size, size / 2, size / 3})));
  all.push_back(shape(frustum(8, size, size, size, Fit::circumscribed)));
  all.push_back(shape(frustum(8, size, size / 3, size, Fit::equal_area)));
  all.push_back(shape(frustum(17, size / 2, size, size / 7, Fit::inscribed)));
  return all;
}

}  // namespace quoin::rounding::testing
