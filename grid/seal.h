/// \file
/// Import, step 4: triangles of zero area go, and their corners become points on their neighbours' edges; so do
/// vertices that lie exactly on the open edges of others.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "exact/geometry.h"
#include "grid/lists/array.h"

namespace quoin::grid {

/// Whether three grid points lie on one line.
bool collinear(const exact::GridPoint& p, const exact::GridPoint& q, const exact::GridPoint& r);

/// Removes the triangles `slivers` (ascending indices into `triangles`; each has three distinct collinear corners).
/// Where they leave edges of their neighbours that no longer balance, these get corners of the slivers as points, and
/// the neighbours are cut into triangles of positive area: the first stands where the neighbour stood, the others at
/// the end. What was balanced stays balanced. O(n log n); at most one new point for each side of a sliver. False, with
/// nothing changed, when some side lacks its neighbour: then the surface is open. The points are pairwise distinct, and
/// no other triangle has zero area.
bool seal(const Array<exact::GridPoint>& points, Array<std::array<std::uint32_t, 3>>& triangles,
          const Array<std::uint32_t>& slivers);

/// Which edges close each other.
enum class Pairing {
  opposite,  // of opposite ways: open edges, by how often they are open
  any,       // edges that an odd number of triangles share, whichever way these look
};

/// Splits open edges at ends of others that lie exactly on them, wherever a stretch of the line between is then closed;
/// neighbours are cut as in `seal`. Where all edges of a line close each other, all of it is closed. Returns the number
/// of points put on edges. O(n log n). No triangle has zero area. Does not depend on the order of points and triangles,
/// but for which of several equal edges is split.
std::uint64_t seal_t_junctions(const Array<exact::GridPoint>& points, Array<std::array<std::uint32_t, 3>>& triangles,
                               Pairing pairing);

}  // namespace quoin::grid
