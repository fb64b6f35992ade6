/// \file
/// Sides of facets and patches: what cells are made of.
#pragma once

#include "booleans/arrangement/arrangement.h"

namespace quoin::booleans {

/// 2 * node is in front of a node (canonical normal; outward normal for patches), 2 * node + 1 behind it.
using SideId = grid::Id<struct SideKind>;

inline SideId front_of(NodeId n) { return 2 * n.value; }
inline SideId back_of(NodeId n) { return 2 * n.value + 1; }
inline NodeId node_of(SideId s) { return s.value / 2; }
inline bool is_back(SideId s) { return (s.value & 1) != 0; }
/// The other side of the same node.
inline SideId opposite(SideId s) { return s.value ^ 1; }

}  // namespace quoin::booleans
