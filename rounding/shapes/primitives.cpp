#include "rounding/shapes/primitives.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include "rounding/numbers/enclosure.h"

namespace quoin::rounding {
namespace {

using Index = std::uint32_t;

/// The highest number of sides: more would be millions of faces.
constexpr Index most_sides = 1 << 16;

std::optional<Error> sides_fault(Index sides, Index least) {
  if (sides >= least && sides <= most_sides) return std::nullopt;
  return bad_primitive("the number of sides must be between " + std::to_string(least) + " and " +
                       std::to_string(most_sides) + ", not " + std::to_string(sides));
}

std::optional<Error> positive_fault(const Rational& v, const char* what) {
  if (v > 0) return std::nullopt;
  return bad_primitive(std::string("the ") + what + " must be positive, not " + exact::to_string(v));
}

std::vector<Index> run(Index begin, Index count) {
  std::vector<Index> r(count);
  std::iota(r.begin(), r.end(), begin);
  return r;
}

std::vector<Index> backward(std::vector<Index> v) {
  std::reverse(v.begin(), v.end());
  return v;
}

/// The ring of points i, i + 1, .. at a height; returns the index of its first point.
Index add_ring(Polyhedron& p, std::span<const PlanePoint> ring, const Rational& height) {
  const auto first = static_cast<Index>(p.points.size());
  for (const PlanePoint& v : ring) p.add_point({v[0], v[1], height});
  return first;
}

/// Four-sided faces between two rings of `count` points, counter-clockwise seen from outside.
void add_band(Polyhedron& p, Index low, Index high, Index count) {
  for (Index i = 0; i < count; ++i) {
    const Index j = grid::next_in_loop(i, count);
    p.add_face(std::array{low + i, low + j, high + j, high + i});
  }
}

/// Triangles between a ring and a point above (+1) or below (-1).
void add_fan(Polyhedron& p, Index ring, Index apex, Index count, int side) {
  for (Index i = 0; i < count; ++i) {
    const Index j = grid::next_in_loop(i, count);
    p.add_face(side > 0 ? std::array{ring + i, ring + j, apex} : std::array{ring + j, ring + i, apex});
  }
}

}  // namespace

Result<Polyhedron> block(const Vector& size) {
  for (const Rational& x : size)
    if (auto fault = positive_fault(x, "size of a block")) return *fault;
  return extrusion({{{{0, 0}, {size[0], 0}, {size[0], size[1]}, {0, size[1]}}}}, {0, 0, size[2]});
}

Result<Polyhedron> wedge(const Vector& size, const Rational& top) {
  for (const Rational& x : size)
    if (auto fault = positive_fault(x, "size of a wedge")) return *fault;
  if (auto fault = positive_fault(top, "top edge of a wedge")) return *fault;

  Polyhedron p;
  add_ring(p, std::array<PlanePoint, 4>{{{0, 0}, {size[0], 0}, {size[0], size[1]}, {0, size[1]}}}, 0);
  p.add_point({(size[0] - top) / 2, size[1] / 2, size[2]});
  p.add_point({(size[0] + top) / 2, size[1] / 2, size[2]});

  p.add_face(std::array<Index, 4>{3, 2, 1, 0});
  p.add_face(std::array<Index, 4>{0, 1, 5, 4});
  p.add_face(std::array<Index, 4>{2, 3, 4, 5});
  p.add_face(std::array<Index, 3>{1, 2, 5});
  p.add_face(std::array<Index, 3>{3, 0, 4});
  return p;
}

Result<Polyhedron> frustum(std::uint32_t sides, const Rational& bottom, const Rational& top, const Rational& height,
                           Fit fit) {
  if (auto fault = sides_fault(sides, 3)) return *fault;
  if (auto fault = positive_fault(height, "height")) return *fault;
  if (bottom < 0 || top < 0 || (bottom == 0 && top == 0)) return bad_primitive("a radius is negative, or both are 0");

  const Outline unit = circle_polygon(sides, 1, fit);
  Polyhedron p;
  const auto add_end = [&](const Rational& radius, const Rational& z) {
    if (radius == 0) return p.add_point({0, 0, z});
    Outline ring = unit;
    for (PlanePoint& v : ring) v = {v[0] * radius, v[1] * radius};
    return add_ring(p, ring, z);
  };

  const Index low = add_end(bottom, 0), high = add_end(top, height);
  if (bottom > 0) p.add_face(backward(run(low, sides)));
  if (top > 0) p.add_face(run(high, sides));
  if (bottom == 0)
    add_fan(p, high, low, sides, -1);
  else if (top == 0)
    add_fan(p, low, high, sides, 1);
  else
    add_band(p, low, high, sides);
  return p;
}

Result<Polyhedron> sphere(const Rational& radius, std::uint32_t sides) {
  if (auto fault = sides_fault(sides, 4)) return *fault;
  if (auto fault = positive_fault(radius, "radius")) return *fault;
  if (sides % 2 != 0) return bad_primitive("a sphere must have an even number of sides, not " + std::to_string(sides));
  if (sides > 4096) return bad_primitive("a sphere of more than 4096 sides has too many faces");

  const Outline unit = circle_polygon(sides, 1, Fit::inscribed);
  Polyhedron p;
  const Index south = p.add_point({0, 0, -radius}), bands = sides / 2;
  Index ring = 0;
  for (Index k = 1; k < bands; ++k) {
    // Of a half turn from south to north.
    const PlanePoint at = circle_point(Rational(180) * k / bands - 90, circle_precision());
    Outline points = unit;
    for (PlanePoint& v : points) v = {v[0] * at[0] * radius, v[1] * at[0] * radius};
    const Index next = add_ring(p, points, at[1] * radius);
    if (k == 1)
      add_fan(p, next, south, sides, -1);
    else
      add_band(p, ring, next, sides);
    ring = next;
  }
  add_fan(p, ring, p.add_point({0, 0, radius}), sides, 1);
  return p;
}

Result<std::vector<WidePlane>> tangent_sphere(const Rational& radius, std::uint32_t planes) {
  if (auto fault = sides_fault(planes, 4)) return *fault;
  if (auto fault = positive_fault(radius, "radius")) return *fault;

  std::vector<WidePlane> r;
  for (Index k = 0; k < planes; ++k) {
    // Equal steps of height, each turned by the golden angle; (s, t) is the point seen from the south pole.
    const Rational z = 1 - Rational(2 * k + 1, planes);
    const Rational distance = best_approximation(root_above((1 - z) / (1 + z)), 1 << 10);
    const PlanePoint turn = circle_point(Rational(137508, 1000) * k, 1 << 8);
    const Rational s = distance * turn[0], t = distance * turn[1];
    r.push_back(wide_plane({2 * s, 2 * t, 1 - s * s - t * t}, -radius * (1 + s * s + t * t)));
  }
  return r;
}

Result<Polyhedron> torus(const Rational& major, const Rational& minor, std::uint32_t sides, std::uint32_t minor_sides) {
  for (const Index n : {sides, minor_sides})
    if (auto fault = sides_fault(n, 3)) return *fault;
  if (std::uint64_t{sides} * minor_sides > 1 << 22)
    return bad_primitive("a torus of more than 2^22 faces is too large");
  if (auto fault = positive_fault(minor, "minor radius")) return *fault;
  if (major <= minor) return bad_primitive("the major radius of a torus must exceed its minor radius");

  const Outline turn = circle_polygon(sides, 1, Fit::inscribed);
  const Outline section = circle_polygon(minor_sides, minor, Fit::inscribed);
  Polyhedron p;
  for (const PlanePoint& v : section) {
    Outline ring = turn;
    for (PlanePoint& q : ring) q = {q[0] * (major + v[0]), q[1] * (major + v[0])};
    add_ring(p, ring, v[1]);
  }

  for (Index k = 0; k < minor_sides; ++k) add_band(p, k * sides, grid::next_in_loop(k, minor_sides) * sides, sides);
  return p;
}

namespace {

/// The rings of a region's outlines at one end of an extrusion.
using Rings = std::vector<std::vector<Index>>;

/// A horizontal face, whatever its first corners turn. Its plane looks up or down.
void add_cap(Polyhedron& p, const Rings& rings, bool looks_up) {
  const int up = looks_up ? 1 : -1;
  p.planes.push_back(wide_plane({0, 0, up}, -up * p.points[rings.front()[0]][2]));
  p.faces.face_start.push_back(p.faces.face_start.back());
  for (const auto& ring : rings) p.add_loop(looks_up ? ring : backward(ring));
}

}  // namespace

Result<Polyhedron> extrusion(const std::vector<Region>& polygons, const Vector& along) {
  if (along[2] == 0)
    return bad_primitive("an extrusion along a vector parallel to the plane of its polygons has an area, no volume");
  const auto regions = oriented(polygons);
  if (!regions) return regions.error();

  Polyhedron p;
  for (const Region& region : regions.value()) {
    Rings low, high;
    for (const Outline& outline : region) {
      const auto count = static_cast<Index>(outline.size());
      Outline shifted = outline;
      for (PlanePoint& v : shifted) v = {v[0] + along[0], v[1] + along[1]};
      low.push_back(run(add_ring(p, outline, 0), count));
      high.push_back(run(add_ring(p, shifted, along[2]), count));
      if (along[2] < 0) std::swap(low.back(), high.back());
    }

    add_cap(p, low, false);
    add_cap(p, high, true);
    for (std::size_t l = 0; l < low.size(); ++l) add_band(p, low[l][0], high[l][0], static_cast<Index>(low[l].size()));
  }
  return p;
}

}  // namespace quoin::rounding
