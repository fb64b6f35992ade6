/// \file
/// The cures, one file each in grid/repair. Each wants and leaves points in lexicographic order and triangles with an
/// area; each says what it found, or did. All are exact, O(n log n) and what is near each other, and depend on the
/// positions of triangles alone.
#pragma once

#include <optional>

#include "grid/repair/surface.h"

namespace quoin::grid {

/// Boundary vertices within reach become one, the least of them; never the two ends of an edge. A vertex moves at most
/// by the tolerance. Triangles that lose their area remain.
Damage weld_boundary(Surface& surface, const Reach& reach);

/// Boundary edges are split at boundary vertices within reach that lie beside them, and bend to them, where one of the
/// pieces then meets another boundary edge. Triangles that lose their area remain.
Damage join_t_junctions(Surface& surface, const Reach& reach);

/// Drops copies of triangles, also opposite ones, where that leaves fewer open edges.
Damage drop_duplicates(Surface& surface);
/// Drops what hangs on the rest by edges that are closed without it, where `careful` only what has at most half of the
/// rest's area; and flat pieces that hang on nothing.
Damage drop_flaps(Surface& surface, bool careful);

/// Turns triangles so that neighbours agree: along edges of two triangles, and along others in turns around the edge,
/// where they do not agree as they are. Of triangles that hang together so the fewer turn.
Damage orient_coherently(Surface& surface);

/// Which holes are closed.
struct Caps {
  bool planar = false;
  std::optional<Reach> up_to;  // of the diagonal of the hole's box
  bool careful = false;        // as Repair::all says
};
/// Boundary loops, planar ones and others; closes those asked for. What is said is of those closed, or, where `look`,
/// of all.
std::array<Damage, 2> close_holes(Surface& surface, const Caps& caps, bool look);

/// Edges that an odd number of triangles, more than one, share.
Damage branches(const Surface& surface);
/// Open edges that an even number of triangles share: of a surface that is coherent as far as it can be, these are
/// where it is one-sided.
Damage disagreements(const Surface& surface);

/// How closed shells are turned round.
enum class Turning { inside_out, nested, solid };
/// Precondition: closed.
Damage turn_shells(Surface& surface, Turning turning);

}  // namespace quoin::grid
