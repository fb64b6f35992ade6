#include "booleans/surface/rounded.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/filter_bounds.h"
#include "exact/predicates.h"
#include "grid/lists/stretches.h"

namespace quoin::booleans {

using exact::Rational;

namespace {

using Corner = std::array<double, 3>;

/// A normal of any length; components below 2^62.
using Normal = std::array<std::int64_t, 3>;

/// What rounding did to one triangle.
enum class Effect { none, flipped, collapsed };

/// The exact answer: the rounded corners and the normal as rationals.
Effect exact_effect(const std::array<Corner, 3>& c, const Normal& normal) {
  std::array<RationalPoint, 3> p;
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
/// Edges within 2^+-300 keep products from overflow; one of edge components that underflows is wrong by 2^-1075 at
/// most, 2^-1013 times a coefficient, far below the bound's second term. Proved by docs/proofs/effect_filter.g.
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
  const double bound =
      exact::effect_bound * exact::unit_roundoff * (size + exact::effect_floor * largest_e * largest_f);
  if (dot > bound) return Effect::none;
  if (dot < -bound) return Effect::flipped;
  return exact_effect(c, normal);
}

/// Triangles before this one are as they were: raw ones between grid points, where doubles hold all of these.
std::size_t first_changed(const Body& body, const Triangulated& mesh, const grid::Lattice& lattice, Floats floats) {
  const bool exact = floats == Floats::float64 && grid::Rounder(lattice).is_exact();
  if (!exact || !mesh.added.empty()) return 0;

  const auto raw = std::partition_point(mesh.face.begin(), mesh.face.end(),
                                        [&](std::uint32_t f) { return f < body.triangles.size(); });
  return static_cast<std::size_t>(raw - mesh.face.begin());
}

/// An upper bound of the distance of a number from those that round to it: half a unit in its last place.
double half_unit(double x, Floats floats) {
  const bool is_float = floats == Floats::float32;
  const int lowest = is_float ? -126 : -1022, digits = is_float ? 24 : 53;
  const int exponent = x == 0 ? lowest : std::max(std::ilogb(x), lowest);
  return std::max(std::ldexp(1.0, exponent - digits), std::numeric_limits<double>::denorm_min());
}

/// The same for what doubles hold exactly.
double distance_moved(double exact, double rounded) { return std::fabs(exact - rounded); }

/// An upper bound of the length of a vector of upper bounds.
double length_above(const std::array<double, 3>& d) {
  const double largest = std::max({d[0], d[1], d[2]});
  if (largest == 0) return 0;
  double sum = 0;
  for (const double x : d) sum += (x / largest) * (x / largest);
  // The roundings are far below 2^-40 of it; what is too small for them is a unit of its own.
  return largest * (std::sqrt(sum) * (1 + 0x1p-40)) + std::numeric_limits<double>::denorm_min();
}

}  // namespace

Moves moves(const Body& body, const Triangulated& mesh, const grid::Lattice& lattice, Floats floats,
            const std::vector<double>& points) {
  const grid::Rounder rounder(lattice);
  const bool is_exact = rounder.is_exact(), to_float = floats == Floats::float32;
  if (is_exact && !to_float && body.points.empty() && mesh.added.empty()) return {};

  constexpr std::size_t length = 4096;
  const std::size_t count = mesh.vertex_count();
  Moves all;
  all.moved.resize(count);
  all.first = first_changed(body, mesh, lattice, floats);
  std::vector<double> most(count / length + 1);
  grid::in_stretches(count, length, [&](std::size_t s, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const double* const p = points.data() + 3 * i;
      const bool is_grid = i < mesh.source.size() && body.is_grid(mesh.source[i]);
      if (is_grid && is_exact && !to_float) continue;

      std::array<double, 3> d{};
      for (int k = 0; k < 3; ++k) {
        const auto at = static_cast<std::size_t>(k);
        d[at] = is_grid && is_exact ? distance_moved(rounder.to_double(body.grid_points[mesh.source[i]][k], k), p[k])
                                    : half_unit(p[k], floats);
      }
      const double distance = length_above(d);
      all.moved[i] = distance > 0;
      most[s] = std::max(most[s], distance);
    }
  });

  all.most = *std::max_element(most.begin(), most.end());
  if (all.most == 0) all.moved.clear();
  return all;
}

std::vector<double> rounded_points(const Body& body, const Triangulated& mesh, const grid::Lattice& lattice,
                                   Floats floats) {
  const bool to_float = floats == Floats::float32;
  const std::size_t count = mesh.source.size();
  std::vector<double> points;
  grid::reserve_large(points, 3 * mesh.vertex_count());
  points.resize(3 * mesh.vertex_count());

  const grid::Rounder rounder(lattice);
  const auto round = [&](const auto& p, int k) -> double {
    return to_float ? rounder.to_float(p, k) : rounder.to_double(p, k);
  };
  grid::in_stretches(count, 1024, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t v = mesh.source[i];
      double* const place = points.data() + 3 * i;
      if (body.is_grid(v))
        for (int k = 0; k < 3; ++k) place[k] = round(body.grid_points[v][k], k);
      else
        for (int k = 0; k < 3; ++k) place[k] = round(body.derived(v), k);
    }
  });

  for (std::size_t i = 0; i < mesh.added.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const Rational x = lattice.origin[k] + lattice.step * mesh.added[i][k];
      points[3 * (count + i) + k] = to_float ? exact::to_float(x) : exact::to_double(x);
    }
  return points;
}

RoundingEffects rounding_effects(const Body& body, const Triangulated& mesh, const grid::Lattice& lattice,
                                 Floats floats, const std::vector<double>& points) {
  const std::size_t first = first_changed(body, mesh, lattice, floats), count = mesh.triangle_count() - first;
  constexpr std::size_t length = 1024;
  std::vector<RoundingEffects> parts(count / length + 1);
  grid::in_stretches(count, length, [&](std::size_t s, std::size_t begin, std::size_t end) {
    for (std::size_t t = first + begin; t < first + end; ++t) {
      std::array<Corner, 3> c;
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k) c[i][k] = points[3 * std::size_t{mesh.corners[3 * t + i]} + k];
      const Effect found = effect(c, body.sign_plane(mesh.face[t]).n);
      parts[s].flipped += found == Effect::flipped;
      parts[s].collapsed += found == Effect::collapsed;
    }
  });

  RoundingEffects sum;
  for (const RoundingEffects& part : parts) {
    sum.flipped += part.flipped;
    sum.collapsed += part.collapsed;
  }
  return sum;
}

}  // namespace quoin::booleans
