/// \file
/// Equality of point sets.
#pragma once

#include "booleans/body/body.h"
#include "quoin/quoin.h"

namespace quoin {

bool equal_on_one_grid(const booleans::Body& a, const booleans::Body& b);
/// By exact positions in model units.
bool equal_across_grids(const Solid& a, const Solid& b);

}  // namespace quoin
