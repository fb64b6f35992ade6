/// \file
/// Reconstruction: primitives, each moved exactly, become clean bodies on the grid.
///
/// A trihedral primitive is rounded plane by plane and keeps every incidence: no vertex leaves a face, flat faces stay
/// flat. All others are rounded vertex by vertex; crossings that this makes are resolved as on import.
/// The unit of rounding is the plane: coincident planes of different primitives are one class and are rounded once.
/// Sources: C. M. Hoffmann, Geometric and Solid Modeling (1989), 4.3.5 (reconstruction, 24 consistency conditions of a
/// block).
///
/// Consistency conditions of a rounded trihedral primitive:
///   C1  at every vertex the determinant of the three normals keeps its sign;
///   C2  along every edge the two vertices keep their order;
///   C3  its faces are simple and do not cross (the rounded body is clean).
/// For a simple convex polyhedron they hold exactly when every vertex lies strictly below each of the planes not
/// through it, 2 (F - 2)(F - 3) conditions for F faces, and C1 does.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "quoin/result.h"
#include "rounding/planes/plane_rounding.h"
#include "rounding/reconstruction/placement.h"

namespace quoin::rounding {

struct Reconstruction {
  std::vector<Reconstructed> primitives;  // as the placements
  /// Distinct planes of all primitives rounded plane by plane.
  std::uint64_t planes = 0;
  /// Of these: those that fitted, and those that a violated condition made face_local.
  std::uint64_t exact_planes = 0, face_local_planes = 0;
};

struct ReconstructionOptions {
  Method method = Method::best;
  /// Round all primitives vertex by vertex.
  bool by_vertices = false;
  /// Called with the fraction that is done.
  std::function<void(double)> progress = {};
  const std::atomic<bool>* cancel = nullptr;
};

/// When a condition is violated the classes of the planes concerned are rounded by `best`, then by `face_local`.
/// Errors: "inconsistent-motion" (naming the vertex and the plane whose condition no rounding keeps; also where
/// rounding vertex by vertex leaves nothing of a primitive; `where` is the primitive), "out-of-range" (a vertex beyond
/// the world; naming the factor by which the step must grow), "bad-primitive" (a face that is no region), "cancelled".
Result<Reconstruction> reconstruct(std::span<const Placement> placements, const ReconstructionOptions& options = {});

}  // namespace quoin::rounding
