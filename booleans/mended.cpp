#include "booleans/mended.h"

#include <algorithm>
#include <cmath>

#include "booleans/body/measure.h"
#include "booleans/resolve.h"
#include "grid/import.h"

namespace quoin::booleans {
namespace {

/// The least e with x <= 2^e; `least` for smaller ones.
int exponent_above(double x, int least) {
  if (x <= std::ldexp(1.0, least)) return least;
  const int e = std::ilogb(x);
  return std::ldexp(1.0, e) == x ? e : e + 1;
}

/// 2^e, exactly.
exact::Rational power_of_two(int e) {
  const exact::Integer p = exact::Integer(1) << static_cast<unsigned>(std::abs(e));
  return e < 0 ? exact::Rational(exact::Integer(1), p) : exact::Rational(p);
}

/// The multiple of 2^e nearest to x.
exact::Rational rounded_to(double x, int e) {
  const double scaled = std::ldexp(x, -e);
  return exact::to_rational(std::nearbyint(scaled)) * power_of_two(e);
}

}  // namespace

grid::Lattice lattice_of_numbers(const std::array<double, 3>& low, const std::array<double, 3>& high, Floats floats,
                                 int coarser) {
  double largest = 0, size = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    largest = std::max({largest, std::fabs(low[k]), std::fabs(high[k])});
    size = std::max(size, high[k] / 2 - low[k] / 2);
  }

  const bool is_float = floats == Floats::float32;
  constexpr int steps = 28, digits = 53, far = 10;
  const int least = is_float ? -149 : -1074;
  const int above = exponent_above(largest, least);
  const int from_zero = std::max(above - (is_float ? 24 : steps), least);
  const int needed = is_float ? from_zero : std::max({exponent_above(size, least) - steps, above + 1 - digits, least});

  grid::Lattice lattice;
  const bool is_far = from_zero - needed > far;
  const int exponent = (is_far ? needed : from_zero) + coarser;
  lattice.step = power_of_two(exponent);
  if (is_far && exponent < from_zero)
    for (std::size_t k = 0; k < 3; ++k) lattice.origin[k] = rounded_to(low[k] / 2 + high[k] / 2, exponent);
  return lattice;
}

Result<Mended> mended(std::span<const double> points, std::span<const std::uint32_t> triangles, Floats floats,
                      int coarser, const Run& run) {
  Mended result;
  if (triangles.empty()) return result;
  std::array<double, 3> low{points[0], points[1], points[2]}, high = low;
  for (std::size_t i = 0; i < points.size(); ++i) {
    low[i % 3] = std::min(low[i % 3], points[i]);
    high[i % 3] = std::max(high[i % 3], points[i]);
  }
  result.lattice = lattice_of_numbers(low, high, floats, coarser);

  auto mesh = grid::import_triangles(points, triangles, result.lattice, grid::Facing::any);
  if (!mesh) return mesh.error();
  result.merged_points = mesh.value().merged_points;
  result.vanished_triangles = mesh.value().zero_area_triangles;
  result.most = mesh.value().max_snap;

  Body body;
  body.grid_points = std::move(mesh.value().points);
  body.triangles = std::move(mesh.value().triangles);
  auto resolved = resolve(std::move(body), result.crossings, run);
  if (!resolved) return resolved.error();
  // A single surface that has been turned inside out has no inside.
  if (volume(resolved.value()) > 0) result.body = std::move(resolved).value();
  return result;
}

}  // namespace quoin::booleans
