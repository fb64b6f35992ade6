/// \file
/// What models are made of. One table says what each kind of node holds; factories, files and evaluation follow it.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "api/access.h"

namespace quoin {

enum class ModelKind {
  // primitives
  block,
  wedge,
  prism,
  cylinder,
  frustum,
  cone,
  sphere,
  tangent_sphere,
  torus,
  half_space,
  convex,
  hull,
  extrusion,
  solid,
  // one child, moved
  rotate,
  translate,
  turn,
  transform,
  mirror,
  scale,
  // one child, with parameters
  scope,
  // any number of children
  any,
  all,
  odd,
  difference,
  // one child
  complement,
};

/// Formulas: one text, or a list.
struct ModelValue {
  std::string text = {};
  std::vector<ModelValue> items = {};
};

/// A field of a node: `lists` lists of any length within each other, of vectors of `count` formulas (of single ones for
/// count 1).
struct ModelField {
  const char* name;
  int lists = 0;
  std::size_t count = 1;
  const char* fallback = nullptr;  // what an absent field says
};

enum class ModelChildren { none, one, many };

struct ModelRule {
  ModelKind kind;
  const char* word;  // in files and messages
  std::vector<ModelField> fields;
  ModelChildren children;
};

/// By kind.
const ModelRule& rule_of(ModelKind kind);
/// nullptr for a word that no kind has.
const ModelRule* rule_of(std::string_view word);

struct Model::Node {
  ModelKind kind = ModelKind::any;
  std::vector<ModelValue> values = {};                 // one a field of the kind's rule
  mutable std::vector<Model> children = {};            // taken apart by the destructor alone
  std::optional<Solid> solid = {};                     // of a solid
  std::map<std::string, std::string> parameters = {};  // of a scope: their defaults
  std::string step = {};                               // of a scope: of the grid; empty where it says none
  std::string name = {};
  std::string place = {};  // in the text it was read from

  Node() = default;
  Node(const Node&) = default;
  Node& operator=(const Node&) = delete;
  /// Without recursion: histories may be deep.
  ~Node();
};

}  // namespace quoin
