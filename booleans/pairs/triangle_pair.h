/// \file
/// Exact intersection of grid triangles, all in 128 bits.
#pragma once

#include <array>

#include "booleans/body/body.h"

namespace quoin::booleans {

using GridTriangle = std::array<exact::GridPoint, 3>;

/// Of a raw triangle of a body.
inline GridTriangle triangle(const Body& body, std::uint32_t t) {
  const auto& c = body.triangles[t];
  return {body.grid_points[c[0]], body.grid_points[c[1]], body.grid_points[c[2]]};
}

/// Do the closed segment and the closed triangle (of non-zero area) share a point?
bool meet(const exact::GridPoint& p, const exact::GridPoint& q, const GridTriangle& t);

/// Do two closed triangles (of non-zero area) share a point?
/// Source: P. Guigue, O. Devillers, Fast and robust triangle-triangle overlap test using orientation predicates, 2003.
bool meet(const GridTriangle& p, const GridTriangle& q);

/// Do two raw triangles of a body meet anywhere but in a common corner or edge, or overlap across one?
bool meet_out_of_place(const Body& mesh, std::uint32_t s, std::uint32_t t);

}  // namespace quoin::booleans
