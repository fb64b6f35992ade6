/// \file
/// Damage as people and programs read it: in model units, with its place, its cure and a sentence.
#pragma once

#include <vector>

#include "grid/grid.h"
#include "grid/repair.h"

namespace quoin::grid {

/// What is wrong, one a damage; the cure is the one that closes all of them, its tolerance not below their sizes.
std::vector<Finding> findings_of(const Array<Damage>& damages, const Lattice& lattice);
/// What was done; the cure is the one that did it.
std::vector<Finding> repairs_of(const Array<Damage>& damages, const Lattice& lattice);

/// A decimal of three digits that is not below a positive number, nor more than 1 % above it.
std::string decimal_above(double value);

}  // namespace quoin::grid
