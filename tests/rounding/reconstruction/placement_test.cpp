#include "rounding/reconstruction/placement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/rounding/reconstruction/placements.h"

namespace quoin::rounding::testing {
namespace {

TEST(PlacementTest, MirrorImages) {
  std::mt19937_64 random = generator(649);
  std::vector<Shape> shapes = convex_ones(power_of_2(10));
  shapes.push_back(shape(frustum(7, 500, 0, 300, Fit::inscribed)));
  shapes.push_back(shape(sphere(700, 8)));
  shapes.push_back(
      shape(extrusion({{{{0, 0}, {90, 0}, {90, 90}, {0, 90}}, {{30, 30}, {60, 30}, {45, 70}}}}, {9, 9, 99})));
  for (const Shape& s : shapes)
    for (const bool by_vertices : {false, true}) {
      const AffineMap map = random_motion(random);
      const AffineMap mirrored = composed(realize(Motion::mirror(random_direction(random, 9))).map, map);
      ASSERT_LT(determinant(mirrored.linear), 0);
      const Reconstructed r = made(placed(s, mirrored), {Method::best, by_vertices});
      EXPECT_GT(booleans::volume(r.body), 0);
      EXPECT_LT(magnitude(booleans::volume(r.body) / volume(s.polyhedron) - 1), Rational(1, 50));
      EXPECT_EQ(r.by_planes, s.trihedral && !by_vertices);
      expect_clean(r.body);
    }
}

TEST(PlacementTest, TheReachOfAShape) {
  const Shape box = shape(block({3, 4, 12}));
  EXPECT_GE(box.reach, 13);
  EXPECT_LE(box.reach, 13 + Rational(1, power_of_2(35)));
  EXPECT_TRUE(box.trihedral.has_value());
  EXPECT_FALSE(shape(sphere(1, 4)).trihedral.has_value());
}

}  // namespace
}  // namespace quoin::rounding::testing
