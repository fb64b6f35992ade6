#include "rounding/motions/affine_map.h"

#include <cassert>
#include <utility>

namespace quoin::rounding {

Vector operator+(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector operator*(const Rational& s, const Vector& v) { return {s * v[0], s * v[1], s * v[2]}; }
Rational dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

namespace {

Vector times(const Matrix& m, const Vector& v) { return {dot(m[0], v), dot(m[1], v), dot(m[2], v)}; }

Matrix times(const Matrix& a, const Matrix& b) {
  Matrix r;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) r[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
  return r;
}

}  // namespace

Vector AffineMap::operator()(const Vector& p) const { return times(linear, p) + shift; }

AffineMap composed(const AffineMap& first, const AffineMap& second) {
  return {times(second.linear, first.linear), second(first.shift)};
}

Rational determinant(const Matrix& m) { return dot(m[0], cross(m[1], m[2])); }

AffineMap inverse(const AffineMap& map) {
  const Rational d = determinant(map.linear);
  assert(d != 0);

  const std::array columns{cross(map.linear[1], map.linear[2]), cross(map.linear[2], map.linear[0]),
                           cross(map.linear[0], map.linear[1])};
  AffineMap r;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) r.linear[i][j] = columns[j][i] / d;
  r.shift = Rational(-1) * times(r.linear, map.shift);
  return r;
}

IntegerMap::IntegerMap(const AffineMap& map) {
  const auto& [x, y, z] = map.linear;
  const Vector& s = map.shift;
  const auto [n, common] =
      over_common_denominator(std::array{x[0], x[1], x[2], s[0], y[0], y[1], y[2], s[1], z[0], z[1], z[2], s[2]});

  for (std::size_t i = 0; i < 3; ++i) {
    linear[i] = {n[4 * i], n[4 * i + 1], n[4 * i + 2]};
    shift[i] = n[4 * i + 3];
  }
  divisor = common;
}

std::array<Integer, 3> IntegerMap::operator()(const Vector& p, unsigned bits) const {
  const auto [n, common] = over_common_denominator(p);
  std::array<Integer, 3> r;
  for (std::size_t i = 0; i < 3; ++i) {
    const Integer image = linear[i][0] * n[0] + linear[i][1] * n[1] + linear[i][2] * n[2] + shift[i] * common;
    r[i] = nearest_integer(Integer(image << bits), Integer(divisor * common));
  }
  return r;
}

// y = (A x + s) / D, so that x = C (D y - s) / t for the cofactors C of A, transposed and in lowest terms, and C A = t.
IntegerMap inverse(const IntegerMap& map) {
  const auto& a = map.linear;
  std::array<Integer, 9> cofactors;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const auto &p = a[(j + 1) % 3], &q = a[(j + 2) % 3];
      cofactors[3 * i + j] = p[(i + 1) % 3] * q[(i + 2) % 3] - p[(i + 2) % 3] * q[(i + 1) % 3];
    }

  const auto c = primitive(std::move(cofactors));
  Integer t = c[0] * a[0][0] + c[1] * a[1][0] + c[2] * a[2][0];
  assert(t != 0);

  const int sign = t.sign();
  IntegerMap r{AffineMap{}};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) r.linear[i][j] = sign * c[3 * i + j] * map.divisor;
    r.shift[i] = -sign * (c[3 * i] * map.shift[0] + c[3 * i + 1] * map.shift[1] + c[3 * i + 2] * map.shift[2]);
  }
  r.divisor = sign * t;
  return r;
}

}  // namespace quoin::rounding
