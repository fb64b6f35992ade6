#include "rounding/motions/quaternion.h"

#include <algorithm>
#include <utility>

namespace quoin::rounding {

Quaternion quaternion(Integer w, Integer x, Integer y, Integer z) {
  const auto v = primitive(std::array{std::move(w), std::move(x), std::move(y), std::move(z)});
  const Integer& first = *std::find_if(v.begin(), v.end(), [](const Integer& n) { return n != 0; });
  if (first < 0) return {-v[0], -v[1], -v[2], -v[3]};
  return {v[0], v[1], v[2], v[3]};
}

Quaternion composed(const Quaternion& p, const Quaternion& q) {
  return quaternion(q.w * p.w - q.x * p.x - q.y * p.y - q.z * p.z, q.w * p.x + q.x * p.w + q.y * p.z - q.z * p.y,
                    q.w * p.y - q.x * p.z + q.y * p.w + q.z * p.x, q.w * p.z + q.x * p.y - q.y * p.x + q.z * p.w);
}

Matrix matrix(const Quaternion& q) {
  const Integer ww = q.w * q.w, xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z;
  const Integer n = ww + xx + yy + zz;
  const auto entry = [&](const Integer& v) { return Rational(v, n); };
  return {
      Vector{entry(ww + xx - yy - zz), entry(2 * (q.x * q.y - q.w * q.z)), entry(2 * (q.x * q.z + q.w * q.y))},
      Vector{entry(2 * (q.x * q.y + q.w * q.z)), entry(ww - xx + yy - zz), entry(2 * (q.y * q.z - q.w * q.x))},
      Vector{entry(2 * (q.x * q.z - q.w * q.y)), entry(2 * (q.y * q.z + q.w * q.x)), entry(ww - xx - yy + zz)},
  };
}

namespace {

using Matrix4 = std::array<std::array<Rational, 4>, 4>;

/// 4 q q^T of the rotation's unit quaternion q, if m is a rotation.
Matrix4 quaternion_products(const Matrix& m) {
  return {
      std::array<Rational, 4>{1 + m[0][0] + m[1][1] + m[2][2], m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1]},
      {m[2][1] - m[1][2], 1 + m[0][0] - m[1][1] - m[2][2], m[0][1] + m[1][0], m[0][2] + m[2][0]},
      {m[0][2] - m[2][0], m[0][1] + m[1][0], 1 - m[0][0] + m[1][1] - m[2][2], m[1][2] + m[2][1]},
      {m[1][0] - m[0][1], m[0][2] + m[2][0], m[1][2] + m[2][1], 1 - m[0][0] - m[1][1] + m[2][2]}};
}

/// Each row is proportional to the quaternion: the one of largest diagonal.
const std::array<Rational, 4>& largest_row(const Matrix4& products) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < 4; ++i)
    if (products[i][i] > products[best][best]) best = i;
  return products[best];
}

Rational largest(const std::array<Rational, 4>& v) { return magnitude(v[longest_component(v)]); }

/// The largest entry of m m^T - 1.
Rational defect(const Matrix& m) {
  Rational r = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) r = std::max(r, magnitude(dot(m[i], m[j]) - (i == j ? 1 : 0)));
  return r;
}

}  // namespace

std::optional<Quaternion> quaternion_along(const std::array<Rational, 4>& v) {
  if (largest(v) == 0) return std::nullopt;
  const std::array<Integer, 4> q = primitive(v);
  return quaternion(q[0], q[1], q[2], q[3]);
}

std::optional<Quaternion> exact_rotation(const Matrix& m) {
  if (defect(m) != 0 || determinant(m) != 1) return std::nullopt;
  return quaternion_along(largest_row(quaternion_products(m)));
}

namespace {

/// Of the quaternion that replaces a matrix.
constexpr unsigned matrix_bits = 62;

/// The eigenvector of the largest eigenvalue, about 4, of a symmetric matrix whose other eigenvalues are about 0, to
/// 2^-128 or so (B. K. P. Horn, 1987). Each step gains 20 bits.
std::array<Rational, 4> first_eigenvector(const Matrix4& m) {
  const Integer unit = Integer(1) << 128;
  std::array<Rational, 4> v = largest_row(m);
  for (int step = 0; step < 8; ++step) {
    std::array<Rational, 4> next{0, 0, 0, 0};
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 4; ++j) next[i] += m[i][j] * v[j];

    const Rational size = largest(next);
    for (std::size_t i = 0; i < 4; ++i) v[i] = naive_approximation(next[i] / size, unit);
  }
  return v;
}

}  // namespace

std::optional<Quaternion> nearest_rotation(const Matrix& m, Rational& deviation) {
  if (defect(m) > Rational(1, 1000000) || determinant(m) < 0) return std::nullopt;
  deviation = 0;
  if (auto q = exact_rotation(m)) return q;

  std::array<Rational, 4> v = first_eigenvector(quaternion_products(m));
  for (Rational& x : v) x = nearest_integer(x * ((Integer(1) << matrix_bits) - 1));
  const Quaternion q = *quaternion_along(v);

  const Matrix used = matrix(q);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) deviation = std::max(deviation, magnitude(used[i][j] - m[i][j]));
  return q;
}

}  // namespace quoin::rounding
