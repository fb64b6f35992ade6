/// \file
/// Where a point lies, and where a body does.
#pragma once

#include <optional>

#include "booleans/body/body.h"
#include "exact/rational.h"

namespace quoin::booleans {

/// +1 inside, 0 on the boundary, -1 outside. `point` in grid steps, any rationals.
int locate(const Body& body, const std::array<exact::Rational, 3>& point);

/// The box of all faces, rounded outward; nothing without faces.
std::optional<Box> bounds(const Body& body);

}  // namespace quoin::booleans
