/// \file
/// Closed integer boxes and the search for pairs of boxes that meet.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "booleans/body.h"

namespace quoin::booleans {

/// A closed box, grid steps; boxes of derived points are rounded outward. Touching boxes meet.
struct Box {
  std::array<std::int32_t, 3> low{INT32_MAX, INT32_MAX, INT32_MAX};
  std::array<std::int32_t, 3> high{INT32_MIN, INT32_MIN, INT32_MIN};

  void add(const std::array<double, 3>& p) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], static_cast<std::int32_t>(std::floor(p[k])));
      high[k] = std::max(high[k], static_cast<std::int32_t>(std::ceil(p[k])));
    }
  }
  void add(const exact::GridPoint& p) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], p.c[k]);
      high[k] = std::max(high[k], p.c[k]);
    }
  }
  void add(const Box& b) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], b.low[k]);
      high[k] = std::max(high[k], b.high[k]);
    }
  }
  bool meets(const Box& b) const {
    return low[0] <= b.high[0] && b.low[0] <= high[0] && low[1] <= b.high[1] && b.low[1] <= high[1] &&
           low[2] <= b.high[2] && b.low[2] <= high[2];
  }
};

Box face_box(const Body& body, std::uint32_t face);

/// A static box hierarchy: items in Morton order of their centres, in buckets, under an implicit binary tree.
/// Every item carries a group; pairs within one group are skipped on request. Visiting order is deterministic.
class BoxTree {
 public:
  struct Item {
    Box box;
    std::uint32_t id;
    std::uint32_t group;
  };

  explicit BoxTree(std::vector<Item> items);

  /// visit(id, id') for every pair of items whose boxes meet, each pair once; pairs of one group only if wanted.
  template <class Visit>
  void pairs(bool within_groups, Visit&& visit) const {
    if (!levels_.empty()) self(levels_.size() - 1, 0, within_groups, visit);
  }

  /// visit(id) for every item whose box meets the given one, which the visitor may shrink; boxes that reach further up
  /// in y come first.
  template <class Visit>
  void meeting(const Box& box, Visit&& visit) const {
    if (!levels_.empty()) descend(levels_.size() - 1, 0, box, visit);
  }

 private:
  static constexpr std::size_t bucket = 4;
  static constexpr std::uint32_t mixed = none;
  struct Node {
    Box box;
    std::uint32_t group;
  };

  std::size_t width(std::size_t level) const { return levels_[level].size(); }
  std::span<const Item> leaf(std::size_t i) const {
    return std::span(items_).subspan(i * bucket, std::min(bucket, items_.size() - i * bucket));
  }

  template <class Visit>
  void self(std::size_t level, std::size_t i, bool within, Visit& visit) const {
    if (!within && levels_[level][i].group != mixed) return;
    if (level == 0) {
      const auto items = leaf(i);
      for (std::size_t a = 0; a < items.size(); ++a)
        for (std::size_t b = a + 1; b < items.size(); ++b) test(items[a], items[b], within, visit);
      return;
    }
    const std::size_t l = 2 * i, r = 2 * i + 1;
    self(level - 1, l, within, visit);
    if (r >= width(level - 1)) return;
    self(level - 1, r, within, visit);
    cross(level - 1, l, r, within, visit);
  }

  template <class Visit>
  void cross(std::size_t level, std::size_t a, std::size_t b, bool within, Visit& visit) const {
    const Node &na = levels_[level][a], &nb = levels_[level][b];
    if (!na.box.meets(nb.box) || (!within && na.group != mixed && na.group == nb.group)) return;
    if (level == 0) {
      for (const Item& x : leaf(a))
        for (const Item& y : leaf(b)) test(x, y, within, visit);
      return;
    }
    for (std::size_t x = 2 * a; x < std::min(2 * a + 2, width(level - 1)); ++x)
      for (std::size_t y = 2 * b; y < std::min(2 * b + 2, width(level - 1)); ++y) cross(level - 1, x, y, within, visit);
  }

  template <class Visit>
  static void test(const Item& x, const Item& y, bool within, Visit& visit) {
    if ((within || x.group != y.group) && x.box.meets(y.box)) visit(x.id, y.id);
  }

  template <class Visit>
  void descend(std::size_t level, std::size_t i, const Box& box, Visit& visit) const {
    if (!levels_[level][i].box.meets(box)) return;
    if (level == 0) {
      for (const Item& x : leaf(i))
        if (x.box.meets(box)) visit(x.id);
      return;
    }
    const std::size_t l = 2 * i, r = 2 * i + 1;
    if (r == width(level - 1)) return descend(level - 1, l, box, visit);
    const bool right_first = levels_[level - 1][r].box.high[1] > levels_[level - 1][l].box.high[1];
    descend(level - 1, right_first ? r : l, box, visit);
    descend(level - 1, right_first ? l : r, box, visit);
  }

  std::vector<Item> items_;
  std::vector<std::vector<Node>> levels_;  // levels_[0] are the buckets
};

}  // namespace quoin::booleans
