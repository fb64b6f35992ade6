/// \file
/// Touched faces: the maximal plane regions of the operands that meet something foreign.
#pragma once

#include <memory>
#include <utility>

#include "booleans/adjacency.h"
#include "booleans/box_tree.h"
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

/// A chunk of one operand; faces are global ids.
struct OperandChunk : Chunk {
  std::uint32_t operand;
  bool far;  // meets the bounds of no other operand: all its faces lie where the others are as they are at infinity
};

/// The operands of one arrangement. Faces of all operands are numbered through.
struct Operands {
  std::vector<const Body*> bodies;
  std::vector<std::uint32_t> base;  // first global face id of each operand, plus the total
  std::vector<OperandChunk> chunks;
  std::vector<std::uint32_t> first_chunk;  // of each operand, plus the total
  std::vector<Box> bounds;                 // of each operand

  /// More operands than this are not compared one by one.
  static constexpr std::size_t few = 8;

  explicit Operands(std::vector<const Body*> list);
  std::uint32_t face_count() const { return base.back(); }
  /// False when the box, of faces of that operand, meets no other operand's bounds; of many operands not all are asked.
  bool may_be_near(std::uint32_t operand, const Box& box) const {
    bool near = bodies.size() > few;
    for (std::uint32_t o = 0; o < bodies.size() && !near; ++o) near = o != operand && box.meets(bounds[o]);
    return near;
  }
  std::span<const OperandChunk> chunks_of(std::uint32_t operand) const {
    return std::span(chunks).subspan(first_chunk[operand], first_chunk[operand + 1] - first_chunk[operand]);
  }
  /// The chunks of one operand, in its own face ids, that meet a box.
  std::vector<Chunk> chunks_meeting(std::uint32_t operand, const Box& box) const;
  /// Operand and local id of a global face id.
  std::pair<std::uint32_t, std::uint32_t> local(std::uint32_t face) const {
    if (bodies.size() == 2) return face < base[1] ? std::pair(0u, face) : std::pair(1u, face - base[1]);
    const auto at = std::upper_bound(base.begin(), base.end(), face) - 1;
    return {static_cast<std::uint32_t>(at - base.begin()), face - *at};
  }
};

struct TouchedFaces {
  /// Faces with more edges than this are searched through a tree over their edges.
  static constexpr std::uint32_t large = 48;

  std::vector<TouchedFace> faces;
  std::vector<BoundaryEdge> edges;
  std::vector<std::uint32_t> isolated;
  std::vector<UntouchedUse> untouched;
  std::vector<std::uint32_t> face_of;  // global face id -> index into faces, none when untouched
  std::vector<std::uint32_t> members;  // global ids of the faces that have one
  /// Per operand: local vertex id -> table id, none where the vertex is on no touched face.
  std::vector<std::vector<std::uint32_t>> vertex_of;
  std::vector<std::vector<std::uint32_t>> table_vertices;  // per operand: the local ids that have one
  /// The table id of a vertex, which enters the table if need be. Precondition: vertex_of[operand] has its size.
  std::uint32_t table_id(const Body& body, std::uint32_t operand, std::uint32_t v, VertexTable& vertices);
  /// Per operand, of the vertices of touched faces at least; null where nothing is touched.
  std::vector<std::unique_ptr<Adjacency>> adjacency;
  std::vector<std::unique_ptr<BoxTree>> edge_tree;  // per face, items are indices into edges; null for small faces
};

/// The faces of the pairs, with all triangles that are coplanar and connected with them.
TouchedFaces collect_touched(const Operands& operands, const std::vector<FaceIdPair>& near, VertexTable& vertices,
                             PlaneTable& planes);

}  // namespace quoin::booleans
