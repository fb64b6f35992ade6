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
  booleans::Boundary boundary;
  for (const WidePlane& before : p.shape->polyhedron.planes) {
    const WidePlane plane = moved(before, back);
    if (!rounder.fits(plane)) return std::nullopt;
    boundary.planes.push_back(*rounder.round(plane, Method::best));
  }

  for (const Vector& v : points.of(placement)) {
    const auto q = point_of(v);
    if (!q) return std::nullopt;
    boundary.vertices.push_back(*q);
  }

  boundary.faces = placed_loops(p);
  return booleans::body_of(boundary);
}

}  // namespace quoin::rounding
