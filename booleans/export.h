/// \file
/// Bodies as triangles, and the boundary's topology.
#pragma once

#include "booleans/body.h"

namespace quoin::booleans {

/// A conforming triangulation of the boundary: raw triangles as they are, polygons triangulated exactly.
struct Triangulated {
  std::vector<std::uint32_t> corners;  // three a triangle: output vertices, counter-clockwise from outside
  std::vector<std::uint32_t> face;     // body face of each triangle
  std::vector<std::uint32_t> source;   // body vertex of each output vertex

  std::size_t triangle_count() const { return face.size(); }
  std::array<std::uint32_t, 3> triangle(std::size_t t) const {
    return {corners[3 * t], corners[3 * t + 1], corners[3 * t + 2]};
  }
};

/// Every body vertex in use is one output vertex; an edge may carry 4, 6, ... triangles.
Triangulated triangulated(const Body& body);
/// How the triangles at an edge of 2k triangles are paired.
enum class Pairing {
  /// Those that bound one wedge of the solid: "shrink the interior". This is the boundary's own topology.
  by_interior,
  /// The same, but where two edges would then join the same two vertices (the solid touches itself along an edge and
  /// hangs together around both of its ends) those that bound one wedge of the outside, so that two indices name one
  /// edge. Only an edge that both the solid and its complement hang around at both ends may keep four triangles.
  by_distinct_edges,
};

/// The same with touching parts separated combinatorially: triangles are glued in pairs over edges, and a vertex is
/// split into its fans.
Triangulated separated(const Body& body, Triangulated mesh, Pairing pairing = Pairing::by_interior);

/// Of a separated mesh: connected components, and the sum of their genera.
struct Shells {
  std::uint64_t count = 0;
  std::int64_t genus = 0;
};
Shells shells(const Triangulated& separated_mesh);

}  // namespace quoin::booleans
