/// \file
/// The closed parts of a mesh, and what each of them encloses.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "exact/geometry.h"
#include "grid/lists/array.h"

namespace quoin::grid {

/// A shell is a set of triangles that is closed by itself and hangs together over edges.
struct Shells {
  /// The shell of each triangle; shells are numbered in the order of their first triangles.
  Array<std::uint32_t> of_triangle;
  /// Six times the signed volume of each shell, cubic grid steps: negative when its faces look inwards.
  Array<exact::int128> six_volumes;
  /// Whether more than two triangles meet at an edge. Where none do the order of the list decides nothing.
  bool has_crowded_edges = false;
};

/// Triangles hang together over edges that they alone share. Parts that more triangles meet at an edge of are united
/// only where they are not closed along it by themselves: there in pairs, in the order of the list. So bodies that
/// touch in a corner or along an edge are shells of their own, and so are bodies that share a face, or a surface that
/// is there twice, when the triangles of one stand behind those of the other. Precondition: every directed edge is
/// balanced by its reverse; no triangle has a corner twice. O(n log n).
Shells shells(std::span<const exact::GridPoint> points, std::span<const std::array<std::uint32_t, 3>> triangles);

/// The lowest corner of a shell, by x, then y, then z.
exact::GridPoint lowest_corner(const Shells& shells, std::uint32_t shell, std::span<const exact::GridPoint> points,
                               std::span<const std::array<std::uint32_t, 3>> triangles);

}  // namespace quoin::grid
