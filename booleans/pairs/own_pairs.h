/// \file
/// Pairs of faces of one body that may meet out of place.
#pragma once

#include "booleans/body/stars.h"
#include "booleans/pairs/operands.h"

namespace quoin::booleans {

/// Pairs of triangles of one closed mesh that meet anywhere but in a corner or edge that they share, and pairs that
/// overlap across a shared one. Empty exactly when the triangles are embedded: they meet in common corners and edges
/// only. `star_of`: the stars of its vertices.
FacePairs improper_pairs(const Body& mesh, const Array<Star>& star_of);

/// Pairs of faces of one body that may meet anywhere but in corners and edges that both list: a superset of those that
/// do. Faces of more than three corners are paired with themselves as well where their loops may cross.
FacePairs doubtful_pairs(const Body& body);

}  // namespace quoin::booleans
