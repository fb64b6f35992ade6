#include <algorithm>
#include <tuple>

#include "grid/repair/cures.h"

namespace quoin::grid {

using exact::GridPoint;
using exact::int128;
using Triangle = Surface::Triangle;

namespace {

/// Union-find of triangles that says of two members whether one is turned against the other. The root is the least.
class Turns {
 public:
  explicit Turns(std::size_t n) : parent_(n), turned_(n) {
    for (std::uint32_t i = 0; i < n; ++i) parent_[i] = i;
  }

  /// The root, and whether i is turned against it.
  std::pair<std::uint32_t, bool> find(std::uint32_t i) {
    std::uint32_t root = i;
    bool turned = false;
    for (; parent_[root] != root; root = parent_[root]) turned ^= turned_[root] != 0;

    // All on the way now hang at the root.
    for (bool rest = turned; parent_[i] != i && parent_[i] != root;) {
      const std::uint32_t next = parent_[i];
      const bool here = turned_[i] != 0;
      parent_[i] = root;
      turned_[i] = rest ? 1 : 0;
      rest ^= here;
      i = next;
    }
    return {root, turned};
  }

  /// False where they are united the other way.
  bool unite(std::uint32_t i, std::uint32_t j, bool against) {
    auto [a, turned_a] = find(i);
    auto [b, turned_b] = find(j);
    if (a == b) return (turned_a ^ turned_b) == against;
    if (a > b) std::swap(a, b);
    parent_[b] = a;
    turned_[b] = (turned_a ^ turned_b ^ against) ? 1 : 0;
    return true;
  }

 private:
  Array<std::uint32_t> parent_;
  Array<std::uint8_t> turned_;
};

/// The triangles at an edge, in their order around it.
Array<EdgeUse> around(const Surface& surface, std::span<const EdgeUse> edge) {
  const GridPoint& origin = surface.points[edge[0].low];
  const GridVector axis = between(origin, surface.points[edge[0].high]);
  const auto arm = [&](const EdgeUse& use) {
    return between(origin, surface.points[surface.triangles[use.triangle()][(use.half % 3 + 2) % 3]]);
  };
  // Half planes through the edge, by the normals that they turn from the first one's.
  const GridVector start = cross(axis, arm(edge[0]));
  const auto is_in_second_half = [&](const EdgeUse& use) {
    const int128 side = dot(start, arm(use));
    return side < 0 || (side == 0 && dot(start, cross(axis, arm(use))) < 0);
  };

  Array<EdgeUse> sorted(edge.begin(), edge.end());
  std::stable_sort(sorted.begin(), sorted.end(), [&](const EdgeUse& u, const EdgeUse& v) {
    const bool second_u = is_in_second_half(u), second_v = is_in_second_half(v);
    if (second_u != second_v) return second_v;
    return dot(cross(axis, arm(u)), arm(v)) > 0;
  });
  return sorted;
}

/// Whether each part that has triangles at an edge is closed along it by itself.
bool is_closed_by_parts(std::span<const EdgeUse> edge, Turns& turns) {
  Array<std::pair<std::uint32_t, std::int32_t>> ways;
  for (const EdgeUse& use : edge) {
    const auto [root, turned] = turns.find(use.triangle());
    ways.emplace_back(root, turned ? -use.way : use.way);
  }
  std::sort(ways.begin(), ways.end());
  for (std::size_t i = 0, j = 0; i < ways.size(); i = j) {
    std::int32_t sum = 0;
    for (; j < ways.size() && ways[j].first == ways[i].first; ++j) sum += ways[j].second;
    if (sum != 0) return false;
  }
  return true;
}

Turns agreement(const Surface& surface) {
  const Array<EdgeUse> uses = edge_uses(surface.triangles);
  Turns turns(surface.triangles.size());
  for_edges(uses, [&](std::span<const EdgeUse> edge) {
    if (edge.size() == 2) turns.unite(edge[0].triangle(), edge[1].triangle(), edge[0].way == edge[1].way);
  });

  // What is closed stays as it is; what is not takes turns around the edge.
  for_edges(uses, [&](std::span<const EdgeUse> edge) {
    if (edge.size() > 2 && excess(edge) == 0)
      for (const EdgeUse& use : edge) turns.unite(edge[0].triangle(), use.triangle(), false);
  });
  for_edges(uses, [&](std::span<const EdgeUse> edge) {
    if (edge.size() == 2 || edge.size() % 2 == 1 || excess(edge) == 0 || is_closed_by_parts(edge, turns)) return;
    const Array<EdgeUse> order = around(surface, edge);
    for (std::size_t i = 0; i + 1 < order.size(); ++i)
      turns.unite(order[i].triangle(), order[i + 1].triangle(), order[i].way == order[i + 1].way);
  });
  return turns;
}

}  // namespace

Damage orient_coherently(Surface& surface) {
  Damage damage{Defect::orientation};
  Turns turns = agreement(surface);
  const auto n = static_cast<std::uint32_t>(surface.triangles.size());
  Array<std::uint32_t> size(n), turned(n);
  for (std::uint32_t t = 0; t < n; ++t) {
    const auto [root, against] = turns.find(t);
    ++size[root];
    if (against) ++turned[root];
  }

  for (std::uint32_t t = 0; t < n; ++t) {
    const auto [root, against] = turns.find(t);
    const bool turns_root = 2 * turned[root] > size[root];
    if (against == turns_root) continue;
    damage.add(0, surface.points[surface.triangles[t][0]]);
    std::swap(surface.triangles[t][1], surface.triangles[t][2]);
  }
  return damage;
}

Damage disagreements(const Surface& surface) {
  Damage damage{Defect::orientation};
  damage.is_curable = false;
  for_edges(edge_uses(surface.triangles), [&](std::span<const EdgeUse> edge) {
    if (edge.size() % 2 == 0 && excess(edge) != 0) damage.add(0, surface.points[edge[0].low]);
  });
  return damage;
}

}  // namespace quoin::grid
