/// \file
/// The search for pairs of faces: boxes, then slabs where many boxes overlap, then an exact test, in parallel.
#pragma once

#include "booleans/pairs/operands.h"
#include "booleans/pairs/subtrees.h"

namespace quoin::booleans {

/// What a search without neighbours skips.
inline constexpr auto skip_nothing = [](std::uint32_t, std::uint32_t) { return 0u; };

/// What comes of faces below two nodes that meet in common corners and edges only: no pairs; or, as of those that lie
/// on one plane, one pair each, with a face of another group.
enum class InParts { passed, one_each };

/// Finds the pairs that a test accepts, smaller id first, in an order that depends on the tree alone; then come those
/// that stand for what is passed over.
/// skip(i, block): which faces of the block are not wanted with the i-th face; bits.
/// wanted(i, j): whether these two faces are; only pairs whose boxes meet are asked for.
template <class Skip, class Wanted>
class PairSearch {
 public:
  /// The faces in the tree's order.
  PairSearch(const Array<SearchedFace>& faces, const BoxTree& tree, InParts in_parts, Skip skip, Wanted wanted)
      : faces_(faces),
        tree_(tree),
        in_parts_(in_parts),
        slabs_(faces, tree),
        subtrees_(faces, tree, in_parts == InParts::one_each),
        skip_(skip),
        wanted_(wanted) {}

  FacePairs run(BoxTree::Pairs pairs) {
    const auto pass = [&](std::size_t level, std::uint32_t x, std::uint32_t y) { return passed(level, x, y, true); };
    tree_.block_pairs(pairs, pass, [&](std::uint32_t x, std::uint32_t y) {
      waiting_.push_back({x, y, 0});
      if (waiting_.size() == most) test(pairs);
    });
    test(pairs);
    found_.insert(found_.end(), standing_.begin(), standing_.end());
    if (in_parts_ == InParts::one_each) found_.hubs = subtrees_.hubs();
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
    for (BlockPair& p : waiting_) {
      const int count = std::popcount(p.lanes);
      if (count <= grid::thresholds().crowded_blocks) continue;
      if (p.x != p.y && faces_.size() > grid::thresholds().few_faces &&
          passed(1, p.x, p.y, count > grid::thresholds().crowded_nodes))
        p.lanes = 0;
      else
        slabs_.need(p.x), slabs_.need(p.y);
    }
    Array<FacePairs> found((waiting_.size() + chunk - 1) / chunk);
    in_parallel(waiting_.size(), [&](std::size_t c, std::size_t i) { test(waiting_[i], found[c]); });
    for (const auto& f : found) found_.insert(found_.end(), f.begin(), f.end());
    waiting_.clear();
  }

  /// May the pairs of faces below two nodes be passed over? Adds the pairs that stand for them.
  bool passed(std::size_t level, std::uint32_t x, std::uint32_t y, bool is_crowded) {
    const Relation relation = subtrees_.relation(level, x, y, is_crowded);
    if (relation == Relation::in_parts && in_parts_ == InParts::one_each) {
      const std::uint32_t i = subtrees_.begin(level, x), j = other_group(i, level, x, y);
      name_each(level, x, y, {i, j});
      name_each(level, y, x, {i, j});
    }
    return relation != Relation::unknown;
  }
  /// The first face below y or x of another group than i's. There is one.
  std::uint32_t other_group(std::uint32_t i, std::size_t level, std::uint32_t x, std::uint32_t y) const {
    for (const std::uint32_t n : {y, x})
      for (std::uint32_t j = subtrees_.begin(level, n); j < subtrees_.end(level, n); ++j)
        if (tree_.group(j) != tree_.group(i)) return j;
    assert(false);
    return i;
  }
  /// Each face below a node in a pair with one below the other one whose box meets its own, if that is soon found, else
  /// with one of two given faces of different groups.
  void name_each(std::size_t level, std::uint32_t node, std::uint32_t other, std::array<std::uint32_t, 2> given) {
    named_.resize(faces_.size());
    for (std::uint32_t i = subtrees_.begin(level, node); i < subtrees_.end(level, node); ++i) {
      if (named_[i]) continue;
      std::uint32_t j = near_partner(i, level, other);
      if (j == none) j = tree_.group(given[0]) != tree_.group(i) ? given[0] : given[1];
      named_[i] = named_[j] = 1;
      standing_.push_back(pair_of(i, j));
    }
  }
  std::uint32_t near_partner(std::uint32_t i, std::size_t level, std::uint32_t node) const {
    constexpr std::uint32_t tried = 64;
    const Box box = tree_.box(i);
    const std::uint32_t begin = subtrees_.begin(level, node), end = std::min(subtrees_.end(level, node), begin + tried);
    for (std::uint32_t j = begin; j < end; ++j)
      if (tree_.group(j) != tree_.group(i) && box.meets(tree_.box(j))) return j;
    return none;
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
    BoxTree::for_lane_pairs(left, p.x, p.y, [&](std::uint32_t i, std::uint32_t j) {
      if (wanted_(i, j)) found.push_back(pair_of(i, j));
    });
  }
  /// Of the faces in those places of the tree.
  FacePair pair_of(std::uint32_t i, std::uint32_t j) const {
    const auto [a, b] = std::minmax(tree_.ids()[i], tree_.ids()[j]);
    return {FaceId(a), FaceId(b)};
  }

  const Array<SearchedFace>& faces_;
  const BoxTree& tree_;
  const InParts in_parts_;
  BlockSlabs slabs_;
  Subtrees subtrees_;
  const Skip skip_;
  const Wanted wanted_;
  Array<BlockPair> waiting_;
  FacePairs found_, standing_;
  Array<std::uint8_t> named_;  // by place in the tree: it has a pair that stands for those passed over
};

}  // namespace quoin::booleans
