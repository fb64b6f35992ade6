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
/// All triangles of a large fan reach its hub, so their boxes overlap by the square of their number. Looked at as a
/// whole the fan needs one look at each other triangle t: a fan whose own triangles meet as they should, on one closed
/// side of a plane, meets t on the other closed side at most in what t has on the plane; where that is nothing, a
/// corner of the fan or an edge of it, each triangle of the fan meets t as it should. Two kinds of fans are tried:
///   - coplanar triangles around one vertex, the plane being theirs;
///   - an embedded star whose outer edges lie on one plane, as that of a cone's apex.
/// O(n) a fan; a fan is as large as the square root of n.
std::vector<std::uint8_t> proved_in_fans(const Body& mesh, const std::vector<Star>& star_of);

}  // namespace quoin::booleans
