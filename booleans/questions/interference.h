/// \file
/// Whether two solids meet.
#pragma once

#include <optional>

#include "booleans/questions/index.h"

namespace quoin::booleans {

/// What the boundaries of two solids on one grid tell of them.
enum class Meeting {
  apart,       // they have no point in common
  contact,     // their boundaries have; whether their interiors have is not known
  overlapping  // their interiors have
};

/// Ends with the first pair of triangles that cross each other.
Meeting meeting(const Index& a, const Index& b);

}  // namespace quoin::booleans
