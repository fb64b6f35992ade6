/// \file
/// What the tests of rounding/ share: random rationals, rotations and planes, and MPFR's word on irrational numbers.
#pragma once

#include <gmp.h>
#include <mpfr.h>

#include <random>

#include "rounding/motions/quaternion.h"
#include "rounding/planes/plane_rounding.h"
#include "rounding/shapes/polyhedron.h"
#include "tests/exact/support.h"

namespace quoin::rounding::testing {

using exact::testing::below;
using exact::testing::between;
using exact::testing::biased_integer;
using exact::testing::generator;
using exact::testing::sign_of;

inline Integer power_of_2(unsigned bits) { return Integer(1) << bits; }

/// Biased towards integers, halves, neighbours of small fractions and their middles, and the very large and small.
inline Rational random_rational(std::mt19937_64& random, unsigned magnitude = 80) {
  const auto small = [&] { return Rational(between(random, -40, 40), between(random, 1, 40)); };
  const auto tiny = [&] { return Rational(between(random, -1, 1), power_of_2(magnitude)); };

  switch (below(random, 6)) {
    case 0:
      return Rational(between(random, -3, 3)) / 2;
    case 1:
      return small() + tiny();
    case 2: {
      const Rational a = small(), b = small();
      return (a + b) / 2 + tiny();
    }
    case 3:
      return biased_integer(random, magnitude);
    default:
      return Rational(biased_integer(random, magnitude), abs(biased_integer(random, magnitude)) + 1);
  }
}

inline Vector random_vector(std::mt19937_64& random, unsigned magnitude = 80) {
  return {random_rational(random, magnitude), random_rational(random, magnitude), random_rational(random, magnitude)};
}
inline Vector random_direction(std::mt19937_64& random, std::int64_t size) {
  for (;;) {
    const Vector v{between(random, -size, size), between(random, -size, size), between(random, -size, size)};
    if (v != Vector{0, 0, 0}) return v;
  }
}

inline Quaternion random_quaternion(std::mt19937_64& random, unsigned magnitude) {
  for (;;) {
    const std::array<Integer, 4> q{biased_integer(random, magnitude), biased_integer(random, magnitude),
                                   biased_integer(random, magnitude), biased_integer(random, magnitude)};
    if (q != std::array<Integer, 4>{0, 0, 0, 0}) return quaternion(q[0], q[1], q[2], q[3]);
  }
}

/// A plane of coefficients of about `magnitude` bits: random ones, or a small plane turned and moved, or near such.
inline WidePlane random_plane(std::mt19937_64& random, unsigned magnitude) {
  for (;;) {
    Vector n;
    for (Rational& x : n) x = biased_integer(random, magnitude);
    Rational d = biased_integer(random, 2 * magnitude);

    if (below(random, 2) == 0) {
      n = random_direction(random, 3);
      d = random_rational(random, magnitude);
      if (below(random, 2) == 0) n[below(random, 3)] += Rational(1, power_of_2(magnitude));
      const WidePlane small = wide_plane(n, d);
      return moved(small, {matrix(random_quaternion(random, magnitude / 2)), random_vector(random, magnitude / 2)});
    }
    if (n != Vector{0, 0, 0}) return wide_plane(n, d);
  }
}

/// The enclosed volume: each face is a fan about its first corner, signed.
inline Rational volume(const Polyhedron& p) {
  Rational sixfold = 0;
  for (std::size_t f = 0; f < p.face_count(); ++f) {
    const Vector& apex = p.points[p.faces.corners_of(f).front()];
    p.faces.for_edges(f,
                      [&](std::uint32_t u, std::uint32_t v) { sixfold += dot(apex, cross(p.points[u], p.points[v])); });
  }
  return sixfold / 6;
}

/// A number of MPFR, of 600 bits. Every operation takes the direction in which it rounds.
class Real {
 public:
  Real() { mpfr_init2(value_, 600); }
  ~Real() { mpfr_clear(value_); }
  Real(const Real&) = delete;
  Real& operator=(const Real&) = delete;
  mpfr_ptr get() { return value_; }
  Rational rational() {
    Rational r;
    mpfr_get_q(r.backend().data(), value_);
    return r;
  }

 private:
  mpfr_t value_;
};

/// Pi, the tangent of degrees in [0, 90), the square root, and the arctangent of a positive number in degrees, rounded
/// down (MPFR_RNDD) or up (MPFR_RNDU): bounds of the true value, next to each other.
inline Rational true_pi(mpfr_rnd_t direction) {
  Real r;
  mpfr_const_pi(r.get(), direction);
  return r.rational();
}
inline Rational true_tangent(const Rational& degrees, mpfr_rnd_t direction) {
  Real r;
  mpfr_const_pi(r.get(), direction);
  const Rational turn = degrees / 180;
  mpfr_mul_q(r.get(), r.get(), turn.backend().data(), direction);
  mpfr_tan(r.get(), r.get(), direction);
  return r.rational();
}
inline Rational true_root(const Rational& v, mpfr_rnd_t direction) {
  Real r;
  mpfr_set_q(r.get(), v.backend().data(), direction);
  mpfr_sqrt(r.get(), r.get(), direction);
  return r.rational();
}
inline Rational true_arctangent_degrees(const Rational& v, mpfr_rnd_t direction) {
  Real r, pi;
  mpfr_set_q(r.get(), v.backend().data(), direction);
  mpfr_atan(r.get(), r.get(), direction);
  mpfr_mul_ui(r.get(), r.get(), 180, direction);
  mpfr_const_pi(pi.get(), direction == MPFR_RNDD ? MPFR_RNDU : MPFR_RNDD);
  mpfr_div(r.get(), r.get(), pi.get(), direction);
  return r.rational();
}

}  // namespace quoin::rounding::testing
