/// \file
/// Planes by their numbers, and rounders of any size.
#pragma once

#include <gtest/gtest.h>

#include <array>

#include "exact/ladder.h"
#include "rounding/planes/plane_rounding.h"
#include "tests/rounding/support.h"

namespace quoin::rounding::testing {

using exact::Plane;
using Normal = std::array<Integer, 3>;

constexpr Method global_methods[] = {Method::best, Method::naive, Method::continued_fraction, Method::lattice};

inline Normal normal(const Plane& p) { return {p.n[0], p.n[1], p.n[2]}; }
inline Integer offset(const Plane& p) { return exact::to_integer(p.d); }
inline WidePlane wide(const Plane& p) { return {normal(p), offset(p)}; }
inline Integer content(const Normal& n) { return gcd(gcd(n[0], n[1]), n[2]); }
inline Normal direction(const Normal& n) {
  const Integer c = content(n);
  return {n[0] / c, n[1] / c, n[2] / c};
}
inline Integer dot_of(const Normal& a, const Normal& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

inline WidePlane plane(const Integer& a, const Integer& b, const Integer& c, const Integer& d) {
  return {{a, b, c}, d};
}
inline WidePlane rounded(const PlaneRounder& r, const WidePlane& p, Method method) {
  const auto q = r.round(p, method);
  EXPECT_TRUE(q.has_value()) << p.n[0] << ' ' << p.n[1] << ' ' << p.n[2] << ' ' << p.d;
  return q ? wide(*q) : WidePlane{};
}

/// 2^bits - 1 and the offset bound of its square.
inline PlaneRounder rounder(unsigned bits) {
  const Integer limit = power_of_2(bits) - 1;
  return {limit, limit * limit};
}
constexpr unsigned all_bits[] = {2, 3, 4, 5, 8, 12, 16, 24, 32, 40, 48, 56, 62};

/// A plane that does not fit L = 2^bits - 1; some offsets are beyond what any direction allows.
inline WidePlane random_large_plane(std::mt19937_64& random, unsigned bits) {
  for (;;) {
    const WidePlane p = random_plane(random, bits + 2 + static_cast<unsigned>(below(random, 60)));
    if (!rounder(bits).fits(p)) return p;
  }
}

}  // namespace quoin::rounding::testing
