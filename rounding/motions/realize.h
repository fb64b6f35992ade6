/// \file
/// What is carried out for a motion: one exact rational map, close to what the motion states, with a certificate.
#pragma once

#include <optional>

#include "rounding/motions/motion.h"

namespace quoin::rounding {

/// What is carried out for a motion.
struct RealizedMotion {
  AffineMap map;
  /// The composition of all rotations; nothing when the motion scales or mirrors.
  std::optional<Quaternion> rotation = Quaternion{};
  /// Upper bounds of the sum of the differences between stated and realized angles.
  Rational angle_error_degrees = 0;
  /// A point p is carried to at most displacement_per_unit * |p| + displacement from where the stated motion has it,
  Rational displacement_per_unit = 0, displacement = 0;
  /// and to at most stretch * |p| + reach from the origin.
  Rational stretch = 1, reach = 0;

  /// Whether it is what the motion states.
  bool is_exact() const { return displacement_per_unit == 0 && displacement == 0; }
  /// An upper bound of how far a point, at most `distance` from the origin, is from where the stated motion has it.
  Rational displacement_within(const Rational& distance) const {
    return displacement_per_unit * distance + displacement;
  }
};
/// By halves, so that numbers of a long motion stay short for as long as they can: about O(n log^2 n) digits' work.
RealizedMotion realize(const Motion& motion);
/// `first`, then `second`.
RealizedMotion composed(const RealizedMotion& first, const RealizedMotion& second);

}  // namespace quoin::rounding
