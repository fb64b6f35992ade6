#include "exact/geometry.h"

#include <bit>
#include <numeric>

#include "exact/filter_bounds.h"

namespace quoin::exact {
namespace {

std::uint64_t magnitude(std::int64_t v) {
  return v < 0 ? ~static_cast<std::uint64_t>(v) + 1 : static_cast<std::uint64_t>(v);
}
uint128 magnitude(int128 v) { return v < 0 ? ~static_cast<uint128>(v) + 1 : static_cast<uint128>(v); }

/// A 2x2 minor of plane coefficients, p q' - q p'.
template <int A, int B>
auto minor(const Int<A>& a, const Int<B>& b, const Int<A>& c, const Int<B>& d) {
  return a * d - c * b;
}

}  // namespace

int compare(const Plane& p, const Plane& q) {
  for (std::size_t k = 0; k < 3; ++k)
    if (p.n[k] != q.n[k]) return p.n[k] < q.n[k] ? -1 : 1;
  return p.d == q.d ? 0 : p.d < q.d ? -1 : 1;
}

bool is_canonical(const Plane& p) {
  if (p.n[0] != 0) return p.n[0] > 0;
  return p.n[1] != 0 ? p.n[1] > 0 : p.n[2] > 0;
}

std::size_t hash(const Plane& p) {
  std::uint64_t h = 0x9E3779B97F4A7C15u;
  const auto mix = [&h](std::uint64_t v) {
    h = (h ^ v) * 0xFF51AFD7ED558CCDu;
    h ^= h >> 32;
  };
  for (std::int64_t v : p.n) mix(static_cast<std::uint64_t>(v));
  mix(static_cast<std::uint64_t>(p.d));
  mix(static_cast<std::uint64_t>(p.d >> 64));
  return h;
}

Plane reduced_plane(std::array<std::int64_t, 3> n, int128 d) {
  std::uint64_t g = std::gcd(magnitude(n[0]), magnitude(n[1]));
  if (g != 1) g = std::gcd(g, magnitude(n[2]));  // mostly it is
  assert(g != 0);
  if (g > 1) {
    g = std::gcd(g, static_cast<std::uint64_t>(magnitude(d) % g));
    if (g > 1) {
      for (std::int64_t& v : n) v /= static_cast<std::int64_t>(g);
      d /= static_cast<std::int64_t>(g);
    }
  }
  return {n, d};
}

Plane spanned_plane(const GridPoint& p, const GridPoint& q, const GridPoint& r) {
  std::array<std::int64_t, 3> e{}, f{}, n{};
  for (int k = 0; k < 3; ++k) {
    e[static_cast<std::size_t>(k)] = std::int64_t{q[k]} - p[k];
    f[static_cast<std::size_t>(k)] = std::int64_t{r[k]} - p[k];
  }
  n[0] = e[1] * f[2] - e[2] * f[1];
  n[1] = e[2] * f[0] - e[0] * f[2];
  n[2] = e[0] * f[1] - e[1] * f[0];
  return {n, -(int128(n[0]) * p[0] + int128(n[1]) * p[1] + int128(n[2]) * p[2])};
}

std::optional<Plane> plane_through(const GridPoint& p, const GridPoint& q, const GridPoint& r) {
  const Plane plane = spanned_plane(p, q, r);
  if (plane.n[0] == 0 && plane.n[1] == 0 && plane.n[2] == 0) return std::nullopt;
  return reduced_plane(plane.n, plane.d);
}

double rounded_quotient(const Numerator& numerator, const Denominator& denominator) {
  const Leading n = leading(numerator);
  if (n.top == 0) return 0.0;
  const Leading d = leading(denominator);
  // q = floor(2^63 n.top / d.top), in [2^62, 2^64): n.top < 2 d.top.
  std::uint64_t q = static_cast<std::uint64_t>((uint128(n.top) << 63) / d.top);
  const int scale = n.exponent - d.exponent - 63;  // the quotient is about q * 2^scale

  // The true q lies in [q - 2, q + 3]: each operand is exact to a factor in [1, 1 + 2^-63). Proved by
  // docs/proofs/quotient.g.
  const double low = static_cast<double>(q - quotient_below), high = static_cast<double>(q + quotient_above);
  double rounded = low;
  if (low != high) {
    // Exact: r = n 2^-scale - q d, or n - q d 2^scale; both sides are below 2^320.
    Int<384> a = numerator.negative() ? -numerator : numerator, b = denominator;
    if (scale < 0)
      a = shifted_left(a, -scale);
    else
      b = shifted_left(b, scale);
    const Int<65> factor{static_cast<int128>(q)};
    Int<384> r = narrow<384>(a - narrow<384>(factor * b));

    while (r.negative()) {
      r = narrow<384>(r + b);
      --q;
    }
    while (compare(r, b) >= 0) {
      r = narrow<384>(r - b);
      ++q;
    }
    // q >= 2^61 has at least 8 bits below the 53 kept ones, so its lowest bit can carry "something is left".
    rounded = static_cast<double>(q | (r.sign() != 0 ? 1U : 0U));
  }

  // Below 2^251 over below 2^189, both at least 1: |scale| < 320, so the factor and the result are normal.
  const double result = rounded * std::bit_cast<double>(static_cast<std::uint64_t>(scale + 1023) << 52);
  return numerator.negative() ? -result : result;
}

namespace {

void approximate(Point& p) {
  for (std::size_t k = 0; k < 3; ++k) p.approximation[k] = rounded_quotient(p.x[k], p.w);
}

}  // namespace

Point point(const GridPoint& p) {
  Point r;
  for (std::size_t k = 0; k < 3; ++k) {
    r.x[k] = Numerator(p.c[k]);
    r.approximation[k] = p.c[k];
  }
  r.w = Denominator(1);
  return r;
}

std::optional<Point> meet(const Plane& p, const Plane& q, const Plane& r) {
  const auto coefficient = [](const Plane& plane, std::size_t k) { return Coefficient(plane.n[k]); };
  const Coefficient a1 = coefficient(p, 0), b1 = coefficient(p, 1), c1 = coefficient(p, 2);
  const Coefficient a2 = coefficient(q, 0), b2 = coefficient(q, 1), c2 = coefficient(q, 2);
  const Coefficient a3 = coefficient(r, 0), b3 = coefficient(r, 1), c3 = coefficient(r, 2);
  const Offset d1(p.d), d2(q.d), d3(r.d);

  // Minors of the normals, shared by w and the numerators.
  const auto bc23 = minor(b2, c2, b3, c3), bc31 = minor(b3, c3, b1, c1), bc12 = minor(b1, c1, b2, c2);
  const auto ca23 = minor(c2, a2, c3, a3), ca31 = minor(c3, a3, c1, a1), ca12 = minor(c1, a1, c2, a2);
  const auto ab23 = minor(a2, b2, a3, b3), ab31 = minor(a3, b3, a1, b1), ab12 = minor(a1, b1, a2, b2);

  Point u;
  u.w = narrow<Denominator::bits>(a1 * bc23 + a2 * bc31 + a3 * bc12);
  const int s = u.w.sign();
  if (s == 0) return std::nullopt;

  // Cramer: x = -det(d, b, c), y = -det(a, d, c), z = -det(a, b, d).
  u.x[0] = -narrow<Numerator::bits>(d1 * bc23 + d2 * bc31 + d3 * bc12);
  u.x[1] = -narrow<Numerator::bits>(d1 * ca23 + d2 * ca31 + d3 * ca12);
  u.x[2] = -narrow<Numerator::bits>(d1 * ab23 + d2 * ab31 + d3 * ab12);
  if (s < 0) {
    u.w = -u.w;
    for (Numerator& x : u.x) x = -x;
  }
  approximate(u);
  return u;
}

Point meet(const GridPoint& u, int128 at_u, const GridPoint& v, int128 at_v) {
  assert((at_u < 0) != (at_v < 0) && at_u != 0 && at_v != 0);
  const bool flip = at_v < at_u;  // makes the denominator positive
  Point r;
  r.w = Denominator(flip ? at_u - at_v : at_v - at_u);
  for (std::size_t k = 0; k < 3; ++k) {
    const int128 x = at_v * u.c[k] - at_u * v.c[k];
    r.x[k] = Numerator(flip ? -x : x);
  }
  approximate(r);
  return r;
}

SideValue scaled_value(const Plane& p, const Point& u) {
  return (Coefficient(p.n[0]) * u.x[0] + Coefficient(p.n[1]) * u.x[1]) +
         (Coefficient(p.n[2]) * u.x[2] + Offset(p.d) * u.w);
}

Plane upright_plane(const GridPoint& p, const GridPoint& q, const Plane& plane) {
  const std::size_t k = longest_component(plane.n), i = (k + 1) % 3, j = (k + 2) % 3;

  std::array<std::int64_t, 3> n{};
  n[i] = std::int64_t{q.c[j]} - p.c[j];
  n[j] = std::int64_t{p.c[i]} - q.c[i];
  return reduced_plane(n, -(int128(n[i]) * p.c[i] + int128(n[j]) * p.c[j]));
}

}  // namespace quoin::exact
