#include <algorithm>
#include <numeric>

#include "grid/repair/cures.h"
#include "grid/repair/median_tree.h"
#include "grid/shells.h"

namespace quoin::grid {

using exact::GridPoint;
using exact::int128;
using Triangle = Surface::Triangle;

namespace {

/// Three times a coordinate, so that centroids are whole.
using Tripled = std::array<std::int64_t, 3>;

Tripled tripled(const GridPoint& p) { return {3 * std::int64_t{p[0]}, 3 * std::int64_t{p[1]}, 3 * std::int64_t{p[2]}}; }

/// Rays that run along x, among triangles.
class Rays {
 public:
  explicit Rays(const Surface& surface)
      : surface_(surface),
        tree_(
            all(surface), [this](std::uint32_t t) { return box(t); }, 1) {}

  /// visit(triangle) for each that the ray from `start` to greater x crosses; of triangles that share what the ray
  /// meets exactly one counts, as if it ran a little higher in z, and less in y.
  template <class Visit>
  void cross(const Tripled& start, Visit&& visit) const {
    const auto is_in_way = [&](const MedianTree::Box& box) {
      const Tripled low = tripled(box.low), high = tripled(box.high);
      return high[0] >= start[0] && high[1] >= start[1] && low[1] <= start[1] && high[2] >= start[2] &&
             low[2] <= start[2];
    };
    tree_.search(is_in_way, [&](std::uint32_t t) {
      if (crosses(t, start)) visit(t);
    });
  }

 private:
  static Array<std::uint32_t> all(const Surface& surface) {
    Array<std::uint32_t> members(surface.triangles.size());
    std::iota(members.begin(), members.end(), 0u);
    return members;
  }

  const GridPoint& corner(std::uint32_t t, std::size_t k) const { return surface_.points[surface_.triangles[t][k]]; }

  MedianTree::Box box(std::uint32_t t) const {
    MedianTree::Box box{corner(t, 0), corner(t, 0)};
    for (std::size_t c = 1; c < 3; ++c)
      for (std::size_t k = 0; k < 3; ++k) {
        box.low.c[k] = std::min(box.low.c[k], corner(t, c).c[k]);
        box.high.c[k] = std::max(box.high.c[k], corner(t, c).c[k]);
      }
    return box;
  }

  /// By half-open edges in y and z; then by the side of the triangle's plane, which the line crosses.
  bool crosses(std::uint32_t t, const Tripled& start) const {
    std::array<std::array<std::int64_t, 3>, 3> v{};  // from the start
    for (std::size_t c = 0; c < 3; ++c) {
      const Tripled p = tripled(corner(t, c));
      for (std::size_t k = 0; k < 3; ++k) v[c][k] = p[k] - start[k];
    }

    bool inside = false;
    for (std::size_t c = 0; c < 3; ++c) {
      const auto &a = v[c], &b = v[(c + 1) % 3];
      if ((a[2] > 0) == (b[2] > 0)) continue;
      // The edge meets the line z = 0 at a y greater than 0 where this has the sign of b_z - a_z.
      const int128 area = int128(a[1]) * b[2] - int128(b[1]) * a[2];
      if ((area > 0) == (b[2] > a[2]) && area != 0) inside = !inside;
    }
    if (!inside) return false;

    // x at y = z = 0 has the sign of the determinant over that of the normal's x.
    const auto minor = [&](std::size_t c, std::size_t d) {
      return int128(v[c][1]) * v[d][2] - int128(v[c][2]) * v[d][1];
    };
    const int128 determinant = v[0][0] * minor(1, 2) + v[1][0] * minor(2, 0) + v[2][0] * minor(0, 1);
    const int128 normal_x = minor(0, 1) + minor(1, 2) + minor(2, 0);
    return determinant != 0 && (determinant > 0) == (normal_x > 0);
  }

  const Surface& surface_;
  MedianTree tree_;
};

/// For each shell the others that it lies in, ascending: those that a ray from the middle of its first triangle
/// crosses oddly often. Of shells that cross each other this is as that triangle lies.
Array<Array<std::uint32_t>> surrounding_shells(const Surface& surface, const Shells& shells) {
  const Rays rays(surface);
  Array<Array<std::uint32_t>> result(shells.six_volumes.size());
  for (std::uint32_t t = 0, next = 0; t < surface.triangles.size(); ++t) {
    const std::uint32_t shell = shells.of_triangle[t];
    if (shell != next) continue;  // shells are numbered in the order of their first triangles
    ++next;

    Tripled middle{};
    for (const std::uint32_t v : surface.triangles[t])
      for (int k = 0; k < 3; ++k) middle[static_cast<std::size_t>(k)] += surface.points[v][k];
    Array<std::uint32_t> crossed;
    rays.cross(middle, [&](std::uint32_t hit) {
      if (shells.of_triangle[hit] != shell) crossed.push_back(shells.of_triangle[hit]);
    });
    std::sort(crossed.begin(), crossed.end());
    for (std::size_t i = 0, j = 0; i < crossed.size(); i = j) {
      while (j < crossed.size() && crossed[j] == crossed[i]) ++j;
      if ((j - i) % 2 == 1) result[shell].push_back(crossed[i]);
    }
  }
  return result;
}

}  // namespace

Damage turn_shells(Surface& surface, Turning turning) {
  Damage damage{Defect::inside_out};
  const Shells all = shells(surface.points, surface.triangles);
  const auto looks_inwards = [&](std::uint32_t shell) { return all.six_volumes[shell] < 0; };
  const std::size_t count = all.six_volumes.size();
  Array<Array<std::uint32_t>> around;
  const bool all_out = count > 0 && !std::any_of(all.six_volumes.begin(), all.six_volumes.end(),
                                                 [](const auto& volume) { return volume < 0; });
  if (turning == Turning::solid || (turning == Turning::inside_out && all_out))
    around.resize(count);
  else
    around = surrounding_shells(surface, all);

  // Outer shells first: what lies directly in one that turns may turn with it.
  Array<std::uint32_t> order(count);
  for (std::uint32_t s = 0; s < count; ++s) order[s] = s;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t s, std::uint32_t t) { return around[s].size() < around[t].size(); });
  Array<std::uint8_t> turns(count);
  for (const std::uint32_t s : order) {
    const bool is_void = around[s].size() % 2 == 1;
    if (turning == Turning::inside_out && is_void) {
      const auto parent = std::max_element(around[s].begin(), around[s].end(), [&](std::uint32_t a, std::uint32_t b) {
        return around[a].size() < around[b].size();
      });
      turns[s] = turns[*parent] != 0 && !looks_inwards(s) ? 1 : 0;
    } else {
      turns[s] = looks_inwards(s) != is_void ? 1 : 0;
    }
  }

  std::uint32_t next = 0;
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
    const std::uint32_t shell = all.of_triangle[t];
    const bool is_first = shell == next;  // shells are numbered in the order of their first triangles
    if (is_first) ++next;
    if (turns[shell] == 0) continue;
    if (is_first) damage.add(0, surface.points[surface.triangles[t][0]]);
    std::swap(surface.triangles[t][1], surface.triangles[t][2]);
  }
  return damage;
}

}  // namespace quoin::grid
