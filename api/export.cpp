#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>

#include "api/access.h"
#include "api/run.h"
#include "booleans/export.h"
#include "exact/predicates.h"
#include "grid/balance.h"
#include "grid/stretches.h"

namespace quoin {

using booleans::Body;
using booleans::Triangulated;
using exact::Rational;

namespace {

using Corner = std::array<double, 3>;

/// Correctly rounded coordinates of the output vertices.
std::vector<double> rounded_points(const Body& body, const grid::Lattice& lattice,
                                   const std::vector<std::uint32_t>& source, bool to_float) {
  const grid::Rounder rounder(lattice);
  std::vector<double> points(3 * source.size());
  const auto round = [&](const auto& p, int k) -> double {
    return to_float ? rounder.to_float(p, k) : rounder.to_double(p, k);
  };
  grid::in_stretches(source.size(), 1024, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t v = source[i];
      for (std::size_t k = 0; k < 3; ++k) {
        const int axis = static_cast<int>(k);
        points[3 * i + k] = body.is_grid(v) ? round(body.grid_points[v][axis], axis) : round(body.derived(v), axis);
      }
    }
  });
  return points;
}

/// A normal of any length; components below 2^62.
using Normal = std::array<std::int64_t, 3>;

/// What rounding did to one triangle.
enum class Effect { none, flipped, collapsed };

/// The exact answer: the rounded corners and the normal as rationals.
Effect exact_effect(const std::array<Corner, 3>& c, const Normal& normal) {
  std::array<std::array<Rational, 3>, 3> p;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) p[i][k] = exact::to_rational(c[i][k]);
  Rational dot = 0;
  bool zero = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    const Rational cross = (p[1][i] - p[0][i]) * (p[2][j] - p[0][j]) - (p[1][j] - p[0][j]) * (p[2][i] - p[0][i]);
    zero = zero && cross == 0;
    dot += cross * normal[k];
  }
  return zero ? Effect::collapsed : dot < 0 ? Effect::flipped : Effect::none;
}

/// A term n (e f) of the dot product of the rounded triangle's normal with the plane's carries eight roundings at most:
/// the coefficient, two edge components, two products, the difference, two sums. So with u = 2^-53 and S the sum of the
/// terms' true sizes the error is below 8.01 u S, and S as computed is at least (1 - 8.01 u) S: 16 u S bounds it.
/// Edges within 2^+-300 keep products from overflow; a product that underflows is wrong by 2^-1074 at most, below the
/// bound's second term.
Effect effect(const std::array<Corner, 3>& c, const Normal& normal) {
  Corner e, f;
  double largest_e = 0, largest_f = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    e[k] = c[1][k] - c[0][k];
    f[k] = c[2][k] - c[0][k];
    largest_e = std::max(largest_e, std::fabs(e[k]));
    largest_f = std::max(largest_f, std::fabs(f[k]));
  }
  const auto ordinary = [](double x) { return x > 0x1p-300 && x < 0x1p300; };
  if (!ordinary(largest_e) || !ordinary(largest_f)) return exact_effect(c, normal);
  double dot = 0, size = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    const double n = static_cast<double>(normal[k]), x = e[i] * f[j], y = e[j] * f[i];
    dot += n * (x - y);
    size += std::fabs(n) * (std::fabs(x) + std::fabs(y));
  }
  const double bound = 16 * exact::unit_roundoff * (size + 0x1p-60 * largest_e * largest_f);
  if (dot > bound) return Effect::none;
  if (dot < -bound) return Effect::flipped;
  return exact_effect(c, normal);
}

struct Effects {
  std::uint64_t flipped = 0, collapsed = 0;
};

/// `first`: the triangles before it are not changed by rounding.
Effects count_effects(const Body& body, const Triangulated& mesh, const std::vector<double>& points,
                      std::size_t first) {
  using Range = tbb::blocked_range<std::size_t>;
  return tbb::parallel_reduce(
      Range(first, mesh.triangle_count(), 1024), Effects{},
      [&](const Range& range, Effects sum) {
        for (std::size_t t = range.begin(); t < range.end(); ++t) {
          std::array<Corner, 3> c;
          for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t k = 0; k < 3; ++k) c[i][k] = points[3 * std::size_t{mesh.corners[3 * t + i]} + k];
          const Effect found = effect(c, body.sign_plane(mesh.face[t]).n);
          sum.flipped += found == Effect::flipped;
          sum.collapsed += found == Effect::collapsed;
        }
        return sum;
      },
      [](const Effects& a, const Effects& b) {
        return Effects{a.flipped + b.flipped, a.collapsed + b.collapsed};
      });
}

Result<Mesh> exported(const Body& body, const grid::Lattice& lattice, const ExportOptions& options,
                      ExportReport* report) {
  // False when the run was cancelled.
  const auto begin = [&](const char* stage, double fraction) {
    if (options.run.stage) options.run.stage(stage);
    if (options.run.progress) options.run.progress(fraction);
    return !options.run.cancel || !options.run.cancel->load(std::memory_order_relaxed);
  };
  const Error cancelled{"cancelled", "the export was cancelled"};
  if (!begin("triangulate", 0)) return cancelled;
  Triangulated mesh = booleans::triangulated(body);
  if (!begin("separate", 0.4)) return cancelled;
  if (options.topology == Topology::manifold)
    mesh = booleans::separated(body, std::move(mesh), booleans::Pairing::by_distinct_edges);
  if (!begin("round", 0.7)) return cancelled;
  Mesh out;
  out.points = rounded_points(body, lattice, mesh.source, options.float32);
  if (!std::all_of(out.points.begin(), out.points.end(), [](double x) { return std::isfinite(x); }))
    return Error{"out-of-range", std::string("the solid reaches beyond the largest ") +
                                     (options.float32 ? "float32" : "double") + "; scale the model down"};
  if (report) {
    // Raw triangles come first.
    const bool exact = !options.float32 && grid::Rounder(lattice).is_exact();
    const auto raw = std::partition_point(mesh.face.begin(), mesh.face.end(),
                                          [&](std::uint32_t f) { return f < body.triangles.size(); });
    const Effects effects =
        count_effects(body, mesh, out.points, exact ? static_cast<std::size_t>(raw - mesh.face.begin()) : 0);
    *report = {mesh.triangle_count(), effects.flipped, effects.collapsed,
               grid::is_balanced(mesh.corners, mesh.source.size())};
  }
  out.triangles = std::move(mesh.corners);
  if (options.run.progress) options.run.progress(1);
  return out;
}

}  // namespace

Result<Mesh> Solid::to_triangles(const ExportOptions& options, ExportReport* report) const {
  if (report) *report = {};
  const Body& body = Access::operand(*this);
  if (body.full_at_infinity)
    return Error{"unbounded", "an unbounded solid has no triangle mesh; its complement may have one"};
  return with_threads(options.run.threads, [&] { return exported(body, Access::lattice(*this), options, report); });
}

}  // namespace quoin
