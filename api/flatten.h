/// \file
/// Public expressions as the engine's: operands by number, complements pushed down to leaves and parities.
#pragma once

#include <vector>

#include "booleans/expression.h"
#include "quoin/quoin.h"

namespace quoin {

/// Leaves name operands: 0 .. solids.size() - 1 are the solids, the rest the half-spaces. A solid, or a half-space
/// expression, that stands in several places is one operand.
/// Nested unions are one union, and so for intersections and parities: the tree is shallow where the expression was a
/// long chain. Node 0 exists.
struct Flattened {
  booleans::Expression expression;
  std::vector<Solid> solids;
  std::vector<HalfSpace> half_spaces;
};

Flattened flattened(const Expression& expression);

}  // namespace quoin
