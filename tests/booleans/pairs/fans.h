/// \file
/// Meshes with large fans, and their pairs of triangles that meet out of place, by looking at all pairs.
#pragma once

#include <cmath>
#include <numbers>
#include <set>

#include "booleans/pairs/operands.h"
#include "booleans/pairs/triangle_pair.h"
#include "tests/booleans/support.h"

namespace quoin::booleans::testing {

/// Does a pair of triangles meet anywhere but in a common corner or edge?
inline bool meets_improperly(const Body& mesh, std::uint32_t s, std::uint32_t t) {
  const auto &a = mesh.triangles[s], &b = mesh.triangles[t];
  const auto has = [](const Triangle& triangle, std::uint32_t v) {
    return std::find(triangle.begin(), triangle.end(), v) != triangle.end();
  };
  std::vector<std::uint32_t> common, only_a, only_b;
  for (const std::uint32_t v : a) (has(b, v) ? common : only_a).push_back(v);
  for (const std::uint32_t v : b)
    if (!has(a, v)) only_b.push_back(v);

  const auto& p = mesh.grid_points;
  switch (common.size()) {
    case 0:
      return meet(triangle(mesh, s), triangle(mesh, t));
    case 1:
      return meet(p[only_a[0]], p[only_a[1]], triangle(mesh, t)) || meet(p[only_b[0]], p[only_b[1]], triangle(mesh, s));
    case 2: {
      const auto n = exact::plane_through(p[common[0]], p[common[1]], p[only_a[0]]),
                 m = exact::plane_through(p[common[0]], p[common[1]], p[only_b[0]]);
      return *n == *m;
    }
    default:
      return true;
  }
}

inline std::set<FacePair> improper_by_pairs(const Body& mesh) {
  std::set<FacePair> pairs;
  for (std::uint32_t s = 0; s < mesh.triangles.size(); ++s)
    for (std::uint32_t t = s + 1; t < mesh.triangles.size(); ++t)
      if (meets_improperly(mesh, s, t)) pairs.insert({s, t});
  return pairs;
}

/// Points around a centre, counter-clockwise, each a corner of their hull or nearly so.
inline std::vector<std::array<std::int64_t, 2>> ring(Random& random, std::int64_t size) {
  std::vector<std::array<std::int64_t, 2>> r;
  const auto n = 3 + random.below(30);
  for (std::uint64_t i = 0; i < n; ++i) {
    const double turn = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    const double radius = random.one_in(8) ? 0.9 : 1.0;
    r.push_back({std::llround(static_cast<double>(size) * radius * std::cos(turn)),
                 std::llround(static_cast<double>(size) * radius * std::sin(turn))});
  }
  return r;
}

/// A solid with two apices over a ring, or with a flat fan instead of one; a few points are moved, or all, up and down.
inline std::optional<Body> pointed(Random& random, std::int64_t size) {
  std::vector<Vector> points;
  const std::int64_t height = random.one_in(3) ? size / 2 : 0;
  for (const auto& p : ring(random, size))
    points.push_back({p[0], p[1], random.one_in(40) ? 1 : random.between(-height, height)});
  const auto n = static_cast<std::uint32_t>(points.size());
  points.push_back({0, 0, size});
  points.push_back({random.between(-2, 2), 0, random.one_in(6) ? size / 2 : -size});
  const bool flat = random.one_in(2);
  std::vector<Triangle> triangles;
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    triangles.push_back({i, j, n});
    if (!flat)
      triangles.push_back({j, i, n + 1});
    else if (i > 0 && j > 0)
      triangles.push_back({0, j, i});
  }
  for (const Triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k)
      if (points[t[k]] == points[t[(k + 1) % 3]]) return std::nullopt;
  return mesh(points, triangles);
}

/// Solids with fans, alone or with others that touch them, stand on them or cross them.
inline std::optional<Body> with_fans(Random& random) {
  const std::int64_t size = random.one_in(2) ? 20 : 1000;
  const auto one = [&]() -> std::optional<Body> {
    if (random.one_in(2)) return pointed(random, size);
    return extruded(ring(random, size), 0, size);
  };
  std::vector<Body> bodies;
  const auto first = one();
  if (!first) return std::nullopt;
  bodies.push_back(*first);
  if (random.one_in(3)) {  // on an edge of the fan, or on any two of its corners
    const auto& p = bodies[0].grid_points;
    const Vector a = vector(p[random.below(p.size())]), b = vector(p[random.below(p.size())]);
    if (const auto needle = tetrahedron({a, b, a + Vector{1, 2, size}, b + Vector{-2, 1, size}}))
      bodies.push_back(*needle);
  }
  if (random.one_in(4))
    if (const auto other = one())
      if (const auto at = moved(*other, {0, 0, random.one_in(2) ? size : random.between(-size, size)}))
        bodies.push_back(*at);
  Body all = merged(bodies);
  for (const Triangle& t : all.triangles)
    if (!exact::plane_through(all.grid_points[t[0]], all.grid_points[t[1]], all.grid_points[t[2]])) return std::nullopt;
  return all;
}

}  // namespace quoin::booleans::testing
