/// \file
/// Public expressions as the engine's: operands by number, complements pushed down to leaves and parities.
#pragma once

#include <map>
#include <vector>

#include "api/access.h"
#include "booleans/classify/expression.h"

namespace quoin {

/// Leaves name operands: 0 .. solids.size() - 1 are the solids, the rest the half-spaces. A solid, or a half-space
/// expression, that stands in several places is one operand.
/// Nested unions are one union, and so for intersections and parities: the tree is shallow where the expression was a
/// long chain. Node 0 exists.
struct Flattened {
  booleans::Expression expression;
  std::vector<Solid> solids;
  std::vector<HalfSpace> half_spaces;
  /// Where each stands first: its number among all leaves, in the order of the expression.
  using Places = std::vector<std::uint32_t>;
  Places solid_places = {}, half_space_places = {};
};

/// Terms in `known` are the solids that they have been found to be.
using KnownTerms = std::map<const Access::ExpressionNode*, Solid>;
Flattened flattened(const Expression& expression, const KnownTerms& known = {});

/// The terms, children first, that are better evaluated by themselves: they stand in several places, and as a tree they
/// have more than Thresholds::few_leaves leaves. The graph's tree could else be exponentially large; now each edge of
/// the graph brings at most that many. Terms with half-spaces cannot be evaluated alone, for they may be unbounded.
/// Errors: "too-many-terms" (more than 2^24 leaves remain).
Result<std::vector<const Expression*>> large_shared_terms(const Expression& expression);

}  // namespace quoin
