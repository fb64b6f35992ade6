/// \file
/// Triangles that are proved to meet all others as they should, a fan at a time.
#pragma once

#include <cstdint>
#include <vector>

#include "booleans/body/stars.h"

namespace quoin::booleans {

/// Marks triangles of a mesh of raw triangles (no zero area) that meet every other one in a common corner or edge only,
/// or not at all. An empty list marks none. `star_of`: the stars of the vertices.
///
/// All triangles of a large fan reach its hub, so their boxes overlap by the square of their number. Two kinds of fans
/// are looked at as a whole:
///   - Coplanar triangles around one vertex. A fan whose own triangles meet as they should meets a triangle t on one
///     closed side of its plane at most in what t has on the plane; where that is nothing, a corner of the fan or an
///     edge of it, each triangle of the fan meets t as it should.
///   - An embedded star whose hub lies higher, above some plane, than all its outer edges, as that of a cone's apex,
///     whether its rim lies on a plane or zigzags. A triangle that reaches no higher than these edges meets the star
///     between their levels only: boxes of what lies there tell which triangles have to be compared.
/// O(n) a fan, and O(k log k) for the k triangles between the levels; a fan is as large as the square root of n.
Array<std::uint8_t> proved_in_fans(const Body& mesh, const Array<Star>& star_of);

}  // namespace quoin::booleans
