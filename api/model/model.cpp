#include <algorithm>
#include <array>
#include <iterator>

#include "api/model/node.h"

namespace quoin {

using ModelNode = Access::ModelNode;

namespace {

constexpr const char *usual_sides = "64", *usual_fit = "inscribed";

const std::vector<ModelRule>& rules() {
  using enum ModelKind;
  static const std::vector<ModelRule>& table = *new std::vector<ModelRule>{
      {block, "block", {{"size", 0, 3}}, ModelChildren::none},
      {wedge, "wedge", {{"size", 0, 3}, {"top"}}, ModelChildren::none},
      {prism, "prism", {{"sides"}, {"radius"}, {"height"}}, ModelChildren::none},
      {cylinder,
       "cylinder",
       {{"radius"}, {"height"}, {"sides", 0, 1, usual_sides}, {"fit", 0, 1, usual_fit}},
       ModelChildren::none},
      {frustum,
       "frustum",
       {{"bottom"}, {"top"}, {"height"}, {"sides", 0, 1, usual_sides}, {"fit", 0, 1, usual_fit}},
       ModelChildren::none},
      {cone,
       "cone",
       {{"radius"}, {"height"}, {"sides", 0, 1, usual_sides}, {"fit", 0, 1, usual_fit}},
       ModelChildren::none},
      {sphere, "sphere", {{"radius"}, {"sides", 0, 1, usual_sides}}, ModelChildren::none},
      {tangent_sphere, "tangent-sphere", {{"radius"}, {"planes", 0, 1, "200"}}, ModelChildren::none},
      {torus,
       "torus",
       {{"major"}, {"minor"}, {"sides", 0, 1, usual_sides}, {"minor-sides", 0, 1, "32"}},
       ModelChildren::none},
      {half_space, "half-space", {{"plane", 0, 4}}, ModelChildren::none},
      {convex, "convex", {{"planes", 1, 4}}, ModelChildren::none},
      {hull, "hull", {{"points", 1, 3}}, ModelChildren::none},
      {extrusion, "extrusion", {{"polygons", 3, 2}, {"along", 0, 3}}, ModelChildren::none},
      {solid, "solid", {}, ModelChildren::none},
      {rotate, "rotate", {{"axis", 0, 3}, {"angle"}}, ModelChildren::one},
      {translate, "translate", {{"by", 0, 3}}, ModelChildren::one},
      {turn, "turn", {{"quaternion", 0, 4}}, ModelChildren::one},
      {transform, "transform", {{"matrix", 1, 3}}, ModelChildren::one},
      {mirror, "mirror", {{"normal", 0, 3}}, ModelChildren::one},
      {scale, "scale", {{"factors", 0, 3}}, ModelChildren::one},
      {scope, "scope", {}, ModelChildren::one},
      {any, "union", {}, ModelChildren::many},
      {all, "intersection", {}, ModelChildren::many},
      {odd, "symmetric-difference", {}, ModelChildren::many},
      {difference, "difference", {}, ModelChildren::many},
      {complement, "complement", {}, ModelChildren::one},
  };
  return table;
}

ModelValue value(const std::string& text) { return {text}; }

template <std::size_t N>
ModelValue value(const std::array<std::string, N>& texts) {
  ModelValue v;
  for (const std::string& text : texts) v.items.push_back({text});
  return v;
}

template <class T>
ModelValue value(const std::vector<T>& list) {
  ModelValue v;
  for (const T& item : list) v.items.push_back(value(item));
  return v;
}

ModelValue value(const std::array<Text3, 3>& rows) { return value(std::vector<Text3>(rows.begin(), rows.end())); }

ModelValue value(Fit fit) {
  return {fit == Fit::inscribed ? "inscribed" : fit == Fit::circumscribed ? "circumscribed" : "equal-area"};
}

template <class... Values>
Model primitive(ModelKind kind, const Values&... values) {
  auto node = std::make_shared<ModelNode>();
  node->kind = kind;
  (node->values.push_back(value(values)), ...);
  return Access::model(std::move(node));
}

template <class... Values>
Model moved(ModelKind kind, const Model& model, const Values&... values) {
  auto node = std::make_shared<ModelNode>();
  node->kind = kind;
  (node->values.push_back(value(values)), ...);
  node->children = {model};
  return Access::model(std::move(node));
}

Model combined(ModelKind kind, std::vector<Model> terms) {
  auto node = std::make_shared<ModelNode>();
  node->kind = kind;
  node->children = std::move(terms);
  return Access::model(std::move(node));
}

Model two(ModelKind kind, Model a, Model b) {
  std::vector<Model> terms;
  terms.push_back(std::move(a));
  terms.push_back(std::move(b));
  return combined(kind, std::move(terms));
}

/// A copy of the node to be changed; of the empty model, an empty union.
std::shared_ptr<ModelNode> copied(const Model& model) {
  const auto& node = Access::node(model);
  return node ? std::make_shared<ModelNode>(*node) : std::make_shared<ModelNode>();
}

/// The model as a scope: itself if it is one.
std::shared_ptr<ModelNode> scoped(const Model& model) {
  if (const auto& node = Access::node(model); node && node->kind == ModelKind::scope) return copied(model);
  auto node = std::make_shared<ModelNode>();
  node->kind = ModelKind::scope;
  node->children = {model};
  return node;
}

}  // namespace

const ModelRule& rule_of(ModelKind kind) { return rules()[static_cast<std::size_t>(kind)]; }

const ModelRule* rule_of(std::string_view word) {
  const auto at = std::find_if(rules().begin(), rules().end(), [&](const ModelRule& r) { return word == r.word; });
  return at == rules().end() ? nullptr : &*at;
}

// Children that nobody else holds are taken over before they could recurse.
Model::Node::~Node() {
  std::vector<Model> pending = std::move(children);
  while (!pending.empty()) {
    const Model last = std::move(pending.back());
    pending.pop_back();
    if (!last.node_ || last.node_.use_count() > 1) continue;
    auto& inner = last.node_->children;
    std::move(inner.begin(), inner.end(), std::back_inserter(pending));
    inner.clear();
  }
}

Model::Model() = default;
Model::~Model() = default;
Model::Model(const Model&) = default;
Model::Model(Model&&) noexcept = default;
Model& Model::operator=(const Model&) = default;
Model& Model::operator=(Model&&) noexcept = default;
Model::Model(std::shared_ptr<const ModelNode> node) : node_(std::move(node)) {}

Model Model::block(const Text3& size) { return primitive(ModelKind::block, size); }
Model Model::wedge(const Text3& size, const std::string& top) { return primitive(ModelKind::wedge, size, top); }
Model Model::prism(const std::string& n, const std::string& radius, const std::string& height) {
  return primitive(ModelKind::prism, n, radius, height);
}
Model Model::cylinder(const std::string& radius, const std::string& height, const std::string& n, Fit fit) {
  return primitive(ModelKind::cylinder, radius, height, n, fit);
}
Model Model::frustum(const std::string& bottom, const std::string& top, const std::string& height, const std::string& n,
                     Fit fit) {
  return primitive(ModelKind::frustum, bottom, top, height, n, fit);
}
Model Model::cone(const std::string& radius, const std::string& height, const std::string& n, Fit fit) {
  return primitive(ModelKind::cone, radius, height, n, fit);
}
Model Model::sphere(const std::string& radius, const std::string& n) { return primitive(ModelKind::sphere, radius, n); }
Model Model::tangent_sphere(const std::string& radius, const std::string& planes) {
  return primitive(ModelKind::tangent_sphere, radius, planes);
}
Model Model::torus(const std::string& major, const std::string& minor, const std::string& n,
                   const std::string& minor_sides) {
  return primitive(ModelKind::torus, major, minor, n, minor_sides);
}
Model Model::half_space(const std::array<std::string, 4>& plane) { return primitive(ModelKind::half_space, plane); }
Model Model::convex(const std::vector<std::array<std::string, 4>>& planes) {
  return primitive(ModelKind::convex, planes);
}
Model Model::hull(const std::vector<Text3>& points) { return primitive(ModelKind::hull, points); }
Model Model::extrusion(const std::vector<std::vector<Outline>>& polygons, const Text3& along) {
  return primitive(ModelKind::extrusion, polygons, along);
}
Model Model::solid(const Solid& solid) {
  auto node = std::make_shared<ModelNode>();
  node->kind = ModelKind::solid;
  node->solid = solid;
  return Model(std::move(node));
}

Model Model::rotated(const Text3& axis, const std::string& degrees) const {
  return moved(ModelKind::rotate, *this, axis, degrees);
}
Model Model::translated(const Text3& by) const { return moved(ModelKind::translate, *this, by); }
Model Model::turned(const std::array<std::string, 4>& wxyz) const { return moved(ModelKind::turn, *this, wxyz); }
Model Model::transformed(const std::array<Text3, 3>& rows) const { return moved(ModelKind::transform, *this, rows); }
Model Model::mirrored(const Text3& normal) const { return moved(ModelKind::mirror, *this, normal); }
Model Model::scaled(const Text3& by) const { return moved(ModelKind::scale, *this, by); }

Model Model::named(const std::string& name) const {
  auto node = copied(*this);
  node->name = name;
  return Model(std::move(node));
}

Model Model::with_parameters(const std::map<std::string, std::string>& defaults) const {
  auto node = scoped(*this);
  for (const auto& [name, definition] : defaults) node->parameters[name] = definition;
  return Model(std::move(node));
}

Model Model::with_step(const std::string& step) const {
  auto node = scoped(*this);
  node->step = step;
  return Model(std::move(node));
}

Model Model::unite(std::vector<Model> terms) { return combined(ModelKind::any, std::move(terms)); }
Model Model::intersect(std::vector<Model> terms) { return combined(ModelKind::all, std::move(terms)); }
Model Model::symmetric_difference(std::vector<Model> terms) { return combined(ModelKind::odd, std::move(terms)); }
Model Model::difference(Model minuend, std::vector<Model> subtrahends) {
  std::vector<Model> terms = std::move(subtrahends);
  terms.insert(terms.begin(), std::move(minuend));
  return combined(ModelKind::difference, std::move(terms));
}
Model Model::complement(Model term) {
  std::vector<Model> terms;
  terms.push_back(std::move(term));
  return combined(ModelKind::complement, std::move(terms));
}

Model operator+(Model a, Model b) { return two(ModelKind::any, std::move(a), std::move(b)); }
Model operator-(Model a, Model b) { return two(ModelKind::difference, std::move(a), std::move(b)); }
Model operator&(Model a, Model b) { return two(ModelKind::all, std::move(a), std::move(b)); }
Model operator^(Model a, Model b) { return two(ModelKind::odd, std::move(a), std::move(b)); }
Model operator~(Model a) { return Model::complement(std::move(a)); }

}  // namespace quoin
