/// \file
/// One grid for many things.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "api/access.h"
#include "api/import.h"

namespace quoin {

/// The finest grid of some solids, the first of equally fine ones. Precondition: there is one.
inline Grid finest_grid(std::span<const Solid> solids) {
  return std::min_element(
             solids.begin(), solids.end(),
             [](const Solid& a, const Solid& b) { return Access::lattice(a).step < Access::lattice(b).step; })
      ->grid();
}

/// The grid that fits all meshes, 3 coordinates a point. Where one of them fits none even by itself, the error of the
/// first such, as named(error, its number).
template <class Named>
Result<Grid> fitting_grid_of(std::span<const std::span<const double>> meshes, Named&& named) {
  auto grid = fitting_grid(meshes);
  if (grid) return grid;

  for (std::size_t i = 0; i < meshes.size(); ++i)
    if (const auto alone = fitting_grid(meshes.subspan(i, 1)); !alone) return named(alone.error(), i);
  return grid;
}

}  // namespace quoin
