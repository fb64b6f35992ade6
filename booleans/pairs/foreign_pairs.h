/// \file
/// Pairs of faces of different operands that may meet.
#pragma once

#include "booleans/pairs/operands.h"

namespace quoin::booleans {

/// Pairs of faces of different operands that may meet: raw triangles that do, other faces whose boxes meet and neither
/// of which lies strictly on one side of the other's plane. A superset of the pairs of closed faces that meet.
FacePairs foreign_pairs(const Operands& operands);

}  // namespace quoin::booleans
