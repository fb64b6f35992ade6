/// \file
/// Intervals of doubles that hold the exact result of a computation.
#pragma once

#include <algorithm>
#include <cmath>

namespace quoin::booleans {

/// low .. high, all real numbers between. Operations on intervals yield one that holds the exact results for all
/// numbers in them: rounding to nearest is monotone, so an exact result lies between the neighbours of the rounded one.
struct Interval {
  double low, high;

  /// Exactly x.
  Interval(double x) : low(x), high(x) {}  // NOLINT: implicit by design
  Interval(double l, double h) : low(l), high(h) {}
  /// Whatever lies between two neighbours of what these round to.
  static Interval around(double l, double h) { return {std::nextafter(l, -HUGE_VAL), std::nextafter(h, HUGE_VAL)}; }
  /// Whatever rounds to x.
  static Interval around(double x) { return around(x, x); }
};

inline Interval operator-(const Interval& a) { return {-a.high, -a.low}; }
inline Interval operator+(const Interval& a, const Interval& b) {
  return Interval::around(a.low + b.low, a.high + b.high);
}
inline Interval operator-(const Interval& a, const Interval& b) { return a + -b; }
inline Interval operator*(const Interval& a, const Interval& b) {
  const auto [low, high] = std::minmax({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
  return Interval::around(low, high);
}
/// Precondition: b > 0.
inline Interval operator/(const Interval& a, const Interval& b) {
  return Interval::around(a.low / (a.low < 0 ? b.low : b.high), a.high / (a.high < 0 ? b.high : b.low));
}

}  // namespace quoin::booleans
