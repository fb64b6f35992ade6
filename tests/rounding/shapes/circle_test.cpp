#include "rounding/shapes/circle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

#include "rounding/numbers/enclosure.h"
#include "tests/rounding/shapes/soundness.h"

namespace quoin::rounding::testing {
namespace {

constexpr Fit all_fits[] = {Fit::inscribed, Fit::circumscribed, Fit::equal_area};

TEST(CircleTest, CirclePointsAreOnTheCircle) {
  std::mt19937_64 random = generator(601);
  for (int i = 0; i < 400; ++i) {
    const Rational degrees = i < 72 ? Rational(5 * i) : random_rational(random, 30);
    const Integer precision = power_of_2(1 + static_cast<unsigned>(below(random, 40)));
    const PlanePoint p = circle_point(degrees, precision);
    ASSERT_EQ(p[0] * p[0] + p[1] * p[1], 1) << degrees;
    ASSERT_EQ(circle_point(degrees + 360, precision), p);
    // About the axes, and about the diagonals but for the points next to them: those themselves are irrational.
    ASSERT_EQ(circle_point(-degrees, precision), (PlanePoint{p[0], Rational(-p[1])})) << degrees;
    ASSERT_EQ(circle_point(180 - degrees, precision), (PlanePoint{Rational(-p[0]), p[1]})) << degrees;
    if (denominator(Rational(degrees / 45)) == 1 && denominator(Rational(degrees / 90)) != 1) continue;
    ASSERT_EQ(circle_point(90 - degrees, precision), (PlanePoint{p[1], p[0]})) << degrees;
  }
  EXPECT_EQ(circle_point(0, 9), (PlanePoint{1, 0}));
  EXPECT_EQ(circle_point(90, 9), (PlanePoint{0, 1}));
  EXPECT_EQ(circle_point(180, 9), (PlanePoint{-1, 0}));
  EXPECT_EQ(circle_point(-180, 9), (PlanePoint{-1, 0}));
  EXPECT_EQ(circle_point(270, 9), (PlanePoint{0, -1}));
  EXPECT_EQ(circle_point(360, 9), (PlanePoint{1, 0}));
  // tan(15 degrees) = 0.2679 and 3/11 = 0.2727, 4/15 = 0.2667.
  EXPECT_EQ(circle_point(30, 4), (PlanePoint{Rational(15, 17), Rational(8, 17)}));
  EXPECT_EQ(circle_point(30, 11), (PlanePoint{Rational(56, 65), Rational(33, 65)}));
  EXPECT_EQ(circle_point(60, 15), (PlanePoint{Rational(120, 241), Rational(209, 241)}));
}

// The stated angle: |t - tan(angle / 2)| <= 1 / (2 Q), and no fraction is closer.
TEST(CircleTest, CirclePointsAreTheClosest) {
  std::mt19937_64 random = generator(602);
  for (int i = 0; i < 150; ++i) {
    const Rational degrees = Rational(1 + below(random, 45'000'000), 1'000'000);
    const std::uint64_t limit = 1 + below(random, 60);
    const auto distance = [&](const Rational& t) {
      const Rational low = true_tangent(degrees / 2, MPFR_RNDD), high = true_tangent(degrees / 2, MPFR_RNDU);
      EXPECT_LT(high - low, Rational(1, power_of_2(500)));
      return std::pair(std::min(magnitude(t - low), magnitude(t - high)),
                       std::max(magnitude(t - low), magnitude(t - high)));
    };
    for (const Integer& precision : {Integer(limit), Integer(limit) * 100'000'007}) {
      const PlanePoint p = circle_point(degrees, precision);
      const Rational t = p[1] / (1 + p[0]);
      ASSERT_LE(denominator(t), precision);
      ASSERT_LE(distance(t).second, Rational(1, 2 * precision) + Rational(1, power_of_2(500)));
      if (precision > 60) continue;
      for (std::uint64_t q = 1; q <= limit; ++q) {
        const Rational other(nearest_integer(true_tangent(degrees / 2, MPFR_RNDD) * q), q);
        if (other != t) {
          ASSERT_GT(distance(other).second, distance(t).first) << degrees;
        }
      }
    }
  }
}

TEST(CircleTest, PolygonsAreConvexAndSymmetric) {
  for (const std::uint32_t sides : {3u, 4u, 5u, 6u, 7u, 8u, 12u, 16u, 17u, 36u, 48u, 100u, 360u}) {
    for (const Fit fit : all_fits) {
      const Loop l = circle_polygon(sides, Rational(7, 3), fit);
      ASSERT_EQ(l.size(), sides);
      for (std::size_t i = 0; i < sides; ++i) {
        const PlanePoint &a = l[i], &b = l[(i + 1) % sides], &c = l[(i + 2) % sides];
        ASSERT_GT((b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]), 0) << sides;
        ASSERT_GT(a[0] * b[1] - a[1] * b[0], 0);
      }
      std::set<PlanePoint> set(l.begin(), l.end());
      ASSERT_EQ(set.size(), sides);
      for (const PlanePoint& p : l) {
        ASSERT_EQ(set.count({p[0], -p[1]}), 1u) << sides;
        if (sides % 2 == 0) {
          ASSERT_EQ(set.count({-p[0], p[1]}), 1u) << sides;
        }
        if (sides % 4 == 0 && sides % 8 != 0) {
          ASSERT_EQ(set.count({p[1], p[0]}), 1u) << sides;
        }
      }
    }
  }
}

TEST(CircleTest, Fits) {
  std::mt19937_64 random = generator(603);
  const Enclosure pi = enclosed_pi(80);
  ASSERT_LE(pi.low, true_pi(MPFR_RNDD));
  ASSERT_GE(pi.high, true_pi(MPFR_RNDU));
  for (const std::uint32_t sides : {3u, 4u, 5u, 8u, 11u, 32u, 100u}) {
    const Rational r = positive(random);
    Rational areas[3];
    for (std::size_t k = 0; k < 3; ++k) areas[k] = doubled_area(circle_polygon(sides, r, all_fits[k])) / 2;
    for (const PlanePoint& p : circle_polygon(sides, r, Fit::inscribed)) ASSERT_EQ(p[0] * p[0] + p[1] * p[1], r * r);
    const Loop around = circle_polygon(sides, r, Fit::circumscribed);
    for (std::size_t i = 0; i < sides; ++i) {
      const PlanePoint &a = around[i], &b = around[(i + 1) % sides];
      const Rational x = b[0] - a[0], y = b[1] - a[1], moment = a[0] * b[1] - a[1] * b[0];
      ASSERT_EQ(moment * moment, r * r * (x * x + y * y));
      // It touches between its corners.
      ASSERT_LT(a[0] * x + a[1] * y, 0);
      ASSERT_GT(b[0] * x + b[1] * y, 0);
    }
    const Rational bound = Rational(1, power_of_2(40));
    EXPECT_GT(areas[2], pi.low * r * r * (1 - bound));
    EXPECT_LT(areas[2], pi.high * r * r * (1 + bound));
    EXPECT_LT(areas[0], pi.low * r * r);
    EXPECT_GT(areas[1], pi.high * r * r);
  }
}

}  // namespace
}  // namespace quoin::rounding::testing
