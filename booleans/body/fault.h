/// \file
/// What is wrong with what a body declares.
#pragma once

#include <optional>
#include <string>

#include "booleans/body/body.h"

namespace quoin::booleans {

/// Checks what a body declares: indices in range, planes reduced and within the ladder's bounds, every corner on its
/// face's plane, no zero-length edge, no zero-area triangle, vertices in the world, every directed edge balanced by its
/// reverse (B1). Nothing when all holds, else a sentence that names the first fault.
/// Does not check that faces do not cross (B2) nor that labels are 0 and 1 (B3).
/// `world`: how far vertices may lie from 0; results on the way to one that half-spaces bound reach one step farther.
std::optional<std::string> fault(const Body& body, std::int32_t world = exact::world);

}  // namespace quoin::booleans
