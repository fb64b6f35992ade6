/// \file
/// Exact intersection of grid triangles, all in 128 bits.
#pragma once

#include <array>

#include "exact/geometry.h"

namespace quoin::booleans {

using GridTriangle = std::array<exact::GridPoint, 3>;

/// The sign of the volume of (a, b, c, d): +1 when d lies on the positive side of the plane through a, b, c.
/// Differences are at most 2^30, so the determinant is below 2^93.
int orientation(const exact::GridPoint& a, const exact::GridPoint& b, const exact::GridPoint& c,
                const exact::GridPoint& d);

/// Do the closed segment and the closed triangle (of non-zero area) share a point?
bool meet(const exact::GridPoint& p, const exact::GridPoint& q, const GridTriangle& t);

/// Do two closed triangles (of non-zero area) share a point?
/// Source: P. Guigue, O. Devillers, Fast and robust triangle-triangle overlap test using orientation predicates, 2003.
bool meet(const GridTriangle& p, const GridTriangle& q);

}  // namespace quoin::booleans
