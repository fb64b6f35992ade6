/// \file
/// What of a mesh `resolve` made nothing of.
#pragma once

#include "booleans/body/body.h"

namespace quoin::booleans {

struct DroppedShells {
  std::uint64_t count = 0;
  /// The lowest corner, by x, then y, then z, of the first of them; when there is one.
  exact::GridPoint lowest_corner = {};
};

/// The shells (grid/shells.h) of `mesh` that look inwards (their volume is negative) and bound nothing of `result`,
/// which is what `resolve` made of the mesh: a body that is inside out among others. A void within a body bounds the
/// result, and an inward body that cuts into another one bounds what it leaves of it: they are not dropped. Nor is a
/// shell that looks outwards within another one: union swallows it. Preconditions: those of `resolve`; the result is
/// packed.
DroppedShells dropped_shells(const Body& mesh, const Body& result);

}  // namespace quoin::booleans
