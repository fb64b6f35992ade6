/// \file
/// Grid points in a box.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>

#include "grid/repair/median_tree.h"

namespace quoin::grid {

class NearPoints {
 public:
  using Corner = std::array<std::int64_t, 3>;

  /// The points `members` (indices into `points`, which must outlive it).
  NearPoints(std::span<const exact::GridPoint> points, Array<std::uint32_t> members)
      : points_(points), tree_(std::move(members), [points](std::uint32_t i) {
          return MedianTree::Box{points[i], points[i]};
        }) {}

  /// visit(point) for each in the closed box.
  template <class Visit>
  void in_box(const Corner& low, const Corner& high, Visit&& visit) const {
    const auto meets = [&](const MedianTree::Box& box) {
      for (std::size_t k = 0; k < 3; ++k)
        if (box.high.c[k] < low[k] || box.low.c[k] > high[k]) return false;
      return true;
    };
    tree_.search(meets, [&](std::uint32_t i) {
      if (meets({points_[i], points_[i]})) visit(i);
    });
  }

 private:
  std::span<const exact::GridPoint> points_;
  MedianTree tree_;
};

}  // namespace quoin::grid
