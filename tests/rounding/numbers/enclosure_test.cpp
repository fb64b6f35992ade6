#include "rounding/numbers/enclosure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <vector>

#include "tests/rounding/support.h"

namespace quoin::rounding::testing {
namespace {

/// 2^exponent.
Rational scale(long exponent) {
  const Integer p = power_of_2(static_cast<unsigned>(std::labs(exponent)));
  return exponent < 0 ? Rational(1, p) : Rational(p);
}

// MPFR's bounds are 600 bits long: up to 512 bits they decide on which side the truth lies.
constexpr unsigned widths[] = {8, 16, 40, 64, 100, 192, 384, 512};

TEST(EnclosureTest, PiIsEnclosed) {
  for (const unsigned bits : widths) {
    const Enclosure pi = enclosed_pi(bits);
    EXPECT_LE(pi.low, true_pi(MPFR_RNDD)) << bits;
    EXPECT_GE(pi.high, true_pi(MPFR_RNDU)) << bits;
  }
}

TEST(EnclosureTest, PiIsAsNarrowAsStated) {
  for (const unsigned bits : widths) {
    const Enclosure pi = enclosed_pi(bits);
    EXPECT_LT(pi.high - pi.low, scale(-static_cast<long>(bits))) << bits;
  }
}

TEST(EnclosureTest, TangentIsEnclosed) {
  std::mt19937_64 random = generator(310);
  std::vector<Rational> degrees{1, 15, 30, Rational(45, 2), 44, 45, Rational(1, power_of_2(60)), Rational(1, 3)};
  for (int i = 0; i < 60; ++i) degrees.emplace_back(Rational(45 * Integer(random() >> 20), Integer(1) << 44));
  degrees.emplace_back(45 - Rational(1, power_of_2(70)));
  for (const unsigned bits : widths) {
    for (const Rational& a : degrees) {
      const Enclosure t = enclosed_tangent(a, bits);
      ASSERT_GE(t.low, 0) << a << ' ' << bits;
      ASSERT_LE(t.low, true_tangent(a, MPFR_RNDD)) << a << ' ' << bits;
      ASSERT_GE(t.high, true_tangent(a, MPFR_RNDU)) << a << ' ' << bits;
      ASSERT_LT(t.high - t.low, scale(-static_cast<long>(bits))) << a << ' ' << bits;
    }
  }
}

TEST(EnclosureTest, TangentOf0And45) {
  for (const unsigned bits : widths) {
    const Enclosure zero = enclosed_tangent(0, bits), one = enclosed_tangent(45, bits);
    EXPECT_EQ(zero.low, 0);
    EXPECT_EQ(zero.high, 0);
    EXPECT_LE(one.low, 1);
    EXPECT_GE(one.high, 1);
    EXPECT_LT(one.high - one.low, scale(-static_cast<long>(bits)));
  }
  // Smaller than a unit: the enclosure reaches down to 0 and not below.
  const Enclosure tiny = enclosed_tangent(Rational(1, power_of_2(300)), 192);
  EXPECT_EQ(tiny.low, 0);
  EXPECT_GT(tiny.high, 0);
  EXPECT_LT(tiny.high, scale(-192));
}

// tan 15 = 2 - sqrt 3, tan 22.5 = sqrt 2 - 1, tan 18 = sqrt(1 - 2 / sqrt 5): by squaring alone.
TEST(EnclosureTest, TangentsThatAreRoots) {
  const auto square = [](const Rational& v) { return Rational(v * v); };
  for (const unsigned bits : widths) {
    if (bits < 40) continue;
    const Enclosure t15 = enclosed_tangent(15, bits), t22 = enclosed_tangent(Rational(45, 2), bits),
                    t18 = enclosed_tangent(18, bits);
    EXPECT_GT(square(2 - t15.low), 3);
    EXPECT_LT(square(2 - t15.high), 3);
    EXPECT_LT(square(1 + t22.low), 2);
    EXPECT_GT(square(1 + t22.high), 2);
    EXPECT_GT(square(1 - square(t18.low)) * 5, 4);
    EXPECT_LT(square(1 - square(t18.high)) * 5, 4);
  }
}

TEST(EnclosureTest, RootIsEnclosed) {
  EXPECT_EQ(enclosed_root(0, 64).low, 0);
  EXPECT_EQ(enclosed_root(0, 64).high, 0);
  std::mt19937_64 random = generator(311);
  std::vector<Rational> numbers{1, 2, 3, Rational(1, 3), scale(300), scale(-300), scale(301), scale(-301)};
  for (int i = 0; i < 500; ++i) numbers.push_back(magnitude(random_rational(random, 200)));
  for (int i = 0; i < 50; ++i) numbers.push_back(numbers[static_cast<std::size_t>(8 + i)] * scale(-2 * i - 301));
  for (const unsigned bits : {1u, 2u, 8u, 63u, 64u, 200u}) {
    for (const Rational& v : numbers) {
      const Enclosure r = enclosed_root(v, bits);
      ASSERT_GE(r.low, 0);
      ASSERT_LE(r.low * r.low, v) << v << ' ' << bits;
      ASSERT_GE(r.high * r.high, v) << v << ' ' << bits;
      // Of relative width: against the lower end, which is the stricter.
      ASSERT_LE(r.high - r.low, r.low * scale(1 - static_cast<long>(bits))) << v << ' ' << bits;
      const Rational above = root_above(v), slack = 1 + scale(-60);
      ASSERT_GE(above * above, v);
      ASSERT_LE(above * above, v * slack * slack) << v;
    }
  }
}

TEST(EnclosureTest, RootsOfSquareIntegersAreExact) {
  std::mt19937_64 random = generator(312);
  for (int i = 0; i < 500; ++i) {
    const Rational r = abs(biased_integer(random, 90));
    const Enclosure e = enclosed_root(r * r, 64);
    ASSERT_EQ(e.low, r);
    ASSERT_EQ(e.high, r);
  }
}

// An irrational number's best approximation is that of any rational close enough to it.
TEST(EnclosureTest, BestApproximationOfIrrationals) {
  std::mt19937_64 random = generator(313);
  const auto check = [](const std::function<Enclosure(unsigned)>& enclosed, const Rational& low, const Rational& high,
                        const Integer& Q) {
    Rational error = -1;
    const Rational u = best_approximation(enclosed, Q, error);
    ASSERT_EQ(u, best_approximation(low, Q));
    ASSERT_EQ(u, best_approximation(high, Q));
    // The truth lies between, far from u.
    ASSERT_GE(error, std::min(magnitude(u - low), magnitude(u - high)));
    ASSERT_LE(error, std::max(magnitude(u - low), magnitude(u - high)) + scale(16 - 192));
  };
  for (int i = 0; i < 100; ++i) {
    const Integer Q = abs(biased_integer(random, 100)) + 1;
    check(enclosed_pi, true_pi(MPFR_RNDD), true_pi(MPFR_RNDU), Q);
    const Rational a = Rational(45 * Integer(1 + (random() >> 24)), (Integer(1) << 40) + 3);
    check([&](unsigned bits) { return enclosed_tangent(a, bits); }, true_tangent(a, MPFR_RNDD),
          true_tangent(a, MPFR_RNDU), Q);
    const Rational v = between(random, 1, 1000) * 1000 + 2;  // never a square: they end in 0, 1, 4, 5, 6, 9
    check([&](unsigned bits) { return enclosed_root(v, bits); }, true_root(v, MPFR_RNDD), true_root(v, MPFR_RNDU), Q);
  }
}

// More bits than the first attempt takes.
TEST(EnclosureTest, BestApproximationAsksForMoreBits) {
  unsigned most = 0;
  const auto counted = [&](unsigned bits) {
    most = std::max(most, bits);
    return enclosed_root(2, bits);
  };
  Rational error;
  const Integer Q = power_of_2(150);
  const Rational u = best_approximation(counted, Q, error);
  EXPECT_GT(most, 192u);
  EXPECT_LE(denominator(u), Q);
  const Enclosure fine = enclosed_root(2, 2000);
  EXPECT_EQ(u, best_approximation(fine.low, Q));
  EXPECT_EQ(u, best_approximation(fine.high, Q));
  EXPECT_GE(error, magnitude(u - fine.low));
  EXPECT_GE(error, magnitude(u - fine.high));
}

}  // namespace
}  // namespace quoin::rounding::testing
