#include "api/model/scope_table.h"

#include <algorithm>

namespace quoin {

ScopeTable::Id ScopeTable::within(const Access::ModelNode& node, Id outer) {
  const auto [at, fresh] = ids_.try_emplace({&node, outer}, scopes_.size());
  if (!fresh) return at->second;

  Definitions definitions = scopes_[outer].definitions;
  for (const auto& [name, definition] : node.parameters) {
    defined_.insert(name);
    if (!set_.count(name)) definitions[name] = definition;
  }
  scopes_.push_back({Parameters(definitions, most_digits_), definitions});
  return at->second;
}

bool ScopeTable::is_known(const std::string& name) const {
  return defined_.count(name) > 0 || std::any_of(scopes_.begin(), scopes_.end(),
                                                 [&](const Scope& scope) { return scope.parameters.was_used(name); });
}

}  // namespace quoin
