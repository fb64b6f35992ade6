#include "rounding/reconstruction/reconstruct.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <string>
#include <vector>

#include "tests/rounding/reconstruction/placements.h"

namespace quoin::rounding::testing {
namespace {

// Example E09.

TEST(ReconstructTest, TheTurnedBox) {
  const Shape box = shape(block({3, 2, 1}));
  const Placement placement = placed(box, realize(Motion::turn(quaternion(2, 0, 0, 1))).map);
  for (const Method method : {Method::best, Method::naive, Method::continued_fraction, Method::lattice}) {
    const Reconstruction all = made(std::vector{placement}, {method});
    EXPECT_EQ(all.planes, 6u);
    EXPECT_EQ(all.exact_planes, 6u);
    EXPECT_EQ(all.face_local_planes, 0u);
    const Reconstructed& r = all.primitives[0];
    EXPECT_TRUE(r.by_planes);
    EXPECT_EQ(r.displacement, 0);
    EXPECT_EQ(r.plane, std::nullopt);
    EXPECT_EQ(r.merged_points + r.zero_area_triangles + r.resolved_crossings, 0u);
    const Canonical form = booleans::canonical(r.body);
    std::set<WidePlane> planes;
    for (const exact::Plane& p : form.planes) planes.insert(wide(p));
    const std::set<WidePlane> expected{{{-3, -4, 0}, 0},  {{3, 4, 0}, -15}, {{4, -3, 0}, 0},
                                       {{-4, 3, 0}, -10}, {{0, 0, -1}, 0},  {{0, 0, 1}, -1}};
    EXPECT_EQ(planes, expected);
    EXPECT_EQ(conditions(form).all, 24u);
    EXPECT_EQ(conditions(form).hold, 24u);
    EXPECT_EQ(booleans::volume(r.body), 6);
    EXPECT_EQ(squared_movement(placement, form), 0);
    expect_clean(r.body);
  }
}

TEST(ReconstructTest, TheThinBox) {
  const Shape plate = shape(block({3, 3, Rational(1, 100)}));
  const Motion motion = Motion::turn(quaternion(3, 0, 0, 1)).then(Motion::turn(quaternion(5, 2, 0, 0)));
  const Reconstructed r = made(placed(plate, realize(motion).map));
  EXPECT_EQ(r.displacement, 0);
  const Canonical form = booleans::canonical(r.body);
  EXPECT_EQ(conditions(form).hold, 24u);
  EXPECT_EQ(booleans::volume(r.body), Rational(9, 100));
  expect_clean(r.body);
}

TEST(ReconstructTest, ShapesThatAreNotConvex) {
  std::mt19937_64 random = generator(644);
  const Shape ring = shape(extrusion({{{{0, 0}, {900, 10}, {800, 700}, {300, 200}, {20, 900}},
                                       {{200, 100}, {400, 100}, {300, 150}},
                                       {{500, 100}, {600, 100}, {600, 200}, {500, 200}}}},
                                     {100, -50, 333}));
  const Rational before = volume(ring.polyhedron);
  for (int i = 0; i < 10; ++i) {
    const Placement placement = placed(ring, random_motion(random));
    const Reconstructed r = made(placement);
    const Canonical form = booleans::canonical(r.body);
    EXPECT_TRUE(r.by_planes);
    EXPECT_EQ(form.face_count(), ring.polyhedron.face_count());
    EXPECT_EQ(form.vertices.size(), ring.polyhedron.points.size());
    EXPECT_EQ(form.faces.loop_start.size(), ring.polyhedron.faces.loop_start.size());
    EXPECT_EQ(form.faces.corners.size(), ring.polyhedron.faces.corners.size());
    EXPECT_GE(r.displacement * r.displacement, squared_movement(placement, form));
    EXPECT_LT(r.displacement, Rational(1, power_of_2(40)));
    EXPECT_LT(magnitude(booleans::volume(r.body) - before), Rational(1, 1000));
    expect_clean(r.body);
  }
}

// Two cubes that touch in a vertex do so after any motion.
TEST(ReconstructTest, TouchingCubes) {
  const Body a = booleans::box_body({{0, 0, 0}}, {{100, 100, 100}}),
             b = booleans::box_body({{100, 100, 100}}, {{150, 170, 190}});
  const std::array operands{&a, &b};
  const auto both = booleans::evaluate(operands, booleans::Expression::flat(booleans::Rule::any, 2));
  const Shape s(polyhedron_of(booleans::canonical(both.value())));
  ASSERT_TRUE(s.trihedral.has_value());
  std::mt19937_64 random = generator(645);
  for (int i = 0; i < 10; ++i) {
    const Reconstructed r = made(placed(s, random_motion(random)));
    const Canonical form = booleans::canonical(r.body);
    EXPECT_EQ(form.vertices.size(), 15u);
    EXPECT_EQ(form.face_count(), 12u);
    expect_clean(r.body);
  }
}

TEST(ReconstructTest, Cancelling) {
  const Shape box = shape(block({3, 2, 1})), ball = shape(sphere(600, 8));
  const AffineMap map{matrix(quaternion(7, 3, 1, 2)), {Rational(1, 3), 0, 0}};
  std::atomic<bool> cancel = true;
  ReconstructionOptions options;
  options.cancel = &cancel;
  for (const Shape* s : {&box, &ball})
    for (const bool by_vertices : {false, true}) {
      options.by_vertices = by_vertices;
      const auto r = reconstruct(std::vector{placed(*s, map)}, options);
      ASSERT_FALSE(r.has_value());
      EXPECT_EQ(r.error().code, ErrorCode::cancelled);
      cancel = false;
      EXPECT_TRUE(reconstruct(std::vector{placed(*s, map)}, options).has_value());
      cancel = true;
    }
}

TEST(ReconstructTest, NothingIsNothing) {
  const auto r = reconstruct({});
  ASSERT_TRUE(r.has_value());
  EXPECT_EQ(r.value().primitives.size(), 0u);
  EXPECT_EQ(r.value().planes, 0u);
}

}  // namespace
}  // namespace quoin::rounding::testing
