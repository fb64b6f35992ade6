/// \file
/// What an operation did to its operands so that they stand on one grid.
#pragma once

#include "quoin/export.h"

#include <cstdint>
#include <string>

namespace quoin {

/// Which grid solids of different grids meet on (docs/doors.md says the rule).
enum class GridRule {
  /// One on which all are exact where there is any; else what is not exact is rounded, once, and reported.
  common,
  /// The same, but what would be rounded is refused: "inexact-grid"; of planes "bad-plane".
  exact,
};

/// All zero where every operand was exact on the grid of the result.
struct OperationReport {
  /// An upper bound of how far any point of an operand's surface moved by rounding, of planes within the box of the
  /// solids; model units. The second as the exact rational that it is, "p/q".
  double max_snap = 0;
  std::string max_snap_bound = "0";
  /// Solids that were not exact on the common grid, each once; those of them whose faces stayed flat, and those rounded
  /// vertex by vertex.
  std::uint64_t rounded_operands = 0, by_planes = 0, by_vertices = 0;
  /// Pairs of faces that rounding vertex by vertex made cross, resolved as on import.
  std::uint64_t resolved_crossings = 0;
  /// Half-spaces whose numbers were too long for the grid.
  std::uint64_t rounded_planes = 0;
  /// Solids of which rounding left nothing, and the first of them, "operand 3", where operands have numbers.
  std::uint64_t vanished_operands = 0;
  std::string vanished_where = {};
};

}  // namespace quoin
