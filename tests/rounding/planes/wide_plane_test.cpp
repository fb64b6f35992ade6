#include "rounding/planes/wide_plane.h"

#include <gtest/gtest.h>

#include <array>

#include "tests/rounding/planes/planes.h"

namespace quoin::rounding::testing {
namespace {

TEST(WidePlaneTest, WidePlanesAreInLowestTerms) {
  EXPECT_EQ(wide_plane({Rational(16, 5), Rational(9, 2), Rational(123, 10)}, 30), plane(32, 45, 123, 300));
  EXPECT_EQ(wide_plane({-2, 4, 0}, 6), plane(-1, 2, 0, 3));
  EXPECT_EQ(wide_plane({0, 0, Rational(1, 7)}, 0), plane(0, 0, 1, 0));
  EXPECT_TRUE(is_canonical(plane(1, -5, 0, 0)));
  EXPECT_TRUE(is_canonical(plane(0, 1, -1, 0)));
  EXPECT_TRUE(is_canonical(plane(0, 0, 1, -1)));
  EXPECT_FALSE(is_canonical(plane(-1, 5, 5, 5)));
  EXPECT_FALSE(is_canonical(plane(0, -1, 5, 5)));
  EXPECT_FALSE(is_canonical(plane(0, 0, -1, 5)));
  std::mt19937_64 random = generator(350);
  for (int i = 0; i < 500; ++i) {
    const Vector n = random_direction(random, 50);
    const Rational d = random_rational(random), factor = magnitude(random_rational(random)) + Rational(1, 3);
    const WidePlane p = wide_plane(n, d);
    ASSERT_EQ(gcd(content(p.n), p.d), 1);
    ASSERT_EQ(wide_plane(factor * n, factor * d), p);
    ASSERT_EQ(wide_plane(-factor * n, -factor * d), p.opposite());
    ASSERT_NE(is_canonical(p), is_canonical(p.opposite()));
    const Vector u = random_vector(random, 20);
    ASSERT_EQ(sign_of(value(p, u)), sign_of(Rational(dot(n, u) + d)));
  }
}

// The plane moves with its points, sides included.
TEST(WidePlaneTest, MovedCarriesPointsAlong) {
  std::mt19937_64 random = generator(359);
  for (int i = 0; i < 200; ++i) {
    const AffineMap map{{random_vector(random, 20), random_vector(random, 20), random_vector(random, 20)},
                        random_vector(random, 20)};
    if (determinant(map.linear) == 0) continue;
    const Vector n = random_direction(random, 20), p = random_vector(random, 20), u = random_vector(random, 20);
    const WidePlane before = wide_plane(n, -dot(n, p));
    ASSERT_EQ(value(before, p), 0);
    const WidePlane after = moved(before, inverse(map));
    ASSERT_EQ(value(after, map(p)), 0);
    ASSERT_EQ(sign_of(value(after, map(u))), sign_of(value(before, u)));
    ASSERT_EQ(moved(after, map), before);
    ASSERT_EQ(moved(before.opposite(), inverse(map)), after.opposite());
    // A translation alone: e = d + a x + b y + c z for the plane that is carried there.
    const Vector by{between(random, -9, 9), between(random, -9, 9), between(random, -9, 9)};
    const WidePlane shifted = moved(before, {AffineMap{}.linear, by});
    ASSERT_EQ(shifted.n, before.n);
    ASSERT_EQ(Rational(shifted.d), before.d + before.n[0] * by[0] + before.n[1] * by[1] + before.n[2] * by[2]);
  }
}

}  // namespace
}  // namespace quoin::rounding::testing
