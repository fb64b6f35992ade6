/// \file
/// Exact questions about bodies.
#pragma once

#include <optional>

#include "booleans/body.h"
#include "exact/rational.h"

namespace quoin::booleans {

/// +1 inside, 0 on the boundary, -1 outside. `point` in grid steps, any rationals.
int locate(const Body& body, const std::array<exact::Rational, 3>& point);

/// The box of all faces, rounded outward; nothing without faces.
std::optional<Box> bounds(const Body& body);

/// Checks what a body declares: indices in range, planes reduced and within the ladder's bounds, every corner on its
/// face's plane, no zero-length edge, no zero-area triangle, vertices in the world, every directed edge balanced by its
/// reverse (B1). Nothing when all holds, else a sentence that names the first fault.
/// Does not check that faces do not cross (B2) nor that labels are 0 and 1 (B3).
/// `world`: how far vertices may lie from 0; results on the way to one that half-spaces bound reach one step farther.
std::optional<std::string> fault(const Body& body, std::int32_t world = exact::world);

}  // namespace quoin::booleans
