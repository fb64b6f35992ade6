/// \file
/// Whether many boxes lie in one place.
#pragma once

#include "booleans/body/box.h"
#include "grid/lists/array.h"

namespace quoin::booleans {

/// Does a box meet, of those that meet it, more than Thresholds::neighbours that also meet each other, on average?
/// Boxes that meet in pairs have a point in common, so this asks for many in one place: n bars across n others, which
/// meet in n^2 places, are no crowd. Which of its neighbours meet is asked of few. Time O(n log n) and the pairs that
/// meet, or less as soon as there are enough.
bool are_crowded(const grid::Array<Box>& boxes);

}  // namespace quoin::booleans
