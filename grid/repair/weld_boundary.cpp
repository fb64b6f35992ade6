#include <algorithm>
#include <tuple>

#include "grid/repair/cures.h"
#include "grid/repair/near_points.h"

namespace quoin::grid {

using exact::GridPoint;
using exact::int128;

namespace {

/// Stars: the least vertex that belongs to none takes all near it that belong to none, the nearest first.
class Stars {
 public:
  Stars(const Surface& surface, const Reach& reach)
      : points_(surface.points),
        reach_(reach),
        boundary_(boundary_of(surface)),
        tree_(surface.points, boundary_.vertices),
        centre_(surface.points.size(), Boundary::absent) {}

  Damage find() {
    for (const std::uint32_t p : boundary_.vertices) {
      if (centre_[p] != Boundary::absent) continue;
      centre_[p] = p;
      for (const auto& [squared, q] : candidates(p)) {
        if (has_neighbour_in(q, p)) continue;
        centre_[q] = p;
        damage_.add(length_of(squared), points_[p]);
      }
    }
    return damage_;
  }

  std::uint32_t centre(std::uint32_t v) const { return centre_[v] == Boundary::absent ? v : centre_[v]; }

 private:
  Array<std::pair<int128, std::uint32_t>> candidates(std::uint32_t p) const {
    NearPoints::Corner low{}, high{};
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = points_[p].c[k] - reach_.radius();
      high[k] = points_[p].c[k] + reach_.radius();
    }

    Array<std::pair<int128, std::uint32_t>> found;
    tree_.in_box(low, high, [&](std::uint32_t q) {
      if (centre_[q] != Boundary::absent) return;
      const int128 squared = squared_distance(points_[p], points_[q]);
      if (reach_.holds(squared) && (!reach_.is_careful() || is_clear(squared, p, q))) found.emplace_back(squared, q);
    });
    std::sort(found.begin(), found.end());
    return found;
  }

  /// Whether a gap is clearly smaller than the edges at its ends.
  bool is_clear(int128 squared, std::uint32_t p, std::uint32_t q) const {
    return 64 * squared <= std::min(boundary_.shortest[boundary_.place[p]], boundary_.shortest[boundary_.place[q]]);
  }

  bool has_neighbour_in(std::uint32_t q, std::uint32_t centre) const {
    const std::uint32_t place = boundary_.place[q];
    for (std::uint32_t i = boundary_.starts[place]; i < boundary_.starts[place + 1]; ++i)
      if (centre_[boundary_.neighbours[i]] == centre) return true;
    return false;
  }

  const Array<GridPoint>& points_;
  const Reach& reach_;
  Boundary boundary_;
  NearPoints tree_;
  Array<std::uint32_t> centre_;
  Damage damage_{Defect::crack};
};

}  // namespace

Damage weld_boundary(Surface& surface, const Reach& reach) {
  Stars stars(surface, reach);
  const Damage damage = stars.find();
  for (auto& triangle : surface.triangles)
    for (std::uint32_t& v : triangle) v = stars.centre(v);
  return damage;
}

}  // namespace quoin::grid
