#include "rounding/motions/map_filter.h"

#include <cmath>

#include "exact/filter_bounds.h"

namespace quoin::rounding {

MapFilter::MapFilter(const AffineMap& map) {
  const Integer point_limit = Integer(1) << 30, limit = Integer(1) << 53;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& [x, y, z] = map.linear[i];
    const Rational& s = map.shift[i];
    const Rational farthest = (magnitude(x) + magnitude(y) + magnitude(z)) * point_limit + magnitude(s);

    rows_[i] = {{exact::to_double(x), exact::to_double(y), exact::to_double(z)},
                exact::to_double(s),
                are_whole(std::array{x, y, z, s}) && farthest < limit};
  }
}

// Every term is a product of at most three factors (1 + d), |d| <= u = 2^-53 (two numbers rounded, and their product),
// and passes through at most three sums: six factors in all. So the error is at most ((1 + u)^6 - 1) < 6.01 u times the
// sum of the terms' sizes, and the computed sum is at most 6.01 u of itself too small: 8 u covers that and the bound's
// own roundings. Where a number or product underflows its error is at most 2^-1075, times the other factor.
// Proved by docs/proofs/map_filter.g.
// An infinite or undefined value has an infinite or undefined error.
MapFilter::Estimate MapFilter::operator()(std::size_t k, const std::array<double, 3>& p, bool in_steps) const {
  const Row& row = rows_[k];
  double value = row.shift, size = std::fabs(row.shift), factors = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    const double term = row.linear[i] * p[i];
    value += term;
    size += std::fabs(term);
    factors += std::fabs(row.linear[i]) + std::fabs(p[i]);
  }

  if (in_steps && row.is_whole) return {value, 0};
  return {value, exact::map_bound * exact::unit_roundoff * size + exact::map_floor * factors};
}

}  // namespace quoin::rounding
