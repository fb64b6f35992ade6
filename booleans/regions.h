/// \file
/// The polygons of a result that come from sheets.
#pragma once

#include "booleans/arrangement.h"

namespace quoin::booleans {

/// Polygons in the making, one after the other.
struct Regions {
  std::vector<exact::Plane> planes;         // one a region, outwards
  std::vector<std::uint32_t> loops = {0};   // region i has the loops loops[i] .. loops[i + 1] - 1
  std::vector<std::uint32_t> starts = {0};  // loop j has the corners starts[j] .. starts[j + 1] - 1
  std::vector<std::uint32_t> corners;

  std::size_t size() const { return planes.size(); }
  /// A loop of the region that is closed next.
  void add_loop(std::span<const std::uint32_t> loop) {
    corners.insert(corners.end(), loop.begin(), loop.end());
    starts.push_back(static_cast<std::uint32_t>(corners.size()));
  }
  void close(const exact::Plane& plane) {
    planes.push_back(plane);
    loops.push_back(static_cast<std::uint32_t>(starts.size() - 1));
  }
  /// visit(loop) for every loop of region i.
  template <class Visit>
  void for_loops(std::size_t i, Visit&& visit) const {
    for (std::uint32_t j = loops[i]; j < loops[i + 1]; ++j)
      visit(std::span(corners).subspan(starts[j], starts[j + 1] - starts[j]));
  }
};

/// Kept facets of each sheet that hang together over elements at which exactly two kept facets meet. A loop of one
/// corner is a vertex inside the region. Corners are table ids; regions come in the order of the sheets.
Regions merged_regions(const Arrangement& a, const Selection& selection);

}  // namespace quoin::booleans
