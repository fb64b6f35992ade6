/// \file
/// Import, step 2: equal grid points become one.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "exact/geometry.h"
#include "grid/lists/array.h"

namespace quoin::grid {

struct Weld {
  /// For each old point the id of the one that stands for it; empty when all were distinct (ids are unchanged).
  Array<std::uint32_t> ids;
  /// Distinct positions in the input beyond one a grid point.
  std::uint64_t merged = 0;
};

/// Keeps the first of equal points, in their order. O(n), and O(n log n) when hashing fails.
/// `input`: the positions before snapping, 3 doubles a point; 0 and -0 are the same.
/// `expected`: a guess at how many distinct points there are; only speed depends on it.
Weld weld(Array<exact::GridPoint>& points, std::span<const double> input, std::size_t expected);
/// The same by sorting.
Weld weld_by_sorting(Array<exact::GridPoint>& points, std::span<const double> input);

}  // namespace quoin::grid
