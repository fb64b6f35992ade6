/// \file
/// Trihedral polyhedra: those that are determined by their planes, so that rounding these keeps every incidence.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "rounding/shapes/polyhedron.h"

namespace quoin::rounding {

/// Every vertex lies on exactly three distinct planes and every edge on two faces.
struct Trihedral {
  /// Three faces with different planes at each vertex, ascending, and the sign of the determinant of their normals.
  std::vector<std::array<std::uint32_t, 3>> faces;
  std::vector<int> sign;
  /// Of each directed edge (from, to): the face through `to` whose plane does not hold the edge, and on which side of
  /// it `from` lies.
  struct Order {
    std::uint32_t from, to, face;
    int side;
  };
  std::vector<Order> orders;
};
/// Nothing for a polyhedron that is not.
std::optional<Trihedral> trihedral(const Polyhedron& p);

}  // namespace quoin::rounding
