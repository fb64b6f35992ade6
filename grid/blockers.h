/// \file
/// A box tree over points of a plane that answers whether a closed triangle holds one of them.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "exact/geometry.h"
#include "grid/lists/array.h"

namespace quoin::grid {

/// A grid point seen along a coordinate axis.
using FlatPoint = std::array<std::int32_t, 2>;

/// Twice the signed area of (p, q, r), positive when counter-clockwise; at most 2^61.
inline std::int64_t area(const FlatPoint& p, const FlatPoint& q, const FlatPoint& r) {
  return (std::int64_t{q[0]} - p[0]) * (std::int64_t{r[1]} - p[1]) -
         (std::int64_t{q[1]} - p[1]) * (std::int64_t{r[0]} - p[0]);
}

class Blockers {
 public:
  /// The tree over the points `members` (indices into `points`, which must outlive the tree).
  void build(const Array<FlatPoint>& points, Array<std::uint32_t> members) {
    points_ = points.data();
    members_ = std::move(members);
    place_.assign(points.size(), absent);
    nodes_.clear();
    if (!members_.empty()) build_node(0, static_cast<std::uint32_t>(members_.size()));
    for (std::uint32_t i = 0; i < members_.size(); ++i) place_[members_[i]] = i;
  }

  void remove(std::uint32_t point) {
    const std::uint32_t place = place_[point];
    if (place == absent) return;
    place_[point] = absent;
    for (std::uint32_t n = 0;;) {
      --nodes_[n].count;
      if (nodes_[n].left == 0) return;
      n = place < nodes_[nodes_[n].left].end ? nodes_[n].left : nodes_[n].right;
    }
  }

  /// Whether the closed counter-clockwise triangle holds a point that `counts`.
  template <class Predicate>
  bool any_in(const std::array<FlatPoint, 3>& triangle, Predicate counts) const {
    if (nodes_.empty()) return false;
    std::array<std::uint32_t, 70> stack{};  // the tree halves at each level
    std::size_t depth = 1;

    while (depth > 0) {
      const Node& node = nodes_[stack[--depth]];
      if (node.count == 0 || is_apart(node, triangle)) continue;
      if (node.left != 0) {
        stack[depth++] = node.right;
        stack[depth++] = node.left;
        continue;
      }
      for (std::uint32_t i = node.begin; i < node.end; ++i)
        if (place_[members_[i]] != absent && holds(triangle, points_[members_[i]]) && counts(members_[i])) return true;
    }
    return false;
  }

 private:
  struct Node {
    FlatPoint low, high;
    std::uint32_t begin, end, left, right, count;  // left = 0 in a leaf
  };
  static constexpr std::uint32_t absent = UINT32_MAX, leaf_size = 12;

  std::uint32_t build_node(std::uint32_t begin, std::uint32_t end) {
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    Node node{points_[members_[begin]], points_[members_[begin]], begin, end, 0, 0, end - begin};
    for (std::uint32_t i = begin; i < end; ++i)
      for (std::size_t k = 0; k < 2; ++k) {
        node.low[k] = std::min(node.low[k], points_[members_[i]][k]);
        node.high[k] = std::max(node.high[k], points_[members_[i]][k]);
      }
    nodes_.push_back(node);
    if (end - begin <= leaf_size) return index;

    const std::size_t k = exact::longest_component(
        std::array{std::int64_t{node.high[0]} - node.low[0], std::int64_t{node.high[1]} - node.low[1]});
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(members_.begin() + begin, members_.begin() + middle, members_.begin() + end,
                     [&](std::uint32_t i, std::uint32_t j) {
                       return points_[i][k] != points_[j][k] ? points_[i][k] < points_[j][k] : i < j;
                     });

    const std::uint32_t left = build_node(begin, middle), right = build_node(middle, end);
    nodes_[index].left = left;
    nodes_[index].right = right;
    return index;
  }

  static bool holds(const std::array<FlatPoint, 3>& t, const FlatPoint& p) {
    return area(t[0], t[1], p) >= 0 && area(t[1], t[2], p) >= 0 && area(t[2], t[0], p) >= 0;
  }
  /// Whether one side of the triangle has the whole box on its right.
  static bool is_apart(const Node& box, const std::array<FlatPoint, 3>& t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const FlatPoint &a = t[i], &b = t[(i + 1) % 3];
      const FlatPoint leftmost{b[1] > a[1] ? box.low[0] : box.high[0], b[0] > a[0] ? box.high[1] : box.low[1]};
      if (area(a, b, leftmost) < 0) return true;
    }
    return false;
  }

  const FlatPoint* points_ = nullptr;
  Array<std::uint32_t> members_, place_;
  Array<Node> nodes_;
};

}  // namespace quoin::grid
