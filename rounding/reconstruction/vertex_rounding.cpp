#include "rounding/reconstruction/vertex_rounding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "booleans/body/measure.h"
#include "booleans/resolve.h"
#include "grid/import.h"
#include "rounding/motions/map_filter.h"
#include "rounding/reconstruction/displacement.h"
#include "rounding/reconstruction/refusals.h"

namespace quoin::rounding {
namespace {

using DoublePoint = std::array<double, 3>;

bool in_world(const DoublePoint& p) {
  return std::all_of(p.begin(), p.end(), [](double x) { return std::fabs(x) <= exact::world; });
}

/// The nearest grid point, and the square of an upper bound of its distance but for roundings below 2^-40 of it.
struct Snap {
  DoublePoint to;
  double squared_distance = 0;
};

/// By doubles; nothing where they do not tell the nearest point, or not whether the point is one of the grid's.
std::optional<Snap> filtered_snap(const MapFilter& filter, const Vector& p) {
  const DoublePoint approximation{exact::to_double(p[0]), exact::to_double(p[1]), exact::to_double(p[2])};
  const bool in_steps = are_whole(p) && in_world(approximation);
  // The square of what is at least this does not underflow.
  constexpr double least = 0x1p-500;

  Snap snap;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [value, error] = filter(k, approximation, in_steps);
    snap.to[k] = std::nearbyint(value);
    // What looks exact is not decided here, so that exact motions have the displacement 0.
    const double distance = std::fabs(value - snap.to[k]);
    const bool is_decided = error == 0 || (distance > error && distance > least && distance + error < 0.5);
    if (!is_decided) return std::nullopt;
    snap.squared_distance += (distance + error) * (distance + error);
  }
  return snap;
}

/// Exactly; `displacement` grows to an upper bound of the movement.
DoublePoint exact_snap(const Placement& placement, const IntegerMap& map, const Vector& p, Rational& displacement) {
  std::array<Integer, 3> q = map(p, 0);
  const DoublePoint nearest{exact::to_double(q[0]), exact::to_double(q[1]), exact::to_double(q[2])};
  if (placement.to_grid(p) != Vector{q[0], q[1], q[2]}) {
    for (Integer& x : q) x <<= unit_bits;
    displacement = std::max(displacement, distance_above(map(p, unit_bits), q));
  }
  return nearest;
}

/// The points of a shape at the grid points nearest to where they are carried, ties to even, three coordinates each;
/// nothing if one leaves the world. `displacement` becomes an upper bound of their movement.
std::optional<std::vector<double>> snapped_points(const Placement& placement, Rational& displacement) {
  const MapFilter filter(placement.to_grid);
  const IntegerMap map(placement.to_grid);
  std::vector<double> coordinates;
  double most = 0;  // the square of the largest movement, of points that the filter decides
  for (const Vector& p : placement.shape->polyhedron.points) {
    const auto snap = filtered_snap(filter, p);
    if (snap) most = std::max(most, snap->squared_distance);
    const DoublePoint nearest = snap ? snap->to : exact_snap(placement, map, p, displacement);
    if (!in_world(nearest)) return std::nullopt;
    coordinates.insert(coordinates.end(), nearest.begin(), nearest.end());
  }

  // The sums and the root are rounded: far less than 2^-40.
  displacement = std::max(displacement, exact::to_rational(std::sqrt(most) * (1 + 0x1p-40)));
  return coordinates;
}

/// How many points lie where an earlier one does.
std::uint64_t merged_points(const std::vector<double>& coordinates) {
  std::vector<DoublePoint> points;
  for (std::size_t i = 0; i < coordinates.size(); i += 3)
    points.push_back({coordinates[i], coordinates[i + 1], coordinates[i + 2]});

  std::sort(points.begin(), points.end());
  return static_cast<std::uint64_t>(points.end() - std::unique(points.begin(), points.end()));
}

/// Of the placed triangles, which a mirror image turns round.
std::vector<std::uint32_t> placed_corners(const Placement& placement,
                                          const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  std::vector<std::uint32_t> corners;
  const bool turned = placement.is_turned_round();
  for (const auto& t : triangles) corners.insert(corners.end(), {t[0], t[turned ? 2u : 1u], t[turned ? 1u : 2u]});
  return corners;
}

}  // namespace

Result<Reconstructed> round_vertices(std::uint32_t primitive, const Placement& placement, CarriedPoints& points) {
  const Shape& shape = *placement.shape;
  Reconstructed result;
  result.by_planes = false;
  const auto triangles = triangulated(shape.polyhedron);
  if (!triangles) return no_region(primitive);

  grid::Curing asked{{}, shape.polyhedron.origins != nullptr};
  const auto coordinates = snapped_points(placement, result.displacement);
  if (!coordinates) return out_of_range(primitive, points.of(primitive));
  auto mesh = grid::import_triangles(*coordinates, placed_corners(placement, triangles->corners), grid::Lattice{},
                                     grid::Facing::any, &asked);
  if (!mesh) {
    Error error = mesh.error();
    error.where = name_of(primitive);
    return error;
  }
  result.merged_points = merged_points(*coordinates);
  result.zero_area_triangles = mesh.value().zero_area_triangles;

  booleans::Body body;
  body.grid_points = std::move(mesh.value().points);
  body.triangles = std::move(mesh.value().triangles);
  body.labels.origins = shape.polyhedron.origins;
  for (const std::uint32_t t : mesh.value().sources)
    body.labels.triangles.push_back(shape.polyhedron.provenance[triangles->face[t]]);
  auto resolved = booleans::resolve(std::move(body), result.resolved_crossings);
  if (!resolved) return resolved.error();

  // What rounding has flattened or, as a whole, turned inside out has no inside.
  const bool is_solid = booleans::volume(resolved.value()) > 0;
  if (is_solid) result.body = std::move(resolved).value();
  result.vanished = !is_solid && !triangles->corners.empty();
  return result;
}

}  // namespace quoin::rounding
