/// \file
/// One grid for many things: which (grid/common_lattice.h has the rule), and how what stands on another gets there.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "api/access.h"
#include "api/doors/import.h"
#include "grid/common_lattice.h"

namespace quoin {

/// The grid that fits all meshes, 3 coordinates a point. Where one of them fits none even by itself, the error of the
/// first such, as named(error, its number).
template <class Named>
Result<Grid> fitting_grid_of(const std::vector<std::span<const double>>& meshes, Named&& named) {
  auto grid = fitting_grid(meshes);
  if (grid) return grid;

  for (std::size_t i = 0; i < meshes.size(); ++i)
    if (const auto alone = fitting_grid(std::span(meshes).subspan(i, 1)); !alone) return named(alone.error(), i);
  return grid;
}

/// The box of a solid's surface; of a derived point it may miss less than a step.
grid::ModelBox model_box(const Solid& solid);

/// The common grid of solids, as a set.
struct CommonGrid {
  Grid grid;
  /// The solids that are exact on it, there; nothing for those that are not.
  std::vector<std::optional<Solid>> exact = {};
};
/// `others`: grids that are candidates, too; `box`: what else shall lie in the world. Precondition: there is a solid,
/// or another grid.
CommonGrid common_grid(std::span<const Solid> solids, std::span<const Grid> others = {},
                       const grid::ModelBox& box = {});

/// A solid on a grid; nothing where it is not exact there.
std::optional<Solid> exactly_on(const Solid& solid, const Grid& grid);

/// A solid on a grid where it need not be exact: rounded once, plane by plane where that keeps its shape and moves
/// nothing farther than rounding its vertices would, else vertex by vertex.
struct Rounded {
  Solid solid;
  /// An upper bound of the movement of any point of its surface; model units, below 7/8 step.
  exact::Rational displacement = 0;
  bool by_planes = true;
  bool vanished = false;
  std::uint64_t resolved_crossings = 0;
};
/// Precondition: the solid lies in the grid's world. Errors: "cancelled".
Result<Rounded> rounded_to(const Solid& solid, const Grid& grid, const std::atomic<bool>* cancel);

/// Gathers an OperationReport.
class OperationRecord {
 public:
  /// `name` is the operand's, or empty.
  void add(const Rounded& rounded, const std::string& name);
  void add_plane(const exact::Rational& displacement);
  /// Nothing happens to nullptr.
  void write_to(OperationReport* report) const;

 private:
  void add_displacement(const exact::Rational& displacement);
  OperationReport report_ = {};
  exact::Rational most_ = 0;
};

/// Puts all solids on their common grid; `tell` hears of each that is rounded.
/// Errors: "inexact-grid" (GridRule::exact), as named(error, its number); "cancelled".
Result<void> go_to_common_grid(std::vector<Solid>& solids, const Options& options,
                               const std::function<Error(Error, std::size_t)>& named,
                               const std::function<void(std::size_t, const Rounded&)>& tell);

}  // namespace quoin
