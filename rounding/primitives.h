/// \file
/// Primitives as programs: exact polyhedra from a few rational numbers. Model units.
///
/// Circles and spheres are approximated by polygons and polyhedra whose vertices (inscribed) or planes (circumscribed)
/// are exactly where they should be: at rational points of the circle, (1 - t^2, 2 t) / (1 + t^2), close to equal
/// angles. The points of a full turn are symmetric about the axes and, but for those at 45 degrees, the diagonals.
/// Errors of all: "bad-primitive", a sentence that says which number does not fit.
#pragma once

#include <span>
#include <vector>

#include "quoin/result.h"
#include "rounding/polyhedron.h"

namespace quoin::rounding {

using PlanePoint = std::array<Rational, 2>;

/// How a polygon approximates a circle.
enum class Fit {
  inscribed,      // its corners lie on the circle
  circumscribed,  // its sides touch the circle
  equal_area,     // its area is that of the circle, to 2^-40 of it
};

/// The rational point of the unit circle closest to this angle among those of t = tan(angle / 2) with denominators up
/// to `precision` within an eighth of a turn.
PlanePoint circle_point(const Rational& degrees, const Integer& precision);
/// The corners of a polygon of `sides` sides about the origin, counter-clockwise. Precondition: sides >= 3, radius > 0.
std::vector<PlanePoint> circle_polygon(std::uint32_t sides, const Rational& radius, Fit fit);

/// [0, a] x [0, b] x [0, c].
Result<Polyhedron> block(const Vector& size);
/// The block's base with a top edge of length `top` along x, at height c, over the middle of the base. 5 faces.
Result<Polyhedron> wedge(const Vector& size, const Rational& top);
/// Between the polygon of radius `bottom` in z = 0 and that of radius `top` in z = height; one of them may be 0: a
/// cone, whose apex is no trihedral vertex if it has more than three sides.
Result<Polyhedron> frustum(std::uint32_t sides, const Rational& bottom, const Rational& top, const Rational& height,
                           Fit fit);
/// About the origin: `sides` meridians, sides / 2 bands; its vertices lie on the sphere. `sides` is even.
Result<Polyhedron> sphere(const Rational& radius, std::uint32_t sides);
/// The planes of a polyhedron around the sphere: each touches it, in points spread evenly along a spiral.
Result<std::vector<WidePlane>> tangent_sphere(const Rational& radius, std::uint32_t planes);
/// About the z-axis, the circle of radius `minor` turning at the distance `major`.
Result<Polyhedron> torus(const Rational& major, const Rational& minor, std::uint32_t sides, std::uint32_t minor_sides);
/// Polygons of the plane z = 0, swept along a vector. Each polygon is its outline and the outlines of its holes, in
/// either orientation. Outlines must be simple and must not touch; holes lie inside, polygons apart.
Result<Polyhedron> extrusion(const std::vector<std::vector<std::vector<PlanePoint>>>& polygons, const Vector& along);
/// The convex hull of points that do not lie in one plane, in any order, with repetitions. Expected O(n log n).
Result<Polyhedron> convex_hull(std::span<const Vector> points);

/// The bounded polyhedron of the points that are below or on all planes. Precondition: `inside` is below each. By the
/// hull of the dual points n / -value(inside), as above. Errors: also "unbounded".
Result<Polyhedron> convex_polyhedron(std::span<const WidePlane> planes, const Vector& inside);

}  // namespace quoin::rounding
