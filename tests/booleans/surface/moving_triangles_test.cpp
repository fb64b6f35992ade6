#include "booleans/surface/moving_triangles.h"

#include <gtest/gtest.h>

#include <cmath>

#include "booleans/surface/rational_triangles.h"
#include "tests/booleans/support.h"

namespace quoin::booleans::testing {
namespace {

using exact::Rational;
using Corners = std::array<std::array<double, 3>, 3>;

/// Small coordinates that often coincide, and a scale.
struct Numbers {
  Random& random;
  double scale;

  double operator()() { return scale * static_cast<double>(random.between(-6, 6)); }
  std::array<double, 3> point() { return {(*this)(), (*this)(), (*this)()}; }
};

/// Corners anywhere within the error: at its ends, or in between.
RationalTriangle somewhere(Random& random, const MovingTriangle& t) {
  RationalTriangle r = rational(t.at);
  const Rational error = exact::to_rational(t.error);
  for (RationalPoint& p : r)
    for (Rational& x : p) x += error * Rational(random.between(-2, 2), 2);
  return r;
}

/// Two triangles move alike where they share a corner.
void join(const MovingTriangle& t, const MovingTriangle& u, const RationalTriangle& a, RationalTriangle& b) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (t.place[i] == u.place[j]) b[j] = a[i];
}

double random_error(Random& random, double scale) {
  static constexpr std::array<double, 4> errors{0, 0x1p-40, 0x1p-8, 0.25};
  return scale * errors[random.below(4)];
}

// What is seen to part does so wherever the corners are, as rational arithmetic tells.
TEST(PartAllTheWay, HoldsWhereverTheCornersAre) {
  std::size_t seen = 0, unseen = 0;
  for (std::uint64_t number = 0; number < case_count(20000); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0x9A27, number);
    const double scale = std::ldexp(1, static_cast<int>(random.between(-30, 30)));
    Numbers next{random, scale};
    const auto shared = static_cast<std::uint32_t>(random.below(3));
    const double error = random_error(random, scale);
    MovingTriangle t{{0, 1, 2}, {next.point(), next.point(), next.point()}, error};
    MovingTriangle u{{3, 4, 5}, {next.point(), next.point(), next.point()}, error};
    for (std::uint32_t i = 0; i < shared; ++i) {
      u.place[2 - i] = t.place[i];
      u.at[2 - i] = t.at[i];
    }

    ASSERT_EQ(align(t, u), shared);
    if (!part_all_the_way(t, u, shared)) {
      ++unseen;
      continue;
    }
    ++seen;
    for (int i = 0; i < 4; ++i) {
      const RationalTriangle a = somewhere(random, t);
      RationalTriangle b = somewhere(random, u);
      join(t, u, a, b);
      // Triangles that have lost their area are another matter.
      const RationalPoint n = normal(a), m = normal(b), zero{0, 0, 0};
      if (n != zero && m != zero) ASSERT_FALSE(meet_out_of_place(a, b, shared));
    }
  }
  EXPECT_GT(seen, unseen / 4);
  EXPECT_GT(unseen, 0u);
}

TEST(Facing, HoldsWhereverTheCornersAre) {
  std::size_t seen = 0;
  for (std::uint64_t number = 0; number < case_count(5000); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0xFACE, number);
    const double scale = std::ldexp(1, static_cast<int>(random.between(-30, 30)));
    Numbers next{random, scale};
    const MovingTriangle t{{0, 1, 2}, {next.point(), next.point(), next.point()}, random_error(random, scale)};
    const unsigned directions = facing(t);
    for (int i = 0; i < 4; ++i) {
      const RationalPoint n = normal(somewhere(random, t));
      for (std::size_t k = 0; k < 3; ++k) {
        if ((directions >> (2 * k) & 1) != 0) ASSERT_GT(n[k], 0);
        if ((directions >> (2 * k + 1) & 1) != 0) ASSERT_LT(n[k], 0);
        seen += (directions >> (2 * k) & 3) != 0;
      }
    }
    // Without error all that is not zero is seen.
    if (t.error == 0) {
      const RationalPoint n = normal(rational(t.at));
      for (std::size_t k = 0; k < 3; ++k) ASSERT_EQ((directions >> (2 * k) & 3) != 0, n[k] != 0);
    }
  }
  EXPECT_GT(seen, 0u);
}

}  // namespace
}  // namespace quoin::booleans::testing
