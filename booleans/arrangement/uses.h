/// \file
/// Uses: which facets and untouched faces meet at each edge.
#pragma once

#include "booleans/arrangement/patches.h"

namespace quoin::booleans {

/// One facet or untouched face at one edge. The edge runs from its smaller to its larger vertex id.
struct Use {
  VertexId low, high;  // the edge's ends
  NodeId node;         // the facet, or the patch of the untouched face
  PlaneId plane;
  PlaneId line;       // another plane through the edge, none when unknown (patches)
  ElementId element;  // none for patches
  bool left;          // the facet lies left of low -> high, seen from the canonical normal
  bool turned;        // patches: the outward normal is opposite to the canonical one

  bool same_edge(const Use& u) const { return low == u.low && high == u.high; }
};

/// All uses, sorted by (low, high), and the patches that they name.
struct Uses {
  Patches patches;
  Array<Use> list;

  /// visit(uses) for the uses of every edge.
  template <class Visit>
  void for_edges(Visit&& visit) const {
    for (std::size_t i = 0, j = 0; i < list.size(); i = j) {
      while (j < list.size() && list[j].same_edge(list[i])) ++j;
      visit(std::span(list).subspan(i, j - i));
    }
  }
};

/// Planes of untouched faces, and vertices of crowded edges, get names.
Uses collect_uses(const Operands& operands, const Touched& touched, const Sheets& sheets, Names& names);

}  // namespace quoin::booleans
