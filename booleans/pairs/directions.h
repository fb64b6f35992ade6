/// \file
/// Directions: how far points and boxes lie along them; integer ones from doubles that need not be exact.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "booleans/body/box.h"
#include "exact/predicates.h"

namespace quoin::booleans {

template <class Number>
std::array<Number, 3> cross(const std::array<Number, 3>& u, const std::array<Number, 3>& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}
template <class Number>
Number dot(const std::array<Number, 3>& u, const std::array<Number, 3>& v) {
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}
inline std::array<double, 3> doubles(const std::array<std::int64_t, 3>& n) {
  return {double(n[0]), double(n[1]), double(n[2])};
}
inline std::array<double, 3> doubles(const exact::GridPoint& p) { return {double(p[0]), double(p[1]), double(p[2])}; }

/// How far a point lies along a direction. Exact for components below 2^31.
inline std::int64_t value(const std::array<std::int64_t, 3>& n, const exact::GridPoint& p) {
  return n[0] * p.c[0] + n[1] * p.c[1] + n[2] * p.c[2];
}

/// The corners of a box that lie lowest and highest along a direction.
inline std::array<exact::GridPoint, 2> ends_along(const std::array<std::int64_t, 3>& n, const Box& box) {
  std::array<exact::GridPoint, 2> r{};
  for (std::size_t k = 0; k < 3; ++k) {
    r[0].c[k] = n[k] < 0 ? box.high[k] : box.low[k];
    r[1].c[k] = n[k] < 0 ? box.low[k] : box.high[k];
  }
  return r;
}

/// Does the box lie strictly on one side of the plane?
inline bool strictly_on_one_side(const exact::Plane& plane, const Box& box) {
  const auto [lowest, highest] = ends_along(plane.n, box);
  return exact::side(plane, lowest) > 0 || exact::side(plane, highest) < 0;
}

/// An axis in which the line of two planes runs, preferably the steepest; -1 for parallel planes.
inline int axis_of_line(const exact::Plane& p, const exact::Plane& q) {
  const int best =
      static_cast<int>(exact::longest_component(cross(exact::approximation(p).n, exact::approximation(q).n)));
  for (int k = 0; k < 3; ++k)
    if (exact::cross_sign(p, q, (best + k) % 3) != 0) return (best + k) % 3;
  return -1;
}

/// In the direction of d, components at most `size`.
inline std::array<std::int64_t, 3> scaled(const std::array<double, 3>& d, int size) {
  const double longest = std::max({std::fabs(d[0]), std::fabs(d[1]), std::fabs(d[2])});
  std::array<std::int64_t, 3> n{};
  for (std::size_t k = 0; k < 3; ++k) n[k] = longest > 0 ? static_cast<std::int64_t>(d[k] * size / longest) : 0;
  return n;
}

}  // namespace quoin::booleans
