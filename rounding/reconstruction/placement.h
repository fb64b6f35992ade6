/// \file
/// What is placed on the grid, and what became of it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "booleans/body/boundary.h"
#include "rounding/shapes/polyhedron.h"
#include "rounding/shapes/trihedral.h"

namespace quoin::rounding {

/// A polyhedron with what is asked of it again and again. Its numbers are steps of a lattice, or model units.
struct Shape {
  explicit Shape(Polyhedron p, const grid::Lattice& units = {});
  Polyhedron polyhedron;
  std::optional<Trihedral> trihedral;
  AffineMap to_model;
  /// An upper bound of the distance of its points from the origin, model units.
  Rational reach;
};

/// A shape or a half-space, and where it goes.
struct Placement {
  /// nullptr for a half-space.
  const Shape* shape = nullptr;
  /// Where it is <= 0; model units.
  std::optional<WidePlane> half_space = {};
  /// The shape's units (of a half-space model units) before the motion to grid steps after it. Its determinant is not
  /// 0.
  AffineMap to_grid;

  /// Whether it is a mirror image.
  bool is_turned_round() const { return determinant(to_grid.linear) < 0; }
};

struct Reconstructed {
  /// Empty for a half-space.
  booleans::Body body;
  /// Of a half-space.
  std::optional<exact::Plane> plane;
  /// Rounded plane by plane, or carried exactly.
  bool by_planes = true;
  /// An upper bound of the largest movement of any of its points by rounding; grid steps. 0 for a half-space.
  Rational displacement = 0;
  /// Of a primitive rounded vertex by vertex: what import reports.
  std::uint64_t merged_points = 0, zero_area_triangles = 0, resolved_crossings = 0;
  /// Its vertices were rounded, and nothing is left: the body is empty though the primitive is not.
  bool vanished = false;
};

/// The points of shapes where they are carried, found when they are first asked for: their numbers can be long.
class CarriedPoints {
 public:
  explicit CarriedPoints(std::span<const Placement> placements) : placements_(placements), points_(placements.size()) {}
  /// Precondition: the placement has a shape.
  const std::vector<Vector>& of(std::uint32_t placement);

 private:
  std::span<const Placement> placements_;
  std::vector<std::vector<Vector>> points_;  // by placement
};

/// Gives a boundary the shape's loops, turned round by a mirror image, and what its faces carry.
void place_faces(const Placement& placement, booleans::Boundary& boundary);

}  // namespace quoin::rounding
