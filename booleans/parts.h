/// \file
/// Large expressions are evaluated part by part.
#pragma once

#include "booleans/boolean.h"

namespace quoin::booleans {

/// The same point set as `evaluate`, and for few operands, or ones that hardly meet, the same work. Where many operands
/// of one node crowd each other, groups of neighbours are combined first, then groups of groups: what lies inside a
/// neighbour never meets the others, each arrangement stays small, and groups are independent of each other.
/// Union, intersection and symmetric difference are associative on regular point sets, and results are exact, so the
/// order decides nothing but the time. `origins`: as `evaluate` has them.
Result<Body> evaluate_in_parts(std::span<const Body* const> operands, const Expression& expression, const Run& run = {},
                               std::shared_ptr<const Origins> origins = nullptr);

}  // namespace quoin::booleans
