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

/// By triangle: the polygon of the input that it is a part of, `no_source` for one that was added; empty where nobody
/// asks. Whatever drops, cuts or adds triangles does the same here.
using Sources = Array<std::uint32_t>;
inline constexpr std::uint32_t no_source = UINT32_MAX;

/// Drops the triangles that `is_dropped`, and their sources.
template <class Predicate>
void drop_triangles(Array<std::array<std::uint32_t, 3>>& triangles, Sources& sources, Predicate is_dropped) {
  std::size_t kept = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (is_dropped(triangles[t])) continue;
    if (!sources.empty()) sources[kept] = sources[t];
    triangles[kept++] = triangles[t];
  }
  triangles.resize(kept);
  if (!sources.empty()) sources.resize(kept);
}

/// Puts the pieces of a triangle in its place and at the end.
inline void replace_triangle(Array<std::array<std::uint32_t, 3>>& triangles, Sources& sources, std::uint32_t t,
                             const Array<std::array<std::uint32_t, 3>>& pieces) {
  triangles[t] = pieces[0];
  triangles.insert(triangles.end(), pieces.begin() + 1, pieces.end());
  if (!sources.empty()) sources.resize(triangles.size(), sources[t]);
}

/// Whether three grid points lie on one line.
bool collinear(const exact::GridPoint& p, const exact::GridPoint& q, const exact::GridPoint& r);

/// Removes the triangles `slivers` (ascending indices into `triangles`; each has three distinct collinear corners).
/// Where they leave edges of their neighbours that no longer balance, these get corners of the slivers as points, and
/// the neighbours are cut into triangles of positive area: the first stands where the neighbour stood, the others at
/// the end. What was balanced stays balanced. O(n log n); at most one new point for each side of a sliver. False, with
/// nothing changed, when some side lacks its neighbour: then the surface is open. The points are pairwise distinct, and
/// no other triangle has zero area.
bool seal(const Array<exact::GridPoint>& points, Array<std::array<std::uint32_t, 3>>& triangles, Sources& sources,
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
                               Sources& sources, Pairing pairing);

}  // namespace quoin::grid
