#include "rounding/planes/wide_plane.h"

#include <cassert>
#include <utility>

namespace quoin::rounding {
namespace {

WidePlane in_lowest_terms(std::array<Integer, 4> p) {
  assert(p[0] != 0 || p[1] != 0 || p[2] != 0);
  p = primitive(std::move(p));
  return {{p[0], p[1], p[2]}, p[3]};
}

}  // namespace

WidePlane wide_plane(const Vector& normal, const Rational& offset) {
  return in_lowest_terms(over_common_denominator(std::array{normal[0], normal[1], normal[2], offset}).numerators);
}

WidePlane moved(const WidePlane& plane, const IntegerMap& to_before) {
  std::array<Integer, 4> p{0, 0, 0, plane.d * to_before.divisor};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) p[k] += to_before.linear[i][k] * plane.n[i];
    p[3] += to_before.shift[i] * plane.n[i];
  }
  return in_lowest_terms(std::move(p));
}

bool is_canonical(const WidePlane& plane) {
  if (plane.n[0] != 0) return plane.n[0] > 0;
  return plane.n[1] != 0 ? plane.n[1] > 0 : plane.n[2] > 0;
}

Rational value(const WidePlane& plane, const Vector& p) {
  return plane.n[0] * p[0] + plane.n[1] * p[1] + plane.n[2] * p[2] + plane.d;
}

Integer dot(const std::array<Integer, 3>& a, const std::array<Integer, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Integer squared_cross(const std::array<Integer, 3>& a, const std::array<Integer, 3>& b) {
  const std::array<Integer, 3> c{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  return dot(c, c);
}

Rational squared_sine(const std::array<Integer, 3>& a, const std::array<Integer, 3>& b) {
  return Rational(squared_cross(a, b), dot(a, a) * dot(b, b));
}

}  // namespace quoin::rounding
