#include "grid/common_lattice.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/booleans/support.h"

namespace quoin::grid {
namespace {

using booleans::testing::case_name;
using booleans::testing::Random;
using exact::Rational;

Rational power(int e) {
  return e < 0 ? Rational(1) / Rational(exact::Integer(1) << -e) : Rational(exact::Integer(1) << e);
}

Lattice random_lattice(Random& random) {
  static constexpr std::array<int, 4> factors{1, 1, 125, 3};
  Lattice lattice;
  lattice.step = power(static_cast<int>(random.between(-30, 10))) / factors[random.below(4)];
  if (random.one_in(2))
    for (auto& x : lattice.origin) x = lattice.step * random.between(-1000000, 1000000);
  return lattice;
}

ModelBox random_box(Random& random) {
  ModelBox box;
  for (int i = 0; i < 2; ++i) {
    std::array<Rational, 3> p;
    for (auto& x : p)
      x = Rational(random.between(-1000000, 1000000)) * power(static_cast<int>(random.between(-20, 20)));
    box.add(p);
  }
  return box;
}

// Boxes and lattices of all sizes.
TEST(CommonLattice, CandidatesHoldTheBoxInAnyOrderOfTheGiven) {
  for (std::uint64_t n = 0; n < 200; ++n) {
    SCOPED_TRACE(case_name(n));
    Random random(0xC0117, n);
    std::vector<Lattice> own;
    for (std::uint64_t i = 0; i <= random.below(4); ++i) own.push_back(random_lattice(random));
    std::vector<Lattice> turned(own.rbegin(), own.rend());
    turned.push_back(own[0]);
    const ModelBox box = random_box(random);
    sort_distinct(own);
    sort_distinct(turned);
    EXPECT_EQ(own, turned);
    EXPECT_TRUE(std::is_sorted(own.begin(), own.end(), finer));

    const auto between = lattices_between(own, box);
    EXPECT_FALSE(between.empty());
    EXPECT_TRUE(std::is_sorted(between.begin(), between.end(), finer));
    for (const Lattice& lattice : between) {
      EXPECT_TRUE(in_world(lattice, box));
      // Whole steps from the coarsest, and each given step and origin is whole multiples of one part of it.
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_EQ(denominator(Rational((lattice.origin[k] - own.back().origin[k]) / lattice.step)), 1);
    }
  }
}

// A vertex moves by half the diagonal of a cell at most: below 7/8 of a step.
TEST(CommonLattice, RoundingLosesLessThanItSays) {
  for (std::uint64_t n = 0; n < 200; ++n) {
    SCOPED_TRACE(case_name(n));
    Random random(0x20117, n);
    std::vector<Lattice> own{random_lattice(random), random_lattice(random)};
    sort_distinct(own);
    const ModelBox box = random_box(random);
    const Lattice lattice = rounding_lattice(own, box);
    EXPECT_TRUE(in_world(lattice, box));
    EXPECT_LT(lattice.step * Rational(7, 8) * power(28), box.size());
    // A power of two of the coarsest.
    const Rational ratio = lattice.step / own.back().step;
    EXPECT_TRUE(numerator(ratio) == 1 || denominator(ratio) == 1);
    EXPECT_EQ(msb(numerator(ratio)), lsb(numerator(ratio)));
    EXPECT_EQ(msb(denominator(ratio)), lsb(denominator(ratio)));
  }
}

// Unit cubes at 0 and at 2^31, with steps 2^-26 and origins of their own.
TEST(CommonLattice, KnownPair) {
  const Rational far = power(31);
  std::vector<Lattice> own{{power(-26), {far, 0, 0}}, {power(-26), {0, 0, 0}}};
  sort_distinct(own);
  EXPECT_EQ(own[0].origin[0], 0);
  ModelBox box;
  box.add(std::array<Rational, 3>{0, 0, 0});
  box.add(std::array<Rational, 3>{far + 1, 1, 1});
  // Half of 2^31 + 1 is more than 2^29 steps of 2, so the step is 4, about 2^31, the origin of the last given one; the
  // least multiple of 2^-26 at which half the box and half a step fit is finer.
  const auto between = lattices_between(own, box);
  ASSERT_EQ(between.size(), 3u);
  EXPECT_EQ(between[0].step, power(-26) * 134217729);
  EXPECT_EQ(between[1].step, 4);
  EXPECT_EQ(between[2].step, 8);
  EXPECT_EQ(rounding_lattice(own, box).step, 8);
}

}  // namespace
}  // namespace quoin::grid
