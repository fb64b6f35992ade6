#include "rounding/planes/noisy_plane.h"

#include <gtest/gtest.h>

#include "tests/booleans/support.h"

namespace quoin::rounding {
namespace {

using booleans::testing::case_name;
using booleans::testing::Random;
using Normal = std::array<Integer, 3>;

Normal normal_of(const exact::Plane& p) { return {p.n[0], p.n[1], p.n[2]}; }

Integer random_integer(Random& random, unsigned bits) {
  Integer v = 0;
  for (unsigned i = 0; i < bits; i += 32) v = (v << 32u) + random.below(std::uint64_t{1} << 32);
  return random.one_in(2) ? v : Integer(-v);
}

WidePlane random_plane(Random& random) {
  const unsigned bits = 32 * static_cast<unsigned>(random.between(2, 6));
  return wide_plane({random_integer(random, bits), random_integer(random, bits), random_integer(random, bits)},
                    Rational(random_integer(random, bits + 32), random.between(1, 1000)));
}

// R1, R2 and R3 of plane rounding.
TEST(NoisyPlane, LawsOfRounding) {
  const PlaneRounder rounder;
  for (std::uint64_t n = 0; n < 200; ++n) {
    SCOPED_TRACE(case_name(n));
    Random random(0x9015E, n);
    const WidePlane p = random_plane(random);
    const auto rounded = plane_from_noise(p), opposite = plane_from_noise(p.opposite());
    ASSERT_TRUE(rounded && opposite);
    EXPECT_EQ(rounded->opposite(), *opposite);
    if (rounder.fits(p)) {
      EXPECT_EQ(*rounded, *rounder.round(p, Method::best));
    }

    const WidePlane parallel = wide_plane({p.n[0], p.n[1], p.n[2]}, Rational(p.d) / 7 + random.between(1, 1000));
    const auto beside = plane_from_noise(parallel);
    ASSERT_TRUE(beside);
    EXPECT_EQ(primitive(normal_of(*beside)), primitive(normal_of(*rounded)));
  }
}

// Small directions with an error in the 51st binary place, and offsets that fit.
TEST(NoisyPlane, NoiseIsTakenAway) {
  for (std::uint64_t n = 0; n < 1000; ++n) {
    SCOPED_TRACE(case_name(n));
    Random random(0x9015F, n);
    Normal clean;
    const std::int64_t most = random.one_in(2) ? 3 : 1000;
    do
      for (Integer& x : clean) x = random.between(-most, most);
    while (clean == Normal{0, 0, 0});
    clean = primitive(clean);

    const Integer top = abs(clean[exact::longest_component(clean)]);
    Vector noisy;
    for (std::size_t k = 0; k < 3; ++k)
      noisy[k] = clean[k] + Rational(top * random.between(-1000000, 1000000), Integer(1000003) << 51u);
    const auto rounded = plane_from_noise(wide_plane(noisy, random.between(-1000, 1000) * top));
    ASSERT_TRUE(rounded);
    EXPECT_EQ(primitive(normal_of(*rounded)), clean);
  }
}

// The second way: where the given plane meets the edges of the box, the distance from the rounded one, exactly.
TEST(NoisyPlane, DistancesAreBounded) {
  const Vector low{-1000, -70, 3}, high{500, 800, 4000};
  for (std::uint64_t n = 0; n < 200; ++n) {
    SCOPED_TRACE(case_name(n));
    Random random(0x90160, n);
    WidePlane p = random_plane(random);
    // Through a point of the box.
    p = wide_plane({p.n[0], p.n[1], p.n[2]}, -Rational(value({p.n, 0}, {1, 2, random.between(3, 4000)})));
    const auto rounded = plane_from_noise(p);
    ASSERT_TRUE(rounded);
    const Rational bound = distance_within(p, *rounded, low, high);

    std::vector<Vector> points;
    for (std::size_t k = 0; k < 3; ++k)
      for (int corner = 0; corner < 4; ++corner) {
        Vector x{0, 0, 0};
        x[(k + 1) % 3] = (corner & 1 ? low : high)[(k + 1) % 3];
        x[(k + 2) % 3] = (corner & 2 ? low : high)[(k + 2) % 3];
        if (p.n[k] == 0) continue;
        x[k] = -value(p, x) / p.n[k];
        if (x[k] >= low[k] && x[k] <= high[k]) points.push_back(x);
      }
    EXPECT_FALSE(points.empty());
    EXPECT_LE(squared_displacement(*rounded, points), bound * bound);
    if (PlaneRounder().fits(p)) {
      EXPECT_EQ(bound, 0);
    }
  }
}

TEST(NoisyPlane, TooFarAway) { EXPECT_FALSE(plane_from_noise(wide_plane({1, 0, 0}, Rational(Integer(1) << 125u)))); }

}  // namespace
}  // namespace quoin::rounding
