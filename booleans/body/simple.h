/// \file
/// Polygons whose loop meets itself nowhere.
#pragma once

#include "booleans/body/body.h"

namespace quoin::booleans {

/// True only where it is proved that a face has one loop, that the loop comes to no point twice, runs counter-clockwise
/// seen from outside, and has no straight corner: then the face is one piece, on the left of its loop. Quadratic, so
/// faces of more than Thresholds::small_face corners are not looked at.
/// Precondition: corners lie on the plane, edges have a length.
bool proved_simple(const Body& body, std::uint32_t face);

}  // namespace quoin::booleans
