/// \file
/// Rational approximation: continued fractions and the best fractions of bounded denominator.
///
/// Source: C. M. Hoffmann, Geometric and Solid Modeling (1989), 4.3.4. Its bound 1 / (qQ) for the result holds for
/// convergents only; the true bounds are stated at `best_approximation`.
#pragma once

#include <utility>

#include "exact/rational.h"

namespace quoin::rounding {

using exact::are_whole;
using exact::Integer;
using exact::longest_component;
using exact::over_common_denominator;
using exact::primitive;
using exact::Rational;

inline Rational magnitude(const Rational& v) { return v < 0 ? Rational(-v) : v; }
/// floor(log2 |v|) + 1; 0 for 0.
inline long bit_length(const Integer& v) {
  return v == 0 ? 0 : static_cast<long>(mpz_sizeinbase(v.backend().data(), 2));
}
/// v rounded to the nearest integer, ties to even: odd in v.
Integer nearest_integer(const Rational& v);
/// n / d rounded likewise, without reducing the fraction. Precondition: d > 0.
Integer nearest_integer(const Integer& n, const Integer& d);
/// The largest integer <= v.
Integer floor_of(const Rational& v);

/// The continued fraction k0 + 1 / (k1 + 1 / (k2 + ..)) of a rational, one quotient at a time, by Euclid's algorithm.
/// k0 is the floor; of the two forms of a rational it is the shorter one.
///   for (ContinuedFraction c(w); c.next();) use(c.quotient(), c.p(), c.q());
class ContinuedFraction {
 public:
  explicit ContinuedFraction(const Rational& w) : ContinuedFraction(numerator(w), denominator(w)) {}
  /// Of above / below, which need not be in lowest terms. Precondition: below > 0.
  ContinuedFraction(Integer above, Integer below) : above_(std::move(above)), below_(std::move(below)) {}
  /// Takes the next quotient; false when the expansion has ended.
  bool next();
  /// Of the last `next()` that was true.
  const Integer& quotient() const { return quotient_; }
  /// The convergent p / q up to that quotient, and the one before (1 / 0 before the first).
  const Integer& p() const { return p_; }
  const Integer& q() const { return q_; }
  const Integer& previous_p() const { return previous_p_; }
  const Integer& previous_q() const { return previous_q_; }

 private:
  Integer above_, below_, quotient_;
  Integer p_ = 1, q_ = 0, previous_p_ = 0, previous_q_ = 1;
};

/// The fraction of denominator <= Q that is closest to w; of two the one of smaller denominator, then the one closer
/// to 0. Odd in w, and monotone. It is the last convergent p_n / q_n with q_n <= Q, or a quasi-convergent
/// (k p_n + p_{n-1}) / (k q_n + q_{n-1}) with the largest such k.
/// Bounds: |w - result| <= 1 / (q_n (Q + 1)) and |w - result| <= 1 / (2 Q). Precondition: Q >= 1.
Rational best_approximation(const Rational& w, const Integer& Q);
/// The same of w = n / d, which need not be in lowest terms: of very long numbers that costs more than all else.
/// Precondition: d > 0.
Rational best_approximation(const Integer& n, const Integer& d, const Integer& Q);

/// p / Q with the nearest p: at most 1 / (2 Q) away. Precondition: Q >= 1.
Rational naive_approximation(const Rational& w, const Integer& Q);

}  // namespace quoin::rounding
