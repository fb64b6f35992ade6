/// \file
/// A box tree over grid points that visits those in a box.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>

#include "exact/geometry.h"
#include "grid/lists/array.h"

namespace quoin::grid {

class NearPoints {
 public:
  using Corner = std::array<std::int64_t, 3>;

  /// Over the points `members` (indices into `points`, which must outlive the tree).
  NearPoints(std::span<const exact::GridPoint> points, Array<std::uint32_t> members)
      : points_(points), members_(std::move(members)) {
    if (!members_.empty()) build(0, static_cast<std::uint32_t>(members_.size()));
  }

  /// visit(point) for each in the closed box.
  template <class Visit>
  void in_box(const Corner& low, const Corner& high, Visit&& visit) const {
    if (nodes_.empty()) return;
    std::array<std::uint32_t, 70> stack{};  // the tree halves at each level
    std::size_t depth = 1;

    while (depth > 0) {
      const Node& node = nodes_[stack[--depth]];
      if (is_apart(node, low, high)) continue;
      if (node.left != 0) {
        stack[depth++] = node.right;
        stack[depth++] = node.left;
        continue;
      }
      for (std::uint32_t i = node.begin; i < node.end; ++i)
        if (holds(low, high, points_[members_[i]])) visit(members_[i]);
    }
  }

 private:
  struct Node {
    exact::GridPoint low, high;
    std::uint32_t begin, end, left, right;  // left = 0 in a leaf
  };
  static constexpr std::uint32_t leaf_size = 8;

  std::uint32_t build(std::uint32_t begin, std::uint32_t end) {
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    Node node{points_[members_[begin]], points_[members_[begin]], begin, end, 0, 0};
    for (std::uint32_t i = begin; i < end; ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        node.low.c[k] = std::min(node.low.c[k], points_[members_[i]].c[k]);
        node.high.c[k] = std::max(node.high.c[k], points_[members_[i]].c[k]);
      }
    nodes_.push_back(node);
    if (end - begin <= leaf_size) return index;

    std::array<std::int64_t, 3> sides{};
    for (std::size_t k = 0; k < 3; ++k) sides[k] = std::int64_t{node.high.c[k]} - node.low.c[k];
    const auto axis = static_cast<std::size_t>(std::max_element(sides.begin(), sides.end()) - sides.begin());
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(members_.begin() + begin, members_.begin() + middle, members_.begin() + end,
                     [&](std::uint32_t i, std::uint32_t j) {
                       const std::int32_t a = points_[i].c[axis], b = points_[j].c[axis];
                       return a != b ? a < b : i < j;
                     });

    const std::uint32_t left = build(begin, middle), right = build(middle, end);
    nodes_[index].left = left;
    nodes_[index].right = right;
    return index;
  }

  static bool is_apart(const Node& node, const Corner& low, const Corner& high) {
    for (std::size_t k = 0; k < 3; ++k)
      if (node.high.c[k] < low[k] || node.low.c[k] > high[k]) return true;
    return false;
  }
  static bool holds(const Corner& low, const Corner& high, const exact::GridPoint& p) {
    for (std::size_t k = 0; k < 3; ++k)
      if (p.c[k] < low[k] || p.c[k] > high[k]) return false;
    return true;
  }

  std::span<const exact::GridPoint> points_;
  Array<std::uint32_t> members_;
  Array<Node> nodes_;
};

}  // namespace quoin::grid
