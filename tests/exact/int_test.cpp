#include "exact/int.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstring>
#include <type_traits>
#include <utility>
#include <vector>

#include "tests/exact/support.h"

namespace quoin::exact::testing {
namespace {

using Big = boost::multiprecision::cpp_int;

static_assert(std::is_trivially_copyable_v<Int<691>>);
static_assert(std::is_same_v<decltype(Int<63>() * Int<125>()), Int<187>>);
static_assert(std::is_same_v<decltype(Int<63>() + Int<125>()), Int<126>>);
static_assert(std::is_same_v<decltype(Int<125>() - Int<63>()), Int<126>>);

/// The limbs read as two's complement: what the number is, without any operation of Int.
template <int Bits>
Big to_big(const Int<Bits>& v) {
  Big r = 0;
  for (int i = Int<Bits>::words - 1; i >= 0; --i) r = (r << 64) + v.limb(i);
  if ((v.limb(Int<Bits>::words - 1) >> 63) != 0) r -= Big(1) << (64 * Int<Bits>::words);
  return r;
}

/// Bit patterns, so that 0 and -0 differ.
std::uint64_t to_double_bits(double v) {
  std::uint64_t r = 0;
  std::memcpy(&r, &v, sizeof r);
  return r;
}

int sign_of_big(const Big& v) { return v < 0 ? -1 : v > 0 ? 1 : 0; }

/// Long-hand: the nearest double, ties to even.
double nearest_double(const Big& v) {
  if (v == 0) return 0;
  Big m = abs(v);
  const int drop = static_cast<int>(msb(m)) - 52;
  if (drop > 0) {
    const Big rest = m & ((Big(1) << drop) - 1), half = Big(1) << (drop - 1);
    m >>= drop;
    if (rest > half || (rest == half && (m & 1) != 0)) ++m;
  }
  const double r = std::ldexp(static_cast<double>(static_cast<std::uint64_t>(m)), drop > 0 ? drop : 0);
  return v < 0 ? -r : r;
}

/// 0, +-1, the extremes, powers of two and their neighbours, random numbers of random length.
template <int Bits>
std::vector<Int<Bits>> samples(std::mt19937_64& random, int count) {
  std::vector<Integer> v{0, 1, 2, 3};
  const Integer one = 1, limit = one << (Bits - 1);
  v.push_back(limit - 1);
  v.push_back(limit - 2);
  for (int k = 31; k < Bits - 1; k += 31 + static_cast<int>(below(random, 4)))
    for (int e = -1; e <= 1; ++e) v.push_back((one << k) + e);
  for (int k = 64; k < Bits - 1; k += 64)
    for (int e = -1; e <= 1; ++e) v.push_back((one << k) + e);
  for (int i = 0; i < count; ++i) v.push_back(abs(biased_integer(random, Bits - 1)));
  std::vector<Int<Bits>> r;
  for (const Integer& x : v) {
    if (x >= limit) continue;
    r.push_back(*to_int<Bits>(x));
    r.push_back(*to_int<Bits>(-x));
    EXPECT_EQ(to_big(r.back()), Big(Integer(-x).str()));
  }
  return r;
}

template <int A, int B>
void check_pair(const std::vector<Int<A>>& as, const std::vector<Int<B>>& bs) {
  std::vector<Big> big_bs;
  for (const auto& b : bs) big_bs.push_back(to_big(b));
  for (const auto& a : as) {
    const Big big_a = to_big(a);
    const Integer gmp_a = to_integer(a);
    for (std::size_t i = 0; i < bs.size(); ++i) {
      const Int<B>& b = bs[i];
      const auto sum = a + b, difference = a - b;
      const auto product = a * b;
      ASSERT_EQ(to_big(sum), big_a + big_bs[i]);
      ASSERT_EQ(to_big(difference), big_a - big_bs[i]);
      ASSERT_EQ(to_big(product), big_a * big_bs[i]);
      const Integer gmp_b = to_integer(b);
      ASSERT_EQ(to_integer(sum), gmp_a + gmp_b);
      ASSERT_EQ(to_integer(product), gmp_a * gmp_b);
      ASSERT_EQ(compare(a, b), sign_of_big(Big(big_a - big_bs[i])));
      // Signs and equality of what was computed, not only of what was read in.
      ASSERT_EQ(difference.sign(), compare(a, b));
      ASSERT_EQ(product.sign(), a.sign() * b.sign());
      ASSERT_TRUE(difference == -(b - a));
      ASSERT_TRUE(product == b * a);
      ASSERT_TRUE((narrow<(A > B ? A : B)>(sum - b) == Int<(A > B ? A : B)>(a)));
    }
  }
}

template <int A>
void check_one(const std::vector<Int<A>>& as) {
  for (const auto& a : as) {
    const Big big = to_big(a);
    ASSERT_EQ(to_big(-a), -big);
    ASSERT_EQ(a.sign(), sign_of_big(big));
    ASSERT_EQ(a.negative(), big < 0);
    ASSERT_TRUE(a == a);
    ASSERT_EQ(to_big(Int<A + 70>(a)), big);
    ASSERT_EQ(to_double_bits(a.to_double()), to_double_bits(nearest_double(big)));
    const Leading m = leading(a);
    ASSERT_EQ(m.top == 0, big == 0);
    if (big == 0) continue;
    ASSERT_EQ(m.top >> 63, 1U);
    const Big scaled = Big(abs(big)) << 64;  // the exponent may be as low as -63
    const unsigned shift = static_cast<unsigned>(m.exponent + 64);
    ASSERT_EQ(Big(scaled >> shift), m.top);
    ASSERT_EQ(Big(Big(m.top) << shift) != scaled, m.sticky);
    const int room = A - 2 - static_cast<int>(msb(Big(abs(big))));
    for (int count = 0; count <= room; count += 1 + room / 7) ASSERT_EQ(to_big(shifted_left(a, count)), big << count);
    if (room > 0) {
      ASSERT_EQ(to_big(shifted_left(a, room)), big << room);
    }
    constexpr int half = (A + 1) / 2 + 1;
    if (abs(big) < (Big(1) << (half - 1))) {
      ASSERT_EQ(to_big(narrow<half>(a)), big);
    }
  }
}

template <int A, int... Bs>
void check_width(std::mt19937_64& random, std::integer_sequence<int, Bs...>) {
  const auto as = samples<A>(random, 20);
  check_one(as);
  (check_pair(as, samples<Bs>(random, 10)), ...);
}

template <int... As>
void check_widths(std::uint64_t salt, std::integer_sequence<int, As...> widths) {
  std::mt19937_64 random = generator(salt);
  (check_width<As>(random, widths), ...);
}

TEST(IntTest, LadderWidthsAgreeWithUnboundedIntegers) {
  check_widths(100, std::integer_sequence<int, 63, 125, 189, 251, 315, 440, 691>{});
}

// Where the sign bit is the first or the last of its limb.
TEST(IntTest, LimbBoundariesAgreeWithUnboundedIntegers) {
  check_widths(101, std::integer_sequence<int, 64, 65, 128, 193>{});
}

template <int Bits>
void check_ties() {
  std::mt19937_64 random = generator(102);
  for (int i = 0; i < 2000; ++i) {
    // 53 kept bits, then exactly a half, then one more or less far below; kept bits of both parities, all ones
    // included.
    Integer kept = (Integer(1) << 52) + Integer(random() >> 12);
    if (i % 5 == 0) kept = (Integer(1) << 53) - 1 - i % 2;
    const unsigned drop = 2 + static_cast<unsigned>(below(random, Bits - 1 - 53 - 2));
    const Integer tie = (kept << drop) + (Integer(1) << (drop - 1));
    for (int e = -1; e <= 1; ++e) {
      const Integer m = tie + e;
      for (const Integer& v : {m, Integer(-m)}) {
        const Int<Bits> a = *to_int<Bits>(v);
        ASSERT_EQ(to_double_bits(a.to_double()), to_double_bits(nearest_double(to_big(a)))) << v;
        ASSERT_EQ(a.to_double(), to_double(Rational(v))) << v;
      }
    }
  }
}

TEST(IntTest, ToDoubleRoundsTiesToEven) {
  check_ties<63>();
  check_ties<125>();
  check_ties<251>();
  check_ties<691>();
  EXPECT_EQ(Int<63>((int128(1) << 53) + 1).to_double(), 0x1p53);
  EXPECT_EQ(Int<63>((int128(1) << 53) + 3).to_double(), 0x1p53 + 4);
  EXPECT_EQ(Int<63>(-(int128(1) << 53) - 1).to_double(), -0x1p53);
  EXPECT_EQ(Int<125>((int128(1) << 124) - 1).to_double(), 0x1p124);
  EXPECT_FALSE(std::signbit(Int<63>(0).to_double()));
}

TEST(IntTest, BuiltInIntegersRoundTrip) {
  std::mt19937_64 random = generator(103);
  const int128 most = static_cast<int128>(~uint128{0} >> 1);
  std::vector<int128> values{0, 1, -1, most, -most, most - 1, INT64_MAX, INT64_MIN, int128(INT64_MAX) + 1};
  for (int i = 0; i < 1000; ++i) {
    const int128 v = static_cast<int128>((uint128(random()) << 64) | random()) >> below(random, 128);
    if (v != -most - 1) values.push_back(v);
  }
  for (const int128 v : values) {
    ASSERT_TRUE(Int<128>(v).low() == v);
    ASSERT_TRUE(Int<300>(v).low() == v);
    ASSERT_EQ(to_integer(Int<300>(v)), to_integer(v));
    ASSERT_EQ(Int<300>(v).sign(), sign(v));
    if (v > -(int128(1) << 62) && v < int128(1) << 62) {
      ASSERT_TRUE(Int<63>(v).low() == v);
      ASSERT_EQ(to_big(Int<63>(v)), to_big(Int<300>(v)));
    }
  }
}

TEST(IntTest, TheSumOfExtremesIsExact) {
  const Int<63> most(coefficient_limit);
  EXPECT_TRUE((most + most).low() == 2 * int128(coefficient_limit));
  EXPECT_TRUE((-most - most).low() == -2 * int128(coefficient_limit));
  EXPECT_TRUE((most * -most).low() == -offset_limit);
}

#if GTEST_HAS_DEATH_TEST
using IntDeathTest = ::testing::Test;

// The ranges are symmetric: -2^(Bits-1) has Bits bits in two's complement and still is out of range.
TEST(IntDeathTest, CheckedBuildsFindOverflow) {
  if constexpr (checked) {
    EXPECT_DEATH(Int<63>(int128(1) << 62), "exceeds its 63-bit type");
    EXPECT_DEATH(Int<63>(-(int128(1) << 62)), "exceeds its 63-bit type");
    EXPECT_DEATH(Int<128>(-static_cast<int128>(~uint128{0} >> 1) - 1), "exceeds its 128-bit type");
    const Int<70> limit(int128(1) << 62);
    EXPECT_DEATH(narrow<63>(limit), "exceeds its 63-bit type");
    EXPECT_DEATH(narrow<63>(-limit), "exceeds its 63-bit type");
    EXPECT_DEATH(narrow<64>(Int<200>(Int<70>(-(int128(1) << 63)))), "exceeds its 64-bit type");
    EXPECT_DEATH(narrow<63>(Int<200>(int128(1) << 100)), "exceeds its 63-bit type");
    EXPECT_DEATH(shifted_left(Int<63>(1), 62), "exceeds its 63-bit type");
    EXPECT_DEATH(shifted_left(Int<63>(-1), 62), "exceeds its 63-bit type");
    EXPECT_TRUE(narrow<63>(limit - Int<63>(1)).low() == coefficient_limit);
  } else {
    GTEST_SKIP() << "needs QUOIN_CHECKED";
  }
}
#endif

}  // namespace
}  // namespace quoin::exact::testing
