#include "api/evaluate.h"
#include "api/common_grid.h"

#include <algorithm>
#include <array>
#include <limits>

#include "api/import.h"
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

/// One that fits all primitives. Errors: "out-of-range", naming the node.
Result<Grid> grid_around(const Gathered& g) {
  std::vector<std::vector<double>> corners;
  for (const Placed& p : g.primitives) corners.push_back(corners_of(p));
  const std::vector<std::span<const double>> meshes(corners.begin(), corners.end());
  return fitting_grid_of(meshes, [&](const Error& error, std::size_t i) { return at_node(error, *g.leaves[i]); });
}

/// What the caller or the model asks for, else the finest grid of its solids, else one that fits the primitives.
Result<Grid> chosen_grid(const Gathered& g, const std::optional<Grid>& asked) {
  if (asked) return *asked;
  if (!g.step.empty()) return Grid::with_step(g.step);
  return g.solids.empty() ? grid_around(g) : finest_grid(g.solids);
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
Result<Expression> leaf(const Term& term, const Grid& grid, std::vector<rounding::Reconstructed>& primitives) {
  const ModelNode& node = *term.node;
  if (term.primitive == nowhere) {
    auto here = node.solid->on_grid(grid);
    if (!here) return here.error();
    return Expression(here.value());
  }
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
Result<Expression> expression(const Gathered& g, const Grid& grid, std::vector<rounding::Reconstructed>& primitives) {
  std::vector<Expression> known;
  for (const Term& term : g.terms) {
    if (rule_of(term.node->kind).children == ModelChildren::none) {
      auto e = leaf(term, grid, primitives);
      if (!e) return at_node(e.error(), *term.node);
      known.push_back(std::move(e).value());
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

  const auto grid = chosen_grid(g, options.grid);
  if (!grid) return grid.error();

  constexpr double placing = 0.5;  // of the time, about
  auto placed = place(g.primitives, Access::lattice(grid.value()), options.rounding, step_of(run, 0, placing));
  if (!placed) return named(placed.error(), g.leaves);
  if (report) *report = placed.value().report;

  const auto root = expression(g, grid.value(), placed.value().primitives);
  if (!root) return root.error();
  // The empty solid carries the grid.
  return evaluate(Expression::unite({Solid::empty(grid.value()), root.value()}), step_of(run, placing, 1));
}

}  // namespace

Result<Solid> evaluate(const Model& model, const ModelOptions& options, MotionReport* report) {
  return run_to_end(options.run, [&](const Options& run) {
    return with_threads(run.threads, [&] { return evaluated(model, options, run, report); });
  });
}

}  // namespace quoin
