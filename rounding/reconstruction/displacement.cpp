#include "rounding/reconstruction/displacement.h"

#include <algorithm>

namespace quoin::rounding {
namespace {

/// In units.
std::array<Integer, 3> in_units(const exact::Point& p) {
  const Integer w = exact::to_integer(p.w);
  std::array<Integer, 3> r;
  for (std::size_t k = 0; k < 3; ++k) r[k] = nearest_integer(Integer(exact::to_integer(p.x[k]) << unit_bits), w);
  return r;
}

}  // namespace

Rational distance_above(const std::array<Integer, 3>& a, const std::array<Integer, 3>& b) {
  Integer sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Integer most = abs(a[k] - b[k]) + 1;
    sum += most * most;
  }
  return Rational(sqrt(sum) + 1, Integer(1) << unit_bits);
}

Rational displacement_above(std::span<const Vector> points, const IntegerMap& map, const booleans::Boundary& boundary) {
  Rational most = 0;
  for (std::size_t v = 0; v < points.size(); ++v)
    most = std::max(most, distance_above(map(points[v], unit_bits), in_units(boundary.vertices[v])));
  return most;
}

}  // namespace quoin::rounding
