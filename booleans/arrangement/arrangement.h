/// \file
/// The arrangement of n operands: the facets their touched faces are cut into, the patches of untouched faces, and how
/// all of them hang together in space. docs/arrangement.md states the invariants.
#pragma once

#include "booleans/arrangement/uses.h"

namespace quoin::booleans {

/// The values of all stages, each made from those before it. Names alone have grown from stage to stage.
struct Arrangement {
  Operands operands;
  Names names;
  Touched touched;
  Sheets sheets;
  Uses uses;

  const Patches& patches() const { return uses.patches; }
  std::uint32_t node_count() const { return uses.patches.node_count(); }

  /// visit(face, patch) for every untouched face.
  template <class Visit>
  void for_untouched(Visit&& visit) const {
    for (const OperandChunk& c : operands.chunks)
      for (const FaceId f : Ids<FaceId>(c.begin, c.end))
        if (const NodeId n = patches().of[f]; n != none) visit(f, n);
  }

  /// visit(operand, by) for the change of winding numbers from a node's front (the canonical normal's side, or the
  /// outward one of a patch) to its back.
  template <class Visit>
  void for_jumps(NodeId n, Visit&& visit) const {
    if (!sheets.is_facet(n)) return visit(patches().operand(n), 1);
    for (const TouchedId t : sheets[sheets.sheet_of(n)].covers(sheets.facet_of(n)))
      visit(touched.faces[t].operand, touched.faces[t].jump());
  }
};

}  // namespace quoin::booleans
