/// \file
/// A body on another lattice.
#pragma once

#include <optional>

#include "booleans/body/body.h"
#include "booleans/body/boundary.h"
#include "grid/grid.h"
#include "quoin/result.h"

namespace quoin::booleans {

/// The same point set in the steps of another lattice, exactly. Grid points that come to lie between those of `to`
/// become derived points, and triangles the maximal faces that they are parts of.
/// Errors, with the vertex or face that does not fit: "inexact-grid", which names a step that would work;
/// "out-of-range" (beyond the world).
Result<Body> on_lattice(const Body& body, const grid::Lattice& from, const grid::Lattice& to);

/// A body that is tried on several lattices. Body and lattice must outlive it.
class Carrier {
 public:
  Carrier(const Body& body, const grid::Lattice& from) : body_(body), from_(from) {}
  /// As on_lattice; nothing where it is not exact. On a lattice that holds all points of a lattice where it is exact it
  /// is exact, too, if it lies in the world.
  std::optional<Body> to(const grid::Lattice& lattice);

 private:
  const Body& body_;
  const grid::Lattice& from_;
  std::optional<Boundary> form_ = {};  // canonical, when it was needed
};

}  // namespace quoin::booleans
