/// \file
/// Placements that need no rounding: every moved plane and point is one of the grid's.
#pragma once

#include <cstdint>
#include <optional>

#include "booleans/body/body.h"
#include "rounding/reconstruction/placement.h"

namespace quoin::rounding {

/// The body whose planes and points the motion carries to ones of the grid; nothing where one of them does not fit.
/// `points` are asked for when all planes fit.
std::optional<booleans::Body> exact_body(std::uint32_t placement, const Placement& p, CarriedPoints& points);

}  // namespace quoin::rounding
