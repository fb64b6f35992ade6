/// \file
/// Meshes become solids.
#pragma once

#include <span>

#include "quoin/quoin.h"

namespace quoin {

/// The box of the points of several meshes; points that are not finite are left to import, and without any the box is
/// {0}.
Box mesh_box(std::span<const std::span<const double>> meshes);

/// The grid that fits the points of several meshes together; points that are not finite are left to import.
/// Errors: "out-of-range".
Result<Grid> fitting_grid(std::span<const std::span<const double>> meshes);

/// Inside is winding number > 0, so that nothing is left of a body that is inside out among others: the last notice of
/// a report with dropped shells.
Notice notice_of_dropped_shells(std::uint64_t count);

}  // namespace quoin
