/// \file
/// The boundary of a solid as numbers alone: points, planes, faces of loops.
#pragma once

#include <vector>

#include "booleans/body/body.h"
#include "grid/lists/loops.h"

namespace quoin::booleans {

/// What a .quoin file says, and what a body says when its triangles are faces like all others. Grid steps.
/// Nothing is promised: `fault` (validity.h) tests what is declared.
struct Boundary {
  std::vector<exact::Point> vertices;
  std::vector<exact::Plane> planes;  // one a face, normal outwards
  grid::Loops<std::uint32_t> faces;  // of vertex indices
  bool full_at_infinity = false;
  Labels labels = {};  // of the faces, as those of polygons

  std::size_t face_count() const { return planes.size(); }
};

/// Is a face one triangle between grid points?
bool is_raw(const Boundary& boundary, std::size_t face);

/// The body with these faces and labels; triangles between grid points become raw, the others are polygons in their
/// order.
Body body_of(const Boundary& boundary);
/// The boundary's face that each face of that body is.
std::vector<std::uint32_t> faces_in_order_of_body(const Boundary& boundary);

/// Equal numbers in equal order, whatever faces carry: for canonical forms on one grid, equal point sets.
bool operator==(const Boundary& a, const Boundary& b);

/// The same homogeneous numbers.
inline bool is_same(const exact::Point& p, const exact::Point& q) { return p.x == q.x && p.w == q.w; }

/// Distinct edges: unordered pairs of consecutive corners.
std::size_t edge_count(const Boundary& boundary);

}  // namespace quoin::booleans
