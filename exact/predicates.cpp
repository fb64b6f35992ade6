#include "exact/predicates.h"

#include <algorithm>

namespace quoin::exact {
namespace {

/// Filter for `turn`: each of the six triple products carries three roundings of entries, two of products, and at most
/// three of additions: ((1 + u)^8 - 1) < 8.01 u relative to the permanent of magnitudes; 16 u leaves room for the
/// roundings of the permanent itself. Entries are integers, so nothing underflows. Proved by docs/proofs/turn_filter.g.
int turn_filter(const Plane& p, const Plane& q, const Plane& r) {
  const auto a = approximation(p).n, b = approximation(q).n, c = approximation(r).n;
  const double bc = b[1] * c[2], cb = b[2] * c[1], ca = b[2] * c[0], ac = b[0] * c[2], ab = b[0] * c[1],
               ba = b[1] * c[0];
  const double value = a[0] * (bc - cb) + a[1] * (ca - ac) + a[2] * (ab - ba);

  const double bound = (turn_bound * unit_roundoff) * (std::fabs(a[0]) * (std::fabs(bc) + std::fabs(cb)) +
                                                       std::fabs(a[1]) * (std::fabs(ca) + std::fabs(ac)) +
                                                       std::fabs(a[2]) * (std::fabs(ab) + std::fabs(ba)));
  if (value > bound) return 1;
  if (value < -bound) return -1;
  return 2;
}

/// The axis along which p's normal is longest; the first one of equals.
int dominant_axis(const Plane& p) {
  const auto size = [&p](std::size_t k) { return p.n[k] < 0 ? -p.n[k] : p.n[k]; };
  const int k = size(1) > size(0) ? 1 : 0;
  return size(2) > size(static_cast<std::size_t>(k)) ? 2 : k;
}

double largest(double a, double b, double c) { return std::max({std::fabs(a), std::fabs(b), std::fabs(c)}); }

}  // namespace

int compare_along(int k, const Point& u, const Point& v) {
  const auto i = static_cast<std::size_t>(k);
  if (u.approximation[i] != v.approximation[i]) {
    ++counters().filter;
    return u.approximation[i] < v.approximation[i] ? -1 : 1;
  }
  ++counters().fixed_width;
  return compare(u.x[i] * v.w, v.x[i] * u.w);
}

int compare_lexicographic(const Point& u, const Point& v) {
  for (int k = 0; k < 3; ++k)
    if (const int c = compare_along(k, u, v)) return c;
  return 0;
}

int turn(const Plane& p, const Plane& q, const Plane& r) {
  const int filtered = turn_filter(p, q, r);
  if (filtered != 2) {
    ++counters().filter;
    return filtered;
  }
  ++counters().fixed_width;
  const auto c = [](const Plane& plane, std::size_t k) { return Coefficient(plane.n[k]); };
  const auto minor = [&](std::size_t i, std::size_t j) { return c(q, i) * c(r, j) - c(q, j) * c(r, i); };
  return (c(p, 0) * minor(1, 2) + c(p, 1) * minor(2, 0) + c(p, 2) * minor(0, 1)).sign();
}

/// The sign of (xb - xa)(yc - ya) - (xc - xa)(yb - ya).
/// With u the unit roundoff, M the largest |x|, N the largest |y|, E and F the largest |difference| computed in x and
/// y:
///   a rounded coordinate is within u M of the true one, so a computed difference e is within u (2 M + |e|) of its own;
///   a product is within u (E (2 N + F) + F (2 M + E) + E F) + u^2 (2 M + E) (2 N + F), its rounding included;
///   two of them and the rounding of their difference (2 u E F): u (4 E N + 4 F M + 8 E F) + 2 u^2 (4 M) (4 N);
///   E <= 2 M and F <= 2 N (up to a factor 1 + u) give E F <= E N + F M: at most 12 u (E N + F M) + 32 u^2 M N.
/// The bound 16 u (E N + F M) + 64 u^2 M N leaves room for these factors and for the bound's own roundings. Coordinates
/// are 0 or at least 2^-188, hence multiples of 2^-240, and products of differences multiples of 2^-480; M, N >= 2^-188
/// unless they are 0, so the bound's smallest part is above 2^-480: no underflow.
/// Proved by docs/proofs/orientation_filter.g.
int projected_filter(const std::array<double, 2>& a, const std::array<double, 2>& b, const std::array<double, 2>& c) {
  const double qx = b[0] - a[0], rx = c[0] - a[0], qy = b[1] - a[1], ry = c[1] - a[1];
  const double value = qx * ry - rx * qy;

  const double m = largest(a[0], b[0], c[0]), n = largest(a[1], b[1], c[1]);
  const double e = std::max(std::fabs(qx), std::fabs(rx)), f = std::max(std::fabs(qy), std::fabs(ry));
  const double bound = (orientation_bound * unit_roundoff) * ((e + (orientation_tail * unit_roundoff) * m) * n + f * m);
  if (value > bound) return 1;
  if (value < -bound) return -1;
  return 2;
}

TripleValue projected_determinant(int k, const Point& a, const Point& b, const Point& c) {
  const auto i = static_cast<std::size_t>((k + 1) % 3), j = static_cast<std::size_t>((k + 2) % 3);
  const auto minor = [i, j](const Point& u, const Point& v) { return u.x[i] * v.x[j] - v.x[i] * u.x[j]; };
  return narrow<TripleValue::bits>(minor(a, b) * c.w + minor(b, c) * a.w + minor(c, a) * b.w);
}

int orientation_in_plane_exact(const Plane& p, const Point& a, const Point& b, const Point& c) {
  ++counters().fixed_width;
  const int k = dominant_axis(p);
  const int s = projected_determinant(k, a, b, c).sign();
  return p.n[static_cast<std::size_t>(k)] > 0 ? s : -s;
}

int orientation_in_plane(const Plane& p, const Point& a, const Point& b, const Point& c) {
  assert(!checked ||
         (scaled_value(p, a).sign() == 0 && scaled_value(p, b).sign() == 0 && scaled_value(p, c).sign() == 0));
  const int k = dominant_axis(p);
  const auto i = static_cast<std::size_t>((k + 1) % 3), j = static_cast<std::size_t>((k + 2) % 3);
  const auto planar = [i, j](const Point& u) { return std::array{u.approximation[i], u.approximation[j]}; };
  const int filtered = projected_filter(planar(a), planar(b), planar(c));
  if (filtered == 2) return orientation_in_plane_exact(p, a, b, c);
  ++counters().filter;
  return p.n[static_cast<std::size_t>(k)] > 0 ? filtered : -filtered;
}

int orientation(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& d) {
  std::array<std::int64_t, 3> u{}, v{}, w{};
  for (std::size_t k = 0; k < 3; ++k) {
    u[k] = std::int64_t{b.c[k]} - a.c[k];
    v[k] = std::int64_t{c.c[k]} - a.c[k];
    w[k] = std::int64_t{d.c[k]} - a.c[k];
  }
  const exact::int128 det = exact::int128(u[1] * v[2] - u[2] * v[1]) * w[0] +
                            exact::int128(u[2] * v[0] - u[0] * v[2]) * w[1] +
                            exact::int128(u[0] * v[1] - u[1] * v[0]) * w[2];
  return det > 0 ? 1 : det < 0 ? -1 : 0;
}

}  // namespace quoin::exact
