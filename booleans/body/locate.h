/// \file
/// Where a point lies, and where a body does.
#pragma once

#include <optional>

#include "booleans/body/body.h"
#include "exact/rational.h"

namespace quoin::booleans {

/// +1 inside, 0 on the boundary, -1 outside. `point` in grid steps, any rationals.
int locate(const Body& body, const std::array<exact::Rational, 3>& point);

/// The box of the rounded coordinates of all vertices, outward; nothing without faces. A function of the point set: a
/// vertex that need not be there lies between others, and rounding is monotone. May miss a vertex by less than a step.
std::optional<Box> bounds(const Body& body);

}  // namespace quoin::booleans
