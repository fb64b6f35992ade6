/// \file
/// Import, step 6, only where it is asked for: cures of open surfaces and of shells that look the wrong way.
#pragma once

#include <optional>

#include "grid/grid.h"
#include "grid/repair/surface.h"
#include "quoin/repair.h"

namespace quoin::grid {

/// Repair (quoin/repair.h) with numbers, model units.
struct Cures {
  std::optional<exact::Rational> weld, t_junctions, caps_up_to;
  bool duplicates = false, caps = false, invert_shells = false, all = false;
  Orient orient = Orient::as_is;

  bool any() const {
    return weld || t_junctions || caps_up_to || duplicates || caps || invert_shells || all || orient != Orient::as_is;
  }
};

/// What was done to a surface, in the order in which it was, kinds without a place left out.
struct Repaired {
  Array<Damage> damages;
  std::uint64_t sealed_t_junctions = 0;  // exact ones
};

/// Cures a surface as asked. It may still be open. Triangles have three corners of different places; points are
/// pairwise distinct. Where nothing is to be cured the surface stays as it is; else the result is in canonical order
/// and a function of the positions of the triangles, as a set.
Repaired repair(Surface& surface, const Cures& cures, const Lattice& lattice);

/// What is wrong with a surface, in the order in which it would be cured: nothing where it is closed and no shell is
/// inside out. What is said of each kind is found on a surface that is cured of those before it.
Array<Damage> diagnose(Surface surface);

}  // namespace quoin::grid
