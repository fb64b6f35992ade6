/// \file
/// The search for pairs of boxes that meet.
#pragma once

#include <bit>
#include <span>
#include <vector>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include "booleans/body.h"

namespace quoin::booleans {

/// Eight boxes side by side, compared with one box at a time. Lanes that are not used meet nothing.
struct BoxBlock {
  static constexpr std::uint32_t width = 8;
  std::array<std::array<std::int32_t, width>, 3> low, high;

  BoxBlock() {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k].fill(INT32_MAX);
      high[k].fill(INT32_MIN);
    }
  }
  void set(std::uint32_t lane, const Box& b) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k][lane] = b.low[k];
      high[k][lane] = b.high[k];
    }
  }
  Box box(std::uint32_t lane) const {
    Box b;
    for (std::size_t k = 0; k < 3; ++k) {
      b.low[k] = low[k][lane];
      b.high[k] = high[k][lane];
    }
    return b;
  }
  /// Bit i: lane i meets the box.
  unsigned meeting(const Box& b) const {
    unsigned apart = 0;
#ifdef __SSE2__
    for (std::size_t half = 0; half < width; half += 4) {
      __m128i a = _mm_setzero_si128();
      for (std::size_t k = 0; k < 3; ++k) {
        const __m128i l = _mm_loadu_si128(reinterpret_cast<const __m128i*>(&low[k][half]));
        const __m128i h = _mm_loadu_si128(reinterpret_cast<const __m128i*>(&high[k][half]));
        a = _mm_or_si128(a, _mm_or_si128(_mm_cmpgt_epi32(l, _mm_set1_epi32(b.high[k])),
                                         _mm_cmpgt_epi32(_mm_set1_epi32(b.low[k]), h)));
      }
      apart |= static_cast<unsigned>(_mm_movemask_ps(_mm_castsi128_ps(a))) << half;
    }
#else
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < width; ++i)
        apart |= static_cast<unsigned>(low[k][i] > b.high[k] || b.low[k] > high[k][i]) << i;
#endif
    return ~apart & ((1u << width) - 1);
  }
};

/// Bit i: lane i is v.
inline unsigned lanes_equal(const std::uint32_t* lanes, std::uint32_t v) {
  unsigned r = 0;
#ifdef __SSE2__
  const __m128i all = _mm_set1_epi32(static_cast<int>(v));
  for (std::size_t half = 0; half < BoxBlock::width; half += 4) {
    const __m128i l = _mm_loadu_si128(reinterpret_cast<const __m128i*>(&lanes[half]));
    r |= static_cast<unsigned>(_mm_movemask_ps(_mm_castsi128_ps(_mm_cmpeq_epi32(l, all)))) << half;
  }
#else
  for (std::size_t i = 0; i < BoxBlock::width; ++i) r |= static_cast<unsigned>(lanes[i] == v) << i;
#endif
  return r;
}

/// A static box hierarchy: items in Morton order of their centres, in blocks of eight, under a tree of such blocks.
/// Every item carries a group. Visiting order is deterministic.
class BoxTree {
 public:
  struct Item {
    Box box;
    std::uint32_t id;
    std::uint32_t group;
  };

  enum class Order {
    by_place,  // neighbours of all groups together
    by_group   // the groups (small numbers) one after the other: blocks hold one each, but where a group ends
  };

  explicit BoxTree(const std::vector<Item>& items, Order order = Order::by_place);

  /// Ids in the tree's order: block b holds those from 8 b to 8 b + 7.
  const std::vector<std::uint32_t>& ids() const { return ids_; }

  /// visit(id, id') for every pair of items whose boxes meet, each pair once.
  template <class Visit>
  void pairs(Visit&& visit) const {
    pairs_but([](std::uint32_t, std::uint32_t, unsigned) { return 0u; }, visit);
  }
  /// The same, leaving out what `skip(i, b, lanes)` says: a bit for each item of block b that is not wanted with the
  /// i-th item of the tree's order; only those of `lanes` matter.
  template <class Skip, class Visit>
  void pairs_but(Skip&& skip, Visit&& visit) const {
    const auto all = [](std::uint32_t, std::uint32_t) { return false; };
    if (!levels_.empty()) self(levels_.size() - 1, 0, all, skip, visit);
  }
  /// The same for pairs of items of different groups; `skip` as above.
  template <class Skip, class Visit>
  void foreign_pairs_but(Skip&& skip, Visit&& visit) const {
    const auto same = [](std::uint32_t g, std::uint32_t h) { return g == h && g != mixed; };
    const auto skip_more = [&](std::uint32_t i, std::uint32_t b, unsigned lanes) {
      const auto& groups = levels_[0].group;
      const unsigned own = lanes_equal(&groups[b * BoxBlock::width], groups[i]);
      return (lanes & ~own) == 0 ? own : own | skip(i, b, lanes & ~own);
    };
    if (!levels_.empty()) self(levels_.size() - 1, 0, same, skip_more, visit);
  }

  /// visit(id) for every item whose box meets the given one, which the visitor may shrink; boxes that reach further up
  /// in y come first.
  template <class Visit>
  void meeting(const Box& box, Visit&& visit) const {
    if (!levels_.empty()) descend(levels_.size() - 1, 0, box, visit);
  }

 private:
  static constexpr std::uint32_t mixed = none;
  /// Boxes of the items (level 0) or of the blocks of the level below, with the group that all in it share.
  struct Level {
    std::vector<BoxBlock> blocks;
    std::vector<std::uint32_t> group;  // of each lane
    std::uint32_t count;               // of lanes in use
  };
  static std::uint32_t lowest(unsigned lanes) { return static_cast<std::uint32_t>(std::countr_zero(lanes)); }

  template <class BoxOf, class GroupOf>
  void add_level(std::size_t n, BoxOf box, GroupOf group) {
    Level& level = levels_.emplace_back();
    level.count = static_cast<std::uint32_t>(n);
    level.blocks.resize((n + BoxBlock::width - 1) / BoxBlock::width);
    level.group.resize(level.blocks.size() * BoxBlock::width, mixed);
    for (std::size_t i = 0; i < n; ++i) {
      level.blocks[i / BoxBlock::width].set(static_cast<std::uint32_t>(i % BoxBlock::width), box(i));
      level.group[i] = group(i);
    }
  }

  template <class Same, class Skip, class Visit>
  void self(std::size_t level, std::uint32_t b, Same& same, Skip& skip, Visit& visit) const {
    const BoxBlock& block = levels_[level].blocks[b];
    for (std::uint32_t i = 0; i < BoxBlock::width; ++i) {
      const std::uint32_t x = b * BoxBlock::width + i;
      if (x >= levels_[level].count) break;
      unsigned lanes = block.meeting(block.box(i)) & (~1u << i);
      if (level == 0) {
        if (lanes != 0) lanes &= ~skip(x, b, lanes);
        for (; lanes != 0; lanes &= lanes - 1) visit(ids_[x], ids_[b * BoxBlock::width + lowest(lanes)]);
        continue;
      }
      if (!same(levels_[level].group[x], levels_[level].group[x])) self(level - 1, x, same, skip, visit);
      for (; lanes != 0; lanes &= lanes - 1) cross(level, x, b * BoxBlock::width + lowest(lanes), same, skip, visit);
    }
  }

  /// Lanes x and y of a level, whose boxes meet: the pairs between the blocks that they stand for.
  template <class Same, class Skip, class Visit>
  void cross(std::size_t level, std::uint32_t x, std::uint32_t y, Same& same, Skip& skip, Visit& visit) const {
    const Level& here = levels_[level];
    if (same(here.group[x], here.group[y])) return;
    const BoxBlock &a = levels_[level - 1].blocks[x], &b = levels_[level - 1].blocks[y];
    unsigned left = a.meeting(here.blocks[y / BoxBlock::width].box(y % BoxBlock::width));
    for (; left != 0; left &= left - 1) {
      const std::uint32_t i = lowest(left), u = x * BoxBlock::width + i;
      unsigned lanes = b.meeting(a.box(i));
      if (level == 1 && lanes != 0) lanes &= ~skip(u, y, lanes);
      for (; lanes != 0; lanes &= lanes - 1) {
        const std::uint32_t v = y * BoxBlock::width + lowest(lanes);
        if (level == 1)
          visit(ids_[u], ids_[v]);
        else
          cross(level - 1, u, v, same, skip, visit);
      }
    }
  }

  template <class Visit>
  void descend(std::size_t level, std::uint32_t b, const Box& box, Visit& visit) const {
    const BoxBlock& block = levels_[level].blocks[b];
    for (unsigned left = block.meeting(box); left != 0;) {
      std::uint32_t top = lowest(left);
      for (unsigned rest = left; rest != 0; rest &= rest - 1)
        if (block.high[1][lowest(rest)] > block.high[1][top]) top = lowest(rest);
      left &= ~(1u << top);
      if (!block.box(top).meets(box)) continue;  // it has shrunk
      if (level == 0)
        visit(ids_[b * BoxBlock::width + top]);
      else
        descend(level - 1, b * BoxBlock::width + top, box, visit);
    }
  }

  std::vector<std::uint32_t> ids_;
  std::vector<Level> levels_;
};

}  // namespace quoin::booleans
