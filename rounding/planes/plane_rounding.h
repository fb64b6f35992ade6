/// \file
/// Element rounding: from a plane with numbers of any length to a near plane with bounded ones.
///
/// Laws, for every method but face_local (a plane is oriented; -p is the opposite one):
///   R1  A plane that fits the bounds is left as it is.
///   R2  round(-p) = -round(p): opposite planes stay opposite, coincident ones coincident.
///   R3  `best`, `lattice`: the result's direction depends on the plane's direction alone, so parallel planes stay
///       parallel.
/// Sources: C. M. Hoffmann, Geometric and Solid Modeling (1989), 4.3.4 for naive and continued-fraction rounding, with
/// its slips mended: the sign of the divisor (S06), a normal that vanishes (S07), the common denominator of three
/// fractions (S08). K. Sugihara proposed lattice reduction; direction first and face_local are this engine's.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <utility>

#include "exact/geometry.h"
#include "rounding/planes/wide_plane.h"

namespace quoin::rounding {

enum class Method {
  /// The direction closest to the plane's of those that naive, continued-fraction and lattice rounding find for a plane
  /// through the origin; then the offset that keeps the point of the plane nearest to the origin, as well as a fraction
  /// can. The default.
  best,
  /// All four coefficients scaled so that the largest, by its bound, reaches it; then each to the nearest integer.
  naive,
  /// The ratios to the largest coefficient by continued fractions of denominators up to the cube root of its bound.
  continued_fraction,
  /// A short vector of a lattice of approximations to the direction (LLL); offset as for `best`.
  lattice,
  /// The least movement of given points of the plane that a lattice of direction and offset together gives.
  face_local,
};

/// Rounds to |a|, |b|, |c| <= `coefficient` and |d| <= `offset`. For one thread.
class PlaneRounder {
 public:
  /// The bounds of exact/ladder.h.
  PlaneRounder();
  /// Precondition: within those.
  PlaneRounder(Integer coefficient, Integer offset);

  bool fits(const WidePlane& plane) const;
  /// Nothing where the offset exceeds its bound, or (naive, continued_fraction) the normal would vanish.
  /// Precondition: not face_local.
  std::optional<exact::Plane> round(const WidePlane& plane, Method method) const;
  /// face_local: never moves the points farther than `best`. Precondition: three of the points are not collinear.
  std::optional<exact::Plane> round_near(const WidePlane& plane, std::span<const Vector> points) const;

 private:
  using Normal = std::array<Integer, 3>;
  std::optional<exact::Plane> naive(const WidePlane& plane) const;
  std::optional<exact::Plane> continued_fraction(const WidePlane& plane) const;
  std::optional<exact::Plane> with_direction(const WidePlane& plane, const Normal& direction) const;
  const Normal& rounded_direction(const Normal& n, Method method) const;
  Normal shortened(const Normal& n) const;
  Normal naive_direction(const Normal& n) const;
  Normal continued_fraction_direction(const Normal& n) const;
  Normal lattice_direction(const Normal& n) const;
  std::optional<exact::Plane> checked(const Normal& n, const Integer& d) const;

  Integer coefficient_, offset_;
  mutable std::map<std::pair<Normal, Method>, Normal> directions_;  // those asked for: parallel planes share one
};

/// The largest squared distance of the points from a plane; squared grid steps.
Rational squared_displacement(const exact::Plane& plane, std::span<const Vector> points);

}  // namespace quoin::rounding
