/// \file
/// Closed triangle meshes on the grid, by name. Shared by the tests, the oracle and the fuzz targets.
///
/// What cannot be built (flat, or outside the world) is nothing, so that generators try again.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "booleans/body/body.h"
#include "exact/predicates.h"
#include "grid/import.h"

namespace quoin::booleans::testing {

using Vector = std::array<std::int64_t, 3>;
using Triangle = std::array<std::uint32_t, 3>;

inline Vector operator+(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vector operator*(std::int64_t s, const Vector& a) { return {s * a[0], s * a[1], s * a[2]}; }

inline exact::int128 determinant(const Vector& u, const Vector& v, const Vector& w) {
  const auto minor = [&](std::size_t i, std::size_t j) {
    return exact::int128(v[i]) * w[j] - exact::int128(v[j]) * w[i];
  };
  return u[0] * minor(1, 2) + u[1] * minor(2, 0) + u[2] * minor(0, 1);
}

/// A mesh of these triangles; equal points become one vertex, collapsed triangles go. Nothing outside the world.
inline std::optional<Body> mesh(std::span<const Vector> points, std::span<const Triangle> triangles) {
  Body body;
  std::map<Vector, std::uint32_t> ids;
  std::vector<std::uint32_t> id;
  for (const Vector& p : points) {
    for (std::int64_t x : p)
      if (x > exact::world || x < -exact::world) return std::nullopt;
    const auto [at, fresh] = ids.try_emplace(p, static_cast<std::uint32_t>(ids.size()));
    id.push_back(at->second);
    if (!fresh) continue;
    body.grid_points.push_back(
        {{static_cast<std::int32_t>(p[0]), static_cast<std::int32_t>(p[1]), static_cast<std::int32_t>(p[2])}});
  }

  for (const Triangle& t : triangles) {
    const Triangle c{id[t[0]], id[t[1]], id[t[2]]};
    if (c[0] != c[1] && c[1] != c[2] && c[2] != c[0]) body.triangles.push_back(c);
  }
  return body;
}

inline Vector vector(const exact::GridPoint& p) { return {p[0], p[1], p[2]}; }
inline std::vector<Vector> points_of(const Body& body) {
  std::vector<Vector> points;
  for (const exact::GridPoint& p : body.grid_points) points.push_back(vector(p));
  return points;
}

/// The raw mesh with its triangles turned round.
inline Body inside_out(Body body) {
  for (Triangle& t : body.triangles.edit()) std::swap(t[1], t[2]);
  return body;
}

/// Several raw meshes as one, equal points shared.
inline Body merged(std::span<const Body> bodies) {
  std::vector<Vector> points;
  std::vector<Triangle> triangles;
  for (const Body& b : bodies) {
    const auto base = static_cast<std::uint32_t>(points.size());
    for (const exact::GridPoint& p : b.grid_points) points.push_back(vector(p));
    for (const Triangle& t : b.triangles) triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  }
  return *mesh(points, triangles);
}

/// x -> origin + columns x. Turns the triangles round when the determinant is negative.
inline std::optional<Body> mapped(const Body& raw, const Vector& origin, const std::array<Vector, 3>& columns) {
  const exact::int128 det = determinant(columns[0], columns[1], columns[2]);
  if (det == 0) return std::nullopt;
  std::vector<Vector> points;
  for (const exact::GridPoint& p : raw.grid_points)
    points.push_back(origin + p[0] * columns[0] + p[1] * columns[1] + p[2] * columns[2]);
  const auto body = mesh(points, raw.triangles);
  return body && det < 0 ? inside_out(*body) : body;
}
inline std::optional<Body> scaled(const Body& raw, std::int64_t factor, const Vector& origin = {0, 0, 0}) {
  return mapped(raw, origin, {{{factor, 0, 0}, {0, factor, 0}, {0, 0, factor}}});
}
inline std::optional<Body> moved(const Body& raw, const Vector& by) { return scaled(raw, 1, by); }

inline Body box(const Vector& low, const Vector& high) {
  const auto grid = [](const Vector& p) {
    return exact::GridPoint{
        {static_cast<std::int32_t>(p[0]), static_cast<std::int32_t>(p[1]), static_cast<std::int32_t>(p[2])}};
  };
  return box_body(grid(low), grid(high));
}

/// The parallelepiped at `corner` spanned by three vectors.
inline std::optional<Body> block(const Vector& corner, const Vector& u, const Vector& v, const Vector& w) {
  return mapped(box({0, 0, 0}, {1, 1, 1}), corner, {u, v, w});
}

inline std::optional<Body> tetrahedron(const std::array<Vector, 4>& p) {
  const exact::int128 det = determinant(p[1] - p[0], p[2] - p[0], p[3] - p[0]);
  if (det == 0) return std::nullopt;
  static constexpr std::array<Triangle, 4> faces{{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  const auto body = mesh(p, faces);
  return body && det < 0 ? inside_out(*body) : body;
}

/// The triangle a, b, c swept along `by`.
inline std::optional<Body> prism(const Vector& a, const Vector& b, const Vector& c, const Vector& by) {
  const exact::int128 det = determinant(b - a, c - a, by);
  if (det == 0) return std::nullopt;
  const std::array<Vector, 6> points{a, b, c, a + by, b + by, c + by};
  static constexpr std::array<Triangle, 8> faces{
      {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}}};
  const auto body = mesh(points, faces);
  return body && det < 0 ? inside_out(*body) : body;
}

/// The hull of centre +- u, centre +- v, centre +- w.
inline std::optional<Body> octahedron(const Vector& centre, const Vector& u, const Vector& v, const Vector& w) {
  const exact::int128 det = determinant(u, v, w);
  if (det == 0) return std::nullopt;
  const std::array<Vector, 6> points{centre + u, centre - u, centre + v, centre - v, centre + w, centre - w};

  std::vector<Triangle> faces;
  for (std::uint32_t i = 0; i < 8; ++i) {
    const std::uint32_t a = i & 1, b = 2 + (i >> 1 & 1), c = 4 + (i >> 2);
    const bool odd = ((i ^ i >> 1 ^ i >> 2) & 1) != 0;
    faces.push_back(odd ? Triangle{a, c, b} : Triangle{a, b, c});
  }
  const auto body = mesh(points, faces);
  return body && det < 0 ? inside_out(*body) : body;
}

/// A counter-clockwise polygon in (x, y), star-shaped from its first corner, between two heights.
inline Body extruded(std::span<const std::array<std::int64_t, 2>> polygon, std::int64_t low, std::int64_t high) {
  std::vector<Vector> points;
  for (std::int64_t z : {low, high})
    for (const auto& p : polygon) points.push_back({p[0], p[1], z});

  std::vector<Triangle> faces;
  const auto n = static_cast<std::uint32_t>(polygon.size());
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    faces.push_back({i, j, n + j});
    faces.push_back({i, n + j, n + i});
    if (i > 0 && j > 0) {
      faces.push_back({0, j, i});
      faces.push_back({n, n + i, n + j});
    }
  }
  return *mesh(points, faces);
}

/// The box from 0 to `outer` in (x, y) without its part beyond `inner`: an L, between two heights.
/// Precondition: 0 < inner < outer in x and y.
inline Body l_shape(const std::array<std::int64_t, 2>& inner, const std::array<std::int64_t, 2>& outer,
                    std::int64_t low, std::int64_t high) {
  const std::array<std::array<std::int64_t, 2>, 6> corners{
      {{0, 0}, {outer[0], 0}, {outer[0], inner[1]}, {inner[0], inner[1]}, {inner[0], outer[1]}, {0, outer[1]}}};
  return extruded(corners, low, high);
}

/// A sphere of meridians and parallels around `centre`, star-shaped; radius(ring, segment) in grid steps, poles are
/// (0, 0) and (rings, 0). Nothing where rounding spoils the star.
template <class Radius>
std::optional<Body> sphere(const Vector& centre, std::uint32_t rings, std::uint32_t segments, Radius&& radius) {
  std::vector<Vector> points;
  const auto add = [&](std::uint32_t i, std::uint32_t j) {
    const double polar = std::numbers::pi * i / rings, turn = 2 * std::numbers::pi * j / segments, r = radius(i, j);
    points.push_back(centre + Vector{std::llround(r * std::sin(polar) * std::cos(turn)),
                                     std::llround(r * std::sin(polar) * std::sin(turn)),
                                     std::llround(r * std::cos(polar))});
  };
  add(0, 0);
  for (std::uint32_t i = 1; i < rings; ++i)
    for (std::uint32_t j = 0; j < segments; ++j) add(i, j);
  add(rings, 0);

  const auto at = [&](std::uint32_t i, std::uint32_t j) {
    if (i == 0) return 0u;
    return i == rings ? static_cast<std::uint32_t>(points.size() - 1) : 1 + (i - 1) * segments + j % segments;
  };

  std::vector<Triangle> faces;
  for (std::uint32_t i = 0; i < rings; ++i)
    for (std::uint32_t j = 0; j < segments; ++j) {
      if (i > 0) faces.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
      if (i + 1 < rings) faces.push_back({at(i, j + 1), at(i + 1, j), at(i + 1, j + 1)});
    }

  // Every face seen from the centre counter-clockwise from outside: the radial projection is one to one.
  for (const Triangle& f : faces)
    if (determinant(points[f[0]] - centre, points[f[1]] - centre, points[f[2]] - centre) <= 0) return std::nullopt;
  return mesh(points, faces);
}

/// A sheet of n x n squares whose corners lie anywhere on the lattice of the plane z = 0, so that it is folded and
/// overlaps itself in any way, closed by a cone over its border: a closed mesh that import would hand on, with flat
/// regions of many boundary edges that cover their plane more than once. between(low, high): any integer of that range.
/// Nothing where it is all flat.
template <class Between>
std::optional<Body> folded_sheet(Between&& between, std::uint32_t n, std::int64_t reach) {
  std::vector<double> points;
  const auto add = [&](std::int64_t x, std::int64_t y, std::int64_t z) {
    for (const std::int64_t c : {x, y, z}) points.push_back(static_cast<double>(c));
  };
  for (std::uint32_t i = 0; i <= n; ++i)
    for (std::uint32_t j = 0; j <= n; ++j) {
      // Near its place in a plain sheet or, one time in three, anywhere.
      const bool anywhere = between(0, 2) == 0;
      const auto at = [&](std::uint32_t k) {
        return anywhere ? between(0, reach) : std::int64_t{k} * reach / n + between(-1, 1);
      };
      const std::int64_t x = at(i);
      add(x, at(j), 0);
    }
  add(between(0, reach), between(0, reach), between(1, reach));

  const auto at = [&](std::uint32_t i, std::uint32_t j) { return i * (n + 1) + j; };
  const std::uint32_t apex = (n + 1) * (n + 1);
  std::vector<std::uint32_t> triangles;
  const auto face = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    triangles.insert(triangles.end(), {a, b, c});
  };

  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < n; ++j) {
      face(at(i, j), at(i, j + 1), at(i + 1, j + 1));
      face(at(i, j), at(i + 1, j + 1), at(i + 1, j));
    }
  for (std::uint32_t k = 0; k < n; ++k) {
    face(at(k, 0), at(k + 1, 0), apex);
    face(at(n, k), at(n, k + 1), apex);
    face(at(k + 1, n), at(k, n), apex);
    face(at(0, k + 1), at(0, k), apex);
  }

  auto imported = grid::import_triangles(points, triangles, grid::Lattice{}, grid::Facing::any);
  if (!imported || imported.value().triangles.empty()) return std::nullopt;
  Body body;
  body.grid_points = std::move(imported.value().points);
  body.triangles = std::move(imported.value().triangles);
  return body;
}

}  // namespace quoin::booleans::testing
