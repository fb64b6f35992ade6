#include "booleans/classify/interval.h"

#include <gtest/gtest.h>

#include "exact/rational.h"
#include "tests/booleans/support.h"

namespace quoin::booleans::testing {
namespace {

using exact::Rational;

bool holds(const Interval& i, const Rational& x) {
  return exact::to_rational(i.low) <= x && x <= exact::to_rational(i.high);
}

/// Any number, whole ones among them.
double any_number(Random& random) {
  const double x = static_cast<double>(random.between(-1'000'000'000'000, 1'000'000'000'000));
  return random.one_in(3) ? x : x / static_cast<double>(random.between(1, 1'000'000));
}

// Operations on numbers of two intervals against rationals: the result is held, and the bounds are close to it.
TEST(Interval, HoldsWhatIsExact) {
  for (std::uint64_t number = 0; number < case_count(2000); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0x1A7E, number);
    const auto any = [&] {
      const double x = any_number(random), y = random.one_in(2) ? x : any_number(random);
      return Interval(std::min(x, y), std::max(x, y));
    };
    const Interval a = any(), b = any();
    for (const double x : {a.low, a.high})
      for (const double y : {b.low, b.high}) {
        const Rational p = exact::to_rational(x), q = exact::to_rational(y);
        EXPECT_TRUE(holds(a + b, p + q));
        EXPECT_TRUE(holds(a - b, p - q));
        EXPECT_TRUE(holds(a * b, p * q));
        EXPECT_TRUE(holds(-a, -p));
        if (b.low > 0) {
          EXPECT_TRUE(holds(a / b, p / q));
        }
      }

    const double sum = a.low + b.low;
    const Interval lows = Interval(a.low) + Interval(b.low);
    EXPECT_EQ(lows.low, std::nextafter(sum, -HUGE_VAL));
    EXPECT_EQ(lows.high, std::nextafter(sum, HUGE_VAL));
  }
}

// A third is not a double: it lies strictly between the bounds, which are no farther apart than they must be.
TEST(Interval, AThird) {
  const Interval third = Interval(1) / Interval(3);
  EXPECT_LT(exact::to_rational(third.low), Rational(1, 3));
  EXPECT_GT(exact::to_rational(third.high), Rational(1, 3));
  EXPECT_EQ(std::nextafter(std::nextafter(third.low, 1), 1), third.high);
  EXPECT_TRUE(holds(Interval::around(1.0 / 3), Rational(1, 3)));
}

}  // namespace
}  // namespace quoin::booleans::testing
