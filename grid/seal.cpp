#include "grid/seal.h"

#include <algorithm>
#include <queue>
#include <set>
#include <tuple>
#include <utility>

namespace quoin::grid {

using exact::GridPoint;

namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// At most 3 * 2^60.
std::int64_t squared_distance(const GridPoint& p, const GridPoint& q) {
  std::int64_t sum = 0;
  for (int k = 0; k < 3; ++k) {
    const std::int64_t d = std::int64_t{p[k]} - q[k];
    sum += d * d;
  }
  return sum;
}

class Sealer {
 public:
  Sealer(const std::vector<GridPoint>& points, std::vector<Triangle>& triangles,
         const std::vector<std::uint32_t>& slivers)
      : points_(points), triangles_(triangles), near_(points.size()) {
    for (std::uint32_t t : slivers)
      for (std::uint32_t v : triangles[t]) near_[v] = 1;
    for (std::uint32_t t = 0; t < triangles.size(); ++t) enter_edges(t);
    for (std::uint32_t t : slivers) push(t);
  }

  bool run() {
    bool sealed = true;
    while (sealed && !longest_.empty()) {
      const auto [length, complement] = longest_.top();
      longest_.pop();
      const std::uint32_t t = ~complement;
      const Triangle& r = triangles_[t];
      // A triangle that was replaced meanwhile is gone or shorter.
      if (!is_dead(r) && long_edge(r).first == length) sealed = remove(t);
    }
    triangles_.erase(std::remove_if(triangles_.begin(), triangles_.end(), is_dead), triangles_.end());
    return sealed;
  }

 private:
  static bool is_dead(const Triangle& r) { return r[0] == r[1]; }

  /// Its squared length, and the corner opposite to it.
  std::pair<std::int64_t, std::size_t> long_edge(const Triangle& r) const {
    std::pair<std::int64_t, std::size_t> best{-1, 0};
    for (std::size_t k = 0; k < 3; ++k)
      best = std::max(best, {squared_distance(points_[r[(k + 1) % 3]], points_[r[(k + 2) % 3]]), k});
    return best;
  }

  /// Long edges join corners of slivers, and what replaces a neighbour brings no others: only edges between such
  /// corners are ever asked for.
  void enter_edges(std::uint32_t t) {
    const Triangle& r = triangles_[t];
    for (std::size_t k = 0; k < 3; ++k)
      if (near_[r[k]] != 0 && near_[r[(k + 1) % 3]] != 0) edges_.insert({r[k], r[(k + 1) % 3], t});
  }
  void erase_edges(std::uint32_t t) {
    const Triangle& r = triangles_[t];
    for (std::size_t k = 0; k < 3; ++k) edges_.erase({r[k], r[(k + 1) % 3], t});
  }
  void push(std::uint32_t t) { longest_.push({long_edge(triangles_[t]).first, ~t}); }

  void enter(std::uint32_t t) {
    const Triangle& r = triangles_[t];
    enter_edges(t);
    if (collinear(points_[r[0]], points_[r[1]], points_[r[2]])) push(t);
  }

  /// Ends, because a neighbour that is a sliver itself has the same long edge (longer ones went before it) and leaves
  /// only shorter ones.
  bool remove(std::uint32_t t) {
    const Triangle r = triangles_[t];
    const std::size_t middle = long_edge(r).second;
    const std::uint32_t m = r[middle], b = r[(middle + 1) % 3], a = r[(middle + 2) % 3];
    const auto found = edges_.lower_bound({a, b, 0});
    if (found == edges_.end() || std::get<0>(*found) != a || std::get<1>(*found) != b) return false;
    const std::uint32_t s = std::get<2>(*found);
    std::uint32_t c = 0;
    for (std::uint32_t v : triangles_[s])
      if (v != a && v != b) c = v;
    erase_edges(t);
    erase_edges(s);
    triangles_[t] = {0, 0, 0};
    if (c == m) {
      triangles_[s] = {0, 0, 0};
      return true;
    }
    triangles_[s] = {a, m, c};
    enter(s);
    triangles_.push_back({m, b, c});
    enter(static_cast<std::uint32_t>(triangles_.size() - 1));
    return true;
  }

  const std::vector<GridPoint>& points_;
  std::vector<Triangle>& triangles_;
  std::vector<std::uint8_t> near_;
  std::set<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> edges_;
  // Squared length and ~index: among equals the first triangle comes first.
  std::priority_queue<std::pair<std::int64_t, std::uint32_t>> longest_;
};

}  // namespace

bool collinear(const GridPoint& p, const GridPoint& q, const GridPoint& r) {
  // Differences are at most 2^30, products at most 2^60.
  const std::int64_t ex = std::int64_t{q[0]} - p[0], ey = std::int64_t{q[1]} - p[1], ez = std::int64_t{q[2]} - p[2];
  const std::int64_t fx = std::int64_t{r[0]} - p[0], fy = std::int64_t{r[1]} - p[1], fz = std::int64_t{r[2]} - p[2];
  return ey * fz == ez * fy && ez * fx == ex * fz && ex * fy == ey * fx;
}

bool seal(const std::vector<GridPoint>& points, std::vector<Triangle>& triangles,
          const std::vector<std::uint32_t>& slivers) {
  return slivers.empty() || Sealer(points, triangles, slivers).run();
}

}  // namespace quoin::grid
