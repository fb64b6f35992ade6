#include "rounding/numbers/enclosure.h"

#include <algorithm>
#include <cassert>

namespace quoin::rounding {
namespace {

/// An interval [low, high] / 2^bits; operations round outward. All values are >= 0 but those of `sum`.
struct Fixed {
  Integer low, high;
};

Fixed product(const Fixed& a, const Fixed& b, unsigned bits) {
  return {Integer(a.low * b.low) >> bits, (Integer(a.high * b.high) >> bits) + 1};
}
Fixed quotient(const Fixed& a, unsigned long n) { return {a.low / n, a.high / n + 1}; }

/// first - second + third - ..., the terms decreasing to 0. `next(term, i)` gives term i + 1; the rest of the series
/// after the last term that is looked at is smaller than it.
template <class Next>
Fixed alternating_sum(Fixed term, Next&& next) {
  Fixed sum{0, 0};
  for (unsigned long i = 0;; ++i) {
    if (i % 2 == 0) {
      sum.low += term.low;
      sum.high += term.high;
    } else {
      sum.low -= term.high;
      sum.high -= term.low;
    }
    if (term.high <= 2) break;
    term = next(term, i);
  }

  sum.low -= term.high;
  sum.high += term.high;
  return sum;
}

/// atan(1 / n) = sum of (-1)^i / ((2 i + 1) n^(2 i + 1)).
Fixed inverse_arctangent(unsigned long n, unsigned bits) {
  Fixed power = quotient({Integer(1) << bits, Integer(1) << bits}, n);
  return alternating_sum(power, [&](const Fixed&, unsigned long i) {
    power = quotient(power, n * n);
    return quotient(power, 2 * i + 3);
  });
}

Fixed machin_pi(unsigned bits) {
  const Fixed a = inverse_arctangent(5, bits), b = inverse_arctangent(239, bits);
  return {a.low * 16 - b.high * 4, a.high * 16 - b.low * 4};
}

/// Summed once for all angles but those of very long numbers.
Fixed fixed_pi(unsigned bits) {
  constexpr unsigned known_bits = 512;
  // Never destroyed, as every static object of the library.
  static const Fixed& known = *new Fixed(machin_pi(known_bits));
  if (bits > known_bits) return machin_pi(bits);
  return {known.low >> (known_bits - bits), (known.high >> (known_bits - bits)) + 1};
}

/// sum of (-1)^i first x^(2 i) / ((start + 1) .. (start + 2 i)): sine for (x, 1), cosine for (1, 0). 0 <= x < 1.
Fixed sine_series(const Fixed& first, const Fixed& x, unsigned long start, unsigned bits) {
  const Fixed square = product(x, x, bits);
  return alternating_sum(first, [&](const Fixed& term, unsigned long i) {
    return quotient(product(term, square, bits), (start + 2 * i + 1) * (start + 2 * i + 2));
  });
}

Enclosure rational(const Fixed& v, unsigned bits) {
  const Integer unit = Integer(1) << bits;
  return {Rational(v.low, unit), Rational(v.high, unit)};
}

/// Rounding loses about one unit a term of a series, times 16: far less than these bits up to 2^16 terms.
constexpr unsigned guard_bits = 24;

/// floor(sqrt(v 4^shift)) / 2^shift with 64 bits or more.
struct Root {
  Integer root;
  long shift;
  bool exact;
};

Root root_of(const Rational& v, unsigned bits) {
  Integer n = numerator(v), d = denominator(v);
  // The quotient gets 2 bits + 2 bits or more.
  const long shift = std::max(0L, static_cast<long>(bits) + 1 - (bit_length(n) - bit_length(d)) / 2 + 1);
  n <<= static_cast<unsigned long>(2 * shift);

  Integer q, r, rest;
  divide_qr(n, d, q, r);
  const Integer s = sqrt(q, rest);
  return {s, shift, r == 0 && rest == 0};
}

}  // namespace

Enclosure enclosed_pi(unsigned bits) {
  bits += guard_bits;
  return rational(fixed_pi(bits), bits);
}

Enclosure enclosed_tangent(const Rational& degrees, unsigned bits) {
  assert(degrees >= 0 && degrees <= 45);
  if (degrees == 0) return {0, 0};

  bits += guard_bits;
  const Fixed pi = fixed_pi(bits);
  const Rational turn = degrees / 180;
  const Fixed x{floor_of(turn * pi.low), floor_of(turn * pi.high) + 1};

  const Integer one = Integer(1) << bits;
  const Fixed sine = sine_series(x, x, 1, bits), cosine = sine_series({one, one}, x, 0, bits);
  const Integer low = sine.low < 0 ? Integer(0) : sine.low;
  return rational({(low << bits) / cosine.high, (sine.high << bits) / cosine.low + 1}, bits);
}

Enclosure enclosed_root(const Rational& v, unsigned bits) {
  assert(v >= 0);
  if (v == 0) return {0, 0};
  const Root r = root_of(v, bits);
  const Integer unit = Integer(1) << static_cast<unsigned long>(r.shift);
  return {Rational(r.root, unit), Rational(r.exact ? r.root : Integer(r.root + 1), unit)};
}

Rational root_above(const Rational& v) { return enclosed_root(v, 64).high; }

Rational best_approximation(const std::function<Enclosure(unsigned)>& enclosed, const Integer& Q, Rational& error) {
  for (unsigned bits = 192;; bits *= 2) {
    const Enclosure w = enclosed(bits);
    const Rational low = best_approximation(w.low, Q), high = best_approximation(w.high, Q);
    if (low != high) continue;
    error = std::max(magnitude(low - w.low), magnitude(low - w.high));
    return low;
  }
}

}  // namespace quoin::rounding
