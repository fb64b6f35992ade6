/// \file
/// What a model consists of: its primitives with their motions, and the expression that joins them.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "api/model/motion_table.h"
#include "api/model/node.h"
#include "api/model/scope_table.h"
#include "api/place.h"

namespace quoin {

constexpr std::size_t nowhere = ~std::size_t{0};

/// A node of the expression; children come before their parents.
struct Term {
  const Access::ModelNode* node = nullptr;
  std::vector<std::size_t> children = {};
  std::size_t primitive = nowhere;  // of a leaf that is placed
};

/// Points into the model and into itself: it is moved, not copied.
struct Gathered {
  Gathered(const ScopeTable::Definitions& parameters, const Limits& most)
      : limits(most), scopes(parameters, most.digits) {}
  Gathered(Gathered&&) = default;

  Limits limits;
  std::vector<Term> terms = {};
  std::size_t root = nowhere;
  std::vector<Placed> primitives = {};
  std::vector<const Access::ModelNode*> leaves = {};  // of the primitives
  std::vector<Solid> solids = {};                     // that the model holds
  std::uint64_t faces = 0;                            // of the primitives
  std::string step = {};                              // of the grid; empty where no scope says one

  // What primitives point to.
  MotionTable motions = {};
  ScopeTable scopes;
  std::map<std::pair<const Access::ModelNode*, ScopeTable::Id>, std::shared_ptr<const rounding::Shape>> shapes = {};
};

/// Walks through a model, without recursion; `parameters` are those that the caller sets.
/// Errors: those of numbers, primitives and motions; "bad-parameter" also for one that the model does not know;
/// "too-large". `where` names the node.
Result<Gathered> gathered(const Access::ModelNode& root, const ScopeTable::Definitions& parameters,
                          const Limits& limits, const Options& run);

/// How messages call a node: its word, its name, its place.
std::string name_of(const Access::ModelNode& node);
/// The error with the node's name before its place.
Error at_node(Error error, const Access::ModelNode& node);

}  // namespace quoin
