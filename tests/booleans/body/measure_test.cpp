#include "booleans/body/measure.h"

#include <gtest/gtest.h>

#include "booleans/body/canonical.h"
#include "tests/booleans/support.h"

namespace quoin::booleans::testing {
namespace {

using exact::Rational;

// Volumes are additive; a solid and its complement in a box fill it.
TEST(Measure, VolumesAddUp) {
  for (std::uint64_t number = 0; number < case_count(150); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0x0E5, number);
    Solids solids(random, families[number % families.size()]);
    const Body a = solids.next(), b = solids.next();
    EXPECT_EQ(Rational(volume(any(a, b)) + volume(all(a, b))), Rational(volume(a) + volume(b)));
    EXPECT_EQ(volume(complement(a)), Rational(-volume(a)));
    EXPECT_EQ(volume(body_of(canonical(a))), volume(a));
  }
}

/// The second way: six times the volume of a closed raw mesh, triangle by triangle.
TEST(Measure, VolumeOfRawMeshes) {
  for (std::uint64_t number = 0; number < case_count(60); ++number) {
    Random random(0x0E6, number);
    Solids solids(random, families[number % families.size()]);
    const Body a = solids.raw();
    Rational six = 0;
    for (const Triangle& t : a.triangles) {
      std::array<std::array<Rational, 3>, 3> p;
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k) p[i][k] = a.grid_points[t[i]].c[k];
      six += p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) - p[0][1] * (p[1][0] * p[2][2] - p[1][2] * p[2][0]) +
             p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0]);
    }
    EXPECT_EQ(volume(a), Rational(six / 6));
  }
}

TEST(Measure, OfACube) {
  const Body cube = box({1, 2, 3}, {4, 6, 8});
  EXPECT_EQ(volume(cube), 60);
  EXPECT_EQ(approximate_area(cube), 94);
  EXPECT_EQ(approximate_area(body_of(canonical(cube))), 94);
  EXPECT_EQ(volume(half_space_body({{1, 1, 1}, -1}, {{0, 0, 0}}, {{1, 1, 1}})), Rational(1, 6));
}

// Against the exact volume; also of complements, whose volume is negative.
TEST(Measure, RoundedVolume) {
  for (const Family family : families)
    for (std::uint64_t number = 0; number < case_count(12); ++number) {
      SCOPED_TRACE(std::string(name_of(family)) + " " + case_name(number));
      Random random(0x40E, number);
      Solids solids(random, family);
      Body body = odd(solids.next(), solids.next());
      if (random.one_in(2)) body = complement(body);
      if (random.one_in(2)) body = body_of(canonical(body));
      const exact::Rational scale(1 + static_cast<std::int64_t>(random.below(1000)),
                                  1 + static_cast<std::int64_t>(random.below(1000)));
      ASSERT_EQ(rounded_volume(body, scale), exact::to_double(volume(body) * scale));
      const auto bits = [](const exact::Integer& v) { return v == 0 ? 0 : msb(abs(v)) + 1; };
      ASSERT_LE(bits(denominator(volume(body))), volume_bits(body) + 3);
      ASSERT_LE(bits(numerator(volume(body))), volume_bits(body) + 100);
    }
}

// An odd number above 2^53 lies in the middle of two doubles; the nearer one is not seen from near the number.
TEST(Measure, RoundedVolumeInTheMiddleOfTwoDoubles) {
  for (const std::int64_t width : {131073, 131075}) {
    const Body cuboid = body_of(canonical(box({0, 0, 0}, {262145, 262145, width})));
    ASSERT_GT(cuboid.polygon_count(), 0u);
    EXPECT_EQ(rounded_volume(cuboid, 1), exact::to_double(volume(cuboid)));
  }
  EXPECT_EQ(rounded_volume(Body(), 1), 0.0);
}

}  // namespace
}  // namespace quoin::booleans::testing
