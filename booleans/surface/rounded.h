/// \file
/// What rounding to floating point does to triangles.
#pragma once

#include <vector>

#include "booleans/surface/triangulated.h"
#include "grid/grid.h"

namespace quoin::booleans {

/// The floating-point numbers of a file format.
enum class Floats { float32, float64 };

/// Correctly rounded coordinates of the output vertices, x, y, z a vertex, in model units; infinite beyond the range.
std::vector<double> rounded_points(const Body& body, const Triangulated& mesh, const grid::Lattice& lattice,
                                   Floats floats);

/// How far rounding moved output vertices.
struct Moves {
  /// By output vertex: 0 where the rounded point is known to be the exact one. Empty where none moved.
  Array<std::uint8_t> moved;
  /// Triangles before this one have no corner that moved.
  std::size_t first = 0;
  /// An upper bound of the largest distance, model units; 0 where none moved.
  double most = 0;
};
/// `points`: those that `rounded_points` gives for the other arguments, all finite.
Moves moves(const Body& body, const Triangulated& mesh, const grid::Lattice& lattice, Floats floats,
            const std::vector<double>& points);

/// Triangles that rounding turned over (the rounded normal points against the exact one) or made flat (the rounded area
/// is zero). Exact.
struct RoundingEffects {
  std::uint64_t flipped = 0, collapsed = 0;
  friend bool operator==(const RoundingEffects&, const RoundingEffects&) = default;
};
/// `points`: those that `rounded_points` gives for the other arguments, all finite.
RoundingEffects rounding_effects(const Body& body, const Triangulated& mesh, const grid::Lattice& lattice,
                                 Floats floats, const std::vector<double>& points);

}  // namespace quoin::booleans
