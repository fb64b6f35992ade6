#include "rounding/planes/plane_rounding.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "exact/ladder.h"
#include "rounding/numbers/lattice.h"

namespace quoin::rounding {
namespace {

using Normal = std::array<Integer, 3>;

/// Whether a is closer to the direction n than b is.
bool closer(const Normal& a, const Normal& b, const Normal& n) {
  return squared_cross(a, n) * dot(b, b) < squared_cross(b, n) * dot(a, a);
}

}  // namespace

PlaneRounder::PlaneRounder() : PlaneRounder(exact::coefficient_limit, exact::to_integer(exact::offset_limit)) {}

PlaneRounder::PlaneRounder(Integer coefficient, Integer offset)
    : coefficient_(std::move(coefficient)), offset_(std::move(offset)) {
  assert(coefficient_ >= 1 && coefficient_ <= exact::coefficient_limit);
  assert(offset_ >= 1 && offset_ <= exact::to_integer(exact::offset_limit));
}

bool PlaneRounder::fits(const WidePlane& plane) const {
  return abs(plane.d) <= offset_ && abs(plane.n[longest_component(plane.n)]) <= coefficient_;
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
  if (abs(n[longest_component(n)]) <= coefficient_) return with_direction(plane, n);
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
  const Integer& top = n[longest_component(n)];
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
  const std::size_t k = longest_component(plane.n);
  // With the offset on top all fractions of the normal would be 0.
  if (abs(plane.d) > abs(plane.n[k]) * coefficient_) return std::nullopt;

  Integer root;
  mpz_root(root.backend().data(), coefficient_.backend().data(), 3);
  const auto fraction = [&](const Integer& v) { return best_approximation(Rational(v, abs(plane.n[k])), root); };
  const std::array<Rational, 4> f{fraction(plane.n[0]), fraction(plane.n[1]), fraction(plane.n[2]), fraction(plane.d)};
  // Of three fractions: the k-th is 1 or -1.
  const std::array<Integer, 4> p = over_common_denominator(f).numerators;
  return checked({p[0], p[1], p[2]}, p[3]);
}

std::optional<exact::Plane> PlaneRounder::with_direction(const WidePlane& plane, const Normal& direction) const {
  // The point of the plane nearest to the origin, -d n / n.n, stays on it.
  const Integer above = plane.d * dot(direction, plane.n), below = dot(plane.n, plane.n);
  Integer most = coefficient_ / abs(direction[longest_component(direction)]);
  if (above != 0) most = std::min<Integer>(most, offset_ * below / abs(above));
  if (most < 1) return std::nullopt;

  const Rational e = best_approximation(above, below, most);
  const Integer q = denominator(e);
  return checked({direction[0] * q, direction[1] * q, direction[2] * q}, numerator(e));
}

Normal PlaneRounder::naive_direction(const Normal& n) const {
  const Integer& top = n[longest_component(n)];
  Normal r;
  for (std::size_t i = 0; i < 3; ++i) r[i] = nearest_integer(Rational(n[i] * coefficient_, abs(top)));
  return primitive(r);
}

Normal PlaneRounder::continued_fraction_direction(const Normal& n) const {
  const Integer& top = n[longest_component(n)];
  const Integer root = sqrt(coefficient_);
  Vector f;
  for (std::size_t i = 0; i < 3; ++i) f[i] = best_approximation(Rational(n[i], abs(top)), root);
  return primitive(f);
}

// The vectors (q e, q v - x 2^s, q w - y 2^s) for v, w the ratios n_i / n_k and n_j / n_k times 2^s. With
// e = 2^s L^(-3/2) a short vector has q of about L and ratios wrong by about L^(-3/2).
Normal PlaneRounder::lattice_direction(const Normal& n) const {
  const std::size_t k = longest_component(n), i = (k + 1) % 3, j = (k + 2) % 3;
  const long bits = bit_length(coefficient_), s = 2 * bits + 16;
  const auto ratio = [&](std::size_t a) {
    return nearest_integer(Rational(n[a] << static_cast<unsigned long>(s), n[k]));
  };
  const Integer one = Integer(1) << static_cast<unsigned long>(s);
  const Integer weight = Integer(1) << static_cast<unsigned long>(s - 3 * bits / 2 - 2);
  std::vector<LatticeVector> basis{{weight, ratio(i), ratio(j)}, {0, one, 0}, {0, 0, one}};
  std::vector<LatticeVector> fractions{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}};  // (q, x, y)

  // A quarter of the weight, all of it, and four times as much.
  Normal best = naive_direction(n);
  for (int round = 0; round < 3; ++round) {
    reduce_basis(basis, fractions);
    for_small_combinations(fractions, [&](const LatticeVector& f) {
      const int sign = (f[0] < 0) == (n[k] < 0) ? 1 : -1;
      Normal r;
      r[k] = sign * f[0];
      r[i] = sign * f[1];
      r[j] = sign * f[2];
      if (f[0] != 0 && abs(r[longest_component(r)]) <= coefficient_ && closer(r, best, n)) best = r;
    });
    for (LatticeVector& v : basis) v[0] *= 4;
  }
  return primitive(best);
}

Rational squared_displacement(const exact::Plane& plane, std::span<const Vector> points) {
  Rational most = 0;
  const Integer d = exact::to_integer(plane.d);
  for (const Vector& p : points)
    most = std::max(most, magnitude(plane.n[0] * p[0] + plane.n[1] * p[1] + plane.n[2] * p[2] + d));

  const std::array<Integer, 3> n{plane.n[0], plane.n[1], plane.n[2]};
  return most * most / dot(n, n);
}

}  // namespace quoin::rounding
