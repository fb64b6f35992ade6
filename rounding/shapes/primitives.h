/// \file
/// Primitives as programs: exact polyhedra from a few rational numbers. Model units.
///
/// Circles and spheres are approximated by polygons (circle.h) and polyhedra whose vertices (inscribed) or planes
/// (circumscribed) are exactly where they should be.
/// Errors of all: "bad-primitive", a sentence that says which number does not fit.
#pragma once

#include <cstdint>
#include <vector>

#include "quoin/result.h"
#include "rounding/shapes/circle.h"
#include "rounding/shapes/polyhedron.h"

namespace quoin::rounding {

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
/// Regions of the plane z = 0, swept along a vector; their outlines in either orientation. Outlines must be simple and
/// must not touch; holes lie inside, regions apart.
Result<Polyhedron> extrusion(const std::vector<Region>& polygons, const Vector& along);

}  // namespace quoin::rounding
