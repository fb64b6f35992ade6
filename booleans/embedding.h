/// \file
/// Proof that a body that came from outside is clean.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "booleans/body/body.h"

namespace quoin::booleans {

/// What breaks B2 or B3 of a body (body.h) and where, in grid steps; none when it is clean and each face is one piece.
/// Preconditions: no `fault` (body/fault.h), no two faces that are alone at an edge are coplanar, and every edge lies
/// on two planes that are not parallel.
///
/// The second half of the arrangement decides: the faces are drawn with all that meets them, and a clean body adds
/// nothing to its own drawing; then the sides of all faces are labelled as in any Boolean.
///
/// `faces`, when given, receives what the sentence is about, ascending: two faces that meet out of place, or one that
/// meets itself or has the wrong sides; of a patched body by their numbers in the packed one. Empty where no single
/// face shows the fault.
std::optional<std::string> embedding_fault(const Body& body, Array<std::uint32_t>* faces = nullptr);

}  // namespace quoin::booleans
