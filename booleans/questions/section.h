/// \file
/// Plane sections.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "booleans/questions/index.h"
#include "exact/rational.h"
#include "grid/lists/loops.h"

namespace quoin::booleans {

/// A plane a x + b y + c z + d = 0 of integers of any length, grid steps; the normal is not 0.
using IntegerPlane = std::array<exact::Integer, 4>;

/// The closure of the points of a plane that are inside a solid: where the solid only touches the plane with a face or
/// an edge there is nothing. Polygons without common interior. A loop runs counter-clockwise seen from the plane's
/// positive side, a hole clockwise; parts that touch in a vertex alone are polygons of their own, holes that touch the
/// loop around them or each other are one loop with it.
/// A function of point set and plane: vertices are in order of (x, y, z), there only where they must be; loops and
/// polygons are in the order of faces in the canonical form.
struct Section {
  std::vector<std::array<exact::Rational, 3>> vertices;
  grid::Loops<std::uint32_t> polygons;  // of vertices; the loop around the polygon first, then its holes
  /// The area of the projection along the axis in which the normal is longest: |n_k| / |n| of the area.
  exact::Rational projected_area = 0;
};

/// Nothing of a body that was trusted wrongly. Precondition: the solid is empty at infinity.
std::optional<Section> section(const Index& index, const IntegerPlane& plane);

}  // namespace quoin::booleans
