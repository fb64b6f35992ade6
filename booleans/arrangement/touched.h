/// \file
/// Touched: the maximal plane regions of the operands that meet something foreign.
#pragma once

#include <memory>

#include "booleans/arrangement/names.h"
#include "booleans/arrangement/segment_tree.h"
#include "booleans/pairs/operands.h"

namespace quoin::booleans {

/// A directed boundary edge of a touched face, the face on its left seen from outside. Those of spared loops are not
/// listed.
struct BoundaryEdge {
  VertexId from, to;
  /// A plane through the edge other than the face's own: that of a neighbouring face, or, where the faces of an edge
  /// are all folded onto one plane, an axis-parallel one.
  PlaneId other;
};

/// One maximal coplanar region of one operand.
struct TouchedFace {
  OperandId operand;
  std::uint32_t source;  // lowest of its faces in the operand
  PlaneId plane;
  bool along;  // its outward normal is the canonical one
  Box box;
  std::uint32_t edges_begin, edges_end;        // in Touched::edges
  std::uint32_t isolated_begin, isolated_end;  // in Touched::isolated
  std::uint32_t spared_begin, spared_end;      // in Touched::spared

  std::uint32_t edge_count() const { return edges_end - edges_begin; }
  /// By how much an operand's winding number changes from the canonical normal's side to the other.
  int jump() const { return along ? 1 : -1; }
};

/// An edge of a touched face at which an untouched face hangs.
struct UntouchedUse {
  VertexId from, to;  // in the direction of the untouched face
  OperandId operand;
  FaceId face;  // the untouched face
};

struct Touched {
  ById<TouchedId, TouchedFace> faces;
  /// The operands are clean: each face covers its plane once at most.
  bool cover_once = true;
  Array<BoundaryEdge> edges;
  Array<VertexId> isolated;  // touching vertices inside faces
  /// Loops of polygons that are not drawn (spared_loops.h), by their numbers in the operand. The first edge of a face
  /// that has some is on its outer loop.
  Array<std::uint32_t> spared;
  Array<UntouchedUse> untouched;
  grid::PagedById<FaceId, TouchedId> touched_of;  // none where a face is untouched
  Array<FaceId> members;                          // the faces that are touched
  /// Of faces with many edges (Thresholds::large_face): their edges in order. Null for the others.
  ById<TouchedId, std::unique_ptr<const SegmentTree>> edge_tree;

  bool is_touched(FaceId f) const { return touched_of[f] != none; }
  std::span<const BoundaryEdge> edges_of(TouchedId t) const {
    return std::span(edges).subspan(faces[t].edges_begin, faces[t].edge_count());
  }
  std::span<const VertexId> isolated_of(TouchedId t) const {
    const TouchedFace& f = faces[t];
    return std::span(isolated).subspan(f.isolated_begin, f.isolated_end - f.isolated_begin);
  }
  std::span<const std::uint32_t> spared_of(TouchedId t) const {
    return std::span(spared).subspan(faces[t].spared_begin, faces[t].spared_end - faces[t].spared_begin);
  }
};

/// The faces of the pairs, with all triangles that are coplanar and connected with them.
Touched collect_touched(const Operands& operands, const FacePairs& pairs, Names& names);

}  // namespace quoin::booleans
