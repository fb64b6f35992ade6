/// \file
/// The search for pairs of boxes that meet.
#pragma once

#include <bit>
#include <span>
#include <vector>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include "booleans/body/body.h"
#include "grid/lists/stretches.h"

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

/// Pairs of a lane of one block and a lane of another: bit 8 i + j stands for the i-th and the j-th.
using LanePairs = std::uint64_t;

/// Bit i: lane i has one of the values in one of its lists.
template <std::size_t N, std::size_t M>
unsigned lanes_with(const std::array<const std::uint32_t*, N>& lists, const std::array<std::uint32_t, M>& values) {
  unsigned r = 0;
#ifdef __SSE2__
  for (std::size_t half = 0; half < BoxBlock::width; half += 4) {
    __m128i equal = _mm_setzero_si128();
    for (std::size_t n = 0; n < N; ++n) {
      const __m128i lanes = _mm_loadu_si128(reinterpret_cast<const __m128i*>(&lists[n][half]));
      for (std::size_t m = 0; m < M; ++m)
        equal = _mm_or_si128(equal, _mm_cmpeq_epi32(lanes, _mm_set1_epi32(static_cast<int>(values[m]))));
    }
    r |= static_cast<unsigned>(_mm_movemask_ps(_mm_castsi128_ps(equal))) << half;
  }
#else
  for (const std::uint32_t v : values)
    for (const std::uint32_t* list : lists)
      for (std::size_t i = 0; i < BoxBlock::width; ++i) r |= static_cast<unsigned>(list[i] == v) << i;
#endif
  return r;
}

/// A static box hierarchy: items in blocks of eight, under a tree of such blocks. Every item carries a group. Visiting
/// order is deterministic.
class BoxTree {
 public:
  struct Item {
    Box box;
    std::uint32_t id;
    std::uint32_t group;
  };

  enum class Order {
    by_place,  // Morton order of the centres: neighbours of all groups together
    by_group   // the groups (small numbers) one after the other, each by place
  };

  explicit BoxTree(const Array<Item>& items, Order order = Order::by_place);

  /// Ids in the tree's order: block b holds those from 8 b to 8 b + 7.
  const Array<std::uint32_t>& ids() const { return ids_; }
  /// The box of the i-th item in the tree's order.
  Box box(std::uint32_t i) const { return levels_[0].blocks[i / BoxBlock::width].box(i % BoxBlock::width); }

  /// The group of the i-th item in the tree's order.
  std::uint32_t group(std::uint32_t i) const { return levels_[0].group[i]; }

  /// Node x of level l stands for the items from x 8^l to (x + 1) 8^l - 1, of which the last node has fewer. Nodes of
  /// level 0 are items; the tree as a whole is no node.
  std::size_t level_count() const { return levels_.size(); }
  std::uint32_t node_count(std::size_t level) const { return levels_[level].count; }
  Box node_box(std::size_t level, std::uint32_t x) const {
    return levels_[level].blocks[x / BoxBlock::width].box(x % BoxBlock::width);
  }
  /// The pairs of parts of two nodes of one level, not 0, whose boxes meet.
  LanePairs part_pairs(std::size_t level, std::uint32_t x, std::uint32_t y) const {
    const BoxBlock &a = levels_[level - 1].blocks[x], &b = levels_[level - 1].blocks[y];
    const BoxBlock& of_y = levels_[level].blocks[y / BoxBlock::width];
    LanePairs parts = 0;
    for (unsigned left = a.meeting(of_y.box(y % BoxBlock::width)); left != 0; left &= left - 1)
      parts |= LanePairs{b.meeting(a.box(lowest(left)))} << (BoxBlock::width * lowest(left));
    return parts;
  }

  enum class Pairs {
    all,
    foreign  // of items of different groups
  };
  /// visit(x, y), x <= y, for blocks of items whose boxes meet; among them are all that hold such pairs, each once, but
  /// for what is passed over: pass(level, x, y) is asked about two nodes, in each of which 8^level items follow each
  /// other, where many of the pairs between their parts have boxes that meet.
  template <class Pass, class Visit>
  void block_pairs(Pairs wanted, Pass&& pass, Visit&& visit) const {
    if (!levels_.empty()) self(levels_.size() - 1, 0, wanted, pass, visit);
  }
  /// The pairs of an item of block x and one of block y, x <= y, whose boxes meet, each pair once.
  LanePairs lane_pairs(Pairs wanted, std::uint32_t x, std::uint32_t y) const {
    const BoxBlock &a = levels_[0].blocks[x], &b = levels_[0].blocks[y];
    unsigned rows = (1u << BoxBlock::width) - 1;
    if (levels_.size() > 1) rows = a.meeting(levels_[1].blocks[y / BoxBlock::width].box(y % BoxBlock::width));
    const auto& groups = levels_[0].group;
    LanePairs pairs = 0;
    for (; rows != 0; rows &= rows - 1) {
      const std::uint32_t i = lowest(rows);
      unsigned row = b.meeting(a.box(i));
      if (x == y) row &= ~1u << i;
      if (wanted == Pairs::foreign && row != 0)
        row &= ~lanes_with(std::array{&groups[y * BoxBlock::width]}, std::array{groups[x * BoxBlock::width + i]});
      pairs |= LanePairs{row} << (BoxBlock::width * i);
    }
    return pairs;
  }
  /// visit(i, j) for the places, in the tree's order, of pairs of an item of block x and one of block y.
  template <class Visit>
  static void for_lane_pairs(LanePairs pairs, std::uint32_t x, std::uint32_t y, Visit&& visit) {
    for (; pairs != 0; pairs &= pairs - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(pairs));
      visit(x * BoxBlock::width + lane / BoxBlock::width, y * BoxBlock::width + lane % BoxBlock::width);
    }
  }
  /// visit(id, id') for every pair of items whose boxes meet, each pair once.
  template <class Visit>
  void pairs(Visit&& visit, Pairs wanted = Pairs::all) const {
    const auto never = [](std::size_t, std::uint32_t, std::uint32_t) { return false; };
    block_pairs(wanted, never, [&](std::uint32_t x, std::uint32_t y) {
      for_lane_pairs(lane_pairs(wanted, x, y), x, y,
                     [&](std::uint32_t i, std::uint32_t j) { visit(ids_[i], ids_[j]); });
    });
  }

  /// visit(id) for every item whose box meets the given one, which the visitor may shrink; boxes that reach further up
  /// in y come first.
  template <class Visit>
  void meeting(const Box& box, Visit&& visit) const {
    const auto always = [](std::size_t, std::uint32_t, const Box&) { return true; };
    meeting(box, always, visit);
  }
  /// The same, but for items below nodes that are not of interest: of_interest(level, node, box).
  template <class Of, class Visit>
  void meeting(const Box& box, Of&& of_interest, Visit&& visit) const {
    if (!levels_.empty()) descend(levels_.size() - 1, 0, box, of_interest, visit);
  }

 private:
  static constexpr std::uint32_t mixed = none;
  /// Boxes of the items (level 0) or of the blocks of the level below, with the group that all in it share.
  struct Level {
    Array<BoxBlock> blocks;
    Array<std::uint32_t> group;  // of each lane
    std::uint32_t count;         // of lanes in use
  };
  static std::uint32_t lowest(unsigned lanes) { return static_cast<std::uint32_t>(std::countr_zero(lanes)); }

  template <class BoxOf, class GroupOf>
  void add_level(std::size_t n, BoxOf box, GroupOf group) {
    Level& level = levels_.emplace_back();
    level.count = static_cast<std::uint32_t>(n);
    level.blocks.resize((n + BoxBlock::width - 1) / BoxBlock::width);
    level.group.resize(level.blocks.size() * BoxBlock::width, mixed);
    grid::in_stretches(n, std::size_t{BoxBlock::width} << 10, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        level.blocks[i / BoxBlock::width].set(static_cast<std::uint32_t>(i % BoxBlock::width), box(i));
        level.group[i] = group(i);
      }
    });
  }

  /// Are all items below two lanes of one group, and pairs within a group not wanted?
  static bool idle(Pairs wanted, std::uint32_t g, std::uint32_t h) {
    return wanted == Pairs::foreign && g == h && g != mixed;
  }

  /// The pairs of items below one block of a level.
  template <class Pass, class Visit>
  void self(std::size_t level, std::uint32_t b, Pairs wanted, Pass& pass, Visit& visit) const {
    if (level == 0) return visit(b, b);
    const Level& here = levels_[level];
    const BoxBlock& block = here.blocks[b];
    const std::uint32_t begin = b * BoxBlock::width, end = std::min(begin + BoxBlock::width, here.count);
    for (std::uint32_t x = begin; x < end; ++x) {
      if (!idle(wanted, here.group[x], here.group[x])) self(level - 1, x, wanted, pass, visit);
      for (unsigned left = block.meeting(block.box(x - begin)) & (~1u << (x - begin)); left != 0; left &= left - 1)
        cross(level, x, begin + lowest(left), wanted, pass, visit);
    }
  }

  /// Lanes x and y of a level, whose boxes meet: the pairs between the blocks that they stand for.
  template <class Pass, class Visit>
  void cross(std::size_t level, std::uint32_t x, std::uint32_t y, Pairs wanted, Pass& pass, Visit& visit) const {
    const Level& here = levels_[level];
    if (idle(wanted, here.group[x], here.group[y])) return;
    if (level == 1) return visit(x, y);
    LanePairs parts = part_pairs(level, x, y);
    if (std::popcount(parts) > grid::thresholds().crowded_nodes && pass(level, x, y)) return;
    for_lane_pairs(parts, x, y, [&](std::uint32_t part_x, std::uint32_t part_y) {
      cross(level - 1, part_x, part_y, wanted, pass, visit);
    });
  }

  template <class Of, class Visit>
  void descend(std::size_t level, std::uint32_t b, const Box& box, Of& of_interest, Visit& visit) const {
    const BoxBlock& block = levels_[level].blocks[b];
    for (unsigned left = block.meeting(box); left != 0;) {
      std::uint32_t top = lowest(left);
      for (unsigned rest = left; rest != 0; rest &= rest - 1)
        if (block.high[1][lowest(rest)] > block.high[1][top]) top = lowest(rest);
      left &= ~(1u << top);
      const Box lane = block.box(top);
      if (!lane.meets(box) || !of_interest(level, b * BoxBlock::width + top, lane)) continue;  // it may have shrunk
      if (level == 0)
        visit(ids_[b * BoxBlock::width + top]);
      else
        descend(level - 1, b * BoxBlock::width + top, box, of_interest, visit);
    }
  }

  Array<std::uint32_t> ids_;
  Array<Level> levels_;
};

}  // namespace quoin::booleans
