#include "rounding/motions/motion.h"

#include <gtest/gtest.h>

#include <variant>

#include "rounding/motions/realize.h"
#include "rounding/planes/wide_plane.h"
#include "tests/rounding/motions/stated.h"

namespace quoin::rounding::testing {
namespace {

TEST(MotionTest, AnglesAddAsStated) {
  Motion m;
  for (int i = 0; i < 360; ++i) {
    EXPECT_EQ(m.steps().size(), i == 0 ? 0u : 1u);
    m = m.then(Motion::rotation(z_axis, 1));
  }
  EXPECT_EQ(m, Motion());
  Motion thirds;
  for (int i = 0; i < 3; ++i) thirds = thirds.then(Motion::rotation({2, 2, 0}, Rational(100, 3)));
  EXPECT_EQ(thirds, Motion::rotation({1, 1, 0}, 100));
  EXPECT_EQ(Motion::rotation(x_axis, 720), Motion());
  EXPECT_EQ(Motion::rotation(x_axis, 190), Motion::rotation(x_axis, -170));
  EXPECT_EQ(Motion::rotation(x_axis, -180), Motion::rotation(x_axis, 180));
  EXPECT_EQ(Motion::rotation(x_axis, 540), Motion::rotation(x_axis, 180));
  EXPECT_EQ(std::get<RotationStep>(Motion::rotation(x_axis, -180).steps()[0]).degrees, 180);
  EXPECT_NE(Motion::rotation(x_axis, 1), Motion::rotation(x_axis, -1));
}

// A quarter about x, then one about z: x goes to y, y to z, z to x.
TEST(MotionTest, JoinedTurnsActInTheirOrder) {
  const Motion about_x = Motion::turn(quaternion(1, 1, 0, 0)), about_z = Motion::turn(quaternion(1, 0, 0, 1));
  EXPECT_EQ(about_x.then(about_z), Motion::turn(quaternion(1, 1, 1, 1)));
  EXPECT_EQ(about_z.then(about_x), Motion::turn(quaternion(1, 1, -1, 1)));
  EXPECT_EQ(realize(about_x.then(about_z)).map({1, 2, 3}), (Vector{3, 1, 2}));
}

TEST(MotionTest, OppositeAxesAreOneAxis) {
  std::mt19937_64 random = generator(331);
  for (int i = 0; i < 200; ++i) {
    const Vector axis = random_direction(random, 4);
    const Rational degrees = random_degrees(random), factor(between(random, 1, 9), between(random, 1, 9));
    const Motion m = Motion::rotation(axis, degrees);
    ASSERT_EQ(Motion::rotation(Rational(-1) * axis, -degrees), m);
    ASSERT_EQ(Motion::rotation(factor * axis, degrees + 360), m);
    ASSERT_EQ(Motion::mirror(-factor * axis), Motion::mirror(axis));
    for (const Step& step : m.steps()) {
      const auto& rotation = std::get<RotationStep>(step);
      ASSERT_TRUE(is_canonical(WidePlane{rotation.axis, 0}));
      ASSERT_EQ(gcd(gcd(rotation.axis[0], rotation.axis[1]), rotation.axis[2]), 1);
      ASSERT_GT(rotation.degrees, -180);
      ASSERT_LE(rotation.degrees, 180);
      ASSERT_NE(rotation.degrees, 0);
    }
  }
}

TEST(MotionTest, InversesCancel) {
  std::mt19937_64 random = generator(334);
  for (int i = 0; i < 100; ++i) {
    const Motion m = random_motion(random, below(random, 7));
    ASSERT_EQ(m.then(m.inverse()), Motion());
    ASSERT_EQ(m.inverse().then(m), Motion());
    ASSERT_EQ(m.inverse().inverse(), m);
    ASSERT_EQ(composed(realize(m).map, realize(m.inverse()).map), identity);
    ASSERT_EQ(inverse(realize(m).map), realize(m.inverse()).map);
  }
}

TEST(MotionTest, WordsAreReduced) {
  std::mt19937_64 random = generator(335);
  for (int i = 0; i < 200; ++i) {
    const Motion a = random_motion(random, below(random, 4)), b = random_motion(random, below(random, 4)),
                 c = random_motion(random, below(random, 4));
    ASSERT_EQ(a.then(b).then(c), a.then(b.then(c)));
    ASSERT_EQ(a.then(b).inverse(), b.inverse().then(a.inverse()));
    ASSERT_EQ(a.then(Motion()), a);
    ASSERT_EQ(Motion().then(a), a);
    ASSERT_EQ(a.then(b).then(b.inverse()), a);
  }
  EXPECT_EQ(Motion::translation({0, 0, 0}), Motion());
  EXPECT_EQ(Motion::scaling({1, 1, 1}), Motion());
  EXPECT_EQ(Motion::turn(Quaternion()), Motion());
  EXPECT_EQ(Motion::translation({1, 2, 3}).then(Motion::translation({-1, 0, 1})), Motion::translation({0, 2, 4}));
  EXPECT_EQ(Motion::scaling({2, 3, 4}).then(Motion::scaling({Rational(1, 2), 1, 1})), Motion::scaling({1, 3, 4}));
}

}  // namespace
}  // namespace quoin::rounding::testing
