/// \file
/// The door for meshes: arrays of doubles become closed, coherently oriented triangles of grid points.
/// What is not examined here: whether the surface crosses or touches itself, and how its shells nest.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "exact/geometry.h"
#include "grid/grid.h"
#include "grid/lists/array.h"
#include "grid/repair.h"
#include "quoin/result.h"

namespace quoin::grid {

/// A closed triangle mesh on the lattice. Every directed edge is balanced by its reverse, no triangle has zero area,
/// points are pairwise distinct, the enclosed signed volume is >= 0 (unless any facing was asked for).
/// Points keep the order of their first occurrence in the input; a point that no triangle uses may remain.
/// Triangles keep the order of the input polygons they come from; those made by sealing stand where the neighbour they
/// replace stood or at the end.
struct ImportedMesh {
  Array<exact::GridPoint> points;
  Array<std::array<std::uint32_t, 3>> triangles;
  /// By triangle, if they are asked for: the polygon that it is a part of, `no_source` for one that closes a hole.
  Sources sources;
  /// The largest move of a point by snapping, an upper bound in model units (of Euclidean length); 0 when exact.
  double max_snap = 0;
  /// Distinct input positions that became one with an earlier one.
  std::uint64_t merged_points = 0;
  /// Input triangles, or triangles of cut polygons, that had zero area after snapping.
  std::uint64_t zero_area_triangles = 0;
  /// Polygons of more than three corners that were not planar after snapping.
  std::uint64_t nonplanar_polygons = 0;
  /// Vertices put on open edges on which they lie exactly, so that these closed.
  std::uint64_t sealed_t_junctions = 0;
};

/// Which way the faces of a mesh may look.
enum class Facing {
  out,  // counter-clockwise from outside: a negative volume is refused, and so are faces that look nowhere
  any,  // also nowhere: of what has been rounded nothing may be left
};

/// What is asked of import beyond what it does always, and what it found. Points and triangles of a mesh that was cured
/// are in canonical order (repair/surface.h).
struct Curing {
  Cures cures = {};
  bool wants_sources = false;          // ImportedMesh::sources
  std::vector<Finding> findings = {};  // what is wrong, where the mesh is refused for it
  std::vector<Finding> repairs = {};   // what was done
};

/// Snaps, welds, cuts polygons into triangles, seals T-junctions, those of zero-area triangles and, where the surface
/// is open, those of vertices that lie exactly on open edges, cures what it is asked to, proves closedness and checks
/// orientation; all exact, deterministic, O(n log n).
/// `points`: 3 doubles per vertex, model units. Polygon i has the corners corners[starts[i]] .. corners[starts[i+1]-1],
/// counter-clockwise from outside; `starts` is non-decreasing and has one entry more than there are polygons, or none.
/// A coordinate goes to the nearest grid coordinate, ties to even. Every vertex is snapped, used or not.
/// Errors: "non-finite", "out-of-range" (naming the vertex and a step that would work; also for more than 2^31 points
/// or corners), "bad-index" (also for broken `starts`), "no-faces" (there are some, but none has an area before
/// snapping: area.h), "open-boundary" (`where` is one edge with its ends in model units and its face, of a mesh that
/// was cured the first finding's place; the sentence has the first finding and its cure), "inside-out" (`where` is the
/// lowest corner of the shell of the most negative volume).
Result<ImportedMesh> import_polygons(std::span<const double> points, std::span<const std::uint32_t> starts,
                                     std::span<const std::uint32_t> corners, const Lattice& lattice,
                                     Curing* curing = nullptr);
/// The same for triangles, three indices each. A length that is not a multiple of 3 is "bad-index".
Result<ImportedMesh> import_triangles(std::span<const double> points, std::span<const std::uint32_t> triangles,
                                      const Lattice& lattice, Facing facing = Facing::out, Curing* curing = nullptr);

}  // namespace quoin::grid
