/// \file
/// One lattice for things that stand on several: the candidates, and the one that serves where none is exact.
///
/// The rule, a function of the lattices and the box as sets: of the candidates in their order the first is taken on
/// which everything is exact. These are (a) the given lattices, finest first, ties by the origin; (b) with g the
/// greatest common divisor of all steps and of the differences of all origins, lattices of the steps c g for c = 2^k
/// and c = m 2^k, where m is the odd part of a given step / g (of the sixteen smallest), each with the two least k at
/// which the box fits the world, and for the least c at which it does; finest first. Where nothing is exact everywhere,
/// what is not is rounded to (c) the coarsest given lattice, its step multiplied by the power of two, perhaps below 1,
/// at which the box just fits rounding_bound steps about its centre. The origin of (b) and (c) is that of the coarsest
/// given lattice where the box lies in the world about it; else the point nearest to the centre of the box that is
/// whole steps away from it.
///
/// Why (b) is complete for steps that are one number times powers of two, with origins that are multiples of their
/// steps, among lattices of this kind, is said in docs/doors.md.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "grid/grid.h"

namespace quoin::grid {

/// A factor 2 to the world is left to motions.
inline constexpr std::int32_t rounding_bound = 1 << 28;

/// A box in model units, exactly. One without points has low > high.
struct ModelBox {
  std::array<exact::Rational, 3> low = {1, 1, 1}, high = {0, 0, 0};

  bool is_empty() const { return high[0] < low[0]; }
  void add(const std::array<exact::Rational, 3>& point);
  void add(const ModelBox& box);
  /// Its longest side. Precondition: not empty.
  exact::Rational size() const;
};

/// By step, then by origin.
bool finer(const Lattice& a, const Lattice& b);
/// In that order, each once.
void sort_distinct(std::vector<Lattice>& lattices);
/// Whether the box, shrunk by `slack`, lies within the world of the lattice.
bool in_world(const Lattice& lattice, const ModelBox& box, const exact::Rational& slack = 0);

/// (b). Precondition: `own` is in order and not empty; the box has points.
std::vector<Lattice> lattices_between(const std::vector<Lattice>& own, const ModelBox& box);
/// (c). A vertex that is rounded there moves by less than 2^-28 of the box's size. Preconditions: as above, and the box
/// is no point.
Lattice rounding_lattice(const std::vector<Lattice>& own, const ModelBox& box);

}  // namespace quoin::grid
