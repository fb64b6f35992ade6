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

/// Cells of a coarser lattice.
class Cells {
 public:
  Cells(const grid::Lattice& lattice, int level)
      : size_(std::ldexp(exact::to_double(lattice.step), level)),
        origin_{exact::to_double(lattice.origin[0]), exact::to_double(lattice.origin[1]),
                exact::to_double(lattice.origin[2])} {}

  /// Marks the cell of a point and those around it.
  void mark_around(const double* point) {
    const Cell c = cell(point);
    for (int i = 0; i < 27; ++i) marked_.push_back({c[0] + i / 9 - 1, c[1] + i / 3 % 3 - 1, c[2] + i % 3 - 1});
  }
  void end_of_marks() {
    std::sort(marked_.begin(), marked_.end());
    marked_.erase(std::unique(marked_.begin(), marked_.end()), marked_.end());
  }
  bool is_marked(const double* point) const { return std::binary_search(marked_.begin(), marked_.end(), cell(point)); }
  /// Moves the point to the nearest corner of a cell, each coordinate by half a cell at most, but for rounding.
  void snap(double* point) const {
    for (std::size_t k = 0; k < 3; ++k) point[k] = origin_[k] + std::nearbyint((point[k] - origin_[k]) / size_) * size_;
  }
  double size() const { return size_; }

 private:
  using Cell = std::array<std::int64_t, 3>;

  Cell cell(const double* point) const {
    Cell c{};
    for (std::size_t k = 0; k < 3; ++k) c[k] = static_cast<std::int64_t>(std::floor((point[k] - origin_[k]) / size_));
    return c;
  }

  double size_;
  std::array<double, 3> origin_;
  Array<Cell> marked_;
};

/// Snaps points near troubled ones to a coarser lattice. Returns an upper bound of their moves, the side of a cell:
/// half its diagonal is less than 7/8 of that. Corners of cells are numbers of the format; the quotients alone are
/// rounded, by far less than the rest.
double coarsen(std::vector<double>& points, const grid::Lattice& lattice, const Coarsening& coarsening) {
  Cells cells(lattice, coarsening.level);
  for (std::size_t i = 0; i < coarsening.troubled.size(); ++i)
    if (coarsening.troubled[i]) cells.mark_around(&points[3 * i]);
  cells.end_of_marks();

  double most = 0;
  for (std::size_t i = 0; i < points.size(); i += 3) {
    if (!cells.is_marked(&points[i])) continue;
    cells.snap(&points[i]);
    most = cells.size();
  }
  return most;
}

std::size_t distinct_count(std::span<const double> points) {
  Array<std::array<double, 3>> all;
  all.reserve(points.size() / 3);
  for (std::size_t i = 0; i < points.size(); i += 3) all.push_back({points[i], points[i + 1], points[i + 2]});
  std::sort(all.begin(), all.end());
  return static_cast<std::size_t>(std::unique(all.begin(), all.end()) - all.begin());
}

/// The multiple of 2^e nearest to x.
exact::Rational rounded_to(double x, int e) {
  const double scaled = std::ldexp(x, -e);
  return exact::to_rational(std::nearbyint(scaled)) * power_of_two(e);
}

}  // namespace

grid::Lattice lattice_of_numbers(const std::array<double, 3>& low, const std::array<double, 3>& high, Floats floats) {
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
  const int exponent = is_far ? needed : from_zero;
  lattice.step = power_of_two(exponent);
  if (is_far)
    for (std::size_t k = 0; k < 3; ++k) lattice.origin[k] = rounded_to(low[k] / 2 + high[k] / 2, exponent);
  return lattice;
}

Result<Mended> mended(std::span<const double> points, std::span<const std::uint32_t> triangles,
                      const TriangleLabels& labels, Floats floats, const Coarsening& coarsening, const Run& run) {
  Mended result;
  if (triangles.empty()) return result;
  std::array<double, 3> low{points[0], points[1], points[2]}, high = low;
  for (std::size_t i = 0; i < points.size(); ++i) {
    low[i % 3] = std::min(low[i % 3], points[i]);
    high[i % 3] = std::max(high[i % 3], points[i]);
  }
  result.lattice = lattice_of_numbers(low, high, floats);

  std::vector<double> coarse;
  if (coarsening.level > 0) {
    coarse.assign(points.begin(), points.end());
    result.most = coarsen(coarse, result.lattice, coarsening);
    result.merged_points = distinct_count(points) - distinct_count(coarse);
    points = coarse;
  }

  grid::Curing asked{{}, labels.origins != nullptr};
  auto mesh = grid::import_triangles(points, triangles, result.lattice, grid::Facing::any, &asked);
  if (!mesh) return mesh.error();
  result.merged_points += mesh.value().merged_points;
  result.vanished_triangles = mesh.value().zero_area_triangles;
  result.most += mesh.value().max_snap;

  Body body;
  body.grid_points = std::move(mesh.value().points);
  body.triangles = std::move(mesh.value().triangles);
  body.labels.origins = labels.origins;
  for (const std::uint32_t t : mesh.value().sources) body.labels.triangles.push_back(labels.of_triangle[t]);
  auto resolved = resolve(std::move(body), result.crossings, run);
  if (!resolved) return resolved.error();
  // A single surface that has been turned inside out has no inside.
  if (volume(resolved.value()) > 0) result.body = std::move(resolved).value();
  return result;
}

}  // namespace quoin::booleans
