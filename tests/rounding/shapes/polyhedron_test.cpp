#include "rounding/shapes/polyhedron.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "booleans/body/measure.h"
#include "rounding/reconstruction/reconstruct.h"
#include "tests/rounding/shapes/solids.h"

namespace quoin::rounding::testing {
namespace {

TEST(PolyhedronTest, OfACanonicalFormAndBack) {
  const Lattice lattices[] = {{}, {Rational(3, 7), {Rational(1, 2), -5, Rational(22, 3)}}, {1000, {0, 0, -1}}};
  for (const Body& body : bodies())
    for (const Lattice& lattice : lattices) {
      const booleans::Canonical form = booleans::canonical(body);
      const Polyhedron p = carried(polyhedron_of(form), inverse(to_grid(lattice)));
      ASSERT_EQ(p.points.size(), form.vertices.size());
      ASSERT_EQ(p.face_count(), form.face_count());
      EXPECT_EQ(p.faces.corners, form.faces.corners);
      EXPECT_EQ(p.faces.loop_start, form.faces.loop_start);
      EXPECT_EQ(p.faces.face_start, form.faces.face_start);
      for (std::size_t v = 0; v < p.points.size(); ++v)
        for (std::size_t k = 0; k < 3; ++k)
          ASSERT_EQ(p.points[v][k],
                    lattice.origin[k] + lattice.step * exact::coordinate(form.vertices[v], static_cast<int>(k)));
      for (std::uint32_t f = 0; f < p.face_count(); ++f) {
        p.faces.for_edges(f, [&](std::uint32_t u, std::uint32_t) { ASSERT_EQ(value(p.planes[f], p.points[u]), 0); });
        // Directions stay, signs too.
        const Vector n{form.planes[f].n[0], form.planes[f].n[1], form.planes[f].n[2]};
        ASSERT_EQ(cross(normal(p.planes[f]), n), (Vector{0, 0, 0}));
        ASSERT_GT(dot(normal(p.planes[f]), n), 0);
      }
      EXPECT_EQ(volume(p), booleans::volume(body) * lattice.step * lattice.step * lattice.step);
      // Back on the grid it is the same point set.
      AffineMap to_grid;
      for (std::size_t k = 0; k < 3; ++k) {
        to_grid.linear[k][k] = 1 / lattice.step;
        to_grid.shift[k] = -lattice.origin[k] / lattice.step;
      }
      const Shape shape(p);
      const std::vector<Placement> placements{{&shape, {}, to_grid}};
      const auto r = reconstruct(placements);
      ASSERT_TRUE(r.has_value()) << r.error().message;
      EXPECT_EQ(r.value().primitives[0].displacement, 0);
      EXPECT_TRUE(r.value().primitives[0].by_planes);
      EXPECT_TRUE(booleans::canonical(r.value().primitives[0].body) == form);
    }
}

/// Triangles, none degenerate and all turned as their faces, that fill the area of the faces and are closed: a tiling.
void expect_tiling(const Polyhedron& p) {
  const auto triangles = triangulated(p);
  ASSERT_TRUE(triangles.has_value());
  std::map<WidePlane, Rational> area;
  for (std::uint32_t f = 0; f < p.face_count(); ++f)
    p.faces.for_edges(f, [&](std::uint32_t u, std::uint32_t v) {
      area[p.planes[f]] += dot(normal(p.planes[f]), cross(p.points[u], p.points[v]));
    });
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;
  std::vector<bool> used(p.points.size());
  for (const auto& t : triangles->corners) {
    const Vector &a = p.points[t[0]], &b = p.points[t[1]], &c = p.points[t[2]];
    const Vector n = cross(b - a, c - a);
    ASSERT_NE(n, (Vector{0, 0, 0}));
    const auto at = area.find(wide_plane(n, -dot(n, a)));
    ASSERT_NE(at, area.end());
    at->second -= dot(normal(at->first), n);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t u = t[k], v = t[(k + 1) % 3];
      balance[{std::min(u, v), std::max(u, v)}] += u < v ? 1 : -1;
      used[u] = true;
      // No corner of any face inside a triangle or its sides.
      for (const Vector& w : p.points) {
        if (value(at->first, w) != 0 || w == a || w == b || w == c) continue;
        const Vector &x = p.points[u], &y = p.points[v], &z = p.points[t[(k + 2) % 3]];
        const bool within =
            dot(n, cross(y - x, w - x)) >= 0 && dot(n, cross(z - y, w - y)) >= 0 && dot(n, cross(x - z, w - z)) >= 0;
        ASSERT_FALSE(within);
      }
    }
  }
  for (const auto& [plane, rest] : area) EXPECT_EQ(rest, 0);
  for (const auto& [edge, sum] : balance) ASSERT_EQ(sum, 0);
  EXPECT_EQ(std::find(used.begin(), used.end(), false), used.end());
}

TEST(PolyhedronTest, TrianglesTileTheFaces) {
  for (const Body& body : bodies())
    expect_tiling(carried(polyhedron_of(booleans::canonical(body)), inverse(to_grid({Rational(1, 3), {1, 2, 3}}))));
  expect_tiling(made(sphere(1, 8)));
  expect_tiling(made(torus(3, 1, 7, 5)));
  expect_tiling(made(frustum(9, 2, 1, 3, Fit::circumscribed)));
  std::mt19937_64 random = generator(621);
  for (int i = 0; i < 10; ++i) {
    // An outline with two holes, turned and moved.
    std::vector<std::vector<PlanePoint>> polygon{{{0, 0}, {20, 1}, {22, 10}, {11, 3}, {1, 12}}};
    for (const int x : {4, 9}) {
      auto& hole = polygon.emplace_back();
      for (int k = 0; k < 5; ++k) {
        const PlanePoint c = circle_point(72 * k + Rational(below(random, 30)), 20);
        const Rational radius(1 + below(random, 12), 12);
        hole.push_back({x + radius * c[0], 2 + radius * c[1]});
      }
    }
    expect_tiling(made(extrusion({polygon}, {1, 1, 3})));
  }
}

TEST(PolyhedronTest, FacesTurnedRoundHaveNoTriangles) {
  // A face turned round.
  Polyhedron q;
  for (const Vector& v : {Vector{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}) q.add_point(v);
  q.planes.push_back({{0, 0, -1}, 0});
  q.faces.face_start.push_back(0);
  q.add_loop(std::array<std::uint32_t, 4>{0, 1, 2, 3});
  EXPECT_FALSE(triangulated(q).has_value());
  // A hole turned as the outline.
  Polyhedron r;
  for (const Vector& v : {Vector{0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {1, 1, 0}, {2, 1, 0}, {1, 2, 0}}) r.add_point(v);
  r.add_face({std::array<std::uint32_t, 3>{0, 1, 2}, std::array<std::uint32_t, 3>{3, 4, 5}});
  EXPECT_FALSE(triangulated(r).has_value());
}

}  // namespace
}  // namespace quoin::rounding::testing
