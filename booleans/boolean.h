/// \file
/// Evaluates a Boolean expression over n bodies in one arrangement.
#pragma once

#include <atomic>
#include <functional>
#include <span>

#include "booleans/body.h"
#include "booleans/expression.h"
#include "quoin/result.h"

namespace quoin::booleans {

/// Progress and cancellation, as the public Options.
struct Run {
  std::function<void(double)> progress = {};
  const std::atomic<bool>* cancel = nullptr;
  std::function<void(const char*)> stage = {};
};

/// The regular point set where the expression holds. Operands must be clean bodies (B1 - B4); the result is one.
/// Its planes are a subset of the operands' planes.
/// Errors: "cancelled"; "inconsistent" when an operand is not clean and this shows.
Result<Body> evaluate(std::span<const Body* const> operands, const Expression& expression, const Run& run = {});

/// A clean body with the points of winding number > 0 of a closed but otherwise arbitrary triangle mesh (B1 alone, raw
/// triangles without zero area). `crossings` counts the pairs of faces that met out of place.
/// A single embedded surface is taken as it is: it must not be inside out.
Result<Body> resolve(Body mesh, std::uint64_t& crossings, const Run& run = {});

}  // namespace quoin::booleans
