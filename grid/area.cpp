#include "grid/area.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "exact/rational.h"

namespace quoin::grid {
namespace {

using exact::Rational;

/// Is (q - p) x (r - p) not 0? Signs of the two products in a component that differ say that it is not.
bool are_off_one_line(const double* p, const double* q, const double* r, Look look) {
  const auto order = [](double x, double y) { return static_cast<int>(x > y) - static_cast<int>(x < y); };
  bool undecided = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    const int left = order(q[i], p[i]) * order(r[j], p[j]), right = order(q[j], p[j]) * order(r[i], p[i]);
    if (left != right) return true;
    undecided = undecided || left != 0;
  }
  if (!undecided || look == Look::at_signs) return false;

  std::array<Rational, 3> u, v;
  for (std::size_t k = 0; k < 3; ++k) {
    u[k] = exact::to_rational(q[k]) - exact::to_rational(p[k]);
    v[k] = exact::to_rational(r[k]) - exact::to_rational(p[k]);
  }
  return u[0] * v[1] != u[1] * v[0] || u[1] * v[2] != u[2] * v[1] || u[2] * v[0] != u[0] * v[2];
}

}  // namespace

bool has_area(std::span<const double> points, std::span<const std::uint32_t> face, Look look) {
  if (face.empty()) return false;
  const auto at = [&](std::uint32_t v) { return &points[3 * std::size_t{v}]; };
  const double* p = at(face[0]);
  const auto differs = [&](std::uint32_t v) { return !std::equal(p, p + 3, at(v)); };
  const auto other = std::find_if(face.begin(), face.end(), differs);
  return std::any_of(other, face.end(), [&](std::uint32_t v) { return are_off_one_line(p, at(*other), at(v), look); });
}

}  // namespace quoin::grid
