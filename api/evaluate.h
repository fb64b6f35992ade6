/// \file
/// The engine behind the public operations.
#pragma once

#include <vector>

#include "booleans/classify/expression.h"
#include "quoin/quoin.h"

namespace quoin {

/// rule(solid 0, .., solid n - 1), those from `negated_from` on complemented, on their common grid. n > 0.
/// Errors: as booleans::evaluate.
Result<Solid> evaluate_flat(booleans::Rule rule, std::vector<Solid> solids, std::uint32_t negated_from);

}  // namespace quoin
