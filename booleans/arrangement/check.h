/// \file
/// What must hold after each stage. Developer builds (QUOIN_CHECKED) run these; a violation stops the program.
#pragma once

#include "booleans/arrangement/arrangement.h"

namespace quoin::booleans {

/// Every boundary edge lies on its face's plane and on its other plane, which are not parallel; at every vertex as many
/// edges of a face end as begin.
void check(const Touched& touched, const Names& names);
/// Elements lie on the sheet and on their lines, their ends in order; turning clockwise permutes the half-edges of each
/// origin; a loop has one facet on its left; what covers the two sides of a boundary differs.
void check(const Sheet& sheet, const Names& names);
/// Of clean operands: every edge has facets on it whose changes of each operand's label, going round, sum to zero.
void check(const Arrangement& a);
/// `fault(body)` finds nothing.
void check(const Body& body);

}  // namespace quoin::booleans
