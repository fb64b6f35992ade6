/// \file
/// The predicates: every geometric question of the engine is one of these signs.
///
/// Laws (all exact, for any input within the bounds of exact/ladder.h):
///   P1  side(-p, u) = -side(p, u); side(p, u) = 0 exactly when u lies on p.
///   P2  compare_along(k, u, v) is a total order up to equal coordinates; compare_lexicographic is total, 0 exactly for
///       equal points.
///   P3  turn is antisymmetric in its arguments and odd in each.
///   P4  cross_sign(p, q, k) = -cross_sign(q, p, k).
///   P5  orientation_in_plane is antisymmetric in its points and odd in its plane; 0 exactly for collinear points.
/// Filters answer 2 ("undecided") rather than guess; nobody above this room sees an epsilon.
#pragma once

#include <cmath>

#include "exact/counters.h"
#include "exact/filter_bounds.h"
#include "exact/geometry.h"

namespace quoin::exact {

inline int sign(int128 v) { return v > 0 ? 1 : v < 0 ? -1 : 0; }

/// A plane in doubles, each coefficient rounded to nearest.
struct PlaneApproximation {
  std::array<double, 3> n;
  double d;
};

inline PlaneApproximation approximation(const Plane& p) {
  return {{static_cast<double>(p.n[0]), static_cast<double>(p.n[1]), static_cast<double>(p.n[2])},
          static_cast<double>(p.d)};
}

/// Filter for `side`. With u the unit roundoff each product carries three roundings (coefficient, coordinate, product),
/// the offset one, and each term passes through at most three additions, so the error is at most
/// ((1 + u)^6 - 1) S < 6.01 u S with S the sum of the terms' true magnitudes; the computed sum of magnitudes is at
/// least (1 - 6.01 u) S. 8 u times the computed sum bounds the error. No underflow: a non-zero coordinate is at least
/// 2^-188 in magnitude and a non-zero coefficient at least 1. Proved by docs/proofs/side_filter.g.
inline int side_filter(const PlaneApproximation& p, const std::array<double, 3>& u) {
  const double x = p.n[0] * u[0], y = p.n[1] * u[1], z = p.n[2] * u[2];
  const double value = (x + y) + (z + p.d);

  const double bound = (side_bound * unit_roundoff) * ((std::fabs(x) + std::fabs(y)) + (std::fabs(z) + std::fabs(p.d)));
  if (value > bound) return 1;
  if (value < -bound) return -1;
  return 2;
}

/// On which side of the plane the point lies: +1 where it is positive (outside), 0 on it, -1 inside.
inline int side(const Plane& p, const GridPoint& u) {
  ++counters().fixed_width;
  return sign(value(p, u));
}

/// The exact rung alone.
inline int side_exact(const Plane& p, const Point& u) {
  ++counters().fixed_width;
  return scaled_value(p, u).sign();
}

inline int side(const Plane& p, const Point& u) {
  const int filtered = side_filter(approximation(p), u.approximation);
  if (filtered != 2) {
    ++counters().filter;
    return filtered;
  }
  return side_exact(p, u);
}

/// Order of two numbers that have correctly rounded approximations: these decide where they differ, else `exactly()`.
template <class Exactly>
int compare_rounded(double a, double b, Exactly&& exactly) {
  return a < b ? -1 : a > b ? 1 : exactly();
}

/// Order of the k-th coordinates.
int compare_along(int k, const Point& u, const Point& v);
/// Order by (x, y, z); 0 exactly for equal points.
int compare_lexicographic(const Point& u, const Point& v);

/// The sign of det(n_p, n_q, n_r): on p, seen from its positive side, whether the direction n_p x n_r lies to the left
/// (+1) of n_p x n_q. Degree 3.
int turn(const Plane& p, const Plane& q, const Plane& r);

/// The orientation of three points of which two coordinates are given, correctly rounded: +1 or -1, or 2 where the
/// filter cannot tell.
int projected_filter(const std::array<double, 2>& a, const std::array<double, 2>& b, const std::array<double, 2>& c);
/// The determinant of the rows (x_i, x_j, w) of a, b, c with i = k + 1, j = k + 2 modulo 3: its sign is the orientation
/// of the points projected along axis k (denominators are positive). Degree 11: at most 4 (4 L^4)^2 (4 L^3) = 256 L^11.
TripleValue projected_determinant(int k, const Point& a, const Point& b, const Point& c);
/// The exact rung of `orientation_in_plane` alone.
int orientation_in_plane_exact(const Plane& p, const Point& a, const Point& b, const Point& c);
/// The orientation of (a, b, c) seen from p's positive side: +1 for counter-clockwise, 0 for collinear points, -1 for
/// clockwise. Precondition: the three points lie on p.
int orientation_in_plane(const Plane& p, const Point& a, const Point& b, const Point& c);

/// The sign of the volume of (a, b, c, d): +1 when d lies on the positive side of the plane through a, b, c.
/// Differences are at most 2^30, so the determinant is below 2^93.
int orientation(const exact::GridPoint& a, const exact::GridPoint& b, const exact::GridPoint& c,
                const exact::GridPoint& d);

/// The sign of component k of n_p x n_q. Degree 2, fits 128 bits.
inline int cross_sign(const Plane& p, const Plane& q, int k) {
  const auto i = static_cast<std::size_t>((k + 1) % 3), j = static_cast<std::size_t>((k + 2) % 3);
  const int128 a = int128(p.n[i]) * q.n[j], b = int128(p.n[j]) * q.n[i];
  return a > b ? 1 : a < b ? -1 : 0;
}

inline bool parallel(const Plane& p, const Plane& q) {
  return cross_sign(p, q, 0) == 0 && cross_sign(p, q, 1) == 0 && cross_sign(p, q, 2) == 0;
}

/// The sign of n_p . n_q. At most 3 L^2 fits 128 bits.
inline int dot_sign(const Plane& p, const Plane& q) {
  return sign(int128(p.n[0]) * q.n[0] + int128(p.n[1]) * q.n[1] + int128(p.n[2]) * q.n[2]);
}

}  // namespace quoin::exact
