/// \file
/// Rational rotations as integer quaternions: these give all of them (L. Euler).
#pragma once

#include <array>
#include <optional>

#include "rounding/motions/affine_map.h"

namespace quoin::rounding {

/// A rational rotation as an integer quaternion w + x i + y j + z k in lowest terms, its first non-zero number
/// positive: equal rotations have equal quaternions. It turns by 2 atan(|(x, y, z)| / w) about (x, y, z).
struct Quaternion {
  Integer w = 1, x = 0, y = 0, z = 0;
  friend bool operator==(const Quaternion&, const Quaternion&) = default;
};
/// In lowest terms. Precondition: not all are 0.
Quaternion quaternion(Integer w, Integer x, Integer y, Integer z);
/// The same for rationals in the order w, x, y, z; nothing when all are 0.
std::optional<Quaternion> quaternion_along(const std::array<Rational, 4>& v);
/// `first`, then `second`.
Quaternion composed(const Quaternion& first, const Quaternion& second);
Matrix matrix(const Quaternion& q);
/// The rotation that a matrix is, exactly; nothing unless its rows are orthonormal and its determinant is 1.
std::optional<Quaternion> exact_rotation(const Matrix& m);

/// The rotation that a matrix is; else, to about 2^-62, the one nearest to it (least sum of squared differences), with
/// quaternion numbers below 2^62. `deviation` becomes the largest difference of two entries. Nothing when some entry of
/// m m^T differs from the identity by more than 1e-6 or the determinant is negative: the matrix is then no rotation.
std::optional<Quaternion> nearest_rotation(const Matrix& m, Rational& deviation);

}  // namespace quoin::rounding
