/// \file
/// Random motions, and what they state, to some 580 bits: the second way to what is carried out.
#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "rounding/motions/motion.h"
#include "tests/rounding/support.h"

namespace quoin::rounding::testing {

inline const AffineMap identity;
inline const Vector x_axis{1, 0, 0}, y_axis{0, 1, 0}, z_axis{0, 0, 1}, diagonal{1, 1, 1};

/// What the 600 bits of MPFR leave over, amply.
inline const Rational epsilon(1, power_of_2(400));

inline Integer power_of_10(int digits) { return pow(Integer(10), static_cast<unsigned>(digits)); }

inline Matrix transposed(const Matrix& m) {
  return {Vector{m[0][0], m[1][0], m[2][0]}, Vector{m[0][1], m[1][1], m[2][1]}, Vector{m[0][2], m[1][2], m[2][2]}};
}
inline Matrix product(const Matrix& a, const Matrix& b) {
  return composed(AffineMap{b, {0, 0, 0}}, {a, {0, 0, 0}}).linear;
}

inline Rational random_degrees(std::mt19937_64& random) {
  switch (below(random, 5)) {
    case 0:
      return between(random, -24, 24) * 15;
    case 1:
      return Rational(between(random, -2, 2)) * 90 + Rational(between(random, -1, 1), power_of_2(50));
    case 2:
      return Rational(between(random, -36000, 36000), 100);
    default:
      return Rational(biased_integer(random, 70), abs(biased_integer(random, 60)) + 1);
  }
}

inline Motion random_step(std::mt19937_64& random) {
  switch (below(random, 6)) {
    case 0:
      return Motion::translation(random_vector(random, 20));
    case 1:
      return Motion::turn(random_quaternion(random, 10));
    case 2:
      return Motion::mirror(random_direction(random, 1));
    case 3:
      return Motion::scaling({between(random, 1, 3), Rational(between(random, 1, 3), 2), between(random, 1, 3)});
    default:
      return Motion::rotation(random_direction(random, 1), random_degrees(random));
  }
}
inline Motion random_motion(std::mt19937_64& random, std::size_t steps) {
  Motion m;
  for (std::size_t i = 0; i < steps; ++i) m = m.then(random_step(random));
  return m;
}

/// The stated rotation, carried out with some 580 bits.
inline Quaternion fine_rotation(const RotationStep& step) {
  const Axis& v = step.axis;
  if (step.degrees == 180) return quaternion(0, v[0], v[1], v[2]);
  const Integer norm = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
  const Rational half = magnitude(step.degrees) / 2;
  const Rational t = true_tangent(half, MPFR_RNDN) / true_root(norm, MPFR_RNDN);
  const Integer s = step.degrees < 0 ? Integer(-numerator(t)) : Integer(numerator(t));
  return quaternion(denominator(t), s * v[0], s * v[1], s * v[2]);
}

/// What a motion states, with some 580 bits.
inline AffineMap stated_map(const Motion& motion) {
  AffineMap map;
  for (const Step& step : motion.steps()) {
    if (const auto* rotation = std::get_if<RotationStep>(&step)) {
      map = composed(map, {matrix(fine_rotation(*rotation)), {0, 0, 0}});
    } else if (const auto* translation = std::get_if<TranslationStep>(&step)) {
      map = composed(map, {identity.linear, translation->by});
    } else if (const auto* turn = std::get_if<TurnStep>(&step)) {
      map = composed(map, {matrix(turn->by), {0, 0, 0}});
    } else if (const auto* mirror = std::get_if<MirrorStep>(&step)) {
      // p - 2 (p . n) / (n . n) n, column by column.
      const Vector n{mirror->normal[0], mirror->normal[1], mirror->normal[2]};
      Matrix columns;
      for (std::size_t k = 0; k < 3; ++k) columns[k] = identity.linear[k] - (2 * n[k] / dot(n, n)) * n;
      map = composed(map, {transposed(columns), {0, 0, 0}});
    } else {
      const Vector& by = std::get<ScalingStep>(step).by;
      map = composed(map, {{Vector{by[0], 0, 0}, Vector{0, by[1], 0}, Vector{0, 0, by[2]}}, {0, 0, 0}});
    }
  }
  return map;
}

/// The signed difference of the angle 2 atan(t) to `degrees`, rounded towards `direction`.
inline Rational angle_error(const Rational& t, const Rational& degrees, mpfr_rnd_t direction) {
  return 2 * true_arctangent_degrees(t, direction) - degrees;
}

}  // namespace quoin::rounding::testing
