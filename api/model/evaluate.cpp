#include "api/evaluate.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>

#include "api/doors/common_grid.h"
#include "api/doors/import.h"
#include "api/model/gather.h"
#include "api/model/primitive.h"
#include "api/run.h"

namespace quoin {

using exact::Rational;
using ModelNode = Access::ModelNode;

namespace {

/// The corners of a primitive where its motion has it; none of a half-space.
std::vector<double> corners_of(const Placed& p) {
  constexpr double most = std::numeric_limits<double>::max();
  std::vector<double> points;
  if (!p.shape) return points;
  const rounding::AffineMap map = composed(p.shape->to_model, p.motion->map);
  for (const auto& v : p.shape->polyhedron.points)
    // Beyond the doubles any coordinate is too far: the largest says so.
    for (const Rational& x : map(v)) points.push_back(std::clamp(exact::to_double(x), -most, most));
  return points;
}

/// The same, exactly.
void add_corners(const Placed& p, grid::ModelBox& box) {
  if (!p.shape) return;
  const rounding::AffineMap map = composed(p.shape->to_model, p.motion->map);
  for (const auto& v : p.shape->polyhedron.points) box.add(map(v));
}

/// Counts a solid at rest that was rounded among the primitives.
void add_to(MotionReport& report, const Rounded& rounded, const std::string& name) {
  ++report.primitives;
  ++(rounded.by_planes ? report.by_planes : report.by_vertices);
  report.resolved_crossings += rounded.resolved_crossings;
  if (rounded.vanished && report.vanished_primitives++ == 0) report.vanished_where = name;
  if (rounded.displacement > *exact::parse_rational(report.displacement_bound))
    report_displacement(report, rounded.displacement);
}

/// One that fits all primitives. Errors: "out-of-range", naming the node.
Result<Grid> grid_around(const Gathered& g) {
  std::vector<std::vector<double>> corners;
  for (const Placed& p : g.primitives) corners.push_back(corners_of(p));
  const std::vector<std::span<const double>> meshes(corners.begin(), corners.end());
  return fitting_grid_of(meshes, [&](const Error& error, std::size_t i) { return at_node(error, *g.leaves[i]); });
}

/// The common grid of the model's solids and of the box of its primitives, or one that fits the primitives alone.
Result<Grid> grid_of(const Gathered& g) {
  if (g.solids.empty()) return grid_around(g);
  std::vector<Solid> at_rest;
  for (const Term& term : g.terms)
    if (term.node->kind == ModelKind::solid && term.primitive == nowhere) at_rest.push_back(*term.node->solid);

  std::vector<Grid> grids;
  for (const Solid& solid : g.solids) grids.push_back(solid.grid());
  grid::ModelBox box;
  for (const Placed& p : g.primitives) add_corners(p, box);
  return common_grid(at_rest, grids, box).grid;
}

/// The solids that stay where they are, on the grid, by their terms: exactly or, where no grid `is_asked` for, rounded.
Result<std::map<const Term*, Solid>> solids_at_rest(const Gathered& g, const Grid& grid, bool is_asked,
                                                    const Options& run, MotionReport& report) {
  std::map<const Term*, Solid> there;
  for (const Term& term : g.terms) {
    const ModelNode& node = *term.node;
    if (node.kind != ModelKind::solid || term.primitive != nowhere) continue;
    if (is_asked || run.grid_rule == GridRule::exact) {
      const auto exact = node.solid->on_grid(grid);
      if (!exact) return at_node(exact.error(), node);
      there.emplace(&term, exact.value());
      continue;
    }

    if (auto exact = exactly_on(*node.solid, grid)) {
      there.emplace(&term, std::move(*exact));
      continue;
    }
    const auto rounded = rounded_to(*node.solid, grid, run.cancel);
    if (!rounded) return rounded.error();
    add_to(report, rounded.value(), name_of(node));
    there.emplace(&term, rounded.value().solid);
  }
  return there;
}

/// An error of `place` says the primitive's number: the node says more.
Error named(Error error, const std::vector<const ModelNode*>& leaves) {
  const std::string word = "primitive ";
  if (error.where.compare(0, word.size(), word) != 0) return error;
  std::size_t length = 0;
  const std::size_t i = std::stoul(error.where.substr(word.size()), &length);
  error.where = name_of(*leaves[i]) + error.where.substr(word.size() + length);
  return error;
}

/// The expression of a leaf. The body of its primitive is used up.
Expression leaf(const Term& term, const Grid& grid, const std::map<const Term*, Solid>& at_rest,
                std::vector<rounding::Reconstructed>& primitives) {
  const ModelNode& node = *term.node;
  if (term.primitive == nowhere) return at_rest.at(&term);
  if (node.kind == ModelKind::half_space) return half_space(*primitives[term.primitive].plane, Access::lattice(grid));

  const Expression e = Access::solid(grid, std::move(primitives[term.primitive].body));
  return node.kind == ModelKind::solid && !node.solid->is_bounded() ? Expression::complement(e) : e;
}

Expression joined(ModelKind kind, std::vector<Expression> terms) {
  switch (kind) {
    case ModelKind::all:
      return Expression::intersect(std::move(terms));
    case ModelKind::odd:
      return Expression::symmetric_difference(std::move(terms));
    case ModelKind::complement:
      return Expression::complement(terms[0]);
    case ModelKind::difference:
      if (terms.empty()) return Expression::unite({});
      return Expression::difference(terms[0], {terms.begin() + 1, terms.end()});
    default:
      return Expression::unite(std::move(terms));
  }
}

/// The expression of the root.
Expression expression(const Gathered& g, const Grid& grid, const std::map<const Term*, Solid>& at_rest,
                      std::vector<rounding::Reconstructed>& primitives) {
  std::vector<Expression> known;
  for (const Term& term : g.terms) {
    if (rule_of(term.node->kind).children == ModelChildren::none) {
      known.push_back(leaf(term, grid, at_rest, primitives));
      continue;
    }

    std::vector<Expression> terms;
    for (const std::size_t child : term.children) terms.push_back(known[child]);
    known.push_back(joined(term.node->kind, std::move(terms)));
  }
  return known[g.root];
}

Result<Solid> evaluated(const Model& model, const ModelOptions& options, const Options& run, MotionReport* report) {
  if (!Access::node(model)) return Solid::empty(options.grid ? *options.grid : Grid());
  auto parts = gathered(*Access::node(model), options.parameters, options.limits, run);
  if (!parts) return parts.error();
  const Gathered& g = parts.value();

  const bool is_asked = options.grid || !g.step.empty();
  const auto grid = options.grid ? Result<Grid>(*options.grid) : is_asked ? Grid::with_step(g.step) : grid_of(g);
  if (!grid) return grid.error();

  constexpr double placing = 0.5;  // of the time, about
  auto placed = place(g.primitives, Access::lattice(grid.value()), options.rounding, step_of(run, 0, placing));
  if (!placed) return named(placed.error(), g.leaves);
  const auto at_rest = solids_at_rest(g, grid.value(), is_asked, run, placed.value().report);
  if (!at_rest) return at_rest.error();
  if (report) *report = placed.value().report;

  const Expression root = expression(g, grid.value(), at_rest.value(), placed.value().primitives);
  // The empty solid carries the grid.
  return evaluate(Expression::unite({Solid::empty(grid.value()), root}), step_of(run, placing, 1));
}

}  // namespace

Result<Solid> evaluate(const Model& model, const ModelOptions& options, MotionReport* report) {
  return run_to_end(options.run, [&](const Options& run) {
    return with_threads(run.threads, [&] { return evaluated(model, options, run, report); });
  });
}

}  // namespace quoin
