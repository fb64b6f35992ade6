#include "api/evaluate.h"

#include <map>
#include <unordered_set>
#include <utility>

#include "api/access.h"
#include "api/doors/common_grid.h"
#include "api/flatten.h"
#include "api/run.h"
#include "booleans/body/locate.h"
#include "booleans/half_spaces.h"
#include "booleans/pairs/operands.h"
#include "booleans/parts.h"
#include "exact/predicates.h"
#include "rounding/planes/noisy_plane.h"
#include "rounding/shapes/polyhedron.h"

namespace quoin {

using booleans::Body;
using booleans::none;
using booleans::Rule;

namespace {

/// "operand 3"; `places` are empty where none is to be named.
std::string operand_name(const Flattened::Places& places, std::size_t operand) {
  return places.empty() ? "" : "operand " + std::to_string(places[operand]);
}

/// The error of one of the operands: its name before the place in it.
Error at_operand(Error error, const Flattened::Places& places, std::size_t operand) {
  if (places.empty()) return error;
  const std::string name = operand_name(places, operand);
  error.where = error.where.empty() ? name : name + ", " + error.where;
  return error;
}

/// Puts the solids on their common grid.
Result<void> unify(Flattened& f, const Options& options, OperationRecord& record) {
  return go_to_common_grid(
      f.solids, options, [&](Error error, std::size_t i) { return at_operand(std::move(error), f.solid_places, i); },
      [&](std::size_t i, const Rounded& rounded) { record.add(rounded, operand_name(f.solid_places, i)); });
}

/// The leaves of an expression that are solids, each once, in the order in which it names them first.
std::vector<const Access::ExpressionNode*> solid_leaves(const Expression& expression) {
  std::vector<const Access::ExpressionNode*> leaves, pending{Access::node(expression)};
  std::unordered_set<const Access::ExpressionNode*> seen;
  while (!pending.empty()) {
    const Access::ExpressionNode* node = pending.back();
    pending.pop_back();
    if (!node || !seen.insert(node).second) continue;
    if (node->kind == Access::ExpressionNode::Kind::solid) leaves.push_back(node);
    for (std::size_t i = node->terms.size(); i-- > 0;) pending.push_back(Access::node(node->terms[i]));
  }
  return leaves;
}

using Origins = std::shared_ptr<const booleans::Origins>;

/// The same where terms are evaluated by themselves: the leaves become known as what they are on the common grid.
/// Returns the origins of all, so that the terms are named as the whole would be.
Result<Origins> unify(const Expression& expression, KnownTerms& known, const Options& options,
                      OperationRecord& record) {
  std::vector<Solid> solids;
  std::vector<std::size_t> numbers;
  std::map<std::pair<const Body*, const grid::Lattice*>, std::size_t> first;
  const auto leaves = solid_leaves(expression);
  for (const auto* leaf : leaves) {
    const auto [at, is_new] =
        first.try_emplace({Access::identity(leaf->solid), &Access::lattice(leaf->solid)}, solids.size());
    if (is_new) solids.push_back(leaf->solid);
    numbers.push_back(at->second);
  }

  const auto unified = go_to_common_grid(
      solids, options, [](Error error, std::size_t) { return error; },
      [&](std::size_t, const Rounded& rounded) { record.add(rounded, ""); });
  if (!unified) return unified.error();
  for (std::size_t i = 0; i < leaves.size(); ++i) known.emplace(leaves[i], solids[numbers[i]]);
  std::vector<const Body*> bodies;
  for (const Solid& solid : solids) bodies.push_back(&Access::operand(solid));
  return booleans::joint_origins(bodies);
}

/// What the solids reach, in steps of their grid; without any surface the world.
rounding::Vector corner(const std::vector<const Body*>& solids, bool high) {
  std::optional<booleans::Box> joint;
  for (const Body* solid : solids)
    if (const auto box = booleans::bounds(*solid)) {
      if (!joint) joint = box;
      joint->add(*box);
    }
  rounding::Vector r;
  for (std::size_t k = 0; k < 3; ++k)
    // A box may miss less than a step.
    r[k] = !joint ? (high ? exact::world : -exact::world) : high ? joint->high[k] + 1 : joint->low[k] - 1;
  return r;
}

/// A plane on a lattice, exactly or, where the rule allows it, rounded; nothing where neither goes.
std::optional<exact::Plane> plane_on(const grid::Lattice& lattice, const std::array<exact::Rational, 4>& coefficients,
                                     const std::vector<const Body*>& solids, GridRule rule, OperationRecord& record) {
  if (const auto exact = grid::grid_plane(lattice, coefficients)) return exact;
  const auto& [a, b, c, d] = coefficients;
  if (rule == GridRule::exact || (a == 0 && b == 0 && c == 0)) return std::nullopt;

  const rounding::WidePlane wide = moved(rounding::wide_plane({a, b, c}, d), inverse(rounding::to_grid(lattice)));
  const auto plane = rounding::plane_from_noise(wide);
  if (plane)
    record.add_plane(rounding::distance_within(wide, *plane, corner(solids, false), corner(solids, true)) *
                     lattice.step);
  return plane;
}

/// The half-spaces of an expression on one lattice, as planes whose first non-zero normal component is positive; a
/// half-space on the other side of its plane is the complement. Rewrites the leaves.
/// Errors: "bad-plane".
Result<std::vector<exact::Plane>> planes_of(Flattened& f, const grid::Lattice& lattice,
                                            const std::vector<const Body*>& bodies, const Options& options,
                                            OperationRecord& record) {
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

    const auto plane = plane_on(lattice, coefficients, bodies, options.grid_rule, record);
    if (!plane)
      return bad("the plane " + h.plane[0] + "," + h.plane[1] + "," + h.plane[2] + "," + h.plane[3] +
                 (options.grid_rule == GridRule::exact
                      ? " has no normal, or its coefficients in grid steps are longer than 62 bits"
                      : " has no normal, or lies too far from the grid"));
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
/// `origins`: those of all operands, null for those of this expression.
Result<Solid> evaluate_at_once(const Expression& expression, const KnownTerms& known, bool is_part,
                               const Origins& origins, const Options& options, OperationRecord& record) {
  Flattened f = flattened(expression, known);
  if (is_part) f.solid_places = f.half_space_places = {};
  if (f.solids.empty())
    return Error{ErrorCode::no_operand, "an expression without a solid has no grid; give it at least one solid"};
  if (options.cancel && options.cancel->load()) return Error{ErrorCode::cancelled, "the operation was cancelled"};
  if (const auto unified = unify(f, options, record); !unified) return unified.error();
  const Grid grid = f.solids[0].grid();
  if (is_identity(f.expression)) return f.solids[f.expression.nodes[0].operand];

  std::vector<const Body*> operands;
  for (const Solid& solid : f.solids) operands.push_back(&Access::operand(solid));
  std::vector<Body> storage;
  if (!f.half_spaces.empty()) {
    const auto planes = planes_of(f, Access::lattice(grid), operands, options, record);
    if (!planes) return planes.error();
    const auto clipped = booleans::clip_half_spaces(f.expression, planes.value(), operands, storage, options.cancel);
    if (!clipped) return clipped.error();
  }

  auto result = booleans::evaluate_in_parts(operands, f.expression, run_of(options), origins);
  if (!result) return result.error();
  return Access::solid(grid, std::move(result).value());
}

Result<Solid> evaluate_here(const Expression& expression, const Options& options, OperationRecord& record) {
  const auto shared = large_shared_terms(expression);
  if (!shared) return shared.error();
  const bool in_parts = !shared.value().empty();
  KnownTerms known;
  Origins origins;
  if (in_parts) {
    auto unified = unify(expression, known, options, record);
    if (!unified) return unified.error();
    origins = std::move(unified).value();
  }

  for (const Expression* term : shared.value()) {
    auto solid = evaluate_at_once(*term, known, in_parts, origins, {.cancel = options.cancel}, record);
    if (!solid) return solid.error();
    known.emplace(Access::node(*term), std::move(solid).value());
  }
  return evaluate_at_once(expression, known, in_parts, origins, options, record);
}

/// A solid as an operand of one of the flat operations.
Result<Solid> operated(Expression (*combine)(std::vector<Expression>), const std::vector<Solid>& solids,
                       const Options& options, OperationReport* report) {
  return evaluate(combine({solids.begin(), solids.end()}), options, report);
}

}  // namespace

Result<Solid> evaluate_flat(Rule rule, std::vector<Solid> solids, std::uint32_t negated_from) {
  const auto unified = go_to_common_grid(
      solids, {}, [](Error error, std::size_t) { return error; }, [](std::size_t, const Rounded&) {});
  if (!unified) return unified.error();

  std::vector<const Body*> operands;
  for (const Solid& solid : solids) operands.push_back(&Access::operand(solid));
  const auto expression = booleans::Expression::flat(rule, static_cast<std::uint32_t>(solids.size()), negated_from);
  auto result = booleans::evaluate_in_parts(operands, expression, run_of({}));
  if (!result) return result.error();
  return Access::solid(solids[0].grid(), std::move(result).value());
}

Result<Solid> evaluate(const Expression& expression, const Options& options, OperationReport* report) {
  OperationRecord record;
  auto result = run_to_end(options, [&](const Options& run) {
    return with_threads(run.threads, [&] { return evaluate_here(expression, run, record); });
  });
  record.write_to(report);
  return result;
}

Result<Solid> unite(const std::vector<Solid>& solids, const Options& options, OperationReport* report) {
  return operated(Expression::unite, solids, options, report);
}

Result<Solid> intersect(const std::vector<Solid>& solids, const Options& options, OperationReport* report) {
  return operated(Expression::intersect, solids, options, report);
}

Result<Solid> difference(const Solid& minuend, const std::vector<Solid>& subtrahends, const Options& options,
                         OperationReport* report) {
  return evaluate(Expression::difference(minuend, {subtrahends.begin(), subtrahends.end()}), options, report);
}

Result<Solid> symmetric_difference(const std::vector<Solid>& solids, const Options& options, OperationReport* report) {
  return operated(Expression::symmetric_difference, solids, options, report);
}

Result<std::array<Solid, 2>> split(const Solid& solid, const HalfSpace& half_space, const Options& options,
                                   OperationReport* report) {
  const Expression below = half_space;
  std::array<Solid, 2> parts;

  for (std::size_t i = 0; i < 2; ++i) {
    const double from = static_cast<double>(i) / 2;
    auto part = evaluate(i == 0 ? Expression(solid) - below : Expression(solid) & below,
                         step_of(options, from, from + 0.5), report);
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
