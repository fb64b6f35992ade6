/// \file
/// The edges of a boundary and the faces around each.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "booleans/body/boundary.h"

namespace quoin::booleans {

/// Corners are numbered as in `Boundary::faces`, and stand for the half-edge that begins there.
struct Edges {
  std::vector<std::array<std::uint32_t, 2>> ends;  // of each edge the lower vertex, then the higher; ascending
  /// Edge e has the half-edges fan[fan_start[e]] .. fan[fan_start[e + 1] - 1], counter-clockwise around the direction
  /// from its lower to its higher vertex; the first has the lowest corner.
  std::vector<std::uint32_t> fan_start = {0};
  std::vector<std::uint32_t> fan;
  // By corner.
  std::vector<std::uint32_t> face, loop;
  std::vector<std::uint32_t> edge;      // none in a loop of one corner
  std::vector<std::uint32_t> opposite;  // with which it bounds a wedge of the solid; itself in a loop of one corner

  std::span<const std::uint32_t> fan_of(std::size_t e) const {
    return std::span(fan).subspan(fan_start[e], fan_start[e + 1] - fan_start[e]);
  }
};

/// Precondition: vertices ascend, as in a canonical form.
Edges edges_of(const Boundary& boundary);

/// The corner after this one in its loop.
inline std::uint32_t next_corner(const Boundary& boundary, const Edges& edges, std::uint32_t corner) {
  const auto& starts = boundary.faces.loop_start;
  const std::uint32_t j = edges.loop[corner];
  return corner + 1 < starts[j + 1] ? corner + 1 : starts[j];
}

/// Whether a half-edge runs to the higher vertex.
inline bool is_forward(const Boundary& boundary, const Edges& edges, std::uint32_t corner) {
  const auto& corners = boundary.faces.corners;
  return corners[corner] < corners[next_corner(boundary, edges, corner)];
}

}  // namespace quoin::booleans
