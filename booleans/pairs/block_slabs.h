/// \file
/// Slabs around blocks of eight faces: what tells long thin faces apart whose boxes all overlap.
#pragma once

#include <limits>

#include "booleans/pairs/box_tree.h"

namespace quoin::booleans {

/// A face that takes part in a search.
struct SearchedFace {
  const Body* body;
  std::uint32_t face;  // its own id in the body

  bool is_raw() const { return face < body->triangles.size(); }
  std::uint32_t corner_count() const { return body->corner_count(face); }
};

/// A slab around the eight faces of a block of a tree. Neighbours on a surface lie nearly in one plane, so the slab is
/// thin, and a face strictly on one side of it meets none of the eight, however much the boxes overlap: those of long
/// thin diagonal triangles do. Two bundles of such triangles that cross are also compared along the direction that is
/// perpendicular to both. Where two slabs cross, what each face has in the other's slab is compared along the line of
/// their planes: the triangles of two fans that cross all meet that line, each in a place of its own. Directions come
/// from doubles, what lies along them is exact or bounded: any direction is right, a good one makes the slab thin.
class BlockSlabs {
 public:
  /// The faces in the tree's order. Both must outlive it.
  BlockSlabs(const Array<SearchedFace>& faces, const BoxTree& tree)
      : faces_(faces), tree_(tree), slab_of_((faces.size() + BoxBlock::width - 1) / BoxBlock::width, none) {}

  /// Makes the slab of a block if it has none.
  void need(std::uint32_t block) {
    if (slab_of_[block] != none) return;
    slab_of_[block] = static_cast<std::uint32_t>(slabs_.size());
    slabs_.push_back(slab(block));
  }
  /// The pairs that cannot meet, perhaps among others than the given ones. Precondition: both blocks have slabs.
  LanePairs apart(std::uint32_t x, std::uint32_t y) const;

 private:
  // Components below 2^30 and coordinates up to 2^29 + 2 make values below 2^61: all exact.
  using Normal = std::array<std::int64_t, 3>;
  /// How far faces reach along a direction.
  template <class Number>
  struct Range {
    Number low = std::numeric_limits<Number>::max(), high = std::numeric_limits<Number>::lowest();
    void add(Number x) {
      low = std::min(low, x);
      high = std::max(high, x);
    }
    void add(const Range& r) {
      low = std::min(low, r.low);
      high = std::max(high, r.high);
    }
    bool apart(const Range& r) const { return high < r.low || r.high < low; }
  };
  using Reach = Range<std::int64_t>;
  using Interval = Range<double>;  // bounds
  struct Slab {
    Normal normal;
    Reach reach;
    Normal along;    // of the longest edge of a triangle, components below 2^14
    bool is_bundle;  // the triangles are long and thin
  };

  std::uint32_t begin(std::uint32_t block) const { return block * BoxBlock::width; }
  std::uint32_t end(std::uint32_t block) const {
    return std::min(begin(block) + BoxBlock::width, static_cast<std::uint32_t>(faces_.size()));
  }
  Reach reach(std::uint32_t face, const Normal& n) const;
  Reach block_reach(std::uint32_t block, const Normal& n) const;
  bool bundles_apart(std::uint32_t x, std::uint32_t y) const;
  Slab slab(std::uint32_t block) const;
  /// How far along a line a face reaches within a slab, and a little more; empty where it does not meet the slab.
  Interval within(std::uint32_t face, const Slab& slab, const Normal& line) const;
  LanePairs apart_along_line(std::uint32_t x, std::uint32_t y, LanePairs left) const;

  const Array<SearchedFace>& faces_;
  const BoxTree& tree_;
  Array<std::uint32_t> slab_of_;
  Array<Slab> slabs_;
};

}  // namespace quoin::booleans
