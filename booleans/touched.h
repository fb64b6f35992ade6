/// \file
/// Touched faces: the maximal plane regions of the operands that meet something foreign.
#pragma once

#include <memory>
#include <utility>

#include "booleans/adjacency.h"
#include "booleans/box.h"
#include "booleans/tables.h"

namespace quoin::booleans {

/// A directed boundary edge of a touched face, the face on its left seen from outside. Vertices are table ids.
struct BoundaryEdge {
  std::uint32_t from, to;
  /// A plane through the edge other than the face's own: that of a neighbouring face, or, where the faces of an edge
  /// are all folded onto one plane, an axis-parallel one.
  std::uint32_t other;
};

/// One maximal coplanar region of one operand.
struct TouchedFace {
  std::uint32_t operand;
  std::uint32_t source;  // lowest of its face ids in the operand
  std::uint32_t sheet;   // plane id
  bool along;            // its outward normal is the canonical one
  Box box;
  std::uint32_t edges_begin, edges_end;
  std::uint32_t isolated_begin, isolated_end;
};

/// An edge of a touched face at which an untouched face hangs.
struct UntouchedUse {
  std::uint32_t from, to;       // table ids, in the direction of the untouched face
  std::uint32_t operand, face;  // the untouched face
};

/// Faces of one operand that follow each other, each near those before it, with their box: what is far away is passed
/// over by the chunk. Meshes come in some order that hangs together; where it jumps, a chunk ends.
struct Chunk {
  static constexpr std::uint32_t most = 32;
  std::uint32_t operand;
  std::uint32_t begin, end;  // global face ids
  Box box;
};

/// The operands of one arrangement. Faces of all operands are numbered through.
struct Operands {
  std::vector<const Body*> bodies;
  std::vector<std::uint32_t> base;  // first global face id of each operand, plus the total
  std::vector<Chunk> chunks;

  explicit Operands(std::vector<const Body*> list);
  std::uint32_t face_count() const { return base.back(); }
  /// Operand and local id of a global face id.
  std::pair<std::uint32_t, std::uint32_t> local(std::uint32_t face) const;
};

struct TouchedFaces {
  /// Faces with more edges than this are searched through a tree over their edges.
  static constexpr std::uint32_t large = 48;

  std::vector<TouchedFace> faces;
  std::vector<BoundaryEdge> edges;
  std::vector<std::uint32_t> isolated;
  std::vector<UntouchedUse> untouched;
  std::vector<std::uint32_t> face_of;  // global face id -> index into faces, none when untouched
  /// Per operand: local vertex id -> table id, none where the vertex is on no touched face.
  std::vector<std::vector<std::uint32_t>> vertex_of;
  /// Per operand, of the vertices of touched faces at least; null where nothing is touched.
  std::vector<std::unique_ptr<Adjacency>> adjacency;
  std::vector<std::unique_ptr<BoxTree>> edge_tree;  // per face, items are indices into edges; null for small faces
};

/// Pairs of global face ids.
using FaceIdPair = std::array<std::uint32_t, 2>;

/// The faces of the pairs, with all triangles that are coplanar and connected with them.
TouchedFaces collect_touched(const Operands& operands, const std::vector<FaceIdPair>& near, VertexTable& vertices,
                             PlaneTable& planes);

}  // namespace quoin::booleans
