#include "rounding/reconstruction/placement.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "rounding/numbers/enclosure.h"

namespace quoin::rounding {
namespace {

/// An upper bound of the distance of the points from the origin.
Rational reach_of(const Polyhedron& p) {
  double most = 0;
  for (const Vector& v : p.points) {
    const double x = exact::to_double(v[0]), y = exact::to_double(v[1]), z = exact::to_double(v[2]);
    most = std::max(most, x * x + y * y + z * z);
  }
  // Far from under- and overflow all these roundings are less than 2^-40 of it.
  if (most > 0x1p-900 && most < 0x1p1000) return exact::to_rational(std::sqrt(most) * (1 + 0x1p-40));

  Rational square = 0;
  for (const Vector& v : p.points) square = std::max(square, dot(v, v));
  return root_above(square);
}

}  // namespace

Shape::Shape(Polyhedron p, const grid::Lattice& units)
    : polyhedron(std::move(p)),
      trihedral(rounding::trihedral(polyhedron)),
      to_model(inverse(rounding::to_grid(units))),
      reach(units.step * reach_of(polyhedron) + root_above(dot(units.origin, units.origin))) {}

const std::vector<Vector>& CarriedPoints::of(std::uint32_t placement) {
  std::vector<Vector>& points = points_[placement];
  const Placement& p = placements_[placement];
  if (points.empty())
    for (const Vector& v : p.shape->polyhedron.points) points.push_back(p.to_grid(v));
  return points;
}

void place_faces(const Placement& placement, booleans::Boundary& boundary) {
  const Polyhedron& p = placement.shape->polyhedron;
  boundary.faces = p.faces;
  boundary.labels.origins = p.origins;
  boundary.labels.polygons.append(p.provenance.begin(), p.provenance.end());
  if (!placement.is_turned_round()) return;

  auto& [face_start, loop_start, corners] = boundary.faces;
  for (std::size_t j = 0; j + 1 < loop_start.size(); ++j)
    std::reverse(corners.begin() + loop_start[j], corners.begin() + loop_start[j + 1]);
}

}  // namespace quoin::rounding
