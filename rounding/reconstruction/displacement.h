/// \file
/// How far rounding moves points: certified upper bounds.
#pragma once

#include <array>
#include <span>

#include "booleans/body/boundary.h"
#include "rounding/motions/affine_map.h"

namespace quoin::rounding {

/// Displacements are measured in units of 2^-unit_bits grid steps.
constexpr unsigned unit_bits = 160;

/// An upper bound of the distance of two points that are within half a unit in every coordinate of these; grid steps.
Rational distance_above(const std::array<Integer, 3>& a, const std::array<Integer, 3>& b);

/// An upper bound of the distance of the boundary's vertices from where the map carries these points, one each.
Rational displacement_above(std::span<const Vector> points, const IntegerMap& map, const booleans::Boundary& boundary);

}  // namespace quoin::rounding
