/// \file
/// The nearest point of a boundary.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "booleans/questions/index.h"
#include "booleans/questions/line.h"

namespace quoin::booleans {

/// Grid steps.
struct Nearest {
  exact::Rational squared_distance;
  RationalPoint point;               // of equally near ones the first in order of (x, y, z)
  std::vector<std::uint32_t> faces;  // that hold it, by their names, ascending
};

/// Nothing where there is no boundary.
std::optional<Nearest> nearest(const Index& index, const QueryPoint& from);

}  // namespace quoin::booleans
