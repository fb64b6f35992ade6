#include "booleans/body/box.h"

#include <gtest/gtest.h>

#include "exact/rational.h"
#include "tests/booleans/support.h"

namespace quoin::booleans::testing {
namespace {

/// (whole w + off) / w: at or beside a whole number, nearer than doubles tell.
exact::Point beside(const std::array<std::int64_t, 3>& whole, const std::array<std::int64_t, 3>& off, std::int64_t w) {
  exact::Point p;
  p.w = exact::Denominator(w);
  for (std::size_t k = 0; k < 3; ++k) {
    p.x[k] = exact::Numerator(exact::int128(whole[k]) * w + off[k]);
    p.approximation[k] = exact::rounded_quotient(p.x[k], p.w);
  }
  return p;
}

// Against rationals. Many points round to whole coordinates on the far side of which they lie.
TEST(Box, HoldsPointsThatRoundToWholeNumbers) {
  std::size_t beyond = 0;  // coordinates that the box of rounded ones does not hold
  for (std::uint64_t number = 0; number < case_count(2000); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0xB0C5, number);
    std::array<std::int64_t, 3> whole{}, off{};
    for (std::size_t k = 0; k < 3; ++k) {
      whole[k] = random.between(-exact::world, exact::world);
      off[k] = random.between(-2, 2);
    }
    const std::int64_t w = std::int64_t{1} << random.between(1, 60);
    const exact::Point p = beside(whole, off, w);

    Box box, rounded;
    box.add_around(p.approximation);
    rounded.add(p.approximation);
    for (std::size_t k = 0; k < 3; ++k) {
      const exact::Rational x = exact::Rational(whole[k]) + exact::Rational(off[k], w);
      EXPECT_LE(box.low[k], x);
      EXPECT_GE(box.high[k], x);
      EXPECT_LE(box.high[k] - box.low[k], 2);
      beyond += x < rounded.low[k] || x > rounded.high[k];
    }
  }
  EXPECT_GT(beyond, case_count(2000));
}

}  // namespace
}  // namespace quoin::booleans::testing
