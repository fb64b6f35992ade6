#include "rounding/reconstruction/exact_body.h"

#include <utility>

#include "booleans/body/boundary.h"
#include "rounding/planes/plane_rounding.h"

namespace quoin::rounding {
namespace {

/// The point in lowest terms, if it lies in the world and is as short as a meeting of three planes.
std::optional<exact::Point> point_of(const Vector& v) {
  const auto [n, common] = over_common_denominator(v);
  const auto w = exact::to_int<exact::Denominator::bits>(common);
  if (!w) return std::nullopt;

  exact::Point p{};
  p.w = *w;
  for (std::size_t k = 0; k < 3; ++k) {
    if (magnitude(v[k]) > exact::world) return std::nullopt;
    p.x[k] = *exact::to_int<exact::Numerator::bits>(n[k]);
    p.approximation[k] = exact::rounded_quotient(p.x[k], p.w);
  }
  return p;
}

}  // namespace

std::optional<booleans::Body> exact_body(std::uint32_t placement, const Placement& p, CarriedPoints& points) {
  const PlaneRounder rounder;
  const IntegerMap back = inverse(IntegerMap(p.to_grid));
  const auto carried = [&](const WidePlane& before) -> std::optional<exact::Plane> {
    const WidePlane plane = moved(before, back);
    return rounder.fits(plane) ? rounder.round(plane, Method::best) : std::nullopt;
  };

  booleans::Boundary boundary;
  for (const WidePlane& before : p.shape->polyhedron.planes) {
    const auto plane = carried(before);
    if (!plane) return std::nullopt;
    boundary.planes.push_back(*plane);
  }

  for (const Vector& v : points.of(placement)) {
    const auto q = point_of(v);
    if (!q) return std::nullopt;
    boundary.vertices.push_back(*q);
  }

  place_faces(p, boundary);
  for (const Polyhedron::Border& b : p.shape->polyhedron.borders) {
    const auto plane = carried(b.other);
    if (!plane) return std::nullopt;
    boundary.labels.borders.push_back({b.corner, *plane});
  }
  if (p.is_turned_round()) boundary.labels.reverse_loops(boundary.faces.loop_start);
  return booleans::body_of(boundary);
}

}  // namespace quoin::rounding
