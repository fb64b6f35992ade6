/// \file
/// Half-spaces inside expressions: where is the surface they make?
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <vector>

#include "booleans/expression.h"
#include "exact/geometry.h"

namespace quoin {

/// The values of an expression's operands, where they are known.
enum class Truth : std::uint8_t { no, yes, unknown };

/// The value of the expression where operand i has the value operands[i], in Kleene's three-valued logic: `unknown`
/// may stand for an expression that is constant all the same.
Truth value(const booleans::Expression& expression, const std::vector<Truth>& operands);

/// The value that the expression has everywhere outside the cube |x|, |y|, |z| <= half_width, but for a set of measure
/// zero; nothing when it takes both values there: then the surface reaches out of the cube or is infinite.
/// Operand i < solids.size() has the value solids[i] there, operand solids.size() + j is the half-space
/// planes[j] <= 0. Exact. Planes are distinct and reduced, and of two opposite ones only one is there.
/// A cancelled search returns some value.
std::optional<bool> value_outside(const booleans::Expression& expression, const std::vector<Truth>& solids,
                                  const std::vector<exact::Plane>& planes, std::int32_t half_width,
                                  const std::atomic<bool>* cancel);

}  // namespace quoin
