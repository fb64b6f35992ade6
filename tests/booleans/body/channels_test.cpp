#include "booleans/body/channels.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/booleans/support.h"

namespace quoin::booleans {
namespace {

using exact::GridPoint;
using exact::Rational;
using testing::Random;

GridPoint random_point(Random& random, std::int64_t size) {
  GridPoint p{};
  for (auto& x : p.c) x = static_cast<std::int32_t>(random.between(-size, size));
  return p;
}

double random_value(Random& random) {
  const double value = static_cast<double>(random.between(-(std::int64_t{1} << 52), std::int64_t{1} << 52));
  return std::ldexp(value, static_cast<int>(random.between(-80, 20)));
}

/// One surface of two channels; a triangle of grid points up to `size`.
Channels random_channels(Random& random, std::int64_t size) {
  Channels channels;
  channels.count = 2;
  for (;;) {
    const auto seed = seed_of({random_point(random, size), random_point(random, size), random_point(random, size)});
    if (!seed) continue;
    channels.seeds.push_back(*seed);
    break;
  }
  for (int i = 0; i < 6; ++i) channels.values.push_back(random_value(random));
  return channels;
}

// The filter of grid points and the rationals of any points are one function, correctly rounded.
TEST(Channels, OfGridPointsAgreeWithRationals) {
  Random random(16, 1);
  for (int round = 0; round < 400; ++round) {
    const std::int64_t size = random.one_in(2) ? 20 : std::int64_t{1} << 29;
    const Channels channels = random_channels(random, size);
    for (int k = 0; k < 50; ++k) {
      const GridPoint p = random_point(random, size);
      std::array<double, 2> fast{}, slow{};
      channels.at(0, p, fast);
      channels.at(0, std::array<Rational, 3>{p.c[0], p.c[1], p.c[2]}, slow);
      ASSERT_EQ(fast, slow);
    }
  }
}

// In the corners of the seed they are the values that were given; along its sides they are affine.
TEST(Channels, HaveTheValuesOfTheirSeed) {
  Random random(16, 1);
  for (int round = 0; round < 200; ++round) {
    const Channels channels = random_channels(random, 1000);
    const auto& corners = channels.seeds[0].corners;
    for (std::size_t i = 0; i < 3; ++i) {
      std::array<double, 2> found{}, exact{};
      channels.at(0, corners[i], found);
      std::array<Rational, 3> place, middle;
      for (std::size_t k = 0; k < 3; ++k) {
        place[k] = corners[i].c[k];
        middle[k] = Rational(corners[i].c[k] + corners[(i + 1) % 3].c[k], 2);
      }
      channels.at(0, place, exact);
      EXPECT_EQ(found, exact);
      channels.at(0, middle, exact);
      for (std::size_t c = 0; c < 2; ++c) {
        const double a = channels.corner_values(0, i)[c], b = channels.corner_values(0, (i + 1) % 3)[c];
        EXPECT_EQ(found[c], a);
        EXPECT_EQ(exact[c], exact::to_double(Rational((exact::to_rational(a) + exact::to_rational(b)) / 2)));
      }
    }
  }
}

TEST(Channels, MapsOfPositionsCompose) {
  grid::Lattice lattice;
  lattice.step = Rational(3, 7);
  lattice.origin = {Rational(1), Rational(-2, 5), Rational(100)};
  EXPECT_TRUE(is_identity(composed(to_model(lattice), to_steps(lattice))));
  EXPECT_TRUE(is_identity(composed(to_steps(lattice), to_model(lattice))));
  EXPECT_FALSE(is_identity(to_model(lattice)));
}

}  // namespace
}  // namespace quoin::booleans
