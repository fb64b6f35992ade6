#include <algorithm>
#include <deque>
#include <limits>
#include <set>
#include <tuple>

#include "api/evaluate.h"
#include "api/import.h"
#include "api/place.h"
#include "api/primitive.h"
#include "api/run.h"

namespace quoin {

using exact::Rational;
using Node = Access::ModelNode;
using rounding::Shape;
using rounding::WidePlane;

namespace {

/// How messages call a node.
std::string name_of(const Node& node) {
  std::string s = rule_of(node.kind).word;
  if (!node.name.empty()) s += " \"" + node.name + "\"";
  return node.place.empty() ? s : s + " at " + node.place;
}

Error at_node(Error error, const Node& node) {
  error.where = error.where.empty() ? name_of(node) : name_of(node) + ", " + error.where;
  return error;
}

/// Equal steps have equal texts.
std::string text(const rounding::Step& step) {
  std::string s = std::to_string(step.index());
  const auto add = [&](const auto& numbers) {
    for (const auto& x : numbers) {
      s += ' ';
      s += x.str();
    }
  };
  if (const auto* rotation = std::get_if<rounding::RotationStep>(&step)) {
    add(rotation->axis);
    add(std::array{rotation->degrees});
  } else if (const auto* translation = std::get_if<rounding::TranslationStep>(&step)) {
    add(translation->by);
  } else if (const auto* turn = std::get_if<rounding::TurnStep>(&step)) {
    add(std::array{turn->by.w, turn->by.x, turn->by.y, turn->by.z});
  } else if (const auto* mirror = std::get_if<rounding::MirrorStep>(&step)) {
    add(mirror->normal);
  } else {
    add(std::get<rounding::ScalingStep>(step).by);
  }
  return s;
}

constexpr std::size_t nowhere = ~std::size_t{0};

/// A node of the expression; children come before their parents.
struct Term {
  const Node* node = nullptr;
  std::vector<std::size_t> children = {};
  std::size_t primitive = nowhere;  // of a leaf that is placed
};

/// Walks through a model, without recursion, and gathers its primitives with their motions.
class ModelEvaluator {
 public:
  ModelEvaluator(const ModelOptions& options, MotionReport* report) : options_(options), report_(report) {}

  Result<Solid> run(const Model& model) {
    if (!Access::node(model)) return Solid::empty(options_.grid ? *options_.grid : Grid());
    const auto root = gather(*Access::node(model));
    if (!root) return root.error();
    for (const auto& [name, value] : options_.parameters)
      if (!is_known(name)) return Error{"bad-parameter", "the model has no parameter \"" + name + "\""};
    const auto grid = chosen_grid();
    if (!grid) return grid.error();
    auto placed =
        place(primitives_, Access::lattice(grid.value()), options_.rounding, step_of(options_.run, 0, placing));
    if (!placed) return named(placed.error());
    if (report_) *report_ = placed.value().report;
    return combined(root.value(), grid.value(), placed.value().primitives);
  }

 private:
  bool is_known(const std::string& name) const {
    return defined_.count(name) > 0 || std::any_of(scopes_.begin(), scopes_.end(),
                                                   [&](const Scope& scope) { return scope.parameters.was_used(name); });
  }

  struct Scope {
    Parameters parameters;
    std::map<std::string, std::string> definitions;
  };
  /// A motion's first step and the motion after it: those of nested nodes share their ends.
  struct MotionLink {
    rounding::Motion first;  // of one step
    std::size_t rest;
  };
  using Key = std::tuple<const Node*, std::size_t, std::size_t>;  // node, motion, scope
  struct Visit {
    Key key;
    std::size_t next_child = 0;
    std::vector<std::size_t> terms = {};
  };

  /// The term of the root.
  Result<std::size_t> gather(const Node& root) {
    motions_.push_back({});
    is_shared_.push_back(false);
    scopes_.push_back({Parameters(options_.parameters), options_.parameters});
    std::vector<Visit> stack{{{&root, 0, 0}}};
    std::size_t last = nowhere;
    while (!stack.empty()) {
      Visit& visit = stack.back();
      if (last != nowhere) visit.terms.push_back(std::exchange(last, nowhere));
      const Node& node = *std::get<0>(visit.key);
      if (visit.next_child == 0)
        if (const auto known = terms_of_.find(visit.key); known != terms_of_.end()) {
          last = known->second;
          stack.pop_back();
          continue;
        }
      if (visit.next_child < node.children.size()) {
        const auto& child = Access::node(node.children[visit.next_child]);
        const auto key = child_key(visit.key, child.get());
        if (!key) return key.error();
        ++visit.next_child;
        stack.push_back({key.value()});
        continue;
      }
      const auto term = finished(visit);
      if (!term) return at_node(term.error(), node);
      last = terms_of_[visit.key] = term.value();
      stack.pop_back();
    }
    return last;
  }

  /// What a child is under its parent: its motion comes before those above it.
  Result<Key> child_key(const Key& parent, const Node* child) {
    static const Node empty;
    const auto [node, motion, scope] = parent;
    is_shared_[motion] = is_shared_[motion] || node->children.size() > 1;
    Key key{child ? child : &empty, motion, scope};
    if (is_motion(node->kind)) {
      const auto own = motion_of(*node, scopes_[scope].parameters);
      if (!own) return at_node(own.error(), *node);
      std::get<1>(key) = preceded(own.value(), motion);
    }
    if (node->kind == ModelKind::scope) {
      if (!node->step.empty() && step_.empty()) step_ = node->step;
      if (!node->parameters.empty()) std::get<2>(key) = scope_id(*node, scope);
    }
    return key;
  }

  /// `own`, of one step or none, then a known motion. 0 is the identity.
  std::size_t preceded(const rounding::Motion& own, std::size_t then) {
    if (own.steps().empty()) return then;
    rounding::Motion head = own;
    if (then != 0) {
      head = head.then(motions_[then].first);
      // The two steps have become one, or none.
      if (head.steps().size() < 2) then = motions_[then].rest;
      if (head.steps().empty()) return then;
    }
    // Equal motions have one number, by whatever path they are reached.
    const auto [at, fresh] = motion_ids_.try_emplace({then, text(head.steps()[0])}, motions_.size());
    if (!fresh) return at->second;
    if (head.steps().size() > 1) head = own;
    motions_.push_back({std::move(head), then});
    is_shared_.push_back(false);
    return at->second;
  }

  /// The inner definition of a name hides the outer one, but what the caller sets holds everywhere.
  std::size_t scope_id(const Node& node, std::size_t outer) {
    const auto [at, fresh] = scope_ids_.try_emplace({&node, outer}, scopes_.size());
    if (!fresh) return at->second;
    std::map<std::string, std::string> definitions = scopes_[outer].definitions;
    for (const auto& [name, definition] : node.parameters) defined_.insert(name);
    for (const auto& [name, definition] : node.parameters)
      if (!options_.parameters.count(name)) definitions[name] = definition;
    scopes_.push_back({Parameters(definitions), definitions});
    return at->second;
  }

  Result<std::size_t> finished(Visit& visit) {
    const auto [node, motion, scope] = visit.key;
    if (is_motion(node->kind) || node->kind == ModelKind::scope) return visit.terms[0];
    Term term{node, merged(node->kind, std::move(visit.terms))};
    if (rule_of(node->kind).children == ModelChildren::none) {
      if (node->kind == ModelKind::solid) solids_.push_back(*node->solid);
      const auto primitive = leaf(*node, motion, scope);
      if (!primitive) return primitive.error();
      term.primitive = primitive.value();
    }
    terms_.push_back(std::move(term));
    return terms_.size() - 1;
  }

  /// The terms of a union or intersection, with those of terms of the same kind in their place, each once: shared
  /// subtrees may be reached by more paths than there are terms.
  std::vector<std::size_t> merged(ModelKind kind, std::vector<std::size_t> terms) const {
    if (kind != ModelKind::any && kind != ModelKind::all) return terms;
    std::vector<std::size_t> r;
    for (const std::size_t t : terms) {
      if (terms_[t].node->kind == kind)
        r.insert(r.end(), terms_[t].children.begin(), terms_[t].children.end());
      else
        r.push_back(t);
    }
    std::sort(r.begin(), r.end());
    r.erase(std::unique(r.begin(), r.end()), r.end());
    return r;
  }

  /// The index of the primitive; `nowhere` for a solid that stays where it is.
  Result<std::size_t> leaf(const Node& node, std::size_t motion, std::size_t scope) {
    Placed placed;
    if (node.kind == ModelKind::half_space) {
      const auto plane = half_space_of(node, scopes_[scope].parameters);
      if (!plane) return plane.error();
      placed.half_space = plane.value();
    } else {
      const auto shape = shape_at(node, motion, scope);
      if (!shape) return shape.error();
      if (!shape.value()) return nowhere;
      placed.shape = shape.value();
    }
    placed.motion = &realized(motion);
    primitives_.push_back(placed);
    leaves_.push_back(&node);
    return primitives_.size() - 1;
  }

  /// nullptr for a solid that stays where it is, or has no boundary.
  Result<const Shape*> shape_at(const Node& node, std::size_t motion, std::size_t scope) {
    if (node.kind == ModelKind::solid) {
      if (motion == 0 || Access::operand(*node.solid).face_count() == 0) return nullptr;
      scope = 0;  // it has no parameters
    }
    const auto [at, fresh] = shapes_.try_emplace({&node, scope});
    if (!fresh) return at->second.get();
    if (node.kind == ModelKind::solid) {
      // Of an unbounded one the complement is placed, and taken back.
      at->second = shape_of(node.solid->is_bounded() ? *node.solid : ~*node.solid);
      return at->second.get();
    }
    auto polyhedron = primitive_of(node, scopes_[scope].parameters, options_.run);
    if (!polyhedron) return polyhedron.error();
    at->second = std::make_shared<const Shape>(std::move(polyhedron).value());
    return at->second.get();
  }

  const rounding::RealizedMotion& realized(std::size_t motion) {
    // The steps from one shared motion to the next, up to one that is known, or the identity.
    std::vector<std::pair<std::size_t, rounding::Motion>> row;
    std::size_t m = motion;
    while (m != 0 && !realized_.count(m)) {
      auto& own = row.emplace_back(m, rounding::Motion()).second;
      do {
        own.add(motions_[m].first.steps()[0]);
        m = motions_[m].rest;
      } while (m != 0 && !is_shared_[m]);
    }
    for (; !row.empty(); row.pop_back()) {
      auto& r = realized_[row.back().first] = rounding::realize(row.back().second);
      if (m != 0) r = composed(r, realized_.at(m));
      m = row.back().first;
    }
    return realized_[motion];
  }

  Result<Grid> chosen_grid() {
    if (options_.grid) return *options_.grid;
    if (!step_.empty()) return Grid::with_step(step_);
    if (!solids_.empty())
      return std::min_element(
                 solids_.begin(), solids_.end(),
                 [](const Solid& a, const Solid& b) { return Access::lattice(a).step < Access::lattice(b).step; })
          ->grid();
    constexpr double most = std::numeric_limits<double>::max();
    std::vector<double> points;
    for (const Placed& p : primitives_) {
      if (!p.shape) continue;
      const rounding::AffineMap map = composed(p.shape->to_model, p.motion->map);
      for (const auto& v : p.shape->polyhedron.points)
        // Beyond the doubles any coordinate is too far: the largest says so.
        for (const Rational& x : map(v)) points.push_back(std::clamp(exact::to_double(x), -most, most));
    }
    return fitting_grid(std::array{std::span<const double>(points)});
  }

  /// An error of `place` says the primitive's number: the node says more.
  Error named(Error error) const {
    const std::string word = "primitive ";
    if (error.where.compare(0, word.size(), word) != 0) return error;
    std::size_t length = 0;
    const std::size_t i = std::stoul(error.where.substr(word.size()), &length);
    error.where = name_of(*leaves_[i]) + error.where.substr(word.size() + length);
    return error;
  }

  Result<Solid> combined(std::size_t root, const Grid& grid, std::vector<rounding::Reconstructed>& primitives) {
    std::vector<Expression> expressions;
    for (const Term& term : terms_) {
      auto e = expression(term, grid, primitives, expressions);
      if (!e) return at_node(e.error(), *term.node);
      expressions.push_back(std::move(e).value());
    }
    // The empty solid carries the grid.
    return evaluate(Expression::union_of({Solid::empty(grid), expressions[root]}), step_of(options_.run, placing, 1));
  }

  Result<Expression> expression(const Term& term, const Grid& grid, std::vector<rounding::Reconstructed>& primitives,
                                const std::vector<Expression>& known) {
    const ModelKind kind = term.node->kind;
    if (kind == ModelKind::solid && term.primitive == nowhere) {
      auto here = term.node->solid->on_grid(grid);
      if (!here) return here.error();
      return Expression(here.value());
    }
    if (kind == ModelKind::half_space) return half_space(*primitives[term.primitive].plane, Access::lattice(grid));
    if (term.primitive != nowhere) {
      const Expression e = Access::solid(grid, std::move(primitives[term.primitive].body));
      return kind == ModelKind::solid && !term.node->solid->is_bounded() ? Expression::complement_of(e) : e;
    }
    std::vector<Expression> terms;
    for (const std::size_t child : term.children) terms.push_back(known[child]);
    switch (kind) {
      case ModelKind::all:
        return Expression::intersection_of(std::move(terms));
      case ModelKind::odd:
        return Expression::symmetric_difference_of(std::move(terms));
      case ModelKind::complement:
        return Expression::complement_of(terms[0]);
      case ModelKind::difference:
        for (std::size_t i = 1; i < terms.size(); ++i) terms[i] = Expression::complement_of(terms[i]);
        return terms.empty() ? Expression::union_of({}) : Expression::intersection_of(std::move(terms));
      default:
        return Expression::union_of(std::move(terms));
    }
  }

  static constexpr double placing = 0.5;  // of the time, about

  const ModelOptions& options_;
  MotionReport* report_;
  std::string step_;
  std::vector<MotionLink> motions_;
  std::vector<bool> is_shared_;  // by motion: that of a node with several children, realized for all of them once
  std::map<std::pair<std::size_t, std::string>, std::size_t> motion_ids_;
  std::map<std::size_t, rounding::RealizedMotion> realized_;
  std::deque<Scope> scopes_;
  std::set<std::string> defined_;  // parameters of scopes
  std::map<std::pair<const Node*, std::size_t>, std::size_t> scope_ids_;
  std::map<Key, std::size_t> terms_of_;
  std::map<std::pair<const Node*, std::size_t>, std::shared_ptr<const Shape>> shapes_;
  std::vector<Term> terms_;
  std::vector<Placed> primitives_;
  std::vector<const Node*> leaves_;  // of the primitives
  std::vector<Solid> solids_;
};

}  // namespace

Result<Solid> evaluate(const Model& model, const ModelOptions& options, MotionReport* report) {
  return with_threads(options.run.threads, [&] { return ModelEvaluator(options, report).run(model); });
}

}  // namespace quoin
