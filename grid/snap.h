/// \file
/// Import, step 1: model coordinates become grid points.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "exact/geometry.h"
#include "grid/grid.h"
#include "grid/lists/array.h"
#include "quoin/result.h"

namespace quoin::grid {

struct Snapped {
  Array<exact::GridPoint> points;
  /// Upper bound of the largest move, model units; 0 exactly when no point moved.
  double max_snap = 0;
};

/// Each coordinate goes to the nearest grid coordinate, ties to even.
/// Precondition: points.size() is a multiple of 3. Errors: "non-finite", "out-of-range".
Result<Snapped> snap(std::span<const double> points, const Lattice& lattice);

/// The shortest decimal that reads back to the same double.
std::string describe_number(double value);
/// "(x, y, z)", each number the shortest that reads back to the same double.
std::string describe_point(const double* point);
/// The same for a grid point, in model units, correctly rounded.
std::string describe_point(const Lattice& lattice, const exact::GridPoint& point);

}  // namespace quoin::grid
