/// \file
/// A gear box as a construction history: what models are for.
#pragma once

#include "quoin/quoin.h"

namespace quoin::examples {

/// A housing with feet, bosses, bores, screws and cooling fins, and two meshing gears in it: about 200 primitives, in
/// millimetres. Parameters: "wall", its thickness; "bore", the radius of shafts and bores; "turn", the angle of the
/// large gear.
Model gear_box();

/// Four brackets: an angle of two blocks, with a square hole, a round one, a rib, or both; unturned, the corner at the
/// origin. Model units.
std::vector<Model> bracket_variants();

}  // namespace quoin::examples
