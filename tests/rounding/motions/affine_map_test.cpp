#include "rounding/motions/affine_map.h"

#include <gtest/gtest.h>

#include "tests/rounding/motions/stated.h"

namespace quoin::rounding::testing {
namespace {

TEST(AffineMapTest, AffineMaps) {
  std::mt19937_64 random = generator(338);
  for (int i = 0; i < 200; ++i) {
    const AffineMap a{{random_vector(random, 10), random_vector(random, 10), random_vector(random, 10)},
                      random_vector(random, 10)},
        b{{random_vector(random, 10), random_vector(random, 10), random_vector(random, 10)}, random_vector(random, 10)};
    const Vector p = random_vector(random, 10);
    ASSERT_EQ(composed(a, b)(p), b(a(p)));
    ASSERT_EQ(determinant(composed(a, b).linear), determinant(a.linear) * determinant(b.linear));
    if (determinant(a.linear) == 0) continue;
    ASSERT_EQ(composed(a, inverse(a)), identity);
    ASSERT_EQ(composed(inverse(a), a), identity);
  }
  EXPECT_EQ(determinant({Vector{1, 2, 3}, Vector{4, 5, 6}, Vector{7, 8, 10}}), -3);
}

TEST(AffineMapTest, InversesInIntegers) {
  std::mt19937_64 random = generator(381);
  for (int i = 0; i < 200; ++i) {
    AffineMap map{{random_vector(random, 30), random_vector(random, 30), random_vector(random, 30)},
                  random_vector(random, 30)};
    if (below(random, 2) == 0) map.linear = matrix(random_quaternion(random, 60));
    if (determinant(map.linear) == 0) continue;
    const IntegerMap back = inverse(IntegerMap(map));
    ASSERT_GT(back.divisor, 0);
    const AffineMap expected = inverse(map);
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t c = 0; c < 3; ++c) ASSERT_EQ(Rational(back.linear[r][c], back.divisor), expected.linear[r][c]);
      ASSERT_EQ(Rational(back.shift[r], back.divisor), expected.shift[r]);
    }
  }
}

}  // namespace
}  // namespace quoin::rounding::testing
