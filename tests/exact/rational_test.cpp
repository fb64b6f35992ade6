#include "exact/rational.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "tests/exact/support.h"

namespace quoin::exact::testing {
namespace {

TEST(RationalTest, ParsesDecimalsAndQuotientsExactly) {
  const std::pair<const char*, Rational> good[] = {
      {"0", 0},
      {"-0", 0},
      {"7", 7},
      {"+7", 7},
      {"007", 7},
      {"010", 10},  // not octal
      {"-12.50", Rational(-25, 2)},
      {".5", Rational(1, 2)},
      {"5.", 5},
      {"0.1", Rational(1, 10)},
      {"0.08", Rational(2, 25)},
      {"-1.25e-3", Rational(-1, 800)},
      {"1E3", 1000},
      {"1e+3", 1000},
      {"1.5e1", 15},
      {"00.00e7", 0},
      {"1/3", Rational(1, 3)},
      {"-4/6", Rational(-2, 3)},
      {"4/-6", Rational(-2, 3)},
      {"0.5/0.25", 2},
      {"1e2/1e-2", 10000},
      {"123456789012345678901234567890/2", Rational(Integer("61728394506172839450617283945"))},
      {"1e400", Rational(pow(Integer(10), 400))},
      {"1e-400", Rational(1) / pow(Integer(10), 400)},
      // Up to 18 digits and more, with and without a sign.
      {"6/4", Rational(3, 2)},
      {"0/7", 0},
      {"+6/-4", Rational(-3, 2)},
      {"007/14", Rational(1, 2)},
      {"999999999999999999/3", Integer("333333333333333333")},
      {"3000000000000000000/4000000000000000000", Rational(3, 4)},
  };
  for (const auto& [text, value] : good) {
    const auto parsed = parse_rational(text);
    ASSERT_TRUE(parsed.has_value()) << text;
    EXPECT_EQ(*parsed, value) << text;
    EXPECT_EQ(to_string(*parsed), to_string(value)) << text;  // reduced, so the texts agree as well
  }
}

TEST(RationalTest, RefusesEveryOtherText) {
  for (const char* text : {"",    " ",     "+",     "-",    ".",     "-.",    "e5",     ".e5",
                           "1e",  "1e+",   "1e5.0", "1e5x", "1 ",    " 1",    "1x",     "0x10",
                           "1,5", "--1",   "+-1",   "1..2", "1.2.3", "1/",    "/1",     "/",
                           "1/0", "1/0.0", "0/0",   "1//2", "1/2/3", "1e401", "1e-401", "1e99999999999999999999",
                           "nan", "inf",   "-inf",  "NaN",  "1'000", "1_000"})
    EXPECT_FALSE(parse_rational(text).has_value()) << text;
  EXPECT_FALSE(parse_rational(std::string_view("1\0", 2)).has_value());
  EXPECT_TRUE(parse_rational(std::string(4000, '9')).has_value());
  EXPECT_FALSE(parse_rational(std::string(4001, '9')).has_value());
}

TEST(RationalTest, TextRoundTrips) {
  std::mt19937_64 random = generator(200);
  for (int i = 0; i < 2000; ++i) {
    const Rational v(biased_integer(random, 300), 1 + abs(biased_integer(random, 300)));
    const auto back = parse_rational(to_string(v));
    ASSERT_TRUE(back.has_value()) << v;
    ASSERT_EQ(*back, v);
    ASSERT_EQ(gcd(numerator(*back), denominator(*back)), 1);
    ASSERT_GT(denominator(*back), 0);
  }
}

TEST(RationalTest, DoublesAreRationals) {
  EXPECT_EQ(to_rational(0.0), 0);
  EXPECT_EQ(to_rational(-0.0), 0);
  EXPECT_EQ(to_rational(0.375), Rational(3, 8));
  EXPECT_EQ(to_rational(-0x1p100), -Rational(Integer(1) << 100));
  EXPECT_EQ(to_rational(0.1), Rational(Integer("3602879701896397"), Integer(1) << 55));
  EXPECT_EQ(to_rational(0x1p-1074), Rational(1, Integer(1) << 1074));
  EXPECT_EQ(to_rational(0x1.fffffffffffffp1023), Rational((Integer(1) << 1024) - (Integer(1) << 971)));
}

/// A random finite double of any exponent, subnormals included.
double random_double(std::mt19937_64& random) {
  const double m = static_cast<double>(between(random, -(std::int64_t{1} << 53), std::int64_t{1} << 53));
  return std::ldexp(m, static_cast<int>(between(random, -1130, 970)));
}

TEST(RationalTest, ToDoubleInvertsToRational) {
  std::mt19937_64 random = generator(201);
  for (int i = 0; i < 20000; ++i) {
    const double v = random_double(random);
    ASSERT_EQ(to_double(to_rational(v)), v);
    const float f = static_cast<float>(std::ldexp(v, static_cast<int>(below(random, 400)) - 200));
    if (std::isfinite(f)) {
      ASSERT_EQ(to_float(to_rational(f)), f);
    }
  }
}

/// Long-hand: between neighbours, the nearer one wins, and at the middle the even one, which is the one whose neighbour
/// on the other side is an even number of steps away: its last bit is 0.
template <class Float, class Round>
void check_between_neighbours(double low, const Round& round) {
  const Float a = static_cast<Float>(low), b = std::nextafter(a, std::numeric_limits<Float>::infinity());
  if (!std::isfinite(a) || !std::isfinite(b)) return;
  const Rational ra = to_rational(a), rb = to_rational(b), middle = (ra + rb) / 2,
                 tiny = (rb - ra) / (Integer(1) << 200);
  ASSERT_LT(ra, rb);
  int e = 0;
  const Float scaled = std::ldexp(std::frexp(a, &e), std::numeric_limits<Float>::digits);
  const bool subnormal = std::fabs(a) < std::numeric_limits<Float>::min();
  const Float steps = subnormal ? a / std::numeric_limits<Float>::denorm_min() : scaled;
  const bool a_even = std::fmod(steps, Float(2)) == 0;
  ASSERT_EQ(round(ra), a);
  ASSERT_EQ(round(ra + tiny), a);
  ASSERT_EQ(round(middle - tiny), a);
  ASSERT_EQ(round(middle), a_even ? a : b) << a;
  ASSERT_EQ(round(middle + tiny), b);
  ASSERT_EQ(round(rb - tiny), b);
}

TEST(RationalTest, RoundsToNearestTiesToEven) {
  std::mt19937_64 random = generator(202);
  const auto as_double = [](const Rational& v) { return to_double(v); };
  const auto as_float = [](const Rational& v) { return to_float(v); };
  for (int i = 0; i < 5000; ++i) {
    const double v = random_double(random);
    check_between_neighbours<double>(v, as_double);
    check_between_neighbours<double>(std::ldexp(v, -1000), as_double);
    check_between_neighbours<float>(
        std::ldexp(1.0 + static_cast<double>(random() >> 11) * 0x1p-53, static_cast<int>(between(random, -155, 126))),
        as_float);
  }
  for (const double v :
       {1.0, 0x1.fffffffffffffp0, -1.0, 0x1p-1022, 0x0.fffffffffffffp-1022, 0x1p-1074, 0.0, -0x1p-1074})
    check_between_neighbours<double>(v, as_double);
}

TEST(RationalTest, RoundsPastTheRangeToInfinity) {
  const double most = std::numeric_limits<double>::max(), infinity = std::numeric_limits<double>::infinity();
  const Rational step(Integer(1) << 971), top = to_rational(most);
  EXPECT_EQ(to_double(top + step / 2 - 1), most);
  EXPECT_EQ(to_double(top + step / 2), infinity);
  EXPECT_EQ(to_double(-top - step / 2), -infinity);
  EXPECT_EQ(to_double(Rational(Integer(1) << 5000)), infinity);
  EXPECT_EQ(to_double(Rational(1, Integer(1) << 5000)), 0.0);
  EXPECT_EQ(to_double(Rational(1, Integer(1) << 1075)), 0.0);  // a tie of 0 and the smallest double
  EXPECT_EQ(to_double(Rational(3, Integer(1) << 1076)), 0x1p-1074);
  const float most_float = std::numeric_limits<float>::max();
  EXPECT_EQ(to_float(to_rational(most_float) + (Integer(1) << 103) - 1), most_float);
  EXPECT_EQ(to_float(to_rational(most_float) + (Integer(1) << 103)), std::numeric_limits<float>::infinity());
  EXPECT_EQ(to_float(to_rational(1e30) * to_rational(-1e30)), -std::numeric_limits<float>::infinity());
  // Rounding to double first would land on a tie of floats and go the wrong way.
  EXPECT_EQ(to_float(1 + Rational(1, 1 << 24) + Rational(1, Integer(1) << 80)), 1 + 0x1p-23f);
}

template <int Bits>
void check_round_trip(std::mt19937_64& random) {
  const Integer limit = Integer(1) << (Bits - 1);
  for (int i = 0; i < 500; ++i) {
    const Integer v = biased_integer(random, Bits - 1);
    const auto n = to_int<Bits>(v);
    ASSERT_TRUE(n.has_value()) << v;
    ASSERT_EQ(to_integer(*n), v);
    ASSERT_EQ(n->sign(), sign_of(v));
  }
  for (const Integer& v : {Integer(limit - 1), Integer(1 - limit), Integer(0)}) {
    const auto n = to_int<Bits>(v);
    ASSERT_TRUE(n.has_value());
    ASSERT_EQ(to_integer(*n), v);
  }
  for (const Integer& v : {limit, Integer(-limit), Integer(limit + 1), Integer(limit << 64), Integer(-(limit << 1000))})
    ASSERT_FALSE(to_int<Bits>(v).has_value()) << v;
}

TEST(RationalTest, IntegersRoundTripThroughEveryWidth) {
  std::mt19937_64 random = generator(203);
  check_round_trip<2>(random);
  check_round_trip<33>(random);
  check_round_trip<34>(random);
  check_round_trip<63>(random);
  check_round_trip<64>(random);
  check_round_trip<65>(random);
  check_round_trip<125>(random);
  check_round_trip<128>(random);
  check_round_trip<189>(random);
  check_round_trip<251>(random);
  check_round_trip<315>(random);
  check_round_trip<440>(random);
  check_round_trip<691>(random);
}

TEST(RationalTest, BuiltInIntegersConvert) {
  const int128 most = static_cast<int128>(~uint128{0} >> 1);
  EXPECT_EQ(to_integer(int128(0)), 0);
  EXPECT_EQ(to_integer(int128(-1)), -1);
  EXPECT_EQ(to_integer(most), (Integer(1) << 127) - 1);
  EXPECT_EQ(to_integer(-most - 1), -(Integer(1) << 127));
  EXPECT_EQ(to_integer(int128(INT64_MIN)), -(Integer(1) << 63));
  EXPECT_EQ(to_integer(int128(UINT64_MAX)), (Integer(1) << 64) - 1);
}

TEST(RationalTest, CoordinatesOfPoints) {
  const Point u = point({{-3, 0, 1 << 29}});
  EXPECT_EQ(coordinate(u, 0), -3);
  EXPECT_EQ(coordinate(u, 1), 0);
  EXPECT_EQ(coordinate(u, 2), Integer(1) << 29);
  const auto v = meet(Plane{{3, 0, 0}, -1}, Plane{{0, -6, 0}, -4}, Plane{{0, 0, 1}, 5});
  ASSERT_TRUE(v.has_value());
  EXPECT_EQ(coordinate(*v, 0), Rational(1, 3));
  EXPECT_EQ(coordinate(*v, 1), Rational(-2, 3));
  EXPECT_EQ(coordinate(*v, 2), -5);
  EXPECT_EQ(to_string(coordinate(*v, 1)), "-2/3");
}

TEST(RationalTest, CommonDenominators) {
  const std::array v{Rational(1, 6), Rational(-3, 4), Rational(0), Rational(5)};
  EXPECT_EQ(over_common_denominator(v).denominator, 12);
  EXPECT_EQ(over_common_denominator(v).numerators, (std::array<Integer, 4>{2, -9, 0, 60}));
  EXPECT_EQ(over_common_denominator(std::array{Rational(-7), Rational(0)}).denominator, 1);
  EXPECT_EQ(primitive(std::array{Rational(-1, 6), Rational(3, 4), Rational(-5)}), (std::array<Integer, 3>{-2, 9, -60}));
  EXPECT_FALSE(are_whole(v));
  EXPECT_TRUE(are_whole(std::array{Rational(-7), Rational(0)}));
  EXPECT_EQ(primitive(std::array<Integer, 4>{-4, 18, 0, -120}), (std::array<Integer, 4>{-2, 9, 0, -60}));
  EXPECT_EQ(primitive(std::array<Integer, 2>{0, -5}), (std::array<Integer, 2>{0, -1}));
}

}  // namespace
}  // namespace quoin::exact::testing
