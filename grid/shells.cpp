#include "grid/shells.h"

#include <algorithm>
#include <cassert>
#include <tuple>

#include "grid/lists/partition.h"
#include "grid/lists/stretches.h"

namespace quoin::grid {

using exact::GridPoint;
using exact::int128;

namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// One triangle at one edge.
struct EdgeUse {
  std::uint32_t low, high, triangle;
  std::int32_t way;  // 1 from low to high, -1 back

  bool shares_edge(const EdgeUse& other) const { return low == other.low && high == other.high; }
  friend bool operator<(const EdgeUse& a, const EdgeUse& b) {
    return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
  }
};

/// All of them, edge by edge.
Array<EdgeUse> edge_uses(std::span<const Triangle> triangles) {
  Array<EdgeUse> uses;
  uses.reserve(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = triangles[t][k], b = triangles[t][(k + 1) % 3];
      uses.push_back({std::min(a, b), std::max(a, b), t, a < b ? 1 : -1});
    }

  sort_side_by_side(uses.begin(), uses.end());
  return uses;
}

/// Unites parts that are open along one edge, in pairs of one that runs forward and one that runs back, both in the
/// order of their first triangles: of two bodies that are one behind the other in the list each is paired with itself.
/// What was closed along an edge stays so.
void unite_open_parts(std::span<const EdgeUse> edge, Partition& parts) {
  Array<std::pair<std::uint32_t, std::int32_t>> ways;
  for (const EdgeUse& use : edge) ways.emplace_back(parts.find(use.triangle), use.way);
  std::sort(ways.begin(), ways.end());

  Array<std::uint32_t> forward, backward;  // a part as often as it is missing its reverse
  for (std::size_t i = 0, j = 0; i < ways.size(); i = j) {
    std::int32_t sum = 0;
    for (; j < ways.size() && ways[j].first == ways[i].first; ++j) sum += ways[j].second;
    forward.insert(forward.end(), static_cast<std::size_t>(std::max(sum, 0)), ways[i].first);
    backward.insert(backward.end(), static_cast<std::size_t>(std::max(-sum, 0)), ways[i].first);
  }

  assert(forward.size() == backward.size());
  for (std::size_t i = 0; i < forward.size(); ++i) parts.unite(forward[i], backward[i]);
}

/// visit(uses) for every edge.
template <class Visit>
void for_edges(const Array<EdgeUse>& uses, Visit&& visit) {
  for (std::size_t i = 0, j = 0; i < uses.size(); i = j) {
    while (j < uses.size() && uses[j].shares_edge(uses[i])) ++j;
    visit(std::span(uses).subspan(i, j - i));
  }
}

Partition closed_parts(std::span<const Triangle> triangles, bool& has_crowded_edges) {
  const Array<EdgeUse> uses = edge_uses(triangles);
  Partition parts(triangles.size());

  for_edges(uses, [&](std::span<const EdgeUse> edge) {
    assert(edge.size() % 2 == 0);
    if (edge.size() == 2) parts.unite(edge[0].triangle, edge[1].triangle);
  });

  // Only now is known what hangs together anyway.
  for_edges(uses, [&](std::span<const EdgeUse> edge) {
    if (edge.size() == 2) return;
    has_crowded_edges = true;
    unite_open_parts(edge, parts);
  });
  return parts;
}

/// Six times the volume of the tetrahedron from the origin, at most 6 * 2^87: 2^32 of them fit.
int128 six_volumes(const GridPoint& p, const GridPoint& q, const GridPoint& r) {
  const auto minor = [&](int i, int j) { return std::int64_t{q[i]} * r[j] - std::int64_t{q[j]} * r[i]; };
  return int128(p[0]) * minor(1, 2) + int128(p[1]) * minor(2, 0) + int128(p[2]) * minor(0, 1);
}

}  // namespace

Shells shells(std::span<const GridPoint> points, std::span<const Triangle> triangles) {
  Shells result;
  Partition parts = closed_parts(triangles, result.has_crowded_edges);
  result.of_triangle.resize(triangles.size());

  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const std::uint32_t first = parts.find(t);  // the smallest of its part
    if (first == t) {
      result.of_triangle[t] = static_cast<std::uint32_t>(result.six_volumes.size());
      result.six_volumes.push_back(0);
    } else {
      result.of_triangle[t] = result.of_triangle[first];
    }
    const auto [a, b, c] = triangles[t];
    result.six_volumes[result.of_triangle[t]] += six_volumes(points[a], points[b], points[c]);
  }
  return result;
}

GridPoint lowest_corner(const Shells& shells, std::uint32_t shell, std::span<const GridPoint> points,
                        std::span<const Triangle> triangles) {
  GridPoint lowest{{INT32_MAX, INT32_MAX, INT32_MAX}};
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (shells.of_triangle[t] == shell)
      for (const std::uint32_t v : triangles[t]) lowest = std::min(lowest, points[v]);
  return lowest;
}

}  // namespace quoin::grid
