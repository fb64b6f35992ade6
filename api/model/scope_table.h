/// \file
/// The scopes of a model: what parameters are worth where.
#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "api/model/formula.h"
#include "api/model/node.h"

namespace quoin {

/// Scopes by number; 0 is that of the caller. The inner definition of a name hides the outer one, but what the caller
/// sets holds everywhere.
class ScopeTable {
 public:
  using Id = std::size_t;
  using Definitions = std::map<std::string, std::string>;

  /// `set`: what the caller sets.
  ScopeTable(const Definitions& set, std::uint64_t most_digits) : set_(set), most_digits_(most_digits) {
    scopes_.push_back({Parameters(set, most_digits), set});
  }

  /// The scope that a node of parameters opens within another. Precondition: the node is a scope.
  Id within(const Access::ModelNode& node, Id outer);
  /// The reference stays valid.
  Parameters& parameters(Id scope) { return scopes_[scope].parameters; }
  /// Whether a scope defines the name, or a formula has asked for it.
  bool is_known(const std::string& name) const;

 private:
  struct Scope {
    Parameters parameters;
    Definitions definitions;
  };

  Definitions set_;
  std::uint64_t most_digits_;
  std::deque<Scope> scopes_;
  std::set<std::string> defined_;  // by nodes
  std::map<std::pair<const Access::ModelNode*, Id>, Id> ids_;
};

}  // namespace quoin
