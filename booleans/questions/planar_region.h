/// \file
/// Polygons from their edges.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "exact/rational.h"
#include "grid/lists/loops.h"

namespace quoin::booleans {

using PlanarPoint = std::array<exact::Rational, 2>;
using PlanarArc = std::array<std::uint32_t, 2>;  // points from, to

/// A bounded region of the plane, regularized.
struct PlanarRegion {
  std::vector<std::uint32_t> points;    // those that are needed, ascending
  grid::Loops<std::uint32_t> polygons;  // of places in that list; the loop around a polygon first, then its holes
  exact::Rational area = 0;
};

/// The region on the left of arcs that meet in points alone, and are balanced: as many end at a point as begin there.
/// Loops and polygons as in `Section`, in order of the points' numbers. Nothing where that is not so.
std::optional<PlanarRegion> planar_region(const std::vector<PlanarPoint>& points, const std::vector<PlanarArc>& arcs);

}  // namespace quoin::booleans
