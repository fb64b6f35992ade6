#include "rounding/numbers/approximation.h"

#include <cassert>
#include <utility>

namespace quoin::rounding {

Integer floor_of(const Rational& v) {
  Integer q;
  mpz_fdiv_q(q.backend().data(), mpq_numref(v.backend().data()), mpq_denref(v.backend().data()));
  return q;
}

Integer nearest_integer(const Integer& n, const Integer& d) {
  assert(d > 0);
  Integer q, rest;
  mpz_fdiv_qr(q.backend().data(), rest.backend().data(), n.backend().data(), d.backend().data());
  const int half = Integer(rest * 2).compare(d);
  return half > 0 || (half == 0 && bit_test(Integer(abs(q)), 0)) ? Integer(q + 1) : q;
}

Integer nearest_integer(const Rational& v) { return nearest_integer(numerator(v), denominator(v)); }

bool ContinuedFraction::next() {
  if (below_ == 0) return false;

  Integer rest;
  mpz_fdiv_qr(quotient_.backend().data(), rest.backend().data(), above_.backend().data(), below_.backend().data());
  above_ = std::exchange(below_, std::move(rest));

  Integer p = quotient_ * p_ + previous_p_, q = quotient_ * q_ + previous_q_;
  previous_p_ = std::exchange(p_, std::move(p));
  previous_q_ = std::exchange(q_, std::move(q));
  return true;
}

Rational best_approximation(const Rational& w, const Integer& Q) {
  return best_approximation(numerator(w), denominator(w), Q);
}

Rational best_approximation(const Integer& n, const Integer& d, const Integer& Q) {
  assert(Q >= 1 && d > 0);
  if (n < 0) return -best_approximation(-n, d, Q);

  ContinuedFraction c(n, d);
  while (c.next() && c.q() <= Q) {
  }
  if (c.q() <= Q) return Rational(c.p(), c.q());

  // The last step went too far: its predecessor is the convergent, and the one before that is needed too.
  const Integer older_p = c.p() - c.quotient() * c.previous_p(), older_q = c.q() - c.quotient() * c.previous_q();
  const Integer k = (Q - older_q) / c.previous_q();
  const Rational convergent(c.previous_p(), c.previous_q());
  // With k = 0 it is the convergent before, which is farther away; but where that is 1 / 0.
  if (k == 0) return convergent;

  const Rational quasi(k * c.previous_p() + older_p, k * c.previous_q() + older_q);
  // |n / d - v| times d and v's denominator.
  const auto distance = [&](const Rational& v) -> Integer { return abs(n * denominator(v) - d * numerator(v)); };
  const bool is_closer = distance(quasi) * denominator(convergent) < distance(convergent) * denominator(quasi);
  return is_closer ? quasi : convergent;
}

Rational naive_approximation(const Rational& w, const Integer& Q) {
  assert(Q >= 1);
  return Rational(nearest_integer(w * Q), Q);
}

}  // namespace quoin::rounding
