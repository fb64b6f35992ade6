/// \file
/// Motions: rotations, translations, mirror images and scalings that compose exactly.
///
/// A motion is a word of steps in lowest terms. Steps that say the same kind of thing are added as they were stated,
/// before anything is approximated: angles about one axis as rationals of degrees, vectors, factors. So 360 times 1
/// degree is the identity, and a motion followed by its inverse is the empty word.
#pragma once

#include <array>
#include <variant>
#include <vector>

#include "rounding/motions/quaternion.h"

namespace quoin::rounding {

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

}  // namespace quoin::rounding
