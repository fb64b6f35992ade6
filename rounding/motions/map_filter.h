/// \file
/// The filter before exact images: an affine map in doubles, with certified errors.
#pragma once

#include <array>

#include "rounding/motions/affine_map.h"

namespace quoin::rounding {

/// An affine map in doubles, with certified errors.
class MapFilter {
 public:
  explicit MapFilter(const AffineMap& map);
  /// The image's coordinate is at most `error` from `value`.
  struct Estimate {
    double value, error;
  };
  /// Of coordinate k of the image of a point whose coordinates are rounded to doubles, or, `in_steps`, integers of at
  /// most 2^30: then rows of integers have no error.
  Estimate operator()(std::size_t k, const std::array<double, 3>& p, bool in_steps) const;

 private:
  struct Row {
    std::array<double, 3> linear;
    double shift;
    bool is_whole;  // integers whose images of such points are below 2^53
  };
  std::array<Row, 3> rows_;
};

}  // namespace quoin::rounding
