/// \file
/// Import, step 4: triangles of zero area give their middle corner to the neighbour over their long edge.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "exact/geometry.h"

namespace quoin::grid {

/// Whether three grid points lie on one line.
bool collinear(const exact::GridPoint& p, const exact::GridPoint& q, const exact::GridPoint& r);

/// Removes the triangles `slivers` (indices into `triangles`; each has three distinct collinear corners). A sliver
/// (a, m, b) with m between a and b and its neighbour (a, b, c) become (a, m, c), in the neighbour's place, and
/// (m, b, c), at the end; longest edges first, until no sliver is left. The sum of the directed edges is unchanged.
/// False when some long edge has no neighbour: then the surface is open, and is left open.
/// The points are pairwise distinct, and no other triangle has zero area.
bool seal(const std::vector<exact::GridPoint>& points, std::vector<std::array<std::uint32_t, 3>>& triangles,
          const std::vector<std::uint32_t>& slivers);

}  // namespace quoin::grid
