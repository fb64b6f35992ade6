/// \file
/// Planes and points: the only numbers a solid carries.
///
/// Orientation: the normal (a, b, c) of a face's plane points out of the solid, so inside is where the plane is
/// negative. A loop runs counter-clockwise seen from outside. (CGAL's convention.)
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "exact/ladder.h"

namespace quoin::exact {

/// An integer point, grid steps.
struct GridPoint {
  std::array<std::int32_t, 3> c;
  std::int32_t operator[](int k) const { return c[static_cast<std::size_t>(k)]; }
  friend bool operator==(const GridPoint& p, const GridPoint& q) {
    return p.c[0] == q.c[0] && p.c[1] == q.c[1] && p.c[2] == q.c[2];  // = default calls memcmp
  }
  friend auto operator<=>(const GridPoint&, const GridPoint&) = default;
};

/// An oriented plane a x + b y + c z + d = 0 with bounded integer coefficients, always reduced (gcd 1): equal oriented
/// planes have equal coefficients. Grid steps.
struct Plane {
  std::array<std::int64_t, 3> n;  // the normal (a, b, c), not zero, each within +-L
  int128 d;                       // within +-L^2

  Plane opposite() const { return {{-n[0], -n[1], -n[2]}, -d}; }
  friend bool operator==(const Plane&, const Plane&) = default;
};

/// The index of the component of largest absolute value; of equal ones the first.
template <class T, std::size_t N>
std::size_t longest_component(const std::array<T, N>& v) {
  const auto size = [&v](std::size_t i) -> T { return v[i] < 0 ? T(-v[i]) : v[i]; };
  std::size_t k = 0;
  for (std::size_t i = 1; i < N; ++i)
    if (size(i) > size(k)) k = i;
  return k;
}

/// Total order by (a, b, c, d).
int compare(const Plane& p, const Plane& q);
/// Of the two orientations, the one whose first non-zero normal component is positive.
bool is_canonical(const Plane& p);
std::size_t hash(const Plane& p);

/// The reduced plane with these coefficients. Precondition: (a, b, c) is not zero, none of them is
/// -2^63, and the result is in bounds.
Plane reduced_plane(std::array<std::int64_t, 3> n, int128 d);
/// The plane through three grid points, normal (q - p) x (r - p): p, q, r are counter-clockwise seen from where it is
/// positive. Edge vectors are <= 2^30, normals <= 2^61 <= L, offsets < 2^92. Nothing when the points are collinear.
std::optional<Plane> plane_through(const GridPoint& p, const GridPoint& q, const GridPoint& r);
/// The same, not reduced: for signs, not for identity. Its normal is zero when the points are collinear.
Plane spanned_plane(const GridPoint& p, const GridPoint& q, const GridPoint& r);

/// The plane through an edge of grid points on the given plane and the axis in which that plane's normal is largest.
/// That axis is not parallel to the edge (the edge is perpendicular to the normal), and the new plane's normal lacks
/// that component, so the two planes are not parallel. Its coefficients are edge lengths, at most 2^30.
Plane upright_plane(const GridPoint& p, const GridPoint& q, const Plane& plane);

/// A point (x, y, z) / w with w > 0: a grid point (w = 1) or the meeting of three planes. Not reduced.
/// `approximation` holds the correctly rounded coordinates. Rounding is monotone and a function of the point alone:
/// equal points have equal approximations, and unequal approximations decide the order exactly. Never -0.
struct Point {
  std::array<Numerator, 3> x;
  Denominator w;
  std::array<double, 3> approximation;
};

/// Numerator / denominator rounded to the nearest double, ties to even; never -0. Precondition: denominator > 0.
double rounded_quotient(const Numerator& numerator, const Denominator& denominator);

Point point(const GridPoint& p);
/// Not told of a point that is not reduced.
inline bool is_grid(const Point& p) { return compare(p.w, Denominator(1)) == 0; }
/// Of coordinates that are those of a grid point.
inline GridPoint grid_point(const std::array<double, 3>& a) {
  return {{static_cast<std::int32_t>(a[0]), static_cast<std::int32_t>(a[1]), static_cast<std::int32_t>(a[2])}};
}
/// Precondition: is_grid(p), so that the approximation is exact.
inline GridPoint grid_point(const Point& p) { return grid_point(p.approximation); }
/// The meeting of three planes; nothing when their normals are dependent.
std::optional<Point> meet(const Plane& p, const Plane& q, const Plane& r);
/// Where segment (u, v) crosses the plane that has the values `at_u` and `at_v` there (at_u * at_v < 0):
/// (u at_v - v at_u) / (at_v - at_u); numerators are below 2^124.
Point meet(const GridPoint& u, int128 at_u, const GridPoint& v, int128 at_v);

/// The plane's value at a grid point: |a x + b y + c z + d| <= 3 * 2^91 + 2^124 fits 128 bits.
inline int128 value(const Plane& p, const GridPoint& u) {
  return int128(p.n[0]) * u[0] + int128(p.n[1]) * u[1] + int128(p.n[2]) * u[2] + p.d;
}
/// The plane's value at a point, times its denominator w > 0: degree 5.
SideValue scaled_value(const Plane& p, const Point& u);

}  // namespace quoin::exact
