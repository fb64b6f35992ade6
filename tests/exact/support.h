/// \file
/// What the tests of exact/ share: seeds, biased random integers, the counters' verdict on the rung that answered.
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <random>

#include "exact/counters.h"
#include "exact/predicates.h"
#include "exact/rational.h"

namespace quoin::exact::testing {

/// The seed of all random tests: QUOIN_SEED, else 1; printed once.
inline std::uint64_t seed() {
  static const std::uint64_t value = [] {
    const char* text = std::getenv("QUOIN_SEED");
    const std::uint64_t s = text != nullptr ? std::strtoull(text, nullptr, 10) : 1;
    std::printf("QUOIN_SEED=%llu\n", static_cast<unsigned long long>(s));
    return s;
  }();
  return value;
}

/// A generator of its own for each test, so that a test's numbers do not depend on which others ran.
inline std::mt19937_64 generator(std::uint64_t salt) { return std::mt19937_64(seed() * 0x9E3779B97F4A7C15u + salt); }

inline std::uint64_t below(std::mt19937_64& random, std::uint64_t n) { return random() % n; }
inline std::int64_t between(std::mt19937_64& random, std::int64_t low, std::int64_t high) {
  return low + static_cast<std::int64_t>(below(random, static_cast<std::uint64_t>(high - low + 1)));
}

/// A random integer with |v| < 2^magnitude, biased towards 0, +-1, the extremes, powers of two and their neighbours.
inline Integer biased_integer(std::mt19937_64& random, unsigned magnitude) {
  const auto uniform = [&random](unsigned length) {
    Integer v = 0;
    for (unsigned i = 0; i < length; i += 64) v = (v << 64) | Integer(random());
    return Integer(v % (Integer(1) << length));
  };

  const unsigned k = static_cast<unsigned>(below(random, magnitude));
  Integer v;
  switch (below(random, 8)) {
    case 0:
      v = below(random, 3);
      break;
    case 1:
      v = (Integer(1) << magnitude) - 1 - below(random, 2);
      break;
    case 2:
      v = Integer(1) << k;
      break;
    case 3:
      v = (Integer(1) << k) - 1;
      break;
    case 4:
      v = k + 1 < magnitude ? (Integer(1) << k) + 1 : Integer(1);
      break;
    case 5:
      v = uniform(magnitude);
      break;
    default:
      v = uniform(k + 1);
      break;
  }

  v %= Integer(1) << magnitude;
  return below(random, 2) == 0 ? v : Integer(-v);
}

template <int Bits>
Int<Bits> biased(std::mt19937_64& random) {
  return *to_int<Bits>(biased_integer(random, Bits - 1));
}

/// Within +-L, biased like biased_integer.
inline std::int64_t biased_coefficient(std::mt19937_64& random) {
  return static_cast<std::int64_t>(biased<Coefficient::bits>(random).low());
}

enum class Rung { none, filter, fixed_width, several };

/// Which rung one question was answered by.
template <class Question>
Rung rung_of(const Question& question) {
  const Counters before = counters();
  question();
  const Counters after = counters();
  const std::uint64_t filter = after.filter - before.filter, fixed = after.fixed_width - before.fixed_width;
  if (filter + fixed == 0) return Rung::none;
  if (filter + fixed > 1) return Rung::several;
  return filter == 1 ? Rung::filter : Rung::fixed_width;
}

/// The plane's value at a point, in rationals.
inline Rational rational_value(const Plane& p, const std::array<Rational, 3>& u) {
  return Rational(to_integer(int128(p.n[0]))) * u[0] + Rational(to_integer(int128(p.n[1]))) * u[1] +
         Rational(to_integer(int128(p.n[2]))) * u[2] + Rational(to_integer(p.d));
}
inline std::array<Rational, 3> coordinates(const Point& u) {
  return {coordinate(u, 0), coordinate(u, 1), coordinate(u, 2)};
}
inline int sign_of(const Rational& v) { return v > 0 ? 1 : v < 0 ? -1 : 0; }
inline int sign_of(const Integer& v) { return v > 0 ? 1 : v < 0 ? -1 : 0; }

}  // namespace quoin::exact::testing
