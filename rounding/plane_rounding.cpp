#include "rounding/plane_rounding.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "exact/ladder.h"
#include "rounding/lattice.h"

namespace quoin::rounding {
namespace {

using Normal = std::array<Integer, 3>;

long bit_length(const Integer& v) { return v == 0 ? 0 : static_cast<long>(mpz_sizeinbase(v.backend().data(), 2)); }

/// About log2 |v|, to 1. Precondition: v is not 0.
long binary_logarithm(const Rational& v) { return bit_length(numerator(v)) - bit_length(denominator(v)); }

using rounding::dot;
Integer dot(const Normal& a, const Normal& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// |a x b|^2
Integer squared_cross(const Normal& a, const Normal& b) {
  const Normal c{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  return dot(c, c);
}

/// Whether a is closer to the direction n than b is.
bool closer(const Normal& a, const Normal& b, const Normal& n) {
  return squared_cross(a, n) * dot(b, b) < squared_cross(b, n) * dot(a, a);
}

/// visit(coefficients) for all vectors of {-1, 0, 1}^size whose first non-zero number is 1.
template <class Visit>
void for_small_combinations(std::size_t size, Visit&& visit) {
  std::vector<int> c(size, -1);
  for (;;) {
    const auto first = std::find_if(c.begin(), c.end(), [](int v) { return v != 0; });
    if (first != c.end() && *first == 1) visit(c);
    std::size_t i = 0;
    while (i < size && c[i] == 1) c[i++] = -1;
    if (i == size) return;
    ++c[i];
  }
}

WidePlane in_lowest_terms(std::array<Integer, 4> p) {
  assert(p[0] != 0 || p[1] != 0 || p[2] != 0);
  p = primitive(std::move(p));
  return {{p[0], p[1], p[2]}, p[3]};
}

/// The combination of the rows.
LatticeVector combined(const std::vector<LatticeVector>& rows, const std::vector<int>& c) {
  LatticeVector sum(rows.front().size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = 0; j < sum.size() && c[i] != 0; ++j) sum[j] += c[i] * rows[i][j];
  return sum;
}

}  // namespace

std::size_t largest_component(const Normal& n) {
  std::size_t k = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (abs(n[i]) > abs(n[k])) k = i;
  return k;
}

WidePlane wide_plane(const Vector& normal, const Rational& offset) {
  const std::array v{normal[0], normal[1], normal[2], offset};
  return in_lowest_terms(whole(v, common_denominator(v)));
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

Rational squared_displacement(const exact::Plane& plane, std::span<const Vector> points) {
  Rational most = 0;
  const Integer d = exact::to_integer(plane.d);
  for (const Vector& p : points)
    most = std::max(most, magnitude(plane.n[0] * p[0] + plane.n[1] * p[1] + plane.n[2] * p[2] + d));
  const Normal n{plane.n[0], plane.n[1], plane.n[2]};
  return most * most / dot(n, n);
}

Rational squared_sine(const Normal& a, const Normal& b) { return Rational(squared_cross(a, b), dot(a, a) * dot(b, b)); }

PlaneRounder::PlaneRounder() : PlaneRounder(exact::coefficient_limit, exact::to_integer(exact::offset_limit)) {}

PlaneRounder::PlaneRounder(Integer coefficient, Integer offset)
    : coefficient_(std::move(coefficient)), offset_(std::move(offset)) {
  assert(coefficient_ >= 1 && coefficient_ <= exact::coefficient_limit);
  assert(offset_ >= 1 && offset_ <= exact::to_integer(exact::offset_limit));
}

bool PlaneRounder::fits(const WidePlane& plane) const {
  return abs(plane.d) <= offset_ && abs(plane.n[largest_component(plane.n)]) <= coefficient_;
}

/// The reduced plane; nothing where it does not fit or has no normal.
std::optional<exact::Plane> PlaneRounder::checked(const Normal& n, const Integer& d) const {
  if (n[0] == 0 && n[1] == 0 && n[2] == 0) return std::nullopt;
  if (!fits({n, d})) return std::nullopt;
  return exact::reduced_plane(
      {static_cast<std::int64_t>(n[0]), static_cast<std::int64_t>(n[1]), static_cast<std::int64_t>(n[2])},
      exact::to_int<exact::Offset::bits>(d)->low());
}

std::optional<exact::Plane> PlaneRounder::round(const WidePlane& plane, Method method) const {
  assert(method != Method::face_local);
  if (fits(plane)) return checked(plane.n, plane.d);
  if (!is_canonical(plane)) {
    const auto p = round(plane.opposite(), method);
    return p ? std::optional(p->opposite()) : std::nullopt;
  }
  if (method == Method::naive) return naive(plane);
  if (method == Method::continued_fraction) return continued_fraction(plane);
  const Normal n = primitive(plane.n);
  if (abs(n[largest_component(n)]) <= coefficient_) return with_direction(plane, n);
  return with_direction(plane, rounded_direction(n, method));
}

const Normal& PlaneRounder::rounded_direction(const Normal& n, Method method) const {
  const auto [at, fresh] = directions_.try_emplace({n, method});
  Normal& direction = at->second;
  if (!fresh) return direction;
  const Normal given = shortened(n);
  direction = lattice_direction(given);
  if (method == Method::best)
    for (const Normal& other : {continued_fraction_direction(given), naive_direction(given)})
      if (closer(other, direction, given)) direction = other;
  return direction;
}

/// A direction with numbers of many thousand digits, by its first 5 bits(L): far more than tell two normals apart.
PlaneRounder::Normal PlaneRounder::shortened(const Normal& n) const {
  const Integer& top = n[largest_component(n)];
  const long bits = 5 * bit_length(coefficient_) + 64;
  if (bit_length(top) <= 2 * bits) return n;
  Normal r;
  for (std::size_t i = 0; i < 3; ++i)
    r[i] = nearest_integer(Integer(n[i] << static_cast<unsigned long>(bits)), Integer(abs(top)));
  return r;
}

std::optional<exact::Plane> PlaneRounder::naive(const WidePlane& plane) const {
  // The coefficient that is largest against its bound.
  const std::array<Integer, 4> v{plane.n[0], plane.n[1], plane.n[2], plane.d};
  const auto limit = [&](std::size_t i) -> const Integer& { return i < 3 ? coefficient_ : offset_; };
  std::size_t k = 0;
  for (std::size_t i = 1; i < 4; ++i)
    if (abs(v[i]) * limit(k) > abs(v[k]) * limit(i)) k = i;
  const auto scaled = [&](std::size_t i) { return nearest_integer(Rational(v[i] * limit(k), abs(v[k]))); };
  return checked({scaled(0), scaled(1), scaled(2)}, scaled(3));
}

std::optional<exact::Plane> PlaneRounder::continued_fraction(const WidePlane& plane) const {
  const std::size_t k = largest_component(plane.n);
  // With the offset on top all fractions of the normal would be 0.
  if (abs(plane.d) > abs(plane.n[k]) * coefficient_) return std::nullopt;
  Integer root;
  mpz_root(root.backend().data(), coefficient_.backend().data(), 3);
  const auto fraction = [&](const Integer& v) { return best_approximation(Rational(v, abs(plane.n[k])), root); };
  const std::array<Rational, 4> f{fraction(plane.n[0]), fraction(plane.n[1]), fraction(plane.n[2]), fraction(plane.d)};
  // Of three fractions: the k-th is 1 or -1.
  const std::array<Integer, 4> p = whole(f, common_denominator(f));
  return checked({p[0], p[1], p[2]}, p[3]);
}

std::optional<exact::Plane> PlaneRounder::with_direction(const WidePlane& plane, const Normal& direction) const {
  // The point of the plane nearest to the origin, -d n / n.n, stays on it.
  const Integer above = plane.d * dot(direction, plane.n), below = dot(plane.n, plane.n);
  Integer most = coefficient_ / abs(direction[largest_component(direction)]);
  if (above != 0) most = std::min<Integer>(most, offset_ * below / abs(above));
  if (most < 1) return std::nullopt;
  const Rational e = best_approximation(above, below, most);
  const Integer q = denominator(e);
  return checked({direction[0] * q, direction[1] * q, direction[2] * q}, numerator(e));
}

Normal PlaneRounder::naive_direction(const Normal& n) const {
  const Integer& top = n[largest_component(n)];
  Normal r;
  for (std::size_t i = 0; i < 3; ++i) r[i] = nearest_integer(Rational(n[i] * coefficient_, abs(top)));
  return primitive(r);
}

Normal PlaneRounder::continued_fraction_direction(const Normal& n) const {
  const Integer& top = n[largest_component(n)];
  const Integer root = sqrt(coefficient_);
  Vector f;
  for (std::size_t i = 0; i < 3; ++i) f[i] = best_approximation(Rational(n[i], abs(top)), root);
  return primitive(whole(f, common_denominator(f)));
}

// The vectors (q e, q v - x 2^s, q w - y 2^s) for v, w the ratios n_i / n_k and n_j / n_k times 2^s. With
// e = 2^s L^(-3/2) a short vector has q of about L and ratios wrong by about L^(-3/2).
Normal PlaneRounder::lattice_direction(const Normal& n) const {
  const std::size_t k = largest_component(n), i = (k + 1) % 3, j = (k + 2) % 3;
  const long bits = bit_length(coefficient_), s = 2 * bits + 16;
  const auto ratio = [&](std::size_t a) {
    return nearest_integer(Rational(n[a] << static_cast<unsigned long>(s), n[k]));
  };
  const Integer one = Integer(1) << static_cast<unsigned long>(s);
  const Integer weight = Integer(1) << static_cast<unsigned long>(s - 3 * bits / 2 - 2);
  std::vector<LatticeVector> basis{{weight, ratio(i), ratio(j)}, {0, one, 0}, {0, 0, one}};
  std::vector<LatticeVector> fractions{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}};  // (q, x, y)
  Normal best = naive_direction(n);
  // A quarter of the weight, all of it, and four times as much.
  for (int round = 0; round < 3; ++round) {
    reduce_basis(basis, fractions);
    for_small_combinations(3, [&](const std::vector<int>& c) {
      const LatticeVector f = combined(fractions, c);
      const int sign = (f[0] < 0) == (n[k] < 0) ? 1 : -1;
      Normal r;
      r[k] = sign * f[0];
      r[i] = sign * f[1];
      r[j] = sign * f[2];
      if (f[0] != 0 && abs(r[largest_component(r)]) <= coefficient_ && closer(r, best, n)) best = r;
    });
    for (LatticeVector& v : basis) v[0] *= 4;
  }
  return primitive(best);
}

namespace {

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
    const Vector e = p - r[0];
    const Rational along = dot(e, f), area = dot(e, e) * dot(f, f) - along * along;
    if (area > most) {
      most = area;
      r[2] = p;
    }
  }
  return r;
}

}  // namespace

// (N, D) -> (N . u0 + D, N . u1 + D, N . u2 + D) 2^s and the part of N along n, weighted: a lattice of four dimensions.
// Its determinant is about A e 2^(3 s), A twice the area of the triangle, so that a short vector has N of about L and
// values of about (A / L)^(1/3): the points move by about A^(1/3) L^(-4/3).
std::optional<exact::Plane> PlaneRounder::round_near(const WidePlane& plane, std::span<const Vector> points) const {
  if (fits(plane)) return checked(plane.n, plane.d);
  if (!is_canonical(plane)) {
    const auto p = round_near(plane.opposite(), points);
    return p ? std::optional(p->opposite()) : std::nullopt;
  }
  std::optional<exact::Plane> best = round(plane, Method::best);
  Rational least = best ? squared_displacement(*best, points) : Rational(-1);
  const std::array<Vector, 3> u = spanning(points);
  const Vector e = u[1] - u[0], f = u[2] - u[0];
  const Rational along = dot(e, f);
  const long area = binary_logarithm(dot(e, e) * dot(f, f) - along * along) / 2;
  const long bits = bit_length(coefficient_), s = 3 * bits + 64;
  const Integer one = Integer(1) << static_cast<unsigned long>(s);
  const Integer& top = plane.n[largest_component(plane.n)];
  for (const long shift : {-3L, 0L, 3L}) {
    const long size = s - (4 * bits - area) / 3 + shift;
    if (size < 1) continue;
    const Integer weight = Integer(1) << static_cast<unsigned long>(size);
    std::vector<LatticeVector> basis, planes;
    for (std::size_t i = 0; i < 4; ++i) {
      LatticeVector v(4), plane_of_v(4);
      for (std::size_t j = 0; j < 3; ++j) v[j] = i < 3 ? nearest_integer(u[j][i] * one) : one;
      v[3] = i < 3 ? nearest_integer(Rational(plane.n[i] * weight, abs(top))) : Integer(0);
      plane_of_v[i] = 1;
      basis.push_back(std::move(v));
      planes.push_back(std::move(plane_of_v));
    }
    reduce_basis(basis, planes);
    for_small_combinations(4, [&](const std::vector<int>& c) {
      const LatticeVector v = combined(planes, c);
      Normal n{v[0], v[1], v[2]};
      Integer d = v[3];
      if (dot(n, plane.n) < 0) {
        for (Integer& x : n) x = -x;
        d = -d;
      }
      const auto p = checked(n, d);
      if (!p) return;
      const Rational moved = squared_displacement(*p, points);
      if (least >= 0 && moved >= least) return;
      least = moved;
      best = p;
    });
  }
  return best;
}

}  // namespace quoin::rounding
