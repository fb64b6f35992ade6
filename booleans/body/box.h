/// \file
/// Closed integer boxes.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>

#include "exact/geometry.h"

namespace quoin::booleans {

/// A closed box, grid steps. Touching boxes meet.
/// Rounding is monotone, so boxes of rounded coordinates meet where the exact ones do. Whoever compares exact numbers
/// with a box wants one that holds the exact points (add_around).
struct Box {
  std::array<std::int32_t, 3> low{INT32_MAX, INT32_MAX, INT32_MAX};
  std::array<std::int32_t, 3> high{INT32_MIN, INT32_MIN, INT32_MIN};

  /// Rounded coordinates, in whole steps outward.
  void add(const std::array<double, 3>& p) { add_outward(p, std::less<>()); }
  /// The exact point whose correctly rounded coordinates are p: it may lie on either side of a whole one.
  void add_around(const std::array<double, 3>& p) { add_outward(p, std::less_equal<>()); }
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

 private:
  /// A step farther than the whole number toward zero where `less` says that a coordinate lies beyond it.
  template <class Less>
  void add_outward(const std::array<double, 3>& p, Less less) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto toward_zero = static_cast<std::int32_t>(p[k]);
      low[k] = std::min(low[k], toward_zero - less(p[k], toward_zero));
      high[k] = std::max(high[k], toward_zero + less(toward_zero, p[k]));
    }
  }
};

/// The same box, with all its coordinates side by side for the processor's vector instructions; the fourth lane is 0.
class WideBox {
 public:
  explicit WideBox(const exact::GridPoint& p) : low_{p.c[0], p.c[1], p.c[2], 0}, high_(low_) {}
  explicit WideBox(const Box& b) : low_{b.low[0], b.low[1], b.low[2], 0}, high_{b.high[0], b.high[1], b.high[2], 0} {}

  void add(const exact::GridPoint& p) { add(WideBox(p)); }
  void add(const WideBox& b) {
    low_ = b.low_ < low_ ? b.low_ : low_;
    high_ = b.high_ > high_ ? b.high_ : high_;
  }
  bool meets(const WideBox& b) const {
    const Lanes apart = (low_ > b.high_) | (b.low_ > high_);
    return (apart[0] | apart[1] | apart[2]) == 0;
  }
  Box box() const { return {{low_[0], low_[1], low_[2]}, {high_[0], high_[1], high_[2]}}; }

 private:
  using Lanes = std::int32_t __attribute__((vector_size(16)));
  Lanes low_, high_;
};

}  // namespace quoin::booleans
