/// \file
/// Rotations by decimal angles: an exact rational one close to each, with a certificate.
///
/// Source: C. M. Hoffmann, Geometric and Solid Modeling (1989), 4.3.3 (half-angle substitution).
#pragma once

#include "rounding/motions/motion.h"

namespace quoin::rounding {

struct ApproximateRotation {
  Quaternion by;
  /// Upper bounds of the difference to the stated angle.
  Rational error_radians, error_degrees;
};
/// The quaternion is w + s axis; s / w is the fraction closest to tan(angle / 2) / |axis| of numbers up to about
/// 2^46 ceil(|axis|), or of 8 bits more until the error is at most 2^-92 radians. Where the tangent over the length is
/// rational, as for multiples of 90 degrees about a coordinate axis, the rotation is exact. Odd in the angle.
ApproximateRotation approximate(const RotationStep& step);

}  // namespace quoin::rounding
