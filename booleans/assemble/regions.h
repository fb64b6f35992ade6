/// \file
/// The polygons of a result that come from sheets.
#pragma once

#include "booleans/classify/selection.h"
#include "grid/lists/loops.h"

namespace quoin::booleans {

/// Polygons in the making, one after the other.
template <class Corner>
struct Regions {
  std::vector<exact::Plane> planes;  // one a region, outwards
  grid::Loops<Corner> loops;

  std::size_t size() const { return planes.size(); }
  /// The loops that were added since the last region make one.
  void close(const exact::Plane& plane) {
    planes.push_back(plane);
    loops.end_face();
  }
};

/// Kept facets of each sheet that hang together over elements at which exactly two kept facets meet. A loop of one
/// corner is a vertex inside the region. Regions come in the order of the sheets.
Regions<VertexId> merged_regions(const Arrangement& a, const Selection& selection);

}  // namespace quoin::booleans
