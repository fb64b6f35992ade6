/// \file
/// Motions of one step from numbers that have been read: the factories of Motion (quoin/model.h) after their texts.
#pragma once

#include "quoin/result.h"
#include "rounding/motions/motion.h"

namespace quoin {

/// Errors: "bad-axis".
Result<rounding::Motion> rotation_of(const rounding::Vector& axis, const exact::Rational& degrees);
/// In the order w, x, y, z. Errors: "bad-axis".
Result<rounding::Motion> turn_of(const std::array<exact::Rational, 4>& wxyz);
/// `deviation` becomes the largest difference of two entries. Errors: "not-a-rotation".
Result<rounding::Motion> turn_of(const rounding::Matrix& rows, exact::Rational& deviation);
/// Errors: "bad-axis".
Result<rounding::Motion> mirror_of(const rounding::Vector& normal);
/// Errors: "bad-factor".
Result<rounding::Motion> scaling_of(const rounding::Vector& factors);

}  // namespace quoin
