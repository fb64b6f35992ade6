#include "rounding/motions/approximate_rotation.h"

#include <functional>
#include <optional>

#include "rounding/numbers/enclosure.h"

namespace quoin::rounding {
namespace {

/// Of s and w / |axis| at first.
constexpr unsigned angle_bits = 46;
/// What no realized angle differs by from the stated one: at the end of the world that is less than rounding moves.
/// Radians.
Rational angle_tolerance() { return Rational(Integer(1), Integer(1) << 92); }

/// s / w is tan(degrees / 2) / |axis|, or close to it.
struct HalfAngle {
  Integer s, w;
  Rational error = 0;  // of the angle, an upper bound; radians
};

/// The square of tan(degrees / 2) where it is rational: cosines of rational degrees are rational at multiples of 60 and
/// 90 alone (I. Niven, 1956). Nothing elsewhere. Precondition: 0 < degrees < 180.
std::optional<Rational> rational_squared_tangent(const Rational& degrees) {
  if (degrees == 60) return Rational(1, 3);
  if (degrees == 90) return Rational(1);
  if (degrees == 120) return Rational(3);
  return std::nullopt;
}

std::optional<Rational> rational_root(const Rational& v) {
  const Integer n = sqrt(Integer(numerator(v))), d = sqrt(Integer(denominator(v)));
  if (n * n == numerator(v) && d * d == denominator(v)) return Rational(n, d);
  return std::nullopt;
}

/// Nothing where the ratio is irrational. Precondition: 0 < degrees < 180.
std::optional<HalfAngle> exact_half_angle(const Rational& degrees, const Integer& norm) {
  const auto squared = rational_squared_tangent(degrees);
  if (!squared) return std::nullopt;
  const auto ratio = rational_root(*squared / norm);
  if (!ratio) return std::nullopt;
  return HalfAngle{numerator(*ratio), denominator(*ratio)};
}

/// tan(degrees / 2) / sqrt(norm). Precondition: 0 < degrees < 180.
Enclosure enclosed_ratio(const Rational& degrees, const Integer& norm, unsigned bits) {
  const bool beyond = degrees > 90;
  const Enclosure t = enclosed_tangent(Rational(beyond ? Rational(180 - degrees) : degrees) / 2, bits);
  const Enclosure root = enclosed_root(norm, bits);
  if (!beyond) return {t.low / root.high, t.high / root.low};

  // A cotangent; far more bits than 180 - degrees needs to differ from 0 come before long.
  if (t.low <= 0) return {0, Rational(Integer(1) << bits)};
  return {1 / (t.high * root.high), 1 / (t.low * root.low)};
}

/// The best fraction of denominators up to size 2^46, or of 8 bits more until the angle, which is at most `factor`
/// times as much wrong, is wrong by no more than the tolerance. `error` becomes the angle's.
Rational closest_fraction(const std::function<Enclosure(unsigned)>& enclosed, const Integer& size,
                          const Rational& factor, Rational& error) {
  const Rational tolerance = angle_tolerance();
  for (unsigned bits = angle_bits;; bits += 8) {
    Rational r = best_approximation(enclosed, size << bits, error);
    error *= factor;
    if (error <= tolerance) return r;
  }
}

/// By the ratio or, where it is above 1, its inverse. |2 atan(x) - 2 atan(y)| <= 2 |x - y| holds for both.
/// Precondition: 0 < degrees < 180, and the ratio is irrational.
HalfAngle closest_half_angle(const Rational& degrees, const Integer& norm) {
  const auto ratio = [&](unsigned bits) { return enclosed_ratio(degrees, norm, bits); };
  const auto inverse_ratio = [&](unsigned bits) {
    const Enclosure e = ratio(bits);
    return Enclosure{1 / e.high, e.low > 0 ? Rational(1 / e.low) : Rational(Integer(1) << bits)};
  };

  unsigned bits = 192;
  Enclosure e = ratio(bits);
  while (e.low < 1 && e.high > 1) e = ratio(bits *= 2);

  HalfAngle result;
  if (e.high <= 1) {
    const Integer length = sqrt(Integer(norm - 1)) + 1;
    const Rational r = closest_fraction(ratio, length, 2 * root_above(norm), result.error);
    result.s = numerator(r);
    result.w = denominator(r);
  } else {
    // An angle closer to 180 than any fraction says becomes 180 itself: w = 0.
    const Rational r = closest_fraction(inverse_ratio, 1, 2 * root_above(Rational(Integer(1), norm)), result.error);
    result.s = denominator(r);
    result.w = numerator(r);
  }
  return result;
}

}  // namespace

ApproximateRotation approximate(const RotationStep& step) {
  const Axis& v = step.axis;
  if (step.degrees == 180) return {quaternion(0, v[0], v[1], v[2]), 0, 0};

  const Integer norm = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
  const Rational degrees = magnitude(step.degrees);
  const auto known = exact_half_angle(degrees, norm);
  const HalfAngle half = known ? *known : closest_half_angle(degrees, norm);

  const Integer s = step.degrees < 0 ? Integer(-half.s) : half.s;
  const Rational error_degrees = half.error == 0 ? Rational(0) : Rational(half.error * 180 / enclosed_pi(64).low);
  return {quaternion(half.w, s * v[0], s * v[1], s * v[2]), half.error, error_degrees};
}

}  // namespace quoin::rounding
