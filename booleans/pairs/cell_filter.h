/// \file
/// A uniform grid of cells that tells boxes of one group that are alone.
#pragma once

#include <cstddef>
#include <vector>

#include "booleans/body/body.h"

namespace quoin::booleans {

/// Which groups the boxes in each cell belong to: boxes of different groups that meet share a cell. Boxes may be added
/// by several threads at a time, before any is asked about.
class CellFilter {
 public:
  /// `all` holds all boxes; the sample stands for them, `share` boxes each. `work` bounds the number of cells and the
  /// number of cells that all boxes take together: cells are as fine as that allows.
  CellFilter(const Box& all, const Array<Box>& sample, std::size_t share, std::size_t work);

  void add(const Box& box, std::uint32_t group);
  /// Is there a box of another group in a cell of this one, which was added?
  bool is_shared(const Box& box) const;

 private:
  static constexpr std::uint32_t mixed = none - 1;

  std::uint32_t cell(std::size_t k, std::int32_t x) const {
    return static_cast<std::uint32_t>(std::int64_t{x} - low_[k]) >> shift_;
  }
  std::size_t cell_count() const;
  std::size_t cells_of(const Box& box) const;
  /// visit(index) until it returns false.
  template <class Visit>
  void for_cells(const Box& box, Visit&& visit) const;

  std::array<std::int32_t, 3> low_, high_;
  std::size_t width_ = 1, depth_ = 1;  // cells along x and y
  int shift_ = 0;
  std::vector<std::uint32_t> owner_;  // the group of the boxes in each cell, none or mixed
};

}  // namespace quoin::booleans
