/// \file
/// The Boolean itself: an expression over n bodies, evaluated in one arrangement.
#pragma once

#include <span>

#include "booleans/body/body.h"
#include "booleans/classify/expression.h"
#include "booleans/run.h"
#include "quoin/result.h"

namespace quoin::booleans {

/// The regular point set where the expression holds. Operands must be clean bodies (B1 - B4); the result is one.
/// Its planes are a subset of the operands' planes.
/// Its faces carry what those of the operands do; `origins`: those of the operands and perhaps others, null for
/// `joint_origins`.
/// Errors: "cancelled"; "inconsistent" when an operand is not clean and this shows.
Result<Body> evaluate(std::span<const Body* const> operands, const Expression& expression, const Run& run = {},
                      std::shared_ptr<const Origins> origins = nullptr);

}  // namespace quoin::booleans
