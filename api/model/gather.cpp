#include "api/model/gather.h"

#include <algorithm>
#include <tuple>

#include "api/model/primitive.h"
#include "io/too_large.h"

namespace quoin {

using ModelNode = Access::ModelNode;
using rounding::Shape;

std::string name_of(const ModelNode& node) {
  std::string s = rule_of(node.kind).word;
  if (!node.name.empty()) s += " \"" + node.name + "\"";
  return node.place.empty() ? s : s + " at " + node.place;
}

Error at_node(Error error, const ModelNode& node) {
  error.where = error.where.empty() ? name_of(node) : name_of(node) + ", " + error.where;
  return error;
}

namespace {

/// A node as it is reached: what it stands for depends on nothing else.
struct Place {
  const ModelNode* node = nullptr;
  MotionTable::Id motion = 0;
  ScopeTable::Id scope = 0;

  friend bool operator<(const Place& a, const Place& b) {
    return std::tie(a.node, a.motion, a.scope) < std::tie(b.node, b.motion, b.scope);
  }
};

/// What a child is under its parent: its motion comes before those above it.
Result<Place> place_of_child(Gathered& g, const Place& parent, const ModelNode* child) {
  static const ModelNode& empty = *new ModelNode;
  const ModelNode& node = *parent.node;
  if (node.children.size() > 1) g.motions.share(parent.motion);

  Place place{child ? child : &empty, parent.motion, parent.scope};
  if (is_motion(node.kind)) {
    const auto own = motion_of(node, g.scopes.parameters(parent.scope));
    if (!own) return at_node(own.error(), node);
    place.motion = g.motions.preceded(own.value(), parent.motion);
  }
  if (node.kind == ModelKind::scope) {
    if (!node.step.empty() && g.step.empty()) g.step = node.step;
    if (!node.parameters.empty()) place.scope = g.scopes.within(node, parent.scope);
  }
  return place;
}

/// nullptr for a solid that stays where it is, or has no boundary.
Result<const Shape*> shape_at(Gathered& g, const Place& place, const Options& run) {
  const ModelNode& node = *place.node;
  const bool is_solid = node.kind == ModelKind::solid;
  if (is_solid && (place.motion == 0 || Access::operand(*node.solid).face_count() == 0)) return nullptr;

  // A solid has no parameters.
  const auto [at, fresh] = g.shapes.try_emplace({place.node, is_solid ? 0 : place.scope});
  if (!fresh) return at->second.get();
  if (is_solid) {
    // Of an unbounded one the complement is placed, and taken back.
    at->second = shape_of(node.solid->is_bounded() ? *node.solid : ~*node.solid);
    return at->second.get();
  }

  auto polyhedron = primitive_of(node, g.scopes.parameters(place.scope), g.limits, run);
  if (!polyhedron) return polyhedron.error();
  at->second = std::make_shared<const Shape>(std::move(polyhedron).value());
  return at->second.get();
}

/// The index of the primitive that a leaf becomes; `nowhere` for a solid that stays where it is.
Result<std::size_t> add_primitive(Gathered& g, const Place& place, const Options& run) {
  Placed placed;
  if (place.node->kind == ModelKind::half_space) {
    const auto plane = half_space_of(*place.node, g.scopes.parameters(place.scope));
    if (!plane) return plane.error();
    placed.half_space = plane.value();
  } else {
    const auto shape = shape_at(g, place, run);
    if (!shape) return shape.error();
    if (!shape.value()) return nowhere;
    placed.shape = shape.value();
    g.faces += placed.shape->polyhedron.face_count();
    if (g.faces > g.limits.model_faces)
      return io::too_large("the primitives of the model have more faces", "model-faces", g.limits.model_faces);
  }

  placed.motion = &g.motions.realized(place.motion);
  g.primitives.push_back(placed);
  g.leaves.push_back(place.node);
  return g.primitives.size() - 1;
}

/// The terms of a union or intersection, with those of terms of the same kind in their place, each once: shared
/// subtrees may be reached by more paths than there are terms.
std::vector<std::size_t> merged(const std::vector<Term>& known, ModelKind kind, std::vector<std::size_t> terms) {
  if (kind != ModelKind::any && kind != ModelKind::all) return terms;
  std::vector<std::size_t> r;
  for (const std::size_t t : terms) {
    if (known[t].node->kind == kind)
      r.insert(r.end(), known[t].children.begin(), known[t].children.end());
    else
      r.push_back(t);
  }

  std::sort(r.begin(), r.end());
  r.erase(std::unique(r.begin(), r.end()), r.end());
  return r;
}

/// The term that a node stands for, those of its children known.
Result<std::size_t> add_term(Gathered& g, const Place& place, std::vector<std::size_t> children, const Options& run) {
  const ModelNode& node = *place.node;
  if (is_motion(node.kind) || node.kind == ModelKind::scope) return children[0];

  Term term{&node, merged(g.terms, node.kind, std::move(children))};
  if (rule_of(node.kind).children == ModelChildren::none) {
    if (node.kind == ModelKind::solid) g.solids.push_back(*node.solid);
    const auto primitive = add_primitive(g, place, run);
    if (!primitive) return at_node(primitive.error(), node);
    term.primitive = primitive.value();
  }
  g.terms.push_back(std::move(term));
  return g.terms.size() - 1;
}

/// The term of the root. Depth first, each place once.
Result<std::size_t> walk(Gathered& g, const ModelNode& root, const Options& run) {
  struct Visit {
    Place place;
    std::size_t next_child = 0;
    std::vector<std::size_t> terms = {};
  };
  std::map<Place, std::size_t> known;
  std::vector<Visit> stack{{{&root}}};
  std::size_t last = nowhere;

  while (!stack.empty()) {
    Visit& visit = stack.back();
    if (last != nowhere) visit.terms.push_back(std::exchange(last, nowhere));
    if (visit.next_child == 0)
      if (const auto at = known.find(visit.place); at != known.end()) {
        last = at->second;
        stack.pop_back();
        continue;
      }

    const auto& children = visit.place.node->children;
    if (visit.next_child < children.size()) {
      const auto place = place_of_child(g, visit.place, Access::node(children[visit.next_child]).get());
      if (!place) return place.error();
      ++visit.next_child;
      stack.push_back({place.value()});
      continue;
    }

    if (known.size() == g.limits.nodes)
      return at_node(io::too_large("the model has more nodes", "nodes", g.limits.nodes), *visit.place.node);
    const auto term = add_term(g, visit.place, std::move(visit.terms), run);
    if (!term) return term.error();
    last = known[visit.place] = term.value();
    stack.pop_back();
  }
  return last;
}

}  // namespace

Result<Gathered> gathered(const ModelNode& root, const ScopeTable::Definitions& parameters, const Limits& limits,
                          const Options& run) {
  Gathered g(parameters, limits);
  const auto term = walk(g, root, run);
  if (!term) return term.error();
  g.root = term.value();

  for (const auto& [name, value] : parameters)
    if (!g.scopes.is_known(name)) return Error{ErrorCode::bad_parameter, "the model has no parameter \"" + name + "\""};
  return Result<Gathered>(std::move(g));
}

}  // namespace quoin
