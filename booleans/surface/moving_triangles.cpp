#include "booleans/surface/moving_triangles.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "exact/filter_bounds.h"

namespace quoin::booleans {
namespace {

using Vector = std::array<double, 3>;

Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

double largest(const Vector& v) { return std::max({std::fabs(v[0]), std::fabs(v[1]), std::fabs(v[2])}); }

/// Products of three such numbers neither overflow nor underflow.
bool is_ordinary(double v) { return v > 0x1p-200 && v < 0x1p200; }

/// A plane through a corner `base` with two directions, differences of corners or exact axes, wherever the corners are
/// within an error of where they are.
class MovingPlane {
 public:
  MovingPlane(double error, const Vector& base, const Vector& a, const Vector& b)
      : error_(2 * error), base_(base), normal_(cross(a, b)) {
    const double x = largest(a), y = largest(b), dx = off(x), dy = off(y);
    size_ = x * y;
    growth_ = dx * y + (x + dx) * dy;
    is_ordinary_ = is_ordinary(x) && is_ordinary(y);
  }

  /// The side of a corner, wherever it and the plane are; 0 if unknown. It is the sign of a determinant of three rows.
  /// Each of their components is off by the two corners' errors and by its own rounding, at most d = 2 error + 2 u
  /// |row|. So the product of the largest components grows by no more than `growth`, and each of the determinant's six
  /// terms with it. Ordinary rows keep all from overflow, and what underflows far below the bound.
  int side(const Vector& corner) const {
    const Vector c = corner - base_;
    const double z = largest(c);
    if (!is_ordinary_ || !is_ordinary(z)) return 0;

    const double value = c[0] * normal_[0] + c[1] * normal_[1] + c[2] * normal_[2];
    const double dz = off(z), growth = dz * size_ + (z + dz) * growth_;
    const double bound = 6 * growth * (1 + 0x1p-40) + exact::moving_bound * exact::unit_roundoff * (size_ * z);
    return value > bound ? 1 : value < -bound ? -1 : 0;
  }

  /// Does it have `own` strictly on one side and all others on the other one?
  bool parts(const Vector& own, std::initializer_list<const Vector*> others) const {
    const int at = side(own);
    return at != 0 && has(others, -at);
  }
  /// Does it have all of them strictly on one side?
  bool bounds(std::initializer_list<const Vector*> others) const {
    const int at = side(**others.begin());
    return at != 0 && has(others, at);
  }

 private:
  static Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
  double off(double size) const { return error_ + 2 * exact::unit_roundoff * size; }
  bool has(std::initializer_list<const Vector*> corners, int at) const {
    return std::all_of(corners.begin(), corners.end(), [&](const Vector* p) { return side(*p) == at; });
  }

  double error_;
  Vector base_, normal_;
  double size_, growth_;
  bool is_ordinary_;
};

constexpr std::array<Vector, 3> axes{Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}};

/// Do boxes part them?
bool boxes_part(const MovingTriangle& t, const MovingTriangle& u, double error) {
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [a, b] = std::minmax({t.at[0][k], t.at[1][k], t.at[2][k]});
    const auto [c, d] = std::minmax({u.at[0][k], u.at[1][k], u.at[2][k]});
    if (c - b > 4 * error || a - d > 4 * error) return true;
  }
  return false;
}

/// Triangles without a common corner.
bool strangers_part(double error, const MovingTriangle& t, const MovingTriangle& u) {
  const auto &p = t.at, &q = u.at;
  const auto plane = [&](const Vector& base, const Vector& a, const Vector& b) {
    return MovingPlane(error, base, a, b);
  };
  if (plane(p[0], p[1] - p[0], p[2] - p[0]).bounds({&q[0], &q[1], &q[2]})) return true;
  if (plane(q[0], q[1] - q[0], q[2] - q[0]).bounds({&p[0], &p[1], &p[2]})) return true;

  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    for (const Vector& axis : axes) {
      if (plane(p[i], p[j] - p[i], axis).parts(p[k], {&q[0], &q[1], &q[2]})) return true;
      if (plane(q[i], q[j] - q[i], axis).parts(q[k], {&p[0], &p[1], &p[2]})) return true;
    }
    for (std::size_t l = 0; l < 3; ++l)
      if (plane(p[i], p[j] - p[i], q[(l + 1) % 3] - q[l]).parts(p[k], {&q[0], &q[1], &q[2]})) return true;
  }
  return false;
}

/// Triangles whose first corner is the same.
bool part_at_corner(double error, const MovingTriangle& t, const MovingTriangle& u) {
  const auto &p = t.at, &q = u.at;
  const Vector& base = p[0];
  const auto plane = [&](const Vector& a, const Vector& b) { return MovingPlane(error, base, a, b); };
  if (plane(p[1] - base, p[2] - base).bounds({&q[1], &q[2]})) return true;
  if (plane(q[1] - base, q[2] - base).bounds({&p[1], &p[2]})) return true;

  for (std::size_t i = 1; i < 3; ++i) {
    for (const Vector& axis : axes) {
      if (plane(p[i] - base, axis).parts(p[3 - i], {&q[1], &q[2]})) return true;
      if (plane(q[i] - base, axis).parts(q[3 - i], {&p[1], &p[2]})) return true;
    }
    for (std::size_t j = 1; j < 3; ++j)
      if (plane(p[i] - base, q[j] - base).parts(p[3 - i], {&q[3 - j]})) return true;
  }
  return false;
}

/// Triangles whose first two corners are the same.
bool part_at_edge(double error, const MovingTriangle& t, const MovingTriangle& u) {
  const auto &p = t.at, &q = u.at;
  const Vector edge = p[1] - p[0];
  if (MovingPlane(error, p[0], edge, p[2] - p[0]).bounds({&q[2]})) return true;
  return std::any_of(axes.begin(), axes.end(),
                     [&](const Vector& axis) { return MovingPlane(error, p[0], edge, axis).parts(p[2], {&q[2]}); });
}

/// The sign of the turn from a to b, differences of corners, seen along axis k, wherever the corners are; 0 if unknown.
/// As of `MovingPlane::side`: each component is off by d = 2 error + 2 u |row| at most, so the product of the largest
/// components grows by `growth`, and each of both terms with it. What rounds besides is proved by
/// docs/proofs/moving_turn.g.
int moving_turn(double error, const Vector& a, const Vector& b, std::size_t k) {
  const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
  const double x = std::max(std::fabs(a[i]), std::fabs(a[j])), y = std::max(std::fabs(b[i]), std::fabs(b[j]));
  if (!is_ordinary(x) || !is_ordinary(y)) return 0;

  const double value = a[i] * b[j] - a[j] * b[i];
  const double dx = 2 * error + 2 * exact::unit_roundoff * x, dy = 2 * error + 2 * exact::unit_roundoff * y;
  const double growth = dx * y + (x + dx) * dy;
  const double bound = 2 * growth * (1 + 0x1p-40) + exact::moving_turn_bound * exact::unit_roundoff * (x * y);
  return value > bound ? 1 : value < -bound ? -1 : 0;
}

}  // namespace

std::size_t align(MovingTriangle& t, MovingTriangle& u) {
  std::size_t shared = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = shared; j < 3; ++j) {
      if (t.place[i] != u.place[j]) continue;
      std::swap(t.place[i], t.place[shared]);
      std::swap(t.at[i], t.at[shared]);
      std::swap(u.place[j], u.place[shared]);
      std::swap(u.at[j], u.at[shared]);
      ++shared;
      break;
    }
  return shared;
}

bool part_all_the_way(const MovingTriangle& t, const MovingTriangle& u, std::size_t shared) {
  const double error = std::max(t.error, u.error);
  switch (shared) {
    case 0:
      return boxes_part(t, u, error) || strangers_part(error, t, u);
    case 1:
      return part_at_corner(error, t, u);
    case 2:
      return part_at_edge(error, t, u);
    default:
      return false;
  }
}

unsigned facing(const MovingTriangle& t) {
  const Vector a = t.at[1] - t.at[0], b = t.at[2] - t.at[0];
  unsigned directions = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const int sign = moving_turn(t.error, a, b, k);
    directions |= unsigned(sign > 0) << (2 * k) | unsigned(sign < 0) << (2 * k + 1);
  }
  return directions;
}

}  // namespace quoin::booleans
