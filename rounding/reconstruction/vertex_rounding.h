/// \file
/// Rounding vertex by vertex: to the nearest grid points. Crossings that this makes are resolved as on import.
#pragma once

#include <cstdint>

#include "quoin/result.h"
#include "rounding/reconstruction/placement.h"

namespace quoin::rounding {

/// What is thinner than a step may vanish. Errors: "bad-primitive" (a face that is no region), "out-of-range".
Result<Reconstructed> round_vertices(std::uint32_t primitive, const Placement& placement, CarriedPoints& points);

}  // namespace quoin::rounding
