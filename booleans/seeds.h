/// \file
/// Where a connected component of surfaces stands among the others: one exact ray per component.
#pragma once

#include "booleans/arrangement.h"

namespace quoin::booleans {

/// Sides of facets and patches: 2 * node is in front (canonical normal; outward normal for patches), + 1 behind.
using Side = std::uint32_t;

/// For one component: the side that sees the space around the component at its lexicographically smallest vertex, and
/// the side of another component's facet that bounds the same space next to it, none when that space reaches infinity.
struct Seed {
  Side outer;
  Side beyond;
};

/// One seed per component. `component_of` maps facets and patches to components 0 .. count - 1.
///
/// Take the lexicographically smallest vertex v of the component C. All of C lies lexicographically after v, so the
/// point v' = v + (delta, -eps, -eps^2) with 1 >> eps >> eps^2 >> delta > 0 is free, and the ray from v' towards -x
/// never meets C. The first facet that it meets, of another component, bounds the space around C there. The shift is
/// symbolic: ties are broken by the signs of plane coefficients, so no ray is ever degenerate.
/// Which side of C sees v': among the edges of C at v take the one of least slope dy/dx, then of least dz (a vertical
/// edge dx = dy = 0 comes before all); all facets around it lie on one side of the vertical plane through it, and the
/// first of them, turning from straight down, shows its outer side.
std::vector<Seed> find_seeds(const Arrangement& a, const std::vector<std::uint32_t>& component_of, std::uint32_t count);

}  // namespace quoin::booleans
