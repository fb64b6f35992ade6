/// \file
/// Motions: rotations, translations, mirror images and scalings that compose exactly.
///
/// A motion is a word of steps in lowest terms. Steps that say the same kind of thing are added as they were stated,
/// before anything is approximated: angles about one axis as rationals of degrees, vectors, factors. So 360 times 1
/// degree is the identity, and a motion followed by its inverse is the empty word.
/// A rotation by a decimal angle is then carried out by an exact rational rotation close to it, with a certificate.
/// Sources: C. M. Hoffmann, Geometric and Solid Modeling (1989), 4.3.3 (half-angle substitution); integer quaternions
/// give all rational rotations (L. Euler).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "rounding/approximation.h"

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

/// An affine map in doubles, with certified errors: the filter before IntegerMap.
class MapFilter {
 public:
  explicit MapFilter(const AffineMap& map);
  /// The image's coordinate is at most `error` from `value`.
  struct Estimate {
    double value, error;
  };
  /// Of coordinate k of the image of a point whose coordinates are rounded to doubles, or, `in_steps`, integers of at
  /// most 2^30: then rows of integers have no error.
  Estimate operator()(std::size_t k, const std::array<double, 3>& p, bool in_steps) const;

 private:
  struct Row {
    std::array<double, 3> linear;
    double shift;
    bool is_whole;  // integers whose images of such points are below 2^53
  };
  std::array<Row, 3> rows_;
};

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

/// A direction in lowest terms whose first non-zero component is positive.
using Axis = std::array<Integer, 3>;

/// By an angle in degrees, right-handed about the axis through the origin. -180 < degrees <= 180, not 0.
struct RotationStep {
  Axis axis;
  Rational degrees;
  friend bool operator==(const RotationStep&, const RotationStep&) = default;
};
struct TranslationStep {
  Vector by;
  friend bool operator==(const TranslationStep&, const TranslationStep&) = default;
};
/// An exact rotation, given as such.
struct TurnStep {
  Quaternion by;
  friend bool operator==(const TurnStep&, const TurnStep&) = default;
};
/// The mirror image in the plane through the origin with this normal.
struct MirrorStep {
  Axis normal;
  friend bool operator==(const MirrorStep&, const MirrorStep&) = default;
};
/// From the origin, along the axes; factors are positive.
struct ScalingStep {
  Vector by;
  friend bool operator==(const ScalingStep&, const ScalingStep&) = default;
};
using Step = std::variant<RotationStep, TranslationStep, TurnStep, MirrorStep, ScalingStep>;

/// An approximated rotation.
struct ApproximateRotation {
  Quaternion by;
  /// Upper bounds of the difference to the stated angle.
  Rational error_radians, error_degrees;
};
/// The quaternion is w + s axis; s / w is the fraction closest to tan(angle / 2) / |axis| of numbers up to about
/// 2^46 ceil(|axis|), or of 8 bits more until the error is at most 2^-92 radians. Where the tangent over the length is
/// rational, as for multiples of 90 degrees about a coordinate axis, the rotation is exact. Odd in the angle.
ApproximateRotation approximate(const RotationStep& step);

class Motion {
 public:
  /// The identity.
  Motion() = default;
  /// Precondition: the axis is not 0.
  static Motion rotation(const Vector& axis, const Rational& degrees);
  static Motion translation(const Vector& by);
  static Motion turn(const Quaternion& by);
  /// Precondition: the normal is not 0.
  static Motion mirror(const Vector& normal);
  /// Precondition: the factors are positive.
  static Motion scaling(const Vector& by);

  /// This, then `next`.
  Motion then(const Motion& next) const;
  Motion inverse() const;
  /// In the order in which they act.
  const std::vector<Step>& steps() const { return steps_; }
  friend bool operator==(const Motion&, const Motion&) = default;

  /// Appends a step, which joins the last one where they say the same kind of thing.
  void add(Step step);

 private:
  std::vector<Step> steps_;
};

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
};
/// By halves, so that numbers of a long motion stay short for as long as they can: about O(n log^2 n) digits' work.
RealizedMotion realize(const Motion& motion);
/// `first`, then `second`.
RealizedMotion composed(const RealizedMotion& first, const RealizedMotion& second);

}  // namespace quoin::rounding
