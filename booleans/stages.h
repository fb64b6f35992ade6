/// \file
/// The stages of a Boolean in a row, each a value made from those before it:
///   Pairs -> Touched -> Contacts -> Sheets -> Uses -> Cells -> Selection -> Body
#pragma once

#include "booleans/classify/selection.h"
#include "booleans/run.h"

namespace quoin::booleans {

/// Touched to uses. Errors: "cancelled".
Result<Arrangement> arrange(Operands operands, const FacePairs& pairs, const Run& run = {});

/// Cells to the body of the expression. Errors: "cancelled", "inconsistent".
Result<Body> selected(const Arrangement& a, const Expression& expression, const Run& run = {});

}  // namespace quoin::booleans
