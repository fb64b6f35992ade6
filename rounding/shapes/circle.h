/// \file
/// Circles as polygons of rational points (1 - t^2, 2 t) / (1 + t^2), close to equal angles.
///
/// The points of a full turn are symmetric about the axes and, but for those at 45 degrees, the diagonals.
#pragma once

#include <cstdint>

#include "rounding/shapes/outline.h"

namespace quoin::rounding {

/// How a polygon approximates a circle.
enum class Fit {
  inscribed,      // its corners lie on the circle
  circumscribed,  // its sides touch the circle
  equal_area,     // its area is that of the circle, to 2^-40 of it
};

/// The rational point of the unit circle closest to this angle among those of t = tan(angle / 2) with denominators up
/// to `precision` within an eighth of a turn.
PlanePoint circle_point(const Rational& degrees, const Integer& precision);
/// That of all primitives.
inline Integer circle_precision() { return Integer(1) << 20; }
/// The corners of a polygon of `sides` sides about the origin, counter-clockwise. Precondition: sides >= 3, radius > 0.
Outline circle_polygon(std::uint32_t sides, const Rational& radius, Fit fit);

}  // namespace quoin::rounding
