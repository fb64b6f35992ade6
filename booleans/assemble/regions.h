/// \file
/// The polygons of a result that come from sheets.
#pragma once

#include "booleans/classify/selection.h"
#include "grid/lists/loops.h"

namespace quoin::booleans {

/// A region that has the spared loops of a touched face, too.
struct SparedRegion {
  std::size_t region;
  TouchedId face;
};

/// Polygons in the making, one after the other.
template <class Corner>
struct Regions {
  Array<exact::Plane> planes;  // one a region, outwards
  grid::Loops<Corner> loops;
  Array<SparedRegion> spared;  // by region

  std::size_t size() const { return planes.size(); }
  /// The loops that were added since the last region make one.
  void close(const exact::Plane& plane) {
    planes.push_back(plane);
    loops.end_face();
  }
  /// Room for all regions of other lists, too.
  void reserve(std::size_t regions, std::size_t loop_count, std::size_t corners) {
    planes.reserve(size() + regions);
    loops.reserve(size() + regions, loops.loop_count() + loop_count, loops.corners.size() + corners);
  }
  /// Adds the regions of another list.
  void append(const Regions& more) {
    for (const SparedRegion& s : more.spared) spared.push_back({size() + s.region, s.face});
    loops.append(more.loops);
    planes.insert(planes.end(), more.planes.begin(), more.planes.end());
  }
};

/// Kept facets of each sheet that hang together over elements at which exactly two kept facets meet. A loop of one
/// corner is a vertex inside the region. Regions come in the order of the sheets.
Regions<VertexId> merged_regions(const Arrangement& a, const Selection& selection);

}  // namespace quoin::booleans
