/// \file
/// Half-spaces inside expressions: bodies of them that serve where the surface is.
#pragma once

#include <atomic>
#include <vector>

#include "booleans/body/body.h"
#include "booleans/classify/expression.h"
#include "exact/geometry.h"
#include "quoin/result.h"

namespace quoin::booleans {

/// Adds half-spaces to the operands, clipped to a box outside of which the expression is constant; where the expression
/// has to be told so, it gets an operand more. `storage`, empty before, keeps the new bodies and must outlive them.
/// Operand i < operands.size() is that body, operand operands.size() + j is the half-space planes[j] <= 0. Planes are
/// distinct and reduced, and of two opposite ones only one is there. A cancelled search leaves some expression.
/// Errors: "unbounded" (the surface is infinite, or reaches out of the world).
Result<void> clip_half_spaces(Expression& expression, const std::vector<exact::Plane>& planes,
                              std::vector<const Body*>& operands, std::vector<Body>& storage,
                              const std::atomic<bool>* cancel);

}  // namespace quoin::booleans
