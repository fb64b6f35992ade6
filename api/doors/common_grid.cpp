#include "api/doors/common_grid.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "api/place.h"
#include "booleans/body/locate.h"
#include "booleans/on_lattice.h"

namespace quoin {

using exact::Rational;
using grid::Lattice;
using grid::ModelBox;

namespace {

bool have_one_grid(std::span<const Solid> solids) {
  return std::all_of(solids.begin(), solids.end(), [&](const Solid& s) { return s.grid() == solids[0].grid(); });
}

/// Solids that are tried on one lattice after the other.
class Trial {
 public:
  explicit Trial(std::span<const Solid> solids) : solids_(solids) {
    for (const Solid& solid : solids) carriers_.emplace_back(Access::body(solid), Access::lattice(solid));
  }

  /// All of them on the lattice; nothing where one is not exact there. That one is the first to be tried again.
  std::optional<std::vector<std::optional<Solid>>> all_on(const Lattice& lattice) {
    const Grid grid = Access::grid(lattice);
    std::vector<std::optional<Solid>> there(solids_.size());
    for (std::size_t n = 0; n < solids_.size(); ++n) {
      const std::size_t i = n == 0 ? suspect_ : n <= suspect_ ? n - 1 : n;
      there[i] = on(i, grid);
      if (there[i]) continue;
      suspect_ = i;
      return std::nullopt;
    }
    return there;
  }

  std::optional<Solid> on(std::size_t i, const Grid& grid) {
    if (solids_[i].grid() == grid) return solids_[i];
    auto body = carriers_[i].to(Access::lattice(grid));
    return body ? std::optional(Access::solid(grid, std::move(*body))) : std::nullopt;
  }

 private:
  std::span<const Solid> solids_;
  std::vector<booleans::Carrier> carriers_;
  std::size_t suspect_ = 0;
};

CommonGrid one_grid(std::span<const Solid> solids) { return {solids[0].grid(), {solids.begin(), solids.end()}}; }

Result<rounding::Reconstructed> placed(const Solid& solid, const Lattice& lattice, Rounding rounding,
                                       const std::atomic<bool>* cancel) {
  const auto shape = shape_of(solid);
  const rounding::RealizedMotion identity;
  auto bodies = place({{shape.get(), {}, &identity}}, lattice, rounding, {.cancel = cancel});
  if (!bodies) return bodies.error();
  return std::move(bodies.value().primitives[0]);
}

}  // namespace

ModelBox model_box(const Solid& solid) {
  ModelBox box;
  const auto bounds = booleans::bounds(Access::body(solid));
  if (!bounds) return box;
  const Lattice& lattice = Access::lattice(solid);
  for (int k = 0; k < 3; ++k) {
    const auto i = static_cast<std::size_t>(k);
    box.low[i] = grid::model_coordinate(lattice, bounds->low[i], k);
    box.high[i] = grid::model_coordinate(lattice, bounds->high[i], k);
  }
  return box;
}

CommonGrid common_grid(std::span<const Solid> solids, std::span<const Grid> others, const ModelBox& box) {
  if (!solids.empty() && others.empty() && box.is_empty() && have_one_grid(solids)) return one_grid(solids);

  std::vector<Lattice> own;
  ModelBox joint = box;
  Rational slack = 0;  // of boxes
  for (const Grid& grid : others) own.push_back(Access::lattice(grid));
  for (const Solid& solid : solids) {
    own.push_back(Access::lattice(solid));
    joint.add(model_box(solid));
    slack = std::max(slack, own.back().step);
  }
  grid::sort_distinct(own);

  Trial trial(solids);
  const auto tried = [&](const Lattice& lattice) -> std::optional<CommonGrid> {
    if (!in_world(lattice, joint, slack)) return std::nullopt;
    auto there = trial.all_on(lattice);
    if (!there) return std::nullopt;
    return CommonGrid{Access::grid(lattice), std::move(*there)};
  };
  for (const Lattice& lattice : own)
    if (auto found = tried(lattice)) return std::move(*found);
  if (joint.is_empty()) return {Access::grid(own[0]), {}};
  for (const Lattice& lattice : lattices_between(own, joint))
    if (auto found = tried(lattice)) return std::move(*found);

  CommonGrid nearest{Access::grid(rounding_lattice(own, joint))};
  for (std::size_t i = 0; i < solids.size(); ++i) nearest.exact.push_back(trial.on(i, nearest.grid));
  return nearest;
}

std::optional<Solid> exactly_on(const Solid& solid, const Grid& grid) { return Trial({&solid, 1}).on(0, grid); }

Result<Rounded> rounded_to(const Solid& solid, const Grid& grid, const std::atomic<bool>* cancel) {
  if (!solid.is_bounded()) {
    auto complement = rounded_to(~solid, grid, cancel);
    if (complement) complement.value().solid = ~complement.value().solid;
    return complement;
  }

  // More than half the diagonal of a cell, by which a vertex can move.
  const Rational most(7, 8);
  const Lattice& lattice = Access::lattice(grid);
  auto there = placed(solid, lattice, Rounding::best, cancel);
  if (!there ? there.error().code != ErrorCode::cancelled : there.value().displacement > most)
    there = placed(solid, lattice, Rounding::vertices, cancel);
  if (!there) return there.error();

  rounding::Reconstructed& r = there.value();
  Rounded rounded;
  rounded.displacement = r.displacement * lattice.step;
  rounded.by_planes = r.by_planes;
  rounded.vanished = r.vanished;
  rounded.resolved_crossings = r.resolved_crossings;
  rounded.solid = Access::solid(grid, std::move(r.body));
  return rounded;
}

void OperationRecord::add(const Rounded& rounded, const std::string& name) {
  ++report_.rounded_operands;
  ++(rounded.by_planes ? report_.by_planes : report_.by_vertices);
  report_.resolved_crossings += rounded.resolved_crossings;
  if (rounded.vanished && report_.vanished_operands++ == 0) report_.vanished_where = name;
  add_displacement(rounded.displacement);
}

void OperationRecord::add_plane(const Rational& displacement) {
  ++report_.rounded_planes;
  add_displacement(displacement);
}

void OperationRecord::add_displacement(const Rational& displacement) {
  if (displacement <= most_) return;
  most_ = displacement;
  report_.max_snap = exact::double_above(displacement);
  // As the rational that a double is it has few digits.
  if (std::isfinite(report_.max_snap)) most_ = exact::to_rational(report_.max_snap);
  report_.max_snap_bound = exact::to_string(most_);
}

void OperationRecord::write_to(OperationReport* report) const {
  if (report) *report = report_;
}

Result<void> go_to_common_grid(std::vector<Solid>& solids, const Options& options,
                               const std::function<Error(Error, std::size_t)>& named,
                               const std::function<void(std::size_t, const Rounded&)>& tell) {
  if (solids.empty() || have_one_grid(solids)) return {};
  CommonGrid common = common_grid(solids);
  for (std::size_t i = 0; i < solids.size(); ++i) {
    if (!common.exact.empty() && common.exact[i]) {
      solids[i] = std::move(*common.exact[i]);
      continue;
    }

    if (options.grid_rule == GridRule::exact)
      return named({ErrorCode::inexact_grid,
                    "no grid that holds all operands exactly was found: this one is not exact on the grid of step " +
                        common.grid.step() + ", which the size of all asks for; the step " + solids[i].grid().step() +
                        " of its own grid would work for it alone"},
                   i);
    auto rounded = rounded_to(solids[i], common.grid, options.cancel);
    if (!rounded) return rounded.error();
    tell(i, rounded.value());
    solids[i] = std::move(rounded.value().solid);
  }
  return {};
}

}  // namespace quoin
