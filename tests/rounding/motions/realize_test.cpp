#include "rounding/motions/realize.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <variant>

#include "rounding/numbers/enclosure.h"
#include "rounding/planes/wide_plane.h"
#include "tests/rounding/motions/stated.h"

namespace quoin::rounding::testing {
namespace {

// Half-angle substitution: t = 1/2 gives (3/5, 4/5).
TEST(RealizeTest, HalfAngleGivesThreeFourFive) {
  const Quaternion q = quaternion(2, 0, 0, 1);
  EXPECT_EQ(matrix(q), (Matrix{Vector{Rational(3, 5), Rational(-4, 5), 0}, Vector{Rational(4, 5), Rational(3, 5), 0},
                               Vector{0, 0, 1}}));
  EXPECT_EQ(realize(Motion::turn(q)).map.linear, matrix(q));
}

// The plane x - 1 = 0 turned again and again by (3/5, 4/5): two digits more every three turns.
TEST(RealizeTest, RepeatedTurnsOfAPlane) {
  const Motion turn = Motion::turn(quaternion(2, 0, 0, 1));
  const std::array<std::array<int, 4>, 6> rows{{{3, 4, 0, -5},
                                                {-7, 24, 0, -25},
                                                {-117, 44, 0, -125},
                                                {-527, -336, 0, -625},
                                                {-237, -3116, 0, -3125},
                                                {11753, -10296, 0, -15625}}};
  const WidePlane start{{1, 0, 0}, -1};
  WidePlane step_by_step = start;
  Motion all;
  for (const auto& row : rows) {
    const WidePlane expected{{row[0], row[1], row[2]}, row[3]};
    step_by_step = moved(step_by_step, inverse(realize(turn).map));
    EXPECT_EQ(step_by_step, expected);
    // At once: the turns joined to one.
    all = all.then(turn);
    EXPECT_EQ(all.steps().size(), 1u);
    EXPECT_EQ(moved(start, inverse(realize(all).map)), expected);
    // By the inverse motion.
    EXPECT_EQ(moved(start, realize(all.inverse()).map), expected);
  }
}

TEST(RealizeTest, ThirtyDegreesAboutZ) {
  const RealizedMotion r = realize(Motion::rotation(z_axis, 30));
  ASSERT_TRUE(r.rotation.has_value());
  const Rational t(r.rotation->z, r.rotation->w);
  const Rational error = std::max(magnitude(angle_error(t, 30, MPFR_RNDD)), magnitude(angle_error(t, 30, MPFR_RNDU)));
  EXPECT_GT(error, 0);
  EXPECT_GE(r.angle_error_degrees, error);
  EXPECT_LT(r.angle_error_degrees, 2 * error);
  EXPECT_LT(r.angle_error_degrees, Rational(1, power_of_10(17)));
  EXPECT_EQ(r.map.linear, matrix(*r.rotation));
  EXPECT_EQ(r.map.shift, (Vector{0, 0, 0}));
}

TEST(RealizeTest, ApproximationsAreOddInTheAngle) {
  std::mt19937_64 random = generator(332);
  for (int i = 0; i < 100; ++i) {
    const Vector axis = random_direction(random, 3);
    const Motion m = Motion::rotation(axis, random_degrees(random));
    const RealizedMotion there = realize(m), back = realize(m.inverse());
    ASSERT_EQ(composed(*there.rotation, *back.rotation), Quaternion());
    ASSERT_EQ(there.map.linear, transposed(back.map.linear));
    ASSERT_EQ(there.angle_error_degrees, back.angle_error_degrees);
    ASSERT_EQ(there.displacement_per_unit, back.displacement_per_unit);
  }
}

TEST(RealizeTest, ExactAngles) {
  const auto exact = [](const Vector& axis, const Rational& degrees, const Matrix& expected) {
    const RealizedMotion r = realize(Motion::rotation(axis, degrees));
    EXPECT_EQ(r.map.linear, expected) << degrees;
    EXPECT_EQ(r.angle_error_degrees, 0) << degrees;
    EXPECT_EQ(r.displacement_per_unit, 0) << degrees;
    EXPECT_EQ(r.displacement, 0) << degrees;
  };
  exact(z_axis, 90, {Vector{0, -1, 0}, Vector{1, 0, 0}, Vector{0, 0, 1}});
  exact(z_axis, -90, {Vector{0, 1, 0}, Vector{-1, 0, 0}, Vector{0, 0, 1}});
  exact(x_axis, 90, {Vector{1, 0, 0}, Vector{0, 0, -1}, Vector{0, 1, 0}});
  exact(y_axis, 90, {Vector{0, 0, 1}, Vector{0, 1, 0}, Vector{-1, 0, 0}});
  exact(x_axis, 180, {Vector{1, 0, 0}, Vector{0, -1, 0}, Vector{0, 0, -1}});
  exact({1, 1, 0}, 180, {Vector{0, 1, 0}, Vector{1, 0, 0}, Vector{0, 0, -1}});
  // x to y to z to x.
  exact(diagonal, 120, {Vector{0, 0, 1}, Vector{1, 0, 0}, Vector{0, 1, 0}});
  exact(diagonal, -120, {Vector{0, 1, 0}, Vector{0, 0, 1}, Vector{1, 0, 0}});
  const Rational a(2, 3), b(-1, 3);
  exact(diagonal, 60, {Vector{a, b, a}, Vector{a, a, b}, Vector{b, a, a}});
  // An axis of rational length: (1, 2, 2) by 90.
  const RealizedMotion r = realize(Motion::rotation({1, 2, 2}, 90));
  EXPECT_EQ(r.angle_error_degrees, 0);
  EXPECT_EQ(*r.rotation, quaternion(3, 1, 2, 2));
  // Those that are not: 60 about z, 90 and 30 about the diagonal.
  for (const Motion& m : {Motion::rotation(z_axis, 60), Motion::rotation(diagonal, 90), Motion::rotation(diagonal, 30)})
    EXPECT_GT(realize(m).angle_error_degrees, 0);
}

// Where no steps join, the map of the composition is the composition of the maps; so it is for exact steps that join.
TEST(RealizeTest, MapsCompose) {
  std::mt19937_64 random = generator(336);
  int whole = 0;
  for (int i = 0; i < 200; ++i) {
    const Motion a = random_motion(random, 1 + below(random, 3)), b = random_motion(random, 1 + below(random, 3));
    const Motion both = a.then(b);
    const bool joined = both.steps().size() != a.steps().size() + b.steps().size();
    // Joined angles are approximated anew; and two mirrors that cancel leave a rotation.
    const auto inexact = [](const Step& step) {
      return std::holds_alternative<RotationStep>(step) || std::holds_alternative<MirrorStep>(step);
    };
    if (joined && (std::ranges::any_of(a.steps(), inexact) || std::ranges::any_of(b.steps(), inexact))) continue;
    whole += joined ? 0 : 1;
    const RealizedMotion first = realize(a), second = realize(b), r = realize(both);
    ASSERT_EQ(r.map, composed(first.map, second.map));
    const Vector p = random_vector(random, 20);
    ASSERT_EQ(r.map(p), second.map(first.map(p)));
    ASSERT_EQ(r.rotation.has_value(), first.rotation.has_value() && second.rotation.has_value());
    if (r.rotation) {
      ASSERT_EQ(*r.rotation, composed(*first.rotation, *second.rotation));
      ASSERT_EQ(matrix(*r.rotation), r.map.linear);
    }
    if (!joined) {
      ASSERT_EQ(r.angle_error_degrees, first.angle_error_degrees + second.angle_error_degrees);
    }
  }
  EXPECT_GT(whole, 50);
}

TEST(RealizeTest, MirrorsAndScalings) {
  std::mt19937_64 random = generator(337);
  for (int i = 0; i < 100; ++i) {
    const Vector n = random_direction(random, 5), p = random_vector(random, 20);
    const Motion mirror = Motion::mirror(n);
    ASSERT_EQ(mirror.then(mirror), Motion());
    ASSERT_EQ(mirror.inverse(), mirror);
    const RealizedMotion r = realize(mirror);
    ASSERT_FALSE(r.rotation.has_value());
    ASSERT_EQ(determinant(r.map.linear), -1);
    ASSERT_EQ(composed(r.map, r.map), identity);
    // The image lies across the plane: the middle in it, the way there along the normal.
    const Vector image = r.map(p), way = image - p;
    ASSERT_EQ(dot(image + p, n), 0);
    ASSERT_EQ(dot(way, way) * dot(n, n), dot(way, n) * dot(way, n));
  }
  EXPECT_EQ(realize(Motion::mirror(x_axis)).map.linear, (Matrix{Vector{-1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}}));
  const RealizedMotion s = realize(Motion::scaling({2, Rational(1, 3), 1}));
  EXPECT_EQ(s.map({3, 3, 3}), (Vector{6, 1, 3}));
  EXPECT_FALSE(s.rotation.has_value());
  EXPECT_EQ(s.displacement_per_unit, 0);
}

// A point is carried to where the stated motion has it, up to the certificate.
TEST(RealizeTest, DisplacementCertificate) {
  std::mt19937_64 random = generator(343);
  Rational tightest = 0;
  for (int i = 0; i < 60; ++i) {
    const Motion m = random_motion(random, 1 + below(random, 6));
    const RealizedMotion r = realize(m);
    const AffineMap stated = stated_map(m);
    for (int j = 0; j < 5; ++j) {
      const Vector p = j == 0 ? Vector{0, 0, 0} : random_vector(random, 30);
      const Vector e = r.map(p) - stated(p);
      const Rational bound = r.displacement_per_unit * root_above(dot(p, p)) + r.displacement;
      const Rational slack = epsilon * (1 + dot(p, p)) * power_of_10(12);
      ASSERT_LE(dot(e, e), (bound + slack) * (bound + slack)) << i;
      if (bound > 0) tightest = std::max(tightest, Rational(dot(e, e) / (bound * bound)));
    }
  }
  // It is not idle either: some point moves by a good part of it.
  EXPECT_GT(tightest, Rational(1, 16));
}

}  // namespace
}  // namespace quoin::rounding::testing
