#include "rounding/shapes/trihedral.h"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <utility>
#include <vector>

#include "rounding/shapes/hull.h"
#include "tests/rounding/shapes/solids.h"

namespace quoin::rounding::testing {
namespace {

void expect_consistent(const Polyhedron& p) {
  const auto t = trihedral(p);
  ASSERT_TRUE(t.has_value());
  ASSERT_EQ(t->faces.size(), p.points.size());
  ASSERT_EQ(t->sign.size(), p.points.size());
  for (std::size_t v = 0; v < p.points.size(); ++v) {
    const auto& [f, g, h] = t->faces[v];
    ASSERT_TRUE(f < g && g < h);
    for (const std::uint32_t face : t->faces[v]) {
      ASSERT_EQ(value(p.planes[face], p.points[v]), 0);
      bool listed = false;
      p.faces.for_edges(face, [&](std::uint32_t u, std::uint32_t) { listed = listed || u == v; });
      ASSERT_TRUE(listed);
    }
    const Rational d = determinant({normal(p.planes[f]), normal(p.planes[g]), normal(p.planes[h])});
    ASSERT_EQ(t->sign[v], sign_of(d));
    ASSERT_NE(t->sign[v], 0);
  }
  // Every directed edge once, with a plane through its end alone.
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges, ordered;
  for (std::uint32_t f = 0; f < p.face_count(); ++f)
    p.faces.for_edges(f, [&](std::uint32_t u, std::uint32_t v) { edges.insert({u, v}); });
  for (const auto& o : t->orders) {
    ASSERT_TRUE(ordered.insert({o.from, o.to}).second);
    ASSERT_EQ(value(p.planes[o.face], p.points[o.to]), 0);
    ASSERT_EQ(sign_of(value(p.planes[o.face], p.points[o.from])), o.side);
    ASSERT_NE(o.side, 0);
  }
  EXPECT_EQ(ordered, edges);
}

TEST(TrihedralTest, TrihedralOnes) {
  expect_consistent(cube());
  expect_consistent(made(wedge({3, 2, 1}, 5)));
  for (const std::uint32_t sides : {3u, 8u}) expect_consistent(made(frustum(sides, 2, 1, 3, Fit::inscribed)));
  expect_consistent(made(frustum(3, 2, 0, 3, Fit::inscribed)));
  // Not convex, with a hole, in parts.
  expect_consistent(made(extrusion(
      {{{{0, 0}, {9, 0}, {9, 9}, {4, 3}}, {{4, 1}, {5, 1}, {5, 2}}}, {{{20, 0}, {21, 0}, {20, 5}}}}, {1, 2, 3})));
  // A cavity, two parts, a dent.
  for (const std::size_t i : {1u, 3u, 4u, 5u, 6u}) expect_consistent(polyhedron_of(booleans::canonical(bodies()[i])));
}

TEST(TrihedralTest, OnesThatAreNot) {
  const Polyhedron pyramid = made(frustum(4, 2, 0, 3, Fit::inscribed));
  EXPECT_FALSE(trihedral(pyramid).has_value());
  EXPECT_FALSE(trihedral(made(sphere(1, 4))).has_value());
  EXPECT_FALSE(trihedral(made(torus(2, 1, 3, 3))).has_value());
  // An edge of four faces, also as canonical forms have it.
  Polyhedron p = cube();
  append(p, shifted(cube(), {1, 1, 0}));
  EXPECT_EQ(p.points.size(), 14u);
  EXPECT_FALSE(trihedral(p).has_value());
  EXPECT_FALSE(trihedral(polyhedron_of(booleans::canonical(bodies()[7]))).has_value());
  // A touching edge or vertex inside a face.
  EXPECT_FALSE(trihedral(polyhedron_of(booleans::canonical(bodies()[9]))).has_value());
  EXPECT_FALSE(trihedral(polyhedron_of(booleans::canonical(bodies()[10]))).has_value());
  // A vertex of two parts with six planes.
  p = cube();
  append(p, made(convex_hull(std::vector<Vector>{{1, 1, 1}, {5, 2, 2}, {2, 6, 2}, {3, 2, 7}})));
  EXPECT_EQ(p.points.size(), 11u);
  EXPECT_FALSE(trihedral(p).has_value());
  // An open boundary, and a point on no face.
  p = cube();
  p.planes.pop_back();
  p.faces.face_start.pop_back();
  p.faces.loop_start.pop_back();
  p.faces.corners.resize(p.faces.loop_start.back());
  EXPECT_FALSE(trihedral(p).has_value());
  p = cube();
  p.add_point({5, 5, 5});
  EXPECT_FALSE(trihedral(p).has_value());
}

// Two cubes that touch in a vertex have the same three planes there: their planes still determine them.
TEST(TrihedralTest, CubesThatTouchInAVertex) {
  Polyhedron p = cube();
  append(p, shifted(cube(), {1, 1, 1}));
  EXPECT_EQ(p.points.size(), 15u);
  const auto t = trihedral(p);
  ASSERT_TRUE(t.has_value());
  EXPECT_EQ(t->orders.size(), 48u);
  EXPECT_TRUE(trihedral(polyhedron_of(booleans::canonical(bodies()[8]))).has_value());
}

}  // namespace
}  // namespace quoin::rounding::testing
