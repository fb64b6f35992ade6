/// \file
/// Triangles for the outside: what export makes of a solid.
#pragma once

#include "quoin/export.h"

#include <cstdint>
#include <vector>

#include "quoin/options.h"

namespace quoin {

/// A triangle mesh as arrays: `points` is x, y, z per vertex in model units, `triangles` three vertex indices each,
/// counter-clockwise seen from outside.
struct Mesh {
  std::vector<double> points;
  std::vector<std::uint32_t> triangles;
};

enum class Topology {
  /// Vertices and edges where parts only touch are separated combinatorially: every edge has exactly two triangles, and
  /// shells and genus of the mesh are those of `Info`.
  manifold,
  /// Vertices are shared wherever they coincide; an edge may carry 4, 6, ... triangles.
  indexed,
};

struct ExportOptions {
  Topology topology = Topology::manifold;
  /// Round coordinates to float32 (what binary STL stores) instead of double before the check.
  bool float32 = false;
  Options run = {};
};

/// What `Info` counts of triangles, whatever the topology of the export: those of the boundary with touching parts
/// separated.
struct SurfaceCounts {
  std::uint64_t triangles = 0, shells = 0;
  std::int64_t genus = 0;
  bool manifold = true;
  friend bool operator==(const SurfaceCounts&, const SurfaceCounts&) = default;
};

/// What rounding to floating point did to the exported triangles.
struct ExportReport {
  std::uint64_t triangles = 0;
  /// Triangles whose rounded normal points against the exact one.
  std::uint64_t flipped = 0;
  /// Triangles whose rounded area is exactly zero.
  std::uint64_t collapsed = 0;
  /// Edges along which the solid touches itself and around both ends of which it hangs together: each got a vertex
  /// inside, one copy for every two triangles, so that two vertices name one edge. Topology::manifold only.
  std::uint64_t split_edges = 0;
  /// Every directed edge of the written mesh is balanced by its reverse.
  bool closed = true;
};

}  // namespace quoin
