/// \file
/// The shells of a boundary, which lies in which, and the parts of the solid that they bound.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "booleans/edges.h"
#include "grid/lists/buckets.h"

namespace quoin::booleans {

/// The connected components of the boundary with touching parts taken apart (`separated`, surface/separated.h), by the
/// faces alone: half-edges are joined where they bound one wedge of the solid. Shells ascend by their lowest faces.
struct ShellsOfFaces {
  std::vector<std::uint32_t> of_face;
  grid::Buckets<> faces;  // by shell, ascending
  std::vector<std::int64_t> genus;

  std::uint32_t count() const { return static_cast<std::uint32_t>(genus.size()); }
};
ShellsOfFaces shells_of_faces(const Boundary& boundary, const Edges& edges);

/// Some faces of a boundary by themselves, in the order given, with their vertices in the same order. Loops of one
/// corner are left out where no edge of these faces ends in their vertex.
Boundary part_of(const Boundary& boundary, std::span<const std::uint32_t> faces);

/// How shells lie in each other, and the connected parts of the solid's interior.
struct ShellForest {
  std::vector<std::uint8_t> is_void;  // by shell: the solid lies outside of it
  std::vector<std::uint32_t> parent;  // by shell: the innermost one around it, or none
  std::vector<std::uint32_t> part;    // by shell: of the interior; parts ascend by their lowest shells
  grid::Buckets<> shells;             // by part, ascending
};

/// A shell lies in all those whose winding number is not 0 at a point of it that lies on no other one: an exact one
/// inside a face. One ray a shell; boxes of faces are searched through a tree.
ShellForest shell_forest(const Boundary& boundary, const ShellsOfFaces& shells);

}  // namespace quoin::booleans
