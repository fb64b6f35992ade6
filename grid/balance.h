/// \file
/// Import, step 5: closedness. Every directed edge is balanced by its reverse, multiplicities counted.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "grid/lists/array.h"

namespace quoin::grid {

/// Whether triangles, three corners each, are closed. Corners are below `point_count` <= 2^31. Exact,
/// O(points + triangles).
bool is_balanced(std::span<const std::uint32_t> corners, std::size_t point_count);

/// The corners of triangles, one after the other.
inline std::span<const std::uint32_t> corners_of(std::span<const std::array<std::uint32_t, 3>> triangles) {
  return triangles.empty() ? std::span<const std::uint32_t>() : std::span(triangles[0].data(), 3 * triangles.size());
}

/// An edge that occurs `excess` times more from `from` to `to` than back.
struct OpenEdge {
  std::uint32_t from, to;
  std::uint64_t excess;
  friend bool operator==(const OpenEdge&, const OpenEdge&) = default;
};

/// All open edges among directed ones {from, to}, each once, ordered by (smaller end, larger end).
Array<OpenEdge> open_edges(Array<std::array<std::uint32_t, 2>> edges);
/// Those of triangles; empty for a closed mesh.
Array<OpenEdge> open_edges(std::span<const std::array<std::uint32_t, 3>> triangles);

}  // namespace quoin::grid
