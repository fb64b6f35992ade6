#include "rounding/reconstruction/vertex_rounding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/rounding/reconstruction/placements.h"

namespace quoin::rounding::testing {
namespace {

/// sqrt(3) / 2, with what an upper bound by doubles may add.
bool is_a_rounding(const Rational& displacement) {
  return displacement >= 0 && displacement * displacement <= Rational(3, 4) * (1 + Rational(1, power_of_2(16)));
}

TEST(VertexRoundingTest, VertexByVertex) {
  std::mt19937_64 random = generator(650);
  std::vector<Shape> shapes;
  shapes.push_back(shape(frustum(12, 500, 0, 400, Fit::inscribed)));
  shapes.push_back(shape(frustum(12, 500, 0, 400, Fit::circumscribed)));
  shapes.push_back(shape(sphere(600, 12)));
  shapes.push_back(shape(torus(500, 200, 12, 7)));
  shapes.push_back(shape(block({300, 200, 100})));
  shapes.push_back(
      shape(extrusion({{{{0, 0}, {90, 0}, {90, 90}, {0, 90}}, {{30, 30}, {60, 30}, {45, 70}}}}, {9, 9, 99})));
  for (const Shape& s : shapes)
    for (int i = 0; i < 4; ++i) {
      const Placement placement = placed(s, random_motion(random));
      const Reconstructed r = made(placement, {Method::best, s.trihedral.has_value()});
      EXPECT_FALSE(r.by_planes);
      EXPECT_TRUE(is_a_rounding(r.displacement));
      // Vertices are the nearest grid points.
      std::set<Vector> rounded;
      Rational most = 0;
      for (const Vector& p : carried(placement)) {
        Vector q;
        for (std::size_t k = 0; k < 3; ++k) q[k] = nearest_integer(p[k]);
        most = std::max(most, dot(q - p, q - p));
        rounded.insert(q);
      }
      EXPECT_GE(r.displacement * r.displacement, most);
      EXPECT_LE(r.displacement * r.displacement, most * (1 + Rational(1, power_of_2(20))));
      // Features are large here: nothing is merged and nothing crosses.
      EXPECT_EQ(r.merged_points, 0u);
      EXPECT_EQ(r.zero_area_triangles, 0u);
      EXPECT_EQ(r.resolved_crossings, 0u);
      std::set<Vector> vertices;
      for (const exact::Point& v : booleans::canonical(r.body).vertices) vertices.insert(vertex(v));
      EXPECT_TRUE(std::includes(rounded.begin(), rounded.end(), vertices.begin(), vertices.end()));
      expect_clean(r.body);
    }
}

// What doubles cannot tell: images halfway between grid points, or next to halfway, and images on grid points.
TEST(VertexRoundingTest, TiesAndExactImagesVertexByVertex) {
  const Shape s = shape(block({1 << 20, 30, 20}));
  const Rational hair(1, power_of_2(90));
  for (const Rational& half : {Rational(1, 2), Rational(1, 2) + hair, Rational(1, 2) - hair}) {
    const Placement placement = placed(s, shift({half, 1 + half, -half}));
    const Reconstructed r = made(placement, {Method::best, true});
    std::set<Vector> expected, vertices;
    for (const Vector& p : carried(placement))
      expected.insert({nearest_integer(p[0]), nearest_integer(p[1]), nearest_integer(p[2])});
    for (const exact::Point& v : booleans::canonical(r.body).vertices) vertices.insert(vertex(v));
    EXPECT_EQ(vertices, expected);
    EXPECT_TRUE(is_a_rounding(r.displacement));
  }
  // By 3, 4, 5: rows that are no integers, images that are.
  const Shape fives = shape(block({500, 1000, 25}));
  const AffineMap turn{matrix(quaternion(2, 0, 0, 1)), {0, 0, 0}};
  ASSERT_NE(denominator(turn.linear[0][0]), 1);
  EXPECT_EQ(made(placed(fives, turn), {Method::best, true}).displacement, 0);
  EXPECT_EQ(made(placed(fives, shift({7, -8, 9})), {Method::best, true}).displacement, 0);
  EXPECT_GT(made(placed(fives, shift({7, hair, 9})), {Method::best, true}).displacement, 0);
}

// 73.5 / 49 is halfway between grid points; by doubles it is less than that: 73.5 (1 / 49) = 1.4999999999999998.
TEST(VertexRoundingTest, TiesThatDoublesMiss) {
  const Rational size(147, 2);
  const Shape s = shape(block({size, size, size}));
  const Reconstructed r = made(placed(s, scaled({}, Rational(1, 49))), {Method::best, true});
  EXPECT_EQ(booleans::volume(r.body), 8);
  EXPECT_TRUE(is_a_rounding(r.displacement));
}

// A movement whose square is no double: the other corners go nowhere.
TEST(VertexRoundingTest, ACornerNextToTheOrigin) {
  const Rational hair = Rational(Integer(1), Integer(pow(Integer(10), 200u)));
  const Shape s = shape(convex_hull(std::vector<Vector>{{hair, hair, hair}, {10, 0, 0}, {0, 10, 0}, {0, 0, 10}}));
  const Reconstructed r = made(placed(s), {Method::best, true});
  EXPECT_EQ(booleans::volume(r.body), Rational(1000, 6));
  EXPECT_GE(r.displacement * r.displacement, 3 * hair * hair);
  EXPECT_LE(r.displacement, Rational(1, power_of_2(150)));
}

/// Nothing is left of it, and that is said.
void expect_vanished(const Placement& placement) {
  const Reconstructed r = made(placement, {Method::best, true});
  EXPECT_TRUE(r.vanished);
  EXPECT_FALSE(r.by_planes);
  EXPECT_EQ(r.body.face_count(), 0u);
}

// Rounding may flatten a thin shape, or turn it inside out.
TEST(VertexRoundingTest, ThinShapesThatVanishAreReported) {
  const Rational z(1, 100);
  const Shape tetrahedron =
      shape(convex_hull(std::vector<Vector>{{0, 0, 40 * z}, {10, 0, 60 * z}, {0, 10, 60 * z}, {3, 3, 51 * z}}));
  expect_vanished(placed(tetrahedron));

  // Its corners merge in pairs. Four points that are not coplanar may be left when it is turned, but not here.
  const Shape plate = shape(block({1 << 10, 1 << 10, Rational(1, power_of_2(90))}));
  for (int i = 0; i < 10; ++i) expect_vanished(placed(plate, shift({Rational(i, 7), i, Rational(2 * i, 7)})));

  const Shape ring = shape(torus(3, 1, 12, 8));
  expect_vanished(placed(ring, scaled(AffineMap{}, Rational(1, 100))));

  // Half a step thick, but across two layers of the grid it stays.
  const Shape across = shape(block({1 << 10, 1 << 10, Rational(1, 2)}));
  const Reconstructed r = made(placed(across, shift({0, 0, Rational(1, 4)})), {Method::best, true});
  EXPECT_EQ(booleans::volume(r.body), 1 << 20);
  expect_vanished(placed(across, shift({0, 0, Rational(3, 4)})));
}

// A plate in the plane x = 0 that is turned into the grid's layers, in steps: 10 x 20 and a thousandth.
TEST(VertexRoundingTest, APlateThinnerThanAStep) {
  const Shape plate = shape(block({10'000, 20'000, Rational(1, 1000)}));
  const AffineMap turn = realize(Motion::rotation({0, 1, 0}, Rational(2675, 10))).map;
  expect_vanished(placed(plate, turn));

  const Reconstructed r = made(placed(plate, turn));
  EXPECT_TRUE(r.by_planes);
  EXPECT_EQ(r.body.face_count(), 6u);
  expect_clean(r.body);
}

// A few grid steps in size: vertices merge, faces cross, and of some nothing is left.
TEST(VertexRoundingTest, TinyShapesStayClean) {
  std::mt19937_64 random = generator(651);
  const Shape shapes[] = {shape(torus(3, 1, 12, 8)), shape(sphere(2, 12)), shape(frustum(9, 2, 0, 3, Fit::inscribed))};
  std::uint64_t merged = 0, flat = 0, crossings = 0, vanished = 0;
  for (int i = 0; i < 90; ++i) {
    const Shape& s = shapes[static_cast<std::size_t>(i) % 3];
    AffineMap map = scaled(random_motion(random), Rational(1 + below(random, 40), 20));
    if (i % 5 == 0)
      map = composed({{Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, Rational(1, 40)}}, {0, 0, 0}},
                     scaled(random_motion(random), 3));

    const Reconstructed r = made(placed(s, map));
    EXPECT_FALSE(r.by_planes);
    EXPECT_EQ(r.vanished, r.body.face_count() == 0);
    vanished += r.vanished ? 1 : 0;
    EXPECT_TRUE(is_a_rounding(r.displacement));
    expect_clean(r.body);
    EXPECT_EQ(booleans::volume(r.body) > 0, !r.vanished);
    merged += r.merged_points;
    flat += r.zero_area_triangles;
    crossings += r.resolved_crossings;
  }
  EXPECT_GT(merged, 0u);
  EXPECT_GT(flat, 0u);
  EXPECT_GT(crossings, 0u);
  std::printf("merged %llu, without area %llu, crossings %llu, vanished %llu\n",
              static_cast<unsigned long long>(merged), static_cast<unsigned long long>(flat),
              static_cast<unsigned long long>(crossings), static_cast<unsigned long long>(vanished));
}

TEST(VertexRoundingTest, FacesThatAreNoRegion) {
  // A block one face of which looks inwards.
  Polyhedron p = block({3, 2, 1}).value();
  p.planes[0] = p.planes[0].opposite();
  const Shape turned(p);
  const auto r = reconstruct(std::vector{placed(turned, {matrix(quaternion(7, 3, 1, 2)), {Rational(1, 3), 0, 0}})},
                             {Method::best, true});
  ASSERT_FALSE(r.has_value());
  EXPECT_EQ(r.error().code, ErrorCode::bad_primitive);
  EXPECT_EQ(r.error().where, "primitive 0");
}

}  // namespace
}  // namespace quoin::rounding::testing
