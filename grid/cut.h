/// \file
/// Import, step 3: polygons are cut into triangles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "exact/geometry.h"
#include "grid/blockers.h"

namespace quoin::grid {

/// Cuts polygons of any number of corners; keeps its memory from one to the next.
class Cutter {
 public:
  explicit Cutter(const Array<exact::GridPoint>& points) : points_(points) {}

  /// Appends triangles whose directed edges sum up to those of the polygon; returns whether the polygon is planar.
  /// `corners`: at least 3, neighbours (also the last and the first) differ.
  /// Every corner remains a corner of a triangle. For a simple polygon, seen along the axis nearest to its normal, the
  /// triangles have positive area, meet only in corners and edges, and cover it. For one that is not simple they are
  /// right as a sum only: they may overlap, have zero area or two equal corners.
  bool cut(std::span<const std::uint32_t> corners, Array<std::array<std::uint32_t, 3>>& triangles);

 private:
  bool project(std::span<const std::uint32_t> corners);
  bool strictly_convex() const;
  void clip_ears(std::span<const std::uint32_t> corners, Array<std::array<std::uint32_t, 3>>& triangles);
  bool is_ear(std::span<const std::uint32_t> corners, std::uint32_t i) const;

  const Array<exact::GridPoint>& points_;
  bool flat_ = false;  // the area vector is zero: there is no projection
  Array<FlatPoint> flat_points_;
  Array<std::uint32_t> previous_, next_, queue_, waiting_;
  Blockers blockers_;
};

}  // namespace quoin::grid
