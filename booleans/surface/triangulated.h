/// \file
/// Bodies as triangles.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "booleans/body/body.h"
#include "exact/rational.h"

namespace quoin::booleans {

/// A point of any denominator, grid steps.
using RationalPoint = std::array<exact::Rational, 3>;

/// A conforming triangulation of the boundary: raw triangles as they are, polygons triangulated exactly. The triangles
/// of raw ones come first, in the body's order, then those of polygons.
struct Triangulated {
  std::vector<std::uint32_t> corners;  // three a triangle: output vertices, counter-clockwise from outside
  Array<std::uint32_t> face;           // body face of each triangle
  Array<std::uint32_t> source;         // body vertex of each output vertex but the last ones
  Array<RationalPoint> added;          // the last output vertices: inside edges that `separated` had to split
  std::size_t split_edges = 0;         // how many edges of the body these are
  std::size_t shared_edges = 0;        // how many edges of the body stayed with the same two vertices for all triangles

  std::size_t triangle_count() const { return face.size(); }
  std::size_t vertex_count() const { return source.size() + added.size(); }
  std::array<std::uint32_t, 3> triangle(std::size_t t) const {
    return {corners[3 * t], corners[3 * t + 1], corners[3 * t + 2]};
  }
};

/// Every body vertex in use is one output vertex; an edge may carry 4, 6, ... triangles.
Triangulated triangulated(const Body& body);

}  // namespace quoin::booleans
