/// \file
/// The triangles around each vertex of a mesh: do they form one fan, and do they meet in common edges only?
#pragma once

#include <vector>

#include "booleans/body/body.h"

namespace quoin::booleans {

enum class Star : std::uint8_t {
  other,     // neither is known
  ring,      // the triangles form one closed fan: each is followed by one other across a common edge
  embedded,  // and any two of them meet in the vertex or their common edge only
};

/// The star of every grid point of a closed body (B1, no triangle of zero area): of its raw triangles. A vertex without
/// triangles is embedded. `ring` is exact in a mesh of raw triangles; a star that is embedded may go unproved.
///
/// The proof: seen against some direction d every triangle turns counter-clockwise around the vertex, so each fills a
/// sector and no two of its points project to one. Edges are balanced, so the number of sectors over a ray from the
/// vertex is the same for all rays. If it is 1 for one ray, sectors do not overlap; triangles whose sectors share a ray
/// have one common edge over it, as two edges over one ray would be covered twice. A polygon has a part in this by the
/// sector that it fills near its corner; where else it lies does not matter to the triangles.
/// The six directions of the axes are tried first, in 64 bits, then the sum of the triangles' normals, in 128.
Array<Star> stars(const Body& body);

}  // namespace quoin::booleans
