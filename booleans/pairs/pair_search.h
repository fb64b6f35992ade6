/// \file
/// The search for pairs of faces: boxes, then slabs where many boxes overlap, then an exact test, in parallel.
#pragma once

#include "booleans/pairs/block_slabs.h"
#include "booleans/pairs/operands.h"

namespace quoin::booleans {

/// What a search without neighbours skips.
inline constexpr auto skip_nothing = [](std::uint32_t, std::uint32_t) { return 0u; };

/// Finds the pairs that a test accepts, smaller id first, in an order that depends on the tree alone.
/// skip(i, block): which faces of the block are not wanted with the i-th face; bits.
/// wanted(i, j): whether these two faces are; only pairs whose boxes meet are asked for.
template <class Skip, class Wanted>
class PairSearch {
 public:
  /// The faces in the tree's order.
  PairSearch(const Array<SearchedFace>& faces, const BoxTree& tree, Skip skip, Wanted wanted)
      : tree_(tree), slabs_(faces, tree), skip_(skip), wanted_(wanted) {}

  FacePairs run(BoxTree::Pairs pairs) {
    tree_.block_pairs(pairs, [&](std::uint32_t x, std::uint32_t y) {
      waiting_.push_back({x, y, 0});
      if (waiting_.size() == most) test(pairs);
    });
    test(pairs);
    return std::move(found_);
  }

 private:
  struct BlockPair {
    std::uint32_t x, y;
    LanePairs lanes;
  };
  const std::size_t most = grid::stretch(std::size_t{1} << 12), chunk = grid::stretch(128);

  template <class Visit>
  void in_parallel(std::size_t count, Visit visit) const {
    grid::in_stretches(count, chunk, [&](std::size_t c, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) visit(c, i);
    });
  }

  void test(BoxTree::Pairs pairs) {
    in_parallel(waiting_.size(), [&](std::size_t, std::size_t i) {
      BlockPair& p = waiting_[i];
      p.lanes = tree_.lane_pairs(pairs, p.x, p.y);
      p.lanes &= ~skipped(p);
    });
    for (const BlockPair& p : waiting_)
      if (std::popcount(p.lanes) > grid::thresholds().crowded_blocks) slabs_.need(p.x), slabs_.need(p.y);
    Array<FacePairs> found((waiting_.size() + chunk - 1) / chunk);
    in_parallel(waiting_.size(), [&](std::size_t c, std::size_t i) { test(waiting_[i], found[c]); });
    for (const auto& f : found) found_.insert(found_.end(), f.begin(), f.end());
    waiting_.clear();
  }

  LanePairs skipped(const BlockPair& p) const {
    LanePairs r = 0;
    for (std::uint32_t i = 0; i < BoxBlock::width; ++i)
      if ((p.lanes >> (BoxBlock::width * i) & 0xFF) != 0)
        r |= LanePairs{skip_(p.x * BoxBlock::width + i, p.y)} << (BoxBlock::width * i);
    return r;
  }

  void test(const BlockPair& p, FacePairs& found) const {
    LanePairs left = p.lanes;
    if (std::popcount(left) > grid::thresholds().crowded_blocks) left &= ~slabs_.apart(p.x, p.y);
    for (; left != 0; left &= left - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(left));
      const std::uint32_t i = p.x * BoxBlock::width + lane / BoxBlock::width,
                          j = p.y * BoxBlock::width + lane % BoxBlock::width;
      const std::uint32_t a = tree_.ids()[i], b = tree_.ids()[j];
      if (wanted_(i, j)) found.push_back({FaceId(std::min(a, b)), FaceId(std::max(a, b))});
    }
  }

  const BoxTree& tree_;
  BlockSlabs slabs_;
  const Skip skip_;
  const Wanted wanted_;
  Array<BlockPair> waiting_;
  FacePairs found_;
};

}  // namespace quoin::booleans
