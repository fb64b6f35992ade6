/// \file
/// Bodies as triangles, and the boundary's topology.
#pragma once

#include "booleans/body.h"

namespace quoin::booleans {

/// A conforming triangulation of the boundary: raw triangles as they are, polygons triangulated exactly.
struct Triangulated {
  std::vector<std::array<std::uint32_t, 3>> triangles;  // output vertices, counter-clockwise from outside
  std::vector<std::uint32_t> face;                      // body face of each triangle
  std::vector<std::uint32_t> source;                    // body vertex of each output vertex
};

/// Every body vertex in use is one output vertex; an edge may carry 4, 6, ... triangles.
Triangulated triangulated(const Body& body);
/// The same with touching parts separated combinatorially: at an edge of 2k triangles those that bound one wedge of the
/// solid are paired, and a vertex is split into its fans ("shrink the interior"). Every edge has two triangles.
/// Two edges may join the same two vertices, where the solid touches itself along an edge and hangs together around both
/// of its ends: then four triangles name that pair of vertices (tests: complement-of-boxes-that-share-an-edge).
Triangulated separated(const Body& body, const Triangulated& mesh);

/// Of a separated mesh: connected components, and the sum of their genera.
struct Shells {
  std::uint64_t count = 0;
  std::int64_t genus = 0;
};
Shells shells(const Triangulated& separated_mesh);

}  // namespace quoin::booleans
