/// \file
/// Triangles of rational corners: what floating-point filters leave undecided.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "booleans/surface/triangulated.h"

namespace quoin::booleans {

using RationalTriangle = std::array<RationalPoint, 3>;

RationalTriangle rational(const std::array<std::array<double, 3>, 3>& t);

/// A normal of any length, outwards.
RationalPoint normal(const RationalTriangle& t);

/// Do triangles that have areas, and whose first corners are the shared ones, meet anywhere else than in their shared
/// corners and edges?
bool meet_out_of_place(const RationalTriangle& t, const RationalTriangle& u, std::size_t shared);

/// What a ray along axis k, up or down, does at a triangle: 1 where it leaves through it, -1 where it enters, 0 where
/// it misses it; nothing where it meets its edge, or begins on its plane.
std::optional<int> passage(const RationalPoint& from, std::size_t k, bool up, const RationalTriangle& t);

}  // namespace quoin::booleans
