// Rounding for the points of a face: face_local.
#include <algorithm>
#include <utility>

#include "rounding/numbers/lattice.h"
#include "rounding/planes/plane_rounding.h"

namespace quoin::rounding {
namespace {

/// About log2 |v|, to 1. Precondition: v is not 0.
long binary_logarithm(const Rational& v) { return bit_length(numerator(v)) - bit_length(denominator(v)); }

/// The square of twice the area.
Rational squared_area(const Vector& e, const Vector& f) {
  const Rational along = dot(e, f);
  return dot(e, e) * dot(f, f) - along * along;
}

/// Three points far apart and not in line.
std::array<Vector, 3> spanning(std::span<const Vector> points) {
  std::array<Vector, 3> r{points[0], points[0], points[0]};
  Rational most = -1;
  for (const Vector& p : points) {
    const Vector e = p - r[0];
    if (const Rational length = dot(e, e); length > most) {
      most = length;
      r[1] = p;
    }
  }

  const Vector f = r[1] - r[0];
  most = -1;
  for (const Vector& p : points) {
    if (const Rational area = squared_area(p - r[0], f); area > most) {
      most = area;
      r[2] = p;
    }
  }
  return r;
}

/// (N, D) -> (N . u0 + D, N . u1 + D, N . u2 + D) 2^s and the part of N along n, times `weight`.
std::vector<LatticeVector> values_at(const std::array<Vector, 3>& u, long s, const WidePlane& plane,
                                     const Integer& weight) {
  const Integer one = Integer(1) << static_cast<unsigned long>(s);
  const Integer top = abs(plane.n[longest_component(plane.n)]);
  std::vector<LatticeVector> basis;
  for (std::size_t i = 0; i < 4; ++i) {
    LatticeVector v(4);
    for (std::size_t j = 0; j < 3; ++j) v[j] = i < 3 ? nearest_integer(u[j][i] * one) : one;
    v[3] = i < 3 ? nearest_integer(Rational(plane.n[i] * weight, top)) : Integer(0);
    basis.push_back(std::move(v));
  }
  return basis;
}

}  // namespace

// The lattice of values_at has four dimensions. Its determinant is about A e 2^(3 s), A twice the area of the triangle,
// so that a short vector has N of about L and values of about (A / L)^(1/3): the points move by about
// A^(1/3) L^(-4/3).
std::optional<exact::Plane> PlaneRounder::round_near(const WidePlane& plane, std::span<const Vector> points) const {
  if (fits(plane)) return checked(plane.n, plane.d);
  if (!is_canonical(plane)) {
    const auto p = round_near(plane.opposite(), points);
    return p ? std::optional(p->opposite()) : std::nullopt;
  }

  std::optional<exact::Plane> best = round(plane, Method::best);
  Rational least = best ? squared_displacement(*best, points) : Rational(-1);
  const auto consider = [&](const LatticeVector& v) {
    const int sign = dot(Normal{v[0], v[1], v[2]}, plane.n) < 0 ? -1 : 1;
    const auto p = checked({sign * v[0], sign * v[1], sign * v[2]}, sign * v[3]);
    if (!p) return;
    const Rational moved = squared_displacement(*p, points);
    if (least >= 0 && moved >= least) return;
    least = moved;
    best = p;
  };

  const std::array<Vector, 3> u = spanning(points);
  const long area = binary_logarithm(squared_area(u[1] - u[0], u[2] - u[0])) / 2;
  const long bits = bit_length(coefficient_), s = 3 * bits + 64;
  for (const long shift : {-3L, 0L, 3L}) {
    const long size = s - (4 * bits - area) / 3 + shift;
    if (size < 1) continue;
    std::vector<LatticeVector> basis = values_at(u, s, plane, Integer(1) << static_cast<unsigned long>(size));
    std::vector<LatticeVector> planes{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
    reduce_basis(basis, planes);
    for_small_combinations(planes, consider);
  }
  return best;
}

}  // namespace quoin::rounding
