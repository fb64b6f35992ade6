/// \file
/// What reconstruction says when it refuses; `where` begins with "primitive I".
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "quoin/result.h"
#include "rounding/reconstruction/conditions.h"

namespace quoin::rounding {

std::string name_of(std::size_t primitive);

/// A vertex lies beyond the world. Names the power of two by which the step must grow for the farthest of the carried
/// points.
Error out_of_range(std::size_t primitive, std::span<const Vector> points);
/// A half-space's plane fits by no rounding.
Error half_space_out_of_range(std::size_t primitive);
/// The violated condition, of a primitive with these carried points.
Error inconsistent(std::size_t primitive, const Violation& v, std::span<const Vector> points);
Error no_region(std::size_t primitive);
Error cancelled();

}  // namespace quoin::rounding
