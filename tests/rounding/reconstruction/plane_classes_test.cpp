#include "rounding/reconstruction/plane_classes.h"

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

TEST(PlaneClassesTest, SharedPlanesAreRoundedOnce) {
  std::mt19937_64 random = generator(646);
  const Shape low = shape(block({300, 200, 100})), high = shape(block({300, 200, Rational(50, 3)}));
  for (int i = 0; i < 100; ++i) {
    AffineMap map = random_motion(random);
    if (i % 4 == 1) map = composed(realize(Motion::mirror(random_direction(random, 5))).map, map);
    if (i % 4 == 2) map = scaled(map, Rational(1 + below(random, 100), 17));
    const Reconstruction r = made({placed(low, map), placed(high, composed(shift({0, 0, 100}), map))});
    ASSERT_EQ(r.planes, 7u);
    const std::array forms{booleans::canonical(r.primitives[0].body), booleans::canonical(r.primitives[1].body)};
    // Four sides are common, one is opposite.
    const auto count = [&](bool opposite) {
      int n = 0;
      for (const exact::Plane& p : forms[0].planes)
        n += static_cast<int>(std::count(forms[1].planes.begin(), forms[1].planes.end(), opposite ? p.opposite() : p));
      return n;
    };
    ASSERT_EQ(count(false), 4);
    ASSERT_EQ(count(true), 1);
    const std::array operands{&r.primitives[0].body, &r.primitives[1].body};
    const auto sum = booleans::evaluate(operands, booleans::Expression::flat(booleans::Rule::any, 2));
    ASSERT_TRUE(sum.has_value());
    const Canonical form = booleans::canonical(sum.value());
    ASSERT_EQ(form.face_count(), 6u);
    ASSERT_EQ(form.vertices.size(), 8u);
    ASSERT_EQ(conditions(form).hold, 24u);
    ASSERT_EQ(booleans::volume(sum.value()),
              booleans::volume(r.primitives[0].body) + booleans::volume(r.primitives[1].body));
    const auto common = booleans::evaluate(operands, booleans::Expression::flat(booleans::Rule::all, 2));
    ASSERT_EQ(common.value().face_count(), 0u);
    // Opposite faces are still parallel.
    for (const Canonical& f : forms) {
      int pairs = 0;
      for (const exact::Plane& p : f.planes)
        for (const exact::Plane& q : f.planes) {
          const WidePlane a = wide(p), b = wide(q.opposite());
          pairs += squared_sine(a.n, b.n) == 0 && a.n[0] * b.n[0] + a.n[1] * b.n[1] + a.n[2] * b.n[2] > 0 ? 1 : 0;
        }
      ASSERT_EQ(pairs, 6);
    }
  }
}

TEST(PlaneClassesTest, HalfSpaces) {
  std::mt19937_64 random = generator(647);
  const Shape box = shape(block({300, 200, 100}));
  for (int i = 0; i < 20; ++i) {
    const AffineMap map = random_motion(random);
    // On the box's plane x = 300, from either side, and one of its own.
    Placement cut{nullptr, WidePlane{{1, 0, 0}, -300}, map}, rest{nullptr, WidePlane{{-1, 0, 0}, 300}, map},
        own{nullptr, WidePlane{{3, -1, 7}, 5}, map};
    const Reconstruction r = made({cut, placed(box, map), rest, own});
    EXPECT_EQ(r.planes, 7u);
    ASSERT_TRUE(r.primitives[0].plane && r.primitives[2].plane && r.primitives[3].plane);
    EXPECT_EQ(*r.primitives[0].plane, r.primitives[2].plane->opposite());
    const Canonical form = booleans::canonical(r.primitives[1].body);
    EXPECT_EQ(std::count(form.planes.begin(), form.planes.end(), *r.primitives[0].plane), 1);
    for (const auto& [k, p] : {std::pair(0, cut), {3, own}}) {
      const Reconstructed& got = r.primitives[static_cast<std::size_t>(k)];
      EXPECT_EQ(*got.plane, PlaneRounder().round(moved(*p.half_space, inverse(map)), Method::best));
      EXPECT_EQ(got.body.face_count(), 0u);
      EXPECT_EQ(got.displacement, 0);
      EXPECT_TRUE(got.by_planes);
    }
  }
  // One that fits stays.
  EXPECT_EQ(made({nullptr, WidePlane{{1, 2, 3}, -4}, {}}).plane, (exact::Plane{{1, 2, 3}, -4}));
}

}  // namespace
}  // namespace quoin::rounding::testing
