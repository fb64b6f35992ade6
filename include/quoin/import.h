/// \file
/// How meshes become solids: options and reports.
#pragma once

#include "quoin/export.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "quoin/arrays.h"
#include "quoin/grid.h"
#include "quoin/limits.h"
#include "quoin/notice.h"
#include "quoin/options.h"
#include "quoin/repair.h"
#include "quoin/result.h"

namespace quoin {

/// What import may take for granted.
enum class Trust {
  /// Prove that the surface does not cross itself; resolve it where it does.
  nothing,
  /// Skip that proof. An operand that does cross itself then gives an unspecified result, never a crash.
  embedded,
};

struct ImportOptions {
  /// The grid to snap to; default: the one that fits the input.
  std::optional<Grid> grid = {};
  Trust trust = Trust::nothing;
  Options run = {};
  /// Cures of an open surface and of shells that are inside out; none by default.
  Repair repair = {};
  Limits limits = {};
  /// What the faces carry (quoin/labels.h): a label for each triangle or polygon, all 0 where there are none, and the
  /// name of the solid. Neighbours on one plane are one face only where their labels are equal. Faces that close holes
  /// carry nothing. Without labels and channels, with id 0 and no name, nothing is carried, and nothing is paid.
  Indices labels = {};
  std::uint32_t id = 0;
  std::string name = {};
  /// Numbers that vary over the faces, as texture coordinates, colours and normals do: the same number of channels for
  /// each corner of each triangle or polygon, corner by corner. Over one face each is an affine function of the
  /// position. Neighbours on one plane are one face only where these functions are one: in the corners of the second
  /// one that of the first is off by at most `channel_tolerance` times the range of the channel. A polygon of more than
  /// three corners whose values are off by more is refused ("bad-number").
  Coordinates channels = {};
  double channel_tolerance = 0x1p-20;
};

/// What import did to the input. Counts are of points and triangles of the input.
struct ImportReport {
  /// An upper bound of the largest move of a point, model units, with that of going to the common grid of several
  /// sources; 0 exactly when none moved.
  double max_snap = 0;
  /// Distinct input points that became one grid point.
  std::uint64_t merged_points = 0;
  /// Triangles of zero area after snapping: gone, their points now on their neighbours' edges. Where these are all, a
  /// mesh smaller than a step, the solid is empty. A mesh of which no face had an area before is refused ("no-faces").
  std::uint64_t zero_area_triangles = 0;
  /// Polygons that were not planar after snapping and were triangulated.
  std::uint64_t nonplanar_polygons = 0;
  /// Pairs of faces that crossed, overlapped or touched out of place, all resolved (inside is winding number > 0).
  /// Where many shells crowd each other they are united group by group, and counted are the pairs that were found to
  /// meet.
  std::uint64_t resolved_crossings = 0;
  /// Shells that look inwards and bound nothing of the result: nothing is left of them, since inside is winding
  /// number > 0. A body that is inside out among others is one; a void within a body is none. Not counted with
  /// Trust::embedded.
  std::uint64_t dropped_shells = 0;
  /// The first of them, "shell at (x, y, z)": its lowest corner by x, then y, then z, in model units; empty for none.
  std::string dropped_where = {};
  /// Where nothing is left of the mesh, the grid on which it bounds nothing, "step 1"; empty otherwise.
  std::string empty_on = {};
  /// Vertices that lie exactly on open edges of neighbours, put on them, so that the surface is closed there.
  std::uint64_t sealed_t_junctions = 0;
  /// What is wrong with the surface: of a mesh that is refused, open or inside out, all that import can tell; of one
  /// that is accepted its dropped shells. After a repair: what is left.
  std::vector<Finding> findings = {};
  /// What the cures did that were asked for, one a kind.
  std::vector<Finding> repairs = {};
  /// What was passed over, of the file and of the mesh, one a kind. Where shells are dropped, the last one says so.
  std::vector<Notice> notices = {};
};

/// What is wrong with polygons given as for Solid::from_polygons, before any of `options.repair`, or what these leave.
/// A mesh that crosses itself is not at fault. Errors: those of import, but for "open-boundary" and "inside-out".
QUOIN_API Result<Diagnosis> diagnose(Coordinates points, Indices starts, Indices corners,
                                     const ImportOptions& options = {});

}  // namespace quoin
