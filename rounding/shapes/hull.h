/// \file
/// The convex hull of points, and its dual: what half-spaces enclose.
#pragma once

#include <span>

#include "quoin/result.h"
#include "rounding/shapes/polyhedron.h"

namespace quoin::rounding {

/// The convex hull of points that do not lie in one plane, in any order, with repetitions. Expected O(n log n).
/// Errors: "bad-primitive".
Result<Polyhedron> convex_hull(std::span<const Vector> points);

/// The bounded polyhedron of the points that are below or on all planes. Precondition: `inside` is below each. By the
/// hull of the dual points n / -value(inside). Errors: "unbounded".
Result<Polyhedron> convex_polyhedron(std::span<const WidePlane> planes, const Vector& inside);

}  // namespace quoin::rounding
