#include "rounding/motions/map_filter.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/rounding/motions/stated.h"

namespace quoin::rounding::testing {
namespace {

TEST(MapFilterTest, FilteredImagesAreWithinTheirErrors) {
  std::mt19937_64 random = generator(380);
  int exact_ones = 0, narrow = 0;
  for (int i = 0; i < 3000; ++i) {
    const bool in_steps = below(random, 2) == 0;
    AffineMap map;
    // Rotations, integers, and anything from 2^-1100 to 2^1100.
    const auto kind = below(random, 3);
    const Rational size = below(random, 2) == 0 ? Rational(power_of_2(static_cast<unsigned>(below(random, 1100))))
                                                : Rational(1, power_of_2(static_cast<unsigned>(below(random, 1100))));
    if (kind == 0) map = {matrix(random_quaternion(random, 40)), random_vector(random, 29)};
    if (kind > 0)
      for (std::size_t k = 0; k < 3; ++k) {
        for (Rational& x : map.linear[k])
          x = kind == 1 ? Rational(between(random, -3, 3)) : size * random_rational(random);
        map.shift[k] = kind == 1 ? Rational(between(random, -1'000'000, 1'000'000)) : size * random_rational(random);
      }
    Vector p = random_vector(random, 200);
    if (in_steps)
      for (Rational& x : p) x = between(random, -(1 << 30), 1 << 30);
    const std::array doubles{exact::to_double(p[0]), exact::to_double(p[1]), exact::to_double(p[2])};
    const MapFilter filter(map);
    const Vector image = map(p);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [value, error] = filter(k, doubles, in_steps);
      if (!std::isfinite(value) || !std::isfinite(error)) {
        EXPECT_FALSE(std::isfinite(error));
        continue;
      }
      ASSERT_LE(magnitude(exact::to_rational(value) - image[k]), exact::to_rational(error)) << i << ' ' << k;
      exact_ones += error == 0 ? 1 : 0;
      narrow += kind == 0 && in_steps && error < 0x1p-17 ? 1 : 0;
    }
  }
  EXPECT_GT(exact_ones, 500);
  EXPECT_GT(narrow, 500);
}

// A row of integers whose image of an integer is no double: (2^30 + 1) (2^29 - 1) has 59 bits.
TEST(MapFilterTest, LongIntegersHaveErrors) {
  AffineMap map;
  map.linear[0][0] = Integer(power_of_2(30) + 1);
  map.shift[0] = Integer(-power_of_2(59));
  const auto [value, error] = MapFilter(map)(0, {0x1p29 - 1, 0, 0}, true);
  EXPECT_EQ(value, -0x1p29);
  EXPECT_EQ(map({Integer(power_of_2(29) - 1), 0, 0})[0], Rational(-power_of_2(29) - 1));
  EXPECT_GE(error, 1);
}

}  // namespace
}  // namespace quoin::rounding::testing
