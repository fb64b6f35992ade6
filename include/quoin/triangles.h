/// \file
/// Triangles for the outside: what export makes of a solid.
#pragma once

#include "quoin/export.h"

#include <array>
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

/// What holds of the written numbers, read as exact ones.
enum class Validity {
  /// They bound a solid: triangles meet in common corners and edges only, none is flipped or has no area, and the
  /// winding number is 1 inside and 0 outside. Where correct rounding keeps that, which is proved, it is what is
  /// written; else the mesh is mended, and the report says by how much anything moved.
  valid,
  /// Correctly rounded, whatever becomes of thin parts: `flipped` and `collapsed` count some of it.
  fast,
};

struct ExportOptions {
  Topology topology = Topology::manifold;
  /// Round coordinates to float32 (what binary STL stores) instead of double before the check.
  bool float32 = false;
  Options run = {};
  Validity validity = Validity::valid;
  /// Subtract the box's centre, rounded to a multiple of a power of two not below half the box's largest side: what
  /// lies far from the origin keeps its shape. See ExportReport::recentred.
  bool recentre = false;
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
  /// Of the written mesh.
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
  /// The written mesh is proved valid (see Validity). With Validity::fast nothing is proved, nor of solids that were
  /// trusted wrongly.
  bool valid = false;
  /// An upper bound, in model units, of the distance by which a vertex moved; 0 where none did. The written solid,
  /// moved back by `recentred`, differs from the exact one at points within that distance of the exact surface only.
  double max_round = 0;
  /// The shortest edge of the exact triangles or, where all are longer than `detail_factor` times `max_round`, the
  /// least distance of two vertices that are nearer to each other than that; model units, computed in doubles. 0
  /// without triangles, or where no vertex moved. Where points move by more than a small part of it shapes suffer.
  double least_detail = 0;
  static constexpr double detail_factor = 16;
  /// What was mended, Validity::valid only: how many times the mesh was snapped and resolved, pairs of triangles that
  /// met out of place, vertices that became one with another one, triangles that lost their area.
  std::uint64_t mending_rounds = 0, mended_crossings = 0, merged_vertices = 0, vanished_triangles = 0;
  /// Edges as in `split_edges` for which the numbers leave no room inside: they keep four triangles and more.
  std::uint64_t shared_edges = 0;
  /// What was subtracted from all points; 0 unless asked for.
  std::array<double, 3> recentred = {0, 0, 0};
};

}  // namespace quoin
