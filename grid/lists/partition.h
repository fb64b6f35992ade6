/// \file
/// Union-find.
#pragma once

#include <cstddef>
#include <cstdint>

#include "grid/lists/array.h"

namespace quoin::grid {

/// Union-find over 0 .. n - 1; the root is the smallest member, so results do not depend on the order of unions.
class Partition {
 public:
  explicit Partition(std::size_t n) { reset(n); }
  /// Begins again.
  void reset(std::size_t n) {
    parent_.resize(n);
    for (std::uint32_t i = 0; i < n; ++i) parent_[i] = i;
  }
  std::size_t size() const { return parent_.size(); }
  /// One more member, by itself.
  void add() { parent_.push_back(static_cast<std::uint32_t>(parent_.size())); }
  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void unite(std::uint32_t i, std::uint32_t j) {
    if (parent_[i] == parent_[j]) return;
    i = find(i);
    j = find(j);
    if (i < j)
      parent_[j] = i;
    else
      parent_[i] = j;
  }

 private:
  Array<std::uint32_t> parent_;
};

}  // namespace quoin::grid
