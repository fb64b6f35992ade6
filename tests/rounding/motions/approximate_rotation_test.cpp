#include "rounding/motions/approximate_rotation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "rounding/numbers/enclosure.h"
#include "tests/rounding/motions/stated.h"

namespace quoin::rounding::testing {
namespace {

// The convergents of tan 15, the rotations by about 30 degrees that they give, and how far they are off.
TEST(ApproximateRotationTest, ConvergentsOfTan15) {
  struct Row {
    Rational t, u, v;
    const char* error;  // degrees, rounded as printed
  };
  const Row rows[] = {
      {Rational(1, 3), Rational(4, 5), Rational(3, 5), "6.87"},
      {Rational(1, 4), Rational(15, 17), Rational(8, 17), "-1.93"},
      {Rational(3, 11), Rational(56, 65), Rational(33, 65), ".510"},
      {Rational(4, 15), Rational(209, 241), Rational(120, 241), "-.137"},
      {Rational(11, 41), Rational(780, 901), Rational(451, 901), ".0367"},
      {Rational(15, 56), Rational(2911, 3361), Rational(1680, 3361), "-.00984"},
      {Rational(41, 153), Rational(10864, 12545), Rational(6273, 12545), ".00264"},
      {Rational(56, 209), Rational(40545, 46817), Rational(23408, 46817), "-.000707"},
      {Rational(153, 571), Rational(151316, 174725), Rational(87363, 174725), ".000189"},
  };
  ContinuedFraction low(enclosed_tangent(15, 192).low), high(enclosed_tangent(15, 192).high);
  for (ContinuedFraction* c : {&low, &high}) {
    ASSERT_TRUE(c->next());
    EXPECT_EQ(c->quotient(), 0);
  }
  const Integer quotients[] = {3, 1, 2, 1, 2, 1, 2, 1, 2};
  std::size_t i = 0;
  for (const Row& row : rows) {
    for (ContinuedFraction* c : {&low, &high}) {
      ASSERT_TRUE(c->next());
      EXPECT_EQ(c->quotient(), quotients[i]);
      EXPECT_EQ(Rational(c->p(), c->q()), row.t);
    }
    ++i;
    const Matrix m = matrix(quaternion(denominator(row.t), 0, 0, numerator(row.t)));
    EXPECT_EQ(m[0][0], row.u);
    EXPECT_EQ(m[1][0], row.v);
    EXPECT_EQ(m[0][1], -row.v);
    const std::string text = row.error;
    Rational half_digit(1, 2);
    for (std::size_t k = text.find('.') + 1; k < text.size(); ++k) half_digit /= 10;
    const Rational printed = *exact::parse_rational(text);
    EXPECT_LE(printed - half_digit, angle_error(row.t, 30, MPFR_RNDD)) << text;
    EXPECT_GE(printed + half_digit, angle_error(row.t, 30, MPFR_RNDU)) << text;
  }
  // What is carried out is one of them, or lies between two.
  const ApproximateRotation r = approximate({{0, 0, 1}, 30});
  const Rational t = enclosed_tangent(15, 400).low;
  EXPECT_EQ(Rational(r.by.z, r.by.w), best_approximation(t, power_of_2(46)));
}

TEST(ApproximateRotationTest, CertifiedAngleBoundsTheTrueError) {
  std::mt19937_64 random = generator(330);
  std::vector<RotationStep> steps{
      {{0, 0, 1}, 30}, {{0, 0, 1}, 1}, {{1, 0, 0}, 179}, {{1, 1, 0}, 45}, {{0, 1, 0}, Rational(1, power_of_2(20))}};
  for (int i = 0; i < 200; ++i) {
    const Motion m = Motion::rotation(random_direction(random, 3), random_degrees(random));
    if (!m.steps().empty()) steps.push_back(std::get<RotationStep>(m.steps()[0]));
  }
  for (const RotationStep& step : steps) {
    const ApproximateRotation r = approximate(step);
    const Axis& v = step.axis;
    const Integer norm = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    // It turns about the axis, by 2 atan(s |v| / w).
    const std::array<Integer, 3> n{r.by.x, r.by.y, r.by.z};
    const std::size_t k = v[0] != 0 ? 0 : v[1] != 0 ? 1 : 2;
    for (std::size_t j = 0; j < 3; ++j) ASSERT_EQ(n[j] * v[k], n[k] * v[j]);
    const Rational s(n[k], v[k]);
    const int sign = step.degrees < 0 ? -1 : 1;
    Rational least, most;  // of the angle
    if (r.by.w == 0) {
      least = most = 180;
    } else {
      const Rational ratio = s * sign / r.by.w;
      ASSERT_GE(ratio, 0);
      least = 2 * true_arctangent_degrees(ratio * true_root(norm, MPFR_RNDD), MPFR_RNDD);
      most = 2 * true_arctangent_degrees(ratio * true_root(norm, MPFR_RNDU), MPFR_RNDU);
    }
    const Rational stated = magnitude(step.degrees);
    const Rational error = std::max(magnitude(least - stated), magnitude(most - stated));
    const Rational surely =
        least <= stated && stated <= most ? Rational(0) : std::min(magnitude(least - stated), magnitude(most - stated));
    ASSERT_GE(r.error_degrees, surely) << step.degrees;
    // The two units agree.
    ASSERT_GE(r.error_degrees, r.error_radians * 180 / true_pi(MPFR_RNDU));
    ASSERT_LE(r.error_degrees, r.error_radians * 180 / true_pi(MPFR_RNDD) * (1 + Rational(1, power_of_2(40))));
    // The bound says nothing worse than the distance of the tangents does: d tan / d angle = 1 + tan^2 <= 1 + norm.
    ASSERT_LE(r.error_degrees, (error + Rational(1, power_of_2(150))) * (1 + norm) * Rational(101, 100))
        << step.degrees;
    // One unit of 1 / (2 Q), Q = 2^32 - 1, in the tangent, or in the cotangent.
    ASSERT_LE(r.error_radians, root_above(norm) * Rational(1, power_of_2(32) - 1) + Rational(1, power_of_2(150)));
  }
}

TEST(ApproximateRotationTest, NoAngleIsOffByMoreThanTheTolerance) {
  std::mt19937_64 random = generator(333);
  for (int i = 0; i < 200; ++i) {
    const Motion m = Motion::rotation(random_direction(random, 5), random_degrees(random));
    for (const Step& step : m.steps())
      ASSERT_LE(approximate(std::get<RotationStep>(step)).error_radians, Rational(1, power_of_2(92)));
  }
}

// Angles too small, or too near to 180, for any fraction: carried out as 0 or 180, and the certificate says so.
TEST(ApproximateRotationTest, AnglesNextTo0And180) {
  for (const unsigned bits : {100u, 300u}) {
    const Rational tiny(1, power_of_2(bits));
    const ApproximateRotation zero = approximate({{0, 1, 0}, tiny}), half = approximate({{0, 1, 0}, 180 - tiny}),
                              back = approximate({{0, 1, 0}, tiny - 180});
    EXPECT_EQ(zero.by, Quaternion());
    EXPECT_EQ(half.by, quaternion(0, 0, 1, 0));
    EXPECT_EQ(back.by, quaternion(0, 0, 1, 0));
    for (const ApproximateRotation& r : {zero, half, back}) {
      EXPECT_GE(r.error_degrees, tiny);
      EXPECT_LE(r.error_degrees, std::max(Rational(2 * tiny), Rational(1, power_of_2(150))));
    }
  }
}

}  // namespace
}  // namespace quoin::rounding::testing
