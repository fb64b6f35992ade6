/// \file
/// Planes with numbers of any length: those of primitives before they are rounded.
#pragma once

#include <array>

#include "exact/geometry.h"
#include "rounding/motions/affine_map.h"

namespace quoin::rounding {

/// n . x + d = 0 with coprime integers of any length; n is not 0. Grid steps.
struct WidePlane {
  std::array<Integer, 3> n;
  Integer d;
  WidePlane opposite() const { return {{-n[0], -n[1], -n[2]}, -d}; }
  friend bool operator==(const WidePlane&, const WidePlane&) = default;
  friend bool operator<(const WidePlane& a, const WidePlane& b) { return a.n != b.n ? a.n < b.n : a.d < b.d; }
};

/// Precondition: the normal is not 0.
WidePlane wide_plane(const Vector& normal, const Rational& offset);
/// The plane of the points that `to_before` carries onto `plane`.
WidePlane moved(const WidePlane& plane, const IntegerMap& to_before);
inline WidePlane moved(const WidePlane& plane, const AffineMap& to_before) {
  return moved(plane, IntegerMap(to_before));
}
/// Of the two orientations, the one whose first non-zero normal component is positive.
bool is_canonical(const WidePlane& plane);
Rational value(const WidePlane& plane, const Vector& p);
/// sin^2 of the angle between two directions.
Rational squared_sine(const std::array<Integer, 3>& a, const std::array<Integer, 3>& b);

Integer dot(const std::array<Integer, 3>& a, const std::array<Integer, 3>& b);
/// |a x b|^2
Integer squared_cross(const std::array<Integer, 3>& a, const std::array<Integer, 3>& b);

}  // namespace quoin::rounding
