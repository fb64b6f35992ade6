/// \file
/// Model generators: closed triangle meshes with known sizes, for examples, tests and measurements.
///
/// Every mesh is closed (each directed edge is balanced by its reverse), counter-clockwise seen from outside and of
/// positive volume. Every generator is a function of its arguments alone.
/// Precondition of all: radii, lengths and counts are positive unless a lower bound is stated.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "quoin/quoin.h"

namespace quoin::examples {

using Point = std::array<double, 3>;

/// Random numbers by splitmix64: the same sequence on every platform.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next();
  /// In [0, 1), a multiple of 2^-53.
  double unit();
  /// In [low, high].
  double between(double low, double high);
  /// Of length 1, evenly distributed.
  Point direction();

 private:
  std::uint64_t state_;
};

/// 12 triangles. `low` is below `high` in each coordinate.
Mesh box(const Point& low, const Point& high);

/// Latitudes and longitudes with fans at the poles: about `target_triangles` (at least 8), within its square root.
Mesh sphere(const Point& center, double radius, std::size_t target_triangles);

/// An icosahedron whose faces are divided into frequency^2 triangles each, projected to the sphere:
/// 20 frequency^2 triangles, none of them thin.
Mesh geodesic_sphere(const Point& center, double radius, std::uint32_t frequency);

/// A geodesic sphere of frequency 2^level: 20 * 4^level triangles, 1,280 at level 3. `level` is at most 12.
Mesh icosphere(const Point& center, double radius, unsigned level);

/// A geodesic sphere of about `target_triangles` whose radius varies by value noise of three octaves, at most +-15 %.
/// Star-shaped about its centre, so it never crosses itself. Two seeds in one place cross in long winding curves:
/// with 200,000 triangles each, in tens of thousands of segments.
Mesh bumpy_sphere(const Point& center, double radius, std::size_t target_triangles, std::uint64_t seed);

/// Axis z; 2 * along * around triangles. `tube` is below `radius`; both counts are at least 3.
Mesh torus(const Point& center, double radius, double tube, std::uint32_t along, std::uint32_t around);

/// The part of a torus from angle 0 to `angle` (radians, below 2 pi), its two ends closed by flat caps:
/// 2 * along * around + 2 * around triangles.
Mesh torus_cut(const Point& center, double radius, double tube, double angle, std::uint32_t along,
               std::uint32_t around);

/// How a torus knot winds: `p` times about the z axis and `q` times through the hole (coprime), on a torus of
/// `radius` and `minor`, as a tube of radius `tube`.
/// The tube must be thin enough not to meet its neighbouring strands; that is not checked.
struct Knot {
  std::uint32_t p = 2, q = 3;
  double radius = 1, minor = 0.4, tube = 0.15;
};

/// 2 * along * around triangles; both counts are at least 3.
Mesh torus_knot(const Point& center, const Knot& knot, std::uint32_t along, std::uint32_t around);

/// A prism over a regular polygon of `sides` (at least 3) corners about the axis from `from` to `to`:
/// 4 * sides triangles. The caps are fans from the end points of the axis.
Mesh cylinder(const Point& from, const Point& to, double radius, std::uint32_t sides);

/// A spur gear about the z axis from height `low` to `high`: 4 * teeth * steps triangles.
/// `steps` (at least 8) points make the profile of a tooth. A concave prism, star-shaped about its axis.
struct Gear {
  std::uint32_t teeth = 24, steps = 16;
  double root = 0.85, tip = 1;
  double low = -0.25, high = 0.25;
};
Mesh gear(const Gear& gear);

/// A slab whose upper and lower sides are ruled strips of `skinny_triangles` (at least 8) long thin diagonal
/// triangles in all, each nearly as long as the slab: the boxes of all of them overlap. `length` is measured along x
/// and y. Half as many short triangles more close the ends.
Mesh diagonal_strip(std::size_t skinny_triangles, double length);

/// `count` prisms through `center` in random directions, 2 * `half_length` long, of `sides` sides.
std::vector<Mesh> needles(std::size_t count, const Point& center, double half_length, double radius,
                          std::uint32_t sides, std::uint64_t seed);

/// The cells [i, i + 1] x [j, j + 1] x [k, k + 1] of the Menger sponge of size 3^level: 20^level cubes.
/// `level` is at most 4.
std::vector<Mesh> menger_cells(unsigned level);

/// Square prisms along x, y and z which, subtracted from the box (0, 0, 0) .. (3^level, ...), leave the same sponge:
/// 3 (8^level - 1) / 7 prisms, reaching out of the box by 1 on both sides. `level` is at most 4.
std::vector<Mesh> menger_holes(unsigned level);

/// n^3 cubes of size 1 whose low corners are `pitch` apart: they touch at 1 and overlap below.
std::vector<Mesh> cube_grid(std::uint32_t n, double pitch);

/// Drills for the plate (0, 0, 0) .. (columns, rows, 1): one cylinder of radius 0.3 in the middle of each unit square.
std::vector<Mesh> drills(std::uint32_t columns, std::uint32_t rows, std::uint32_t sides);

/// `count` spheres of `triangles` triangles with centres in the unit cube, so large that neighbours overlap.
std::vector<Mesh> sphere_cloud(std::size_t count, std::size_t triangles, std::uint64_t seed);

/// All parts in one mesh, vertices not merged.
Mesh joined(const std::vector<Mesh>& parts);

}  // namespace quoin::examples
