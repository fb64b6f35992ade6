/// \file
/// Selection: the boundary of an expression's value among all nodes.
#pragma once

#include "booleans/classify/cells.h"
#include "booleans/classify/expression.h"

namespace quoin::booleans {

struct Selection {
  /// +1 kept with the outside in front (canonical normal; for patches their own outward normal), -1 kept with the
  /// outside behind, 0 dropped.
  ById<NodeId, std::int8_t> kept;
  ById<ElementId, std::uint8_t> kept_at;  // how many kept facets meet there, at most 255
  ById<NodeId, TouchedId> named_by;       // by facet: the touched face that names it (naming.h); empty without labels
  /// With labels: do exactly two kept faces meet there that have one oriented plane, one of them untouched?
  ById<ElementId, std::uint8_t> is_border;
  bool full_at_infinity = false;
  bool is_consistent = true;    // false: the surfaces of an operand do not bound a solid (trusted wrongly)
  NodeId contradiction = none;  // then one whose sides' labels do not differ by its jump, if there is one
};

/// Labels both sides of every node and selects the boundary of the expression.
Selection select(const Arrangement& a, const Cells& cells, const Expression& expression);

}  // namespace quoin::booleans
