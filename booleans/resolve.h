/// \file
/// Meshes that may cross themselves become clean bodies.
#pragma once

#include "booleans/pairs/own_pairs.h"
#include "booleans/run.h"
#include "quoin/result.h"

namespace quoin::booleans {

/// A clean body with the points of winding number > 0 of a closed but otherwise arbitrary triangle mesh (B1 alone, raw
/// triangles without zero area). `crossings` counts the pairs of faces that met out of place; where many shells crowd
/// each other, those that were found to meet as the shells were united, group by group.
/// A single embedded surface is taken as it is: it must not be inside out.
/// Errors: "cancelled".
Result<Body> resolve(Body mesh, std::uint64_t& crossings, const Run& run = {});

/// The same in one arrangement of all faces, also of a surface that is inside out. `pairs`: `improper_pairs`.
Result<Body> resolved_at_once(const Body& mesh, const FacePairs& pairs, const Run& run = {});

}  // namespace quoin::booleans
