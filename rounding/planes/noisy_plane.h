/// \file
/// Planes that were given in floating point: their numbers are too long for a grid, and their last digits mean nothing.
#pragma once

#include <array>
#include <optional>

#include "rounding/planes/plane_rounding.h"

namespace quoin::rounding {

/// A plane that fits is itself. Of any other the direction becomes the one of the shortest numbers (below 2, 2^2, 2^4,
/// ..., 2^62) that turns it by at most 2^-50, which is what doubles leave open and moves no point of the world by more
/// than some 2^-20 steps; else the closest. Then the offset as PlaneRounder does it. Of (6.1e-17, 0, 1) the direction
/// is (0, 0, 1).
/// A function of the plane alone, with the laws R1, R2 and R3 of plane_rounding.h. Nothing where the plane lies too far
/// from the origin. Grid steps.
std::optional<exact::Plane> plane_from_noise(const WidePlane& plane);

/// An upper bound of the distance between two planes of nearly one direction: of a point of one of them, within the
/// box, from the other. Grid steps.
Rational distance_within(const WidePlane& a, const exact::Plane& b, const Vector& low, const Vector& high);

}  // namespace quoin::rounding
