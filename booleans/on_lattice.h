/// \file
/// A body on another lattice.
#pragma once

#include "booleans/body/body.h"
#include "grid/grid.h"
#include "quoin/result.h"

namespace quoin::booleans {

/// The same point set in the steps of another lattice, exactly. Grid points that come to lie between those of `to`
/// become derived points, and triangles the maximal faces that they are parts of.
/// Errors, with the vertex or face that does not fit: "inexact-grid", which names a step that would work;
/// "out-of-range" (beyond the world).
Result<Body> on_lattice(const Body& body, const grid::Lattice& from, const grid::Lattice& to);

}  // namespace quoin::booleans
