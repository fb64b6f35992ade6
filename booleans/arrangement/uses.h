/// \file
/// Uses: which facets and untouched faces meet at each edge.
#pragma once

#include "booleans/arrangement/patches.h"
#include "grid/lists/buckets.h"

namespace quoin::booleans {

/// One facet or untouched face at one edge, which runs from one vertex, its low end, to one with a larger id.
class Use {
 public:
  Use() = default;  // of nothing, and without a value: many are made at once
  /// `plane`: that of the facet's sheet.
  static Use of_facet(VertexId high, NodeId facet, bool left, PlaneId plane, ElementId element) {
    return {high, facet, left, plane.value, element.value};
  }
  static Use of_patch(VertexId high, NodeId patch, bool left, FaceId face) {
    return {high, patch, left, face.value, none};
  }

  VertexId high() const { return static_cast<std::uint32_t>(key_ >> 32); }
  /// The facet, or the patch of the untouched face.
  NodeId node() const { return static_cast<std::uint32_t>(key_) >> 1; }
  /// It lies left of low -> high, seen from its node's front.
  bool left() const { return (key_ & 1) != 0; }
  bool is_facet() const { return element_ != none; }
  /// Precondition of both: is_facet().
  ElementId element() const { return element_; }
  PlaneId plane() const { return of_; }
  /// The untouched face. Precondition: !is_facet().
  FaceId face() const { return of_; }

  friend bool operator==(const Use&, const Use&) = default;
  /// By high end, then node.
  friend bool operator<(const Use& x, const Use& y) { return x.key_ != y.key_ ? x.key_ < y.key_ : x.of_ < y.of_; }

 private:
  Use(VertexId high, NodeId node, bool left, std::uint32_t of, std::uint32_t element)
      : key_(std::uint64_t{high.value} << 32 | node.value << 1 | std::uint32_t{left}), of_(of), element_(element) {}

  std::uint64_t key_;      // the high end, the node, and whether left: a node is below 2^31, as its sides have ids
  std::uint32_t of_;       // the facet's plane, or the untouched face
  std::uint32_t element_;  // none for patches
};

/// All uses, and the patches that they name.
struct Uses {
  Patches patches;
  grid::Buckets<Use> at;  // by the low ends of their edges; those of one edge follow each other

  /// visit(low, uses) for the uses of every edge, by (low, high).
  template <class Visit>
  void for_edges(Visit&& visit) const {
    for (const VertexId low : Ids<VertexId>(at.size())) {
      const auto uses = at[low.value];
      for (std::size_t i = 0, j = 0; i < uses.size(); i = j) {
        while (j < uses.size() && uses[j].high() == uses[i].high()) ++j;
        visit(low, uses.subspan(i, j - i));
      }
    }
  }
};

/// Vertices of crowded edges get names.
Uses collect_uses(const Operands& operands, const Touched& touched, const Sheets& sheets, Names& names);

}  // namespace quoin::booleans
