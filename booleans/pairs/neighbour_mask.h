/// \file
/// Which triangles of a tree's blocks share a vertex that is known to be harmless.
#pragma once

#include "booleans/pairs/box_tree.h"

namespace quoin::booleans {

/// Of the pairs of triangles whose boxes meet nearly all share a vertex; where its star is embedded they meet as they
/// should.
class NeighbourMask {
 public:
  /// `order`: triangles in the order of a tree. corner(t, k): the k-th vertex of one, or none where it does not count.
  template <class Corner>
  NeighbourMask(const Array<std::uint32_t>& order, Corner&& corner)
      : corners_((order.size() + BoxBlock::width - 1) / BoxBlock::width) {
    for (std::size_t i = 0; i < order.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t v = corner(order[i], k);
        // What does not count gets a name that no other triangle has.
        corners_[i / BoxBlock::width][k][i % BoxBlock::width] = v != none ? v : none - static_cast<std::uint32_t>(i);
      }
  }

  /// The lanes of block b that are neighbours of the i-th triangle.
  unsigned operator()(std::uint32_t i, std::uint32_t b) const {
    const Block &own = corners_[i / BoxBlock::width], &others = corners_[b];
    const std::size_t lane = i % BoxBlock::width;
    return lanes_with(std::array{others[0].data(), others[1].data(), others[2].data()},
                      std::array{own[0][lane], own[1][lane], own[2][lane]});
  }
  /// Of these pairs those of neighbours.
  LanePairs among(LanePairs pairs, std::uint32_t x, std::uint32_t y) const {
    LanePairs r = 0;
    for (std::uint32_t i = 0; i < BoxBlock::width; ++i)
      if ((pairs >> (BoxBlock::width * i) & 0xFF) != 0)
        r |= LanePairs{(*this)(x * BoxBlock::width + i, y)} << (BoxBlock::width * i);
    return r;
  }

 private:
  using Block = std::array<std::array<std::uint32_t, BoxBlock::width>, 3>;

  Array<Block> corners_;
};

}  // namespace quoin::booleans
