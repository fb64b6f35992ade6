#include "api/evaluate.h"

#include <algorithm>
#include <map>

#include "api/access.h"
#include "api/common_grid.h"
#include "api/flatten.h"
#include "api/run.h"
#include "booleans/half_spaces.h"
#include "booleans/parts.h"
#include "exact/predicates.h"

namespace quoin {

using booleans::Body;
using booleans::none;
using booleans::Rule;

namespace {

/// The error of one of the operands: "operand 3" before the place in it. `places` are empty where none is to be named.
Error at_operand(Error error, const Flattened::Places& places, std::size_t operand) {
  if (places.empty()) return error;
  const std::string name = "operand " + std::to_string(places[operand]);
  error.where = error.where.empty() ? name : name + ", " + error.where;
  return error;
}

/// Puts the solids on one grid: their common one, else the finest among theirs.
/// Errors: those of Solid::on_grid.
Result<void> go_to_finest_grid(Flattened& f) {
  const Grid finest = finest_grid(f.solids);
  for (std::size_t i = 0; i < f.solids.size(); ++i) {
    if (f.solids[i].grid() == finest) continue;
    auto moved = f.solids[i].on_grid(finest);
    if (!moved) return at_operand(moved.error(), f.solid_places, i);
    f.solids[i] = std::move(moved).value();
  }
  return {};
}

/// The half-spaces of an expression on one lattice, as planes whose first non-zero normal component is positive; a
/// half-space on the other side of its plane is the complement. Rewrites the leaves.
/// Errors: "bad-plane".
Result<std::vector<exact::Plane>> planes_of(Flattened& f, const grid::Lattice& lattice) {
  const auto less = [](const exact::Plane& p, const exact::Plane& q) { return exact::compare(p, q) < 0; };
  std::map<exact::Plane, std::uint32_t, decltype(less)> known(less);
  std::vector<exact::Plane> planes;
  struct Place {
    std::uint32_t plane;
    bool turned;
  };
  std::vector<Place> places;

  for (std::size_t i = 0; i < f.half_spaces.size(); ++i) {
    const HalfSpace& h = f.half_spaces[i];
    const auto bad = [&](std::string message) {
      return at_operand({ErrorCode::bad_plane, std::move(message)}, f.half_space_places, i);
    };

    std::array<exact::Rational, 4> coefficients;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto number = exact::parse_rational(h.plane[k]);
      if (!number)
        return bad("the coefficient \"" + h.plane[k].substr(0, 80) +
                   "\" of a plane is neither a decimal nor a rational p/q");
      coefficients[k] = *number;
    }

    const auto plane = grid::grid_plane(lattice, coefficients);
    if (!plane)
      return bad("the plane " + h.plane[0] + "," + h.plane[1] + "," + h.plane[2] + "," + h.plane[3] +
                 " has no normal, or its coefficients in grid steps are longer than 62 bits");
    const bool turned = !exact::is_canonical(*plane);
    const exact::Plane key = turned ? plane->opposite() : *plane;
    const auto [at, is_new] = known.emplace(key, static_cast<std::uint32_t>(planes.size()));
    if (is_new) planes.push_back(key);
    places.push_back({at->second, turned});
  }

  const auto solids = static_cast<std::uint32_t>(f.solids.size());
  for (auto& node : f.expression.nodes) {
    if (node.rule != Rule::operand || node.operand < solids) continue;
    const Place& place = places[node.operand - solids];
    node.operand = solids + place.plane;
    node.negated = node.negated != place.turned;
  }
  return planes;
}

bool is_identity(const booleans::Expression& e) {
  return e.nodes.size() == 1 && e.nodes[0].rule == Rule::operand && !e.nodes[0].negated;
}

/// As one Boolean, but for the terms that are known. Errors name operands unless the expression `is_part` of one.
Result<Solid> evaluate_at_once(const Expression& expression, const KnownTerms& known, bool is_part,
                               const Options& options) {
  Flattened f = flattened(expression, known);
  if (is_part) f.solid_places = f.half_space_places = {};
  if (f.solids.empty())
    return Error{ErrorCode::no_operand, "an expression without a solid has no grid; give it at least one solid"};
  if (options.cancel && options.cancel->load()) return Error{ErrorCode::cancelled, "the operation was cancelled"};
  if (const auto unified = go_to_finest_grid(f); !unified) return unified.error();
  const Grid grid = f.solids[0].grid();
  if (is_identity(f.expression)) return f.solids[f.expression.nodes[0].operand];

  std::vector<const Body*> operands;
  for (const Solid& solid : f.solids) operands.push_back(&Access::operand(solid));
  std::vector<Body> storage;
  if (!f.half_spaces.empty()) {
    const auto planes = planes_of(f, Access::lattice(grid));
    if (!planes) return planes.error();
    const auto clipped = booleans::clip_half_spaces(f.expression, planes.value(), operands, storage, options.cancel);
    if (!clipped) return clipped.error();
  }

  auto result = booleans::evaluate_in_parts(operands, f.expression, run_of(options));
  if (!result) return result.error();
  return Access::solid(grid, std::move(result).value());
}

Result<Solid> evaluate_here(const Expression& expression, const Options& options) {
  const auto shared = large_shared_terms(expression);
  if (!shared) return shared.error();
  const bool in_parts = !shared.value().empty();
  KnownTerms known;
  for (const Expression* term : shared.value()) {
    auto solid = evaluate_at_once(*term, known, in_parts, {.cancel = options.cancel});
    if (!solid) return solid.error();
    known.emplace(Access::node(*term), std::move(solid).value());
  }
  return evaluate_at_once(expression, known, in_parts, options);
}

/// A solid as an operand of one of the flat operations.
Result<Solid> operated(Expression (*combine)(std::vector<Expression>), const std::vector<Solid>& solids,
                       const Options& options) {
  return evaluate(combine({solids.begin(), solids.end()}), options);
}

}  // namespace

Result<Solid> evaluate_flat(Rule rule, const std::vector<const Solid*>& solids, std::uint32_t negated_from,
                            const Options& options) {
  std::vector<const Body*> operands;
  for (const Solid* solid : solids) operands.push_back(&Access::operand(*solid));
  const auto expression = booleans::Expression::flat(rule, static_cast<std::uint32_t>(solids.size()), negated_from);
  auto result = booleans::evaluate_in_parts(operands, expression, run_of(options));
  if (!result) return result.error();
  return Access::solid(solids[0]->grid(), std::move(result).value());
}

Result<Solid> evaluate(const Expression& expression, const Options& options) {
  return run_to_end(options, [&](const Options& run) {
    return with_threads(run.threads, [&] { return evaluate_here(expression, run); });
  });
}

Result<Solid> unite(const std::vector<Solid>& solids, const Options& options) {
  return operated(Expression::unite, solids, options);
}

Result<Solid> intersect(const std::vector<Solid>& solids, const Options& options) {
  return operated(Expression::intersect, solids, options);
}

Result<Solid> difference(const Solid& minuend, const std::vector<Solid>& subtrahends, const Options& options) {
  return evaluate(Expression::difference(minuend, {subtrahends.begin(), subtrahends.end()}), options);
}

Result<Solid> symmetric_difference(const std::vector<Solid>& solids, const Options& options) {
  return operated(Expression::symmetric_difference, solids, options);
}

Result<std::array<Solid, 2>> split(const Solid& solid, const HalfSpace& half_space, const Options& options) {
  const Expression below = half_space;
  std::array<Solid, 2> parts;

  for (std::size_t i = 0; i < 2; ++i) {
    const double from = static_cast<double>(i) / 2;
    auto part =
        evaluate(i == 0 ? Expression(solid) - below : Expression(solid) & below, step_of(options, from, from + 0.5));
    if (!part) {
      Error error = part.error();
      if (error.code == ErrorCode::bad_plane) error.where = {};  // there is no other plane
      return error;
    }
    parts[i] = std::move(part).value();
  }
  return parts;
}

}  // namespace quoin
