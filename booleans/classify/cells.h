/// \file
/// Cells: which sides look into the same region of space.
#pragma once

#include "booleans/classify/sides.h"

namespace quoin::booleans {

/// Classes of sides with equal labels (winding-number vectors): all sides of one region of space are in one cell.
struct Cells {
  ById<SideId, CellId> of;
  CellId infinity;            // the cell of what is far away
  std::uint32_t count = 0;    // cell ids are below
  bool is_consistent = true;  // false: some surface does not bound anything (an operand trusted wrongly)
};

/// Facets around an edge look at their neighbours; components that hang together over edges are placed by far patches
/// or by one ray each (seeds.h).
Cells find_cells(const Arrangement& a);

}  // namespace quoin::booleans
