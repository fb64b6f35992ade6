/// \file
/// Affine maps of rationals, exact, and in integers.
#pragma once

#include <array>

#include "rounding/numbers/approximation.h"

namespace quoin::rounding {

using Vector = std::array<Rational, 3>;
using Matrix = std::array<Vector, 3>;  // rows

/// x -> linear x + shift, exactly.
struct AffineMap {
  Matrix linear = {Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}};
  Vector shift = {0, 0, 0};
  friend bool operator==(const AffineMap&, const AffineMap&) = default;

  Vector operator()(const Vector& p) const;
};

/// `first`, then `second`.
AffineMap composed(const AffineMap& first, const AffineMap& second);
/// Precondition: the determinant is not 0.
AffineMap inverse(const AffineMap& map);
Rational determinant(const Matrix& m);
Rational dot(const Vector& a, const Vector& b);
Vector cross(const Vector& a, const Vector& b);
Vector operator+(const Vector& a, const Vector& b);
Vector operator-(const Vector& a, const Vector& b);
Vector operator*(const Rational& s, const Vector& v);

/// An affine map in integers over one denominator: images are found without reducing fractions, whose numbers can be
/// long after many motions.
struct IntegerMap {
  explicit IntegerMap(const AffineMap& map);
  std::array<std::array<Integer, 3>, 3> linear;
  std::array<Integer, 3> shift;
  Integer divisor = 1;

  /// 2^bits times the image of p, each coordinate to the nearest integer, ties to even.
  std::array<Integer, 3> operator()(const Vector& p, unsigned bits) const;
};

/// Precondition: the determinant is not 0.
IntegerMap inverse(const IntegerMap& map);

}  // namespace quoin::rounding
