/// \file
/// The one form of a point set: maximal faces, maximal edges, only the vertices that must be, all in canonical order.
#pragma once

#include <utility>

#include "booleans/body/boundary.h"

namespace quoin::booleans {

/// Equal point sets on one grid have equal canonical forms, whatever their histories.
///
/// Take at each boundary point the dimension of the space of directions in which the tangent cone is invariant:
/// vertices are the points of dimension 0, edges and faces the connected components of those of dimension 1 and 2.
/// Every vertex on a face is listed: a touching vertex inside it as a loop of one corner, a touching edge inside it as
/// a slit, run along both ways. Planes and points are reduced. Order: vertices by exact (x, y, z); a loop starts at its
/// smallest half-edge (origin, target); the loop of a face with its smallest vertex comes first, then the others by
/// their corners; faces by plane (a, b, c, d), then by their loops.
/// Only `canonical` makes one; what is to be changed is kept as a Boundary.
class Canonical : public Boundary {
  friend Canonical canonical(const Body& body);
  explicit Canonical(Boundary&& form) : Boundary(std::move(form)) {}
};

/// Precondition: a clean body (B1 - B4).
Canonical canonical(const Body& body);

/// The same, but that faces on one plane are one face only where they carry the same: with vertices where borders
/// between such end or bend, and with labels. What a face carries is the first of what its parts do
/// (Origins::comes_before). Without labels the canonical form.
Boundary labelled_boundary(const Body& body);
/// The same, with the faces of the canonical form that its faces are parts of.
struct LabelledForm {
  Boundary boundary;
  Array<std::uint32_t> whole;
};
LabelledForm labelled_form(const Body& body);

/// How much the canonical form has, without making it.
struct CanonicalCounts {
  std::size_t vertices, edges, faces;
};
/// Precondition: a clean body.
CanonicalCounts canonical_counts(const Body& body);

}  // namespace quoin::booleans
