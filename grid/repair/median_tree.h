/// \file
/// A box tree over numbered things, halved at each level.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>

#include "exact/geometry.h"
#include "grid/lists/array.h"

namespace quoin::grid {

class MedianTree {
 public:
  struct Box {
    exact::GridPoint low, high;
  };

  /// Over the members, which are told apart along the axes from `first_axis` on. box_of(member) is asked many times.
  template <class BoxOf>
  MedianTree(Array<std::uint32_t> members, BoxOf&& box_of, std::size_t first_axis = 0) : members_(std::move(members)) {
    if (!members_.empty()) build(0, static_cast<std::uint32_t>(members_.size()), box_of, first_axis);
  }

  /// visit(member) for all below nodes whose boxes are wanted.
  template <class Wanted, class Visit>
  void search(Wanted&& wanted, Visit&& visit) const {
    if (nodes_.empty()) return;
    std::array<std::uint32_t, 70> stack{};  // the tree halves at each level
    std::size_t depth = 1;

    while (depth > 0) {
      const Node& node = nodes_[stack[--depth]];
      if (!wanted(node.box)) continue;
      if (node.left != 0) {
        stack[depth++] = node.right;
        stack[depth++] = node.left;
        continue;
      }
      for (std::uint32_t i = node.begin; i < node.end; ++i) visit(members_[i]);
    }
  }

 private:
  struct Node {
    Box box;
    std::uint32_t begin, end, left, right;  // left = 0 in a leaf
  };
  static constexpr std::uint32_t leaf_size = 8;

  template <class BoxOf>
  std::uint32_t build(std::uint32_t begin, std::uint32_t end, BoxOf& box_of, std::size_t first_axis) {
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    Box box = box_of(members_[begin]);
    for (std::uint32_t i = begin + 1; i < end; ++i) {
      const Box own = box_of(members_[i]);
      for (std::size_t k = 0; k < 3; ++k) {
        box.low.c[k] = std::min(box.low.c[k], own.low.c[k]);
        box.high.c[k] = std::max(box.high.c[k], own.high.c[k]);
      }
    }
    nodes_.push_back({box, begin, end, 0, 0});
    if (end - begin <= leaf_size) return index;

    const auto side = [&](std::size_t k) { return std::int64_t{box.high.c[k]} - box.low.c[k]; };
    std::size_t axis = first_axis;
    for (std::size_t k = first_axis + 1; k < 3; ++k)
      if (side(k) > side(axis)) axis = k;
    const auto key = [&](std::uint32_t member) {
      const Box own = box_of(member);
      return std::pair{std::int64_t{own.low.c[axis]} + own.high.c[axis], member};
    };
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(members_.begin() + begin, members_.begin() + middle, members_.begin() + end,
                     [&](std::uint32_t i, std::uint32_t j) { return key(i) < key(j); });

    const std::uint32_t left = build(begin, middle, box_of, first_axis), right = build(middle, end, box_of, first_axis);
    nodes_[index].left = left;
    nodes_[index].right = right;
    return index;
  }

  Array<std::uint32_t> members_;
  Array<Node> nodes_;
};

}  // namespace quoin::grid
