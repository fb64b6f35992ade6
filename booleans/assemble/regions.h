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
struct Regions {
  struct Plane {
    PlaneId id;
    bool turned;  // the outward normal is opposite to the canonical one
  };
  grid::Loops<VertexId> loops;
  Array<Plane> planes;         // one a region
  Array<SparedRegion> spared;  // by region
  // With labels only:
  Array<Provenance> provenance;      // one a region
  Array<const exact::Plane*> lines;  // by corner: another plane through the edge that begins there, if it is a border

  std::size_t size() const { return planes.size(); }
};

/// Kept facets of each sheet that carry the same and hang together over elements at which exactly two kept facets meet.
/// A loop of one corner is a vertex inside the region. Regions come in the order of the sheets, list by list.
Array<Regions> merged_regions(const Arrangement& a, const Selection& selection);

}  // namespace quoin::booleans
