#include "exact/lowest_terms.h"

#include <gtest/gtest.h>

#include <array>

#include "tests/exact/support.h"

namespace quoin::exact::testing {
namespace {

Integer to_integer(uint128 v) {
  return (Integer(static_cast<std::uint64_t>(v >> 64)) << 64) + Integer(static_cast<std::uint64_t>(v));
}

uint128 random_number(std::mt19937_64& random) {
  const uint128 all = uint128(random()) << 64 | random();
  return all >> below(random, 128);
}

TEST(LowestTerms, GreatestCommonDivisorAsGmpHasIt) {
  auto random = generator(1);
  for (int round = 0; round < 100000; ++round) {
    const uint128 common = random_number(random) >> below(random, 128);
    const uint128 a = below(random, 2) ? random_number(random) : common * (random() >> below(random, 64));
    const uint128 b = below(random, 2) ? random_number(random) : common * (random() >> below(random, 64));
    ASSERT_EQ(to_integer(gcd(a, b)), Integer(gcd(to_integer(a), to_integer(b))));
  }
  EXPECT_TRUE(gcd(0, 0) == 0 && gcd(0, 6) == 6 && gcd(6, 0) == 6);
  const uint128 top = uint128(1) << 127;
  EXPECT_TRUE(gcd(top, top) == top && gcd(top, 1) == 1 && gcd(~uint128(0), ~uint128(0)) == ~uint128(0));
}

/// Numbers of either length, mostly with a common divisor.
std::array<Integer, 4> random_numbers(std::mt19937_64& random) {
  const unsigned size = below(random, 2) ? 120 : 188;
  const unsigned common = static_cast<unsigned>(below(random, 60));
  Integer factor = abs(biased_integer(random, common + 1));
  if (factor == 0) factor = 1;
  std::array<Integer, 4> x;
  for (Integer& v : x) v = biased_integer(random, size - common - 1) * factor;
  x[3] = abs(x[3]) + (x[3] == 0 ? factor : Integer(0));
  return x;
}

Point point_of(const std::array<Integer, 4>& x) {
  Point p{};
  for (std::size_t k = 0; k < 3; ++k) p.x[k] = *to_int<Numerator::bits>(x[k]);
  p.w = *to_int<Denominator::bits>(x[3]);
  return p;
}

TEST(LowestTerms, PointsAsGmpReducesThem) {
  auto random = generator(2);
  for (int round = 0; round < 20000; ++round) {
    const std::array<Integer, 4> x = random_numbers(random);
    const std::array<Integer, 4> least = primitive(x);
    const Point p = point_of(x), r = reduced(p);
    for (std::size_t k = 0; k < 3; ++k) ASSERT_EQ(exact::to_integer(r.x[k]), least[k]);
    ASSERT_EQ(exact::to_integer(r.w), least[3]);
    ASSERT_EQ(is_reduced(p), x == least);
    ASSERT_TRUE(is_reduced(r));
  }
}

}  // namespace
}  // namespace quoin::exact::testing
