/// \file
/// One view of every facet in space, whether cut or untouched.
#pragma once

#include "booleans/arrangement.h"

namespace quoin::booleans {

/// A facet to shoot at: a facet of a sheet, or an untouched face.
struct Target {
  std::uint32_t sheet;  // none for untouched faces
  std::uint32_t index;  // facet of the sheet, or global face id
};

/// All targets of an arrangement with their boxes; edges of sheet facets are indexed once.
class Targets {
 public:
  explicit Targets(const Arrangement& a);

  std::size_t size() const { return targets_.size(); }
  const Box& box(std::uint32_t t) const { return boxes_[t]; }
  /// Facet or patch number.
  std::uint32_t node(std::uint32_t t) const;
  /// Canonical plane, and whether a patch's outward normal is opposite to it.
  exact::Plane plane(std::uint32_t t, bool& turned) const;
  /// Does the line in direction x through v, shifted by (-eps, -eps^2) in (y, z), pass through the target?
  /// Precondition: the plane's normal has a component along x.
  bool crossed(std::uint32_t t, const exact::Plane& plane, const exact::Point& v) const;

 private:
  bool edge_counts(const exact::Plane& plane, const exact::Point& a, const exact::Point& b, const exact::Plane* line,
                   const exact::Point& v) const;

  const Arrangement& a_;
  std::vector<Target> targets_;
  std::vector<Box> boxes_;
  struct SheetEdges {
    std::vector<std::uint32_t> start, half_edges;  // half-edges by facet
  };
  std::vector<SheetEdges> sheet_edges_;
};

}  // namespace quoin::booleans
