/// \file
/// Where a connected component of surfaces stands among the others: one exact ray per component.
#pragma once

#include "booleans/classify/sides.h"

namespace quoin::booleans {

/// Nodes that hang together over edges.
struct Components {
  ById<NodeId, ComponentId> of;
  std::uint32_t count = 0;
};

/// For one component: the side that sees the space around the component at its lexicographically smallest vertex, and
/// the side of another component's node that bounds the same space next to it, none when that space reaches infinity.
/// No outer side: the component bounds nothing (an operand trusted wrongly).
struct Seed {
  SideId outer;
  SideId beyond;
};

/// One seed for each component that is not placed yet.
///
/// Take the lexicographically smallest vertex v of the component C, and among its edges at v the one of least slope
/// dy/dx, then of least dz (a vertical edge dx = dy = 0 comes before all); let d be its direction. All facets around it
/// lie on one side of the vertical plane through it, and the first of them, turning from straight down, shows its outer
/// side to the point s = v + t d - t^2 y - t^3 z + t^4 x, t > 0 infinitely small.
/// The ray from s towards -y never meets C: near v all of C has a slope of at least d's, and all of C lies
/// lexicographically after v. The first facet that it meets belongs to another component and bounds the same space; no
/// facet passes between v and s, because none meets the edge but in v. That component has a smaller vertex, or the same
/// one and a smaller slope, so following the seeds ends at infinity.
/// The shift is symbolic: ties are broken by signs of lower terms, so no ray is ever degenerate.
std::vector<Seed> find_seeds(const Arrangement& a, const Components& components,
                             const ById<ComponentId, std::uint8_t>& is_placed);

}  // namespace quoin::booleans
