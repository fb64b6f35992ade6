/// \file
/// From a selection back to a body: untouched faces are copied or shared, coplanar kept facets merge into maximal
/// faces, and vertices that are no longer needed vanish.
#pragma once

#include "booleans/classify/selection.h"

namespace quoin::booleans {

/// Precondition: the selection is consistent.
Body assemble(const Arrangement& a, const Selection& selection);

}  // namespace quoin::booleans
