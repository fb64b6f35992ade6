#include "grid/balance.h"

#include <algorithm>
#include <atomic>
#include <utility>

#include "grid/lists/buckets.h"
#include "grid/lists/stretches.h"

namespace quoin::grid {

namespace {

/// The edges whose smaller end is one of first .. last - 1.
bool is_part_balanced(std::span<const std::uint32_t> corners, std::size_t point_count, std::size_t first,
                      std::size_t last) {
  // By the smaller end: the larger end and the direction.
  const Buckets<> edges(last - first, [&](auto&& visit) {
    const auto edge = [&](std::uint32_t a, std::uint32_t b) {
      const std::size_t low = std::size_t{std::min(a, b)} - first;
      if (low < last - first) visit(low, std::max(a, b) * 2 + (a > b ? 1U : 0U));
    };
    for (std::size_t c = 0; c < corners.size(); c += 3) {
      edge(corners[c], corners[c + 1]);
      edge(corners[c + 1], corners[c + 2]);
      edge(corners[c + 2], corners[c]);
    }
  });

  // Counters are all zero between buckets: `open` is the sum of their magnitudes.
  Array<std::int32_t> counter(point_count);
  for (std::size_t i = 0; i + first < last; ++i) {
    std::int64_t open = 0;
    for (const std::uint32_t edge : edges[i]) {
      std::int32_t& c = counter[edge >> 1];
      const std::int32_t before = c, after = before + ((edge & 1) != 0 ? -1 : 1);
      open += (after < 0 ? -after : after) - (before < 0 ? -before : before);
      c = after;
    }
    if (open != 0) return false;
  }
  return true;
}

}  // namespace

bool is_balanced(std::span<const std::uint32_t> corners, std::size_t point_count) {
  std::atomic<bool> balanced = true;
  in_shares(point_count, [&](std::size_t first, std::size_t last) {
    if (!is_part_balanced(corners, point_count, first, last)) balanced = false;
  });
  return balanced;
}

Array<OpenEdge> open_edges(Array<std::array<std::uint32_t, 2>> edges) {
  const auto ends = [](const std::array<std::uint32_t, 2>& e) {
    return std::uint64_t{std::min(e[0], e[1])} << 32 | std::max(e[0], e[1]);
  };
  std::sort(edges.begin(), edges.end(), [&](const auto& e, const auto& f) { return ends(e) < ends(f); });

  Array<OpenEdge> result;
  for (std::size_t i = 0, j = 0; i < edges.size(); i = j) {
    const auto [low, high] = std::minmax(edges[i][0], edges[i][1]);
    std::int64_t sum = 0;
    for (; j < edges.size() && ends(edges[j]) == ends(edges[i]); ++j) sum += edges[j][0] > edges[j][1] ? -1 : 1;
    if (sum > 0) result.push_back({low, high, static_cast<std::uint64_t>(sum)});
    if (sum < 0) result.push_back({high, low, static_cast<std::uint64_t>(-sum)});
  }
  return result;
}

Array<OpenEdge> open_edges(std::span<const std::array<std::uint32_t, 3>> triangles) {
  Array<std::array<std::uint32_t, 2>> edges;
  edges.reserve(3 * triangles.size());
  for (const auto& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) edges.push_back({t[k], t[(k + 1) % 3]});
  return open_edges(std::move(edges));
}

}  // namespace quoin::grid
