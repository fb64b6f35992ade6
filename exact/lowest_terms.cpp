#include "exact/lowest_terms.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <utility>

#include "exact/rational.h"

namespace quoin::exact {
namespace {

int trailing_zeros(uint128 a) {
  const auto low = static_cast<std::uint64_t>(a);
  return low != 0 ? std::countr_zero(low) : 64 + std::countr_zero(static_cast<std::uint64_t>(a >> 64));
}

bool is_one_word(uint128 a) { return a >> 64 == 0; }

template <int Bits>
bool fits_128(const Int<Bits>& v) {
  return v == Int<Bits>(v.low());
}

uint128 size_of(int128 v) { return v < 0 ? -static_cast<uint128>(v) : static_cast<uint128>(v); }

/// Of numbers that fit 128 bits.
uint128 short_content(const Point& p) {
  uint128 g = size_of(p.w.low());
  for (std::size_t k = 0; k < 3 && g != 1; ++k) g = gcd(size_of(p.x[k].low()), g);
  return g;
}

Integer long_content(const Point& p) {
  Integer g = to_integer(p.w);
  for (std::size_t k = 0; k < 3 && g != 1; ++k) g = gcd(g, to_integer(p.x[k]));
  return g;
}

bool is_short(const Point& p) {
  return fits_128(p.w) && std::all_of(p.x.begin(), p.x.end(), [](const Numerator& x) { return fits_128(x); });
}

template <int Bits>
Int<Bits> quotient(const Int<Bits>& v, const Integer& divisor) {
  return *to_int<Bits>(Integer(to_integer(v) / divisor));
}

/// v / divisor, both being below 2^127.
template <int Bits>
Int<Bits> short_quotient(const Int<Bits>& v, int128 divisor) {
  return Int<Bits>(v.low() / divisor);
}

}  // namespace

uint128 gcd(uint128 a, uint128 b) {
  if (a == 0) return b;
  if (b == 0) return a;
  const int twos = trailing_zeros(a | b);
  a >>= trailing_zeros(a);
  b >>= trailing_zeros(b);

  // Both are odd.
  for (;;) {
    if (a < b) std::swap(a, b);
    if (is_one_word(b))
      return uint128(std::gcd(static_cast<std::uint64_t>(a % b), static_cast<std::uint64_t>(b))) << twos;
    a -= b;
    if (a == 0) return b << twos;
    a >>= trailing_zeros(a);
  }
}

bool is_reduced(const Point& p) { return is_short(p) ? short_content(p) == 1 : long_content(p) == 1; }

Point reduced(const Point& p) {
  if (is_grid(p)) return p;

  Point r = p;
  if (is_short(p)) {
    const auto g = static_cast<int128>(short_content(p));
    if (g == 1) return p;
    for (Numerator& x : r.x) x = short_quotient(x, g);
    r.w = short_quotient(r.w, g);
  } else {
    const Integer g = long_content(p);
    if (g == 1) return p;
    for (Numerator& x : r.x) x = quotient(x, g);
    r.w = quotient(r.w, g);
  }
  return r;
}

}  // namespace quoin::exact
