/// \file
/// Patches: untouched faces of one operand that hang together, so that one label does for all of them.
#pragma once

#include "booleans/arrangement/sheets.h"

namespace quoin::booleans {

/// An edge of an untouched face that is no edge of exactly two faces.
struct CrowdedEdge {
  FaceId face;
  std::uint32_t from, to;  // own vertices, in the direction of the face
};

struct Patches {
  grid::PagedById<FaceId, NodeId> of;  // none for touched faces; of a patched body not for gone ones
  Array<OperandId> operand_of;         // by patch: node - first
  NodeId first;                        // patches follow the facets
  /// Per operand: the patch of the untouched faces of far chunks, and of those that hang together with them; none
  /// without far chunks. Where touched faces reach through all of these it has no face. In front of it (of an operand
  /// that is full at infinity: behind it) all is as at infinity.
  ById<OperandId, NodeId> far;
  ById<OperandId, Array<CrowdedEdge>> crowded;

  OperandId operand(NodeId patch) const { return operand_of[patch.value - first.value]; }
  std::uint32_t node_count() const { return first.value + static_cast<std::uint32_t>(operand_of.size()); }
};

/// Faces of clean operands are glued over vertices: an untouched vertex lies on no foreign surface, so all its
/// untouched faces have the same foreign labels, and their own labels are 0 in front and 1 behind. Others are glued
/// over edges of exactly two faces.
Patches glue(const Operands& operands, const Touched& touched, const Sheets& sheets);

}  // namespace quoin::booleans
