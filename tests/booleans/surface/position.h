/// \file
/// Where the vertices of a triangulated body are. Shared by the tests and the fuzz targets.
#pragma once

#include "booleans/surface/triangulated.h"

namespace quoin::booleans::testing {

/// Of an output vertex, exactly.
inline RationalPoint position(const Body& body, const Triangulated& mesh, std::uint32_t vertex) {
  if (vertex >= mesh.source.size()) return mesh.added[vertex - mesh.source.size()];

  const exact::Point p = body.point(mesh.source[vertex]);
  return {exact::coordinate(p, 0), exact::coordinate(p, 1), exact::coordinate(p, 2)};
}

}  // namespace quoin::booleans::testing
