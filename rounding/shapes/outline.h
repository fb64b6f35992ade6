/// \file
/// Outlines: closed polygons of the plane, and whether they bound regions.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "quoin/result.h"
#include "rounding/numbers/approximation.h"

namespace quoin::rounding {

using PlanePoint = std::array<Rational, 2>;
using Outline = std::vector<PlanePoint>;
/// An outline and those of its holes.
using Region = std::vector<Outline>;

Rational cross(const PlanePoint& a, const PlanePoint& b);
PlanePoint operator-(const PlanePoint& a, const PlanePoint& b);
/// Twice the enclosed area, positive where the outline is counter-clockwise.
Rational doubled_area(std::span<const PlanePoint> outline);

/// The same regions with outlines counter-clockwise, holes clockwise, and without repeated corners and those on a
/// straight side. Errors: "bad-primitive" where outlines cross, touch, or run back on themselves, where one encloses no
/// area, where a hole does not lie inside its outline alone, and where regions overlap.
Result<std::vector<Region>> oriented(const std::vector<Region>& regions);

}  // namespace quoin::rounding
