/// \file
/// What a node of a model says in one scope: its primitive, its half-space or its motion, all numbers read.
#pragma once

#include "api/model/formula.h"
#include "api/model/node.h"
#include "rounding/shapes/polyhedron.h"

namespace quoin {

bool is_motion(ModelKind kind);

/// Errors of all: "bad-number", "bad-parameter".
/// Precondition: a primitive that is no half-space and no solid.
/// Errors: "bad-primitive", "bad-plane", "unbounded", "too-large", "cancelled".
Result<rounding::Polyhedron> primitive_of(const Access::ModelNode& node, Parameters& parameters, const Limits& limits,
                                          const Options& run);
/// Precondition: a half-space. Errors: "bad-plane".
Result<rounding::WidePlane> half_space_of(const Access::ModelNode& node, Parameters& parameters);
/// Precondition: is_motion(node.kind). Errors: "bad-axis", "bad-factor", "not-a-rotation".
Result<rounding::Motion> motion_of(const Access::ModelNode& node, Parameters& parameters);

/// A half-space of the grid as a term, in model units.
Expression half_space(const exact::Plane& plane, const grid::Lattice& lattice);

}  // namespace quoin
