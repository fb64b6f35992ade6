/// \file
/// Broad phase: which pairs of faces may meet at all.
#pragma once

#include "booleans/stars.h"
#include "booleans/touched.h"

namespace quoin::booleans {

/// Pairs of faces of different operands that may meet: raw triangles that do, other faces whose boxes meet and neither
/// of which lies strictly on one side of the other's
/// plane. A superset of the pairs of closed faces that meet.
std::vector<FaceIdPair> foreign_pairs(const Operands& operands);

/// Pairs of triangles of one closed mesh that meet anywhere but in a corner or edge that they share, and pairs that
/// overlap across a shared one. Empty exactly when the triangles are embedded: they meet in common corners and edges
/// only. `star_of`: the stars of its vertices.
std::vector<FaceIdPair> improper_pairs(const Body& mesh, const std::vector<Star>& star_of);

/// Pairs of faces of one body that may meet anywhere but in corners and edges that both list: a superset of those that
/// do. Faces of more than three corners are paired with themselves as well: their loops may cross.
std::vector<FaceIdPair> doubtful_pairs(const Body& body);

}  // namespace quoin::booleans
