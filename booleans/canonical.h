/// \file
/// The one form of a point set: maximal faces, maximal edges, only the vertices that must be, all in canonical order.
#pragma once

#include "booleans/body.h"

namespace quoin::booleans {

/// Equal point sets on one grid have equal canonical forms, whatever their histories.
///
/// Take at each boundary point the dimension of the space of directions in which the tangent cone is invariant:
/// vertices are the points of dimension 0, edges and faces the connected components of those of dimension 1 and 2.
/// Every vertex on a face is listed: a touching vertex inside it as a loop of one corner, a touching edge inside it as
/// a slit, run along both ways. Order: vertices by exact (x, y, z), each reduced; a loop starts at its smallest
/// half-edge (origin, target); the loop of a face with its smallest vertex comes first, then the others by their
/// corners; faces by plane (a, b, c, d), then by their loops.
struct Canonical {
  std::vector<exact::Point> vertices;
  std::vector<exact::Plane> planes;               // one a face, reduced, normal outwards
  std::vector<std::uint32_t> face_loops = {0};    // face i has the loops face_loops[i] .. face_loops[i + 1] - 1
  std::vector<std::uint32_t> loop_corners = {0};  // loop j has the corners corners[loop_corners[j]] ..
  std::vector<std::uint32_t> corners;             // vertex indices
  bool full_at_infinity = false;

  std::size_t face_count() const { return planes.size(); }
};

/// Precondition: a clean body (B1 - B4).
Canonical canonical(const Body& body);
/// The body of a canonical form; triangles between grid points become raw.
Body body_of(const Canonical& form);

bool operator==(const Canonical& a, const Canonical& b);

/// Distinct edges: unordered pairs of consecutive corners.
std::size_t edge_count(const Canonical& form);

}  // namespace quoin::booleans
