/// \file
/// Meshes become solids.
#pragma once

#include <span>

#include "quoin/quoin.h"

namespace quoin {

/// The grid that fits the points of several meshes together; points that are not finite are left to import.
/// Errors: "out-of-range".
Result<Grid> fitting_grid(std::span<const std::span<const double>> meshes);

}  // namespace quoin
