/// \file
/// From a selection back to a body: coplanar kept facets merge into maximal faces, and vertices that are no longer
/// needed vanish.
#pragma once

#include "booleans/arrangement.h"

namespace quoin::booleans {

Body assemble(const Arrangement& a, const Selection& selection);

}  // namespace quoin::booleans
