#include "booleans/surface/rational_triangles.h"

#include <algorithm>

namespace quoin::booleans {

using exact::Rational;

RationalPoint normal(const RationalTriangle& t) {
  RationalPoint n;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    n[k] = (t[1][i] - t[0][i]) * (t[2][j] - t[0][j]) - (t[1][j] - t[0][j]) * (t[2][i] - t[0][i]);
  }
  return n;
}

namespace {

RationalPoint rational_point(const std::array<double, 3>& p) {
  return {exact::to_rational(p[0]), exact::to_rational(p[1]), exact::to_rational(p[2])};
}

int sign_of(const Rational& x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

int side(const RationalTriangle& t, const RationalPoint& p) {
  const RationalPoint n = normal(t);
  Rational dot = 0;
  for (std::size_t k = 0; k < 3; ++k) dot += n[k] * (p[k] - t[0][k]);
  return sign_of(dot);
}

/// The turn a, b, c seen along axis k.
int turn(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c, std::size_t k) {
  const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
  return sign_of((b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]));
}

/// Is c, collinear with a and b, between them, seen along axis k?
bool is_between(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c, std::size_t k) {
  const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
  return std::min(a[i], b[i]) <= c[i] && c[i] <= std::max(a[i], b[i]) && std::min(a[j], b[j]) <= c[j] &&
         c[j] <= std::max(a[j], b[j]);
}

/// Do closed segments of one plane meet? Seen along an axis that is not in the plane.
bool segments_meet(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c, const RationalPoint& d,
                   std::size_t k) {
  const int abc = turn(a, b, c, k), abd = turn(a, b, d, k), cda = turn(c, d, a, k), cdb = turn(c, d, b, k);
  if (abc * abd < 0 && cda * cdb < 0) return true;
  return (abc == 0 && is_between(a, b, c, k)) || (abd == 0 && is_between(a, b, d, k)) ||
         (cda == 0 && is_between(c, d, a, k)) || (cdb == 0 && is_between(c, d, b, k));
}

/// Do a closed segment and a closed triangle of their plane meet?
bool meet_in_plane(const RationalPoint& p, const RationalPoint& q, const RationalTriangle& t) {
  const RationalPoint n = normal(t);
  const std::size_t k = n[0] != 0 ? 0 : n[1] != 0 ? 1 : 2;
  bool inside = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const RationalPoint &a = t[i], &b = t[(i + 1) % 3];
    if (segments_meet(p, q, a, b, k)) return true;
    inside = inside && turn(a, b, p, k) == sign_of(n[k]);
  }
  return inside;
}

/// Do a closed segment and a closed triangle share a point? Precondition: the triangle has an area.
bool meet(const RationalPoint& p, const RationalPoint& q, const RationalTriangle& t) {
  const int at_p = side(t, p), at_q = side(t, q);
  if (at_p == 0 && at_q == 0) return meet_in_plane(p, q, t);
  if (at_p * at_q > 0) return false;

  int lowest = 1, highest = -1;
  for (std::size_t i = 0; i < 3; ++i) {
    const int s = side({p, t[i], t[(i + 1) % 3]}, q);
    lowest = std::min(lowest, s);
    highest = std::max(highest, s);
  }
  return lowest >= 0 || highest <= 0;
}

}  // namespace

RationalTriangle rational(const std::array<std::array<double, 3>, 3>& t) {
  return {rational_point(t[0]), rational_point(t[1]), rational_point(t[2])};
}

bool meet_out_of_place(const RationalTriangle& t, const RationalTriangle& u, std::size_t shared) {
  if (shared == 0) {
    for (std::size_t i = 0; i < 3; ++i)
      if (meet(t[i], t[(i + 1) % 3], u) || meet(u[i], u[(i + 1) % 3], t)) return true;
    return false;
  }
  // What they have in common is convex: it reaches a side opposite to the corner.
  if (shared == 1) return meet(t[1], t[2], u) || meet(u[1], u[2], t);

  if (shared == 3) return true;
  if (side(t, u[2]) != 0) return false;
  const RationalPoint n = normal(t);
  const std::size_t k = n[0] != 0 ? 0 : n[1] != 0 ? 1 : 2;
  return turn(t[0], t[1], t[2], k) == turn(t[0], t[1], u[2], k);
}

std::optional<int> passage(const RationalPoint& from, std::size_t k, bool up, const RationalTriangle& t) {
  const std::array<int, 3> turns{turn(t[0], t[1], from, k), turn(t[1], t[2], from, k), turn(t[2], t[0], from, k)};
  const auto [least, most] = std::minmax({turns[0], turns[1], turns[2]});
  if (least < 0 && most > 0) return 0;
  if (least == 0 || most == 0) return std::nullopt;

  const int looks = most;  // along +k
  const int at = side(t, from);
  const bool is_ahead = at == (up == (looks > 0) ? -1 : 1);
  if (at == 0) return std::nullopt;
  return is_ahead ? (up ? looks : -looks) : 0;
}

}  // namespace quoin::booleans
