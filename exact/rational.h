/// \file
/// The top rung: unbounded integers and rationals, for doors, volumes and moments. Never on the path of a Boolean.
#pragma once

#include <algorithm>
#include <boost/multiprecision/gmp.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "exact/geometry.h"

namespace quoin::exact {

using Integer = boost::multiprecision::mpz_int;
using Rational = boost::multiprecision::mpq_rational;

Integer to_integer(int128 v);
template <int Bits>
Integer to_integer(const Int<Bits>& v) {
  const Int<Bits> m = v.negative() ? -v : v;
  std::array<std::uint64_t, Int<Bits>::words> limbs;
  for (int i = 0; i < Int<Bits>::words; ++i) limbs[static_cast<std::size_t>(i)] = m.limb(i);
  Integer r;
  mpz_import(r.backend().data(), limbs.size(), -1, sizeof(std::uint64_t), 0, 0, limbs.data());
  return v.negative() ? Integer(-r) : r;
}
/// The value when it fits |v| < 2^(Bits-1), else nothing.
template <int Bits>
std::optional<Int<Bits>> to_int(const Integer& v) {
  if (v != 0 && mpz_sizeinbase(v.backend().data(), 2) > Bits - 1) return std::nullopt;
  std::array<std::uint64_t, Int<Bits>::words> limbs{};
  mpz_export(limbs.data(), nullptr, -1, sizeof(std::uint64_t), 0, 0, v.backend().data());

  Int<Bits> r(0);
  for (int i = Int<Bits>::words - 1; i >= 0; --i) {
    // Limbs enter in halves, so that no part looks negative.
    const std::uint64_t limb = limbs[static_cast<std::size_t>(i)];
    r = shifted_left(r, 32);
    r = narrow<Bits>(r + Int < Bits < 34 ? Bits : 34 > (static_cast<int128>(limb >> 32)));
    r = shifted_left(r, 32);
    r = narrow<Bits>(r + Int < Bits < 34 ? Bits : 34 > (static_cast<int128>(limb & 0xFFFFFFFFu)));
  }
  return v < 0 ? -r : r;
}

/// A decimal ("-1.25e-3") or a quotient of decimals or integers ("1/3"), exactly; nothing on any other text, on a zero
/// denominator, on an exponent beyond +-400, or on a decimal of more digits than `most_digits`.
std::optional<Rational> parse_rational(std::string_view text, std::size_t most_digits = 4000);
/// Reduced "p/q", or "p" when q = 1.
std::string to_string(const Rational& v);
/// The double's exact value. Precondition: finite.
Rational to_rational(double v);
/// Correctly rounded (ties to even); infinite beyond the range of double.
double to_double(const Rational& v);
/// The least double that is not below v.
double double_above(const Rational& v);
/// Correctly rounded to float32.
float to_float(const Rational& v);
/// Rationals as integers over their least common denominator.
template <std::size_t N>
struct CommonFraction {
  std::array<Integer, N> numerators;
  Integer denominator = 1;
};
template <std::size_t N>
CommonFraction<N> over_common_denominator(const std::array<Rational, N>& v) {
  CommonFraction<N> r;
  for (const Rational& x : v) r.denominator = lcm(r.denominator, denominator(x));
  for (std::size_t i = 0; i < N; ++i) r.numerators[i] = numerator(v[i]) * (r.denominator / denominator(v[i]));
  return r;
}
/// Whether all are integers.
template <std::size_t N>
bool are_whole(const std::array<Rational, N>& v) {
  return std::all_of(v.begin(), v.end(), [](const Rational& x) { return denominator(x) == 1; });
}

/// Divided by their greatest common divisor. Precondition: not all are 0.
template <std::size_t N>
std::array<Integer, N> primitive(std::array<Integer, N> v) {
  Integer content = 0;
  for (const Integer& x : v) content = gcd(content, x);
  if (content != 1)
    for (Integer& x : v) x /= content;
  return v;
}
/// The coprime integers that are a positive multiple of them. Precondition: not all are 0.
template <std::size_t N>
std::array<Integer, N> primitive(const std::array<Rational, N>& v) {
  return primitive(over_common_denominator(v).numerators);
}

/// The largest rational of which both are whole multiples; not negative. That of 0 and v is |v|.
Rational common_divisor(const Rational& a, const Rational& b);

/// The exact k-th coordinate.
Rational coordinate(const Point& u, int k);

}  // namespace quoin::exact
