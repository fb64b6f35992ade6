#include "grid/cut.h"

#include <cassert>
#include <numeric>

#include "grid/lists/loops.h"
#include "grid/seal.h"

namespace quoin::grid {

using exact::GridPoint;
using exact::int128;

namespace {

using Triangle = std::array<std::uint32_t, 3>;
using AreaVector = std::array<int128, 3>;

std::array<std::int64_t, 3> difference(const GridPoint& p, const GridPoint& q) {
  return {std::int64_t{p[0]} - q[0], std::int64_t{p[1]} - q[1], std::int64_t{p[2]} - q[2]};
}

/// Each component is at most 2^61.
void add_cross(AreaVector& sum, const std::array<std::int64_t, 3>& e, const std::array<std::int64_t, 3>& f) {
  sum[0] += e[1] * f[2] - e[2] * f[1];
  sum[1] += e[2] * f[0] - e[0] * f[2];
  sum[2] += e[0] * f[1] - e[1] * f[0];
}

/// Whether all corners lie on the plane through the first with this normal: below 3 * 2^(61 + 32 + 30) fits 128 bits.
bool on_plane(const Array<GridPoint>& points, std::span<const std::uint32_t> corners, const AreaVector& normal) {
  for (std::uint32_t v : corners) {
    const auto d = difference(points[v], points[corners[0]]);
    if (normal[0] * d[0] + normal[1] * d[1] + normal[2] * d[2] != 0) return false;
  }
  return true;
}

/// The polygon whose area vector is zero.
bool is_planar_without_area(const Array<GridPoint>& points, std::span<const std::uint32_t> corners) {
  const GridPoint &p = points[corners[0]], &q = points[corners[1]];
  for (std::uint32_t v : corners) {
    if (collinear(p, q, points[v])) continue;
    AreaVector normal{};
    add_cross(normal, difference(q, p), difference(points[v], p));
    return on_plane(points, corners, normal);
  }
  return true;
}

int direction(const FlatPoint& p, const FlatPoint& q) { return p < q ? 1 : -1; }

template <class Corner>
void fan(std::size_t count, Corner corner, Array<Triangle>& triangles) {
  for (std::size_t i = 2; i < count; ++i) triangles.push_back({corner(0), corner(i - 1), corner(i)});
}

}  // namespace

bool Cutter::cut(std::span<const std::uint32_t> corners, Array<Triangle>& triangles) {
  assert(corners.size() >= 3);
  const bool planar = project(corners);
  if (flat_ || strictly_convex())
    fan(
        corners.size(), [&](std::size_t i) { return corners[i]; }, triangles);
  else
    clip_ears(corners, triangles);
  return planar;
}

/// Fills flat_points_, so that the polygon's area is positive, or sets flat_; returns whether the polygon is planar.
bool Cutter::project(std::span<const std::uint32_t> corners) {
  const GridPoint& p = points_[corners[0]];
  AreaVector normal{};
  for (std::size_t i = 2; i < corners.size(); ++i)
    add_cross(normal, difference(points_[corners[i - 1]], p), difference(points_[corners[i]], p));
  flat_ = normal == AreaVector{};
  if (flat_) return is_planar_without_area(points_, corners);

  const std::size_t axis = exact::longest_component(normal);
  std::size_t first = (axis + 1) % 3, second = (axis + 2) % 3;
  if (normal[axis] < 0) std::swap(first, second);
  flat_points_.clear();
  for (std::uint32_t v : corners) flat_points_.push_back({points_[v].c[first], points_[v].c[second]});
  return on_plane(points_, corners, normal);
}

/// Every turn is to the left, and the edges' directions go around once: they change between up and down twice.
bool Cutter::strictly_convex() const {
  const std::size_t n = flat_points_.size();
  int changes = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = next_in_loop(i, n);
    const FlatPoint &p = flat_points_[i], &q = flat_points_[j], &r = flat_points_[next_in_loop(j, n)];
    if (area(p, q, r) <= 0) return false;
    if (direction(p, q) != direction(q, r)) ++changes;
  }
  return changes == 2;
}

/// A corner with a turn to the left whose closed triangle holds no other corner. If it holds one, it holds one without
/// a turn to the left: the one nearest to the ear's tip. A corner at the same place as one of the ear's does not count:
/// bridges to holes run there and back.
bool Cutter::is_ear(std::span<const std::uint32_t> corners, std::uint32_t i) const {
  const std::uint32_t u = previous_[i], w = next_[i];
  const std::array<FlatPoint, 3> triangle{flat_points_[u], flat_points_[i], flat_points_[w]};
  if (area(triangle[0], triangle[1], triangle[2]) <= 0) return false;
  return !blockers_.any_in(triangle, [&](std::uint32_t x) {
    return corners[x] != corners[u] && corners[x] != corners[i] && corners[x] != corners[w];
  });
}

/// An ear can only appear next to one that was cut off, so each cut asks for two corners again. A polygon that is not
/// simple may need all of them to be asked again, or have none: then a fan is as good as anything.
void Cutter::clip_ears(std::span<const std::uint32_t> corners, Array<Triangle>& triangles) {
  const auto n = static_cast<std::uint32_t>(corners.size());
  previous_.resize(n);
  next_.resize(n);
  Array<std::uint32_t> members;
  for (std::uint32_t i = 0; i < n; ++i) {
    previous_[i] = previous_in_loop(i, n);
    next_[i] = next_in_loop(i, n);
    if (area(flat_points_[previous_[i]], flat_points_[i], flat_points_[next_[i]]) <= 0) members.push_back(i);
  }
  blockers_.build(flat_points_, std::move(members));

  queue_.resize(n);
  std::iota(queue_.begin(), queue_.end(), 0U);
  waiting_.assign(n, 1);  // 2 once cut off
  std::uint32_t left = n, some = 0;
  const auto ask = [&](std::uint32_t i) {
    if (waiting_[i] != 0) return;
    waiting_[i] = 1;
    queue_.push_back(i);
  };

  constexpr int rounds = 4;
  for (int round = 0; round < rounds && left > 3; ++round) {
    const std::uint32_t before = left;
    for (std::size_t head = 0; head < queue_.size() && left > 3; ++head) {
      const std::uint32_t i = queue_[head];
      if (waiting_[i] == 2) continue;
      waiting_[i] = 0;
      if (!is_ear(corners, i)) continue;

      const std::uint32_t u = previous_[i], w = next_[i];
      triangles.push_back({corners[u], corners[i], corners[w]});
      next_[u] = w;
      previous_[w] = u;
      waiting_[i] = 2;
      blockers_.remove(i);
      --left;
      some = w;
      ask(u);
      ask(w);
    }
    if (left == before) break;
    queue_.clear();
    for (std::uint32_t i = 0, at = some; i < left; ++i, at = next_[at]) ask(at);
  }

  queue_.clear();
  for (std::uint32_t i = 0, at = some; i < left; ++i, at = next_[at]) queue_.push_back(at);
  fan(
      left, [&](std::size_t i) { return corners[queue_[i]]; }, triangles);
}

}  // namespace quoin::grid
