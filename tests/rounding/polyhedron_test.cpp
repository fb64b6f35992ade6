#include "rounding/polyhedron.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "booleans/boolean.h"
#include "booleans/measure.h"
#include "rounding/primitives.h"
#include "rounding/reconstruct.h"
#include "tests/rounding/support.h"

namespace quoin::rounding::testing {
namespace {

using booleans::Body;
using booleans::Rule;
using grid::Lattice;

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vector normal(const WidePlane& p) { return {p.n[0], p.n[1], p.n[2]}; }
Polyhedron made(const Result<Polyhedron>& r) {
  EXPECT_TRUE(r.has_value()) << r.error().message;
  return r ? r.value() : Polyhedron{};
}
Body combined(Rule rule, const std::vector<Body>& bodies, std::uint32_t negated_from = booleans::none) {
  std::vector<const Body*> operands;
  for (const Body& b : bodies) operands.push_back(&b);
  auto r = booleans::evaluate(
      operands, booleans::Expression::flat(rule, static_cast<std::uint32_t>(bodies.size()), negated_from));
  EXPECT_TRUE(r.has_value());
  return r ? std::move(r).value() : Body{};
}
Body box(std::array<std::int32_t, 3> low, std::array<std::int32_t, 3> high) {
  return booleans::box_body({low}, {high});
}

/// A solid's faces one after the other, points found again.
void append(Polyhedron& p, const Polyhedron& q) {
  std::vector<std::uint32_t> id;
  for (const Vector& v : q.points) {
    const auto at = std::find(p.points.begin(), p.points.end(), v);
    id.push_back(at != p.points.end() ? static_cast<std::uint32_t>(at - p.points.begin()) : p.add_point(v));
  }
  for (std::uint32_t f = 0; f < q.face_count(); ++f) {
    p.planes.push_back(q.planes[f]);
    p.face_loops.push_back(p.face_loops.back());
    for (std::uint32_t j = q.face_loops[f]; j < q.face_loops[f + 1]; ++j) {
      std::vector<std::uint32_t> loop;
      for (const std::uint32_t v : q.loop(j)) loop.push_back(id[v]);
      p.add_loop(loop);
    }
  }
}
Polyhedron shifted(Polyhedron p, const Vector& by) {
  const AffineMap back{AffineMap{}.linear, Rational(-1) * by};
  for (Vector& v : p.points) v = v + by;
  for (WidePlane& plane : p.planes) plane = moved(plane, back);
  return p;
}
Polyhedron cube() { return made(block({1, 1, 1})); }

const std::vector<Body>& bodies() {
  static const std::vector<Body> all{
      box({0, 0, 0}, {3, 2, 1}),
      // A plane that cuts a corner off; an oblique half.
      booleans::half_space_body({{1, 2, 3}, -20}, {{0, 0, 0}}, {{7, 7, 7}}),
      booleans::half_space_body({{7, -11, 5}, 13}, {{-9, -9, -9}}, {{9, 9, 9}}),
      // A hole through it, a dent in a face, a cavity, two parts.
      combined(Rule::all, {box({0, 0, 0}, {9, 9, 9}), box({2, 2, -1}, {4, 5, 10})}, 1),
      combined(Rule::all, {box({0, 0, 0}, {9, 9, 9}), box({2, 2, 5}, {4, 5, 10})}, 1),
      combined(Rule::all, {box({0, 0, 0}, {9, 9, 9}), box({2, 2, 2}, {4, 5, 6})}, 1),
      combined(Rule::any, {box({0, 0, 0}, {1, 1, 1}), box({5, 0, 0}, {6, 2, 1})}),
      // Touching in an edge, in a vertex, in an edge inside a face, in a vertex inside a face.
      combined(Rule::any, {box({0, 0, 0}, {1, 1, 1}), box({1, 1, 0}, {2, 2, 1})}),
      combined(Rule::any, {box({0, 0, 0}, {1, 1, 1}), box({1, 1, 1}, {2, 2, 2})}),
      combined(Rule::any,
               {box({-9, -9, -2}, {9, 9, 0}),
                combined(Rule::all, {booleans::half_space_body({{1, 0, -1}, 0}, {{-5, -5, -5}}, {{5, 5, 5}}),
                                     booleans::half_space_body({{-1, 0, -1}, 0}, {{-5, -5, -5}}, {{5, 5, 5}})})}),
      combined(Rule::any,
               {box({-9, -9, -2}, {9, 9, 0}),
                combined(Rule::all, {booleans::half_space_body({{2, 1, -1}, 0}, {{-5, -5, -5}}, {{5, 5, 5}}),
                                     booleans::half_space_body({{-2, 1, -1}, 0}, {{-5, -5, -5}}, {{5, 5, 5}}),
                                     booleans::half_space_body({{0, -1, -1}, 0}, {{-5, -5, -5}}, {{5, 5, 5}})})}),
  };
  return all;
}

TEST(PolyhedronTest, OfACanonicalFormAndBack) {
  const Lattice lattices[] = {{}, {Rational(3, 7), {Rational(1, 2), -5, Rational(22, 3)}}, {1000, {0, 0, -1}}};
  for (const Body& body : bodies())
    for (const Lattice& lattice : lattices) {
      const booleans::Canonical form = booleans::canonical(body);
      const Polyhedron p = carried(polyhedron_of(form), inverse(to_grid(lattice)));
      ASSERT_EQ(p.points.size(), form.vertices.size());
      ASSERT_EQ(p.face_count(), form.face_count());
      EXPECT_EQ(p.corners, form.corners);
      EXPECT_EQ(p.loop_corners, form.loop_corners);
      EXPECT_EQ(p.face_loops, form.face_loops);
      for (std::size_t v = 0; v < p.points.size(); ++v)
        for (std::size_t k = 0; k < 3; ++k)
          ASSERT_EQ(p.points[v][k],
                    lattice.origin[k] + lattice.step * exact::coordinate(form.vertices[v], static_cast<int>(k)));
      for (std::uint32_t f = 0; f < p.face_count(); ++f) {
        p.for_edges(f, [&](std::uint32_t u, std::uint32_t) { ASSERT_EQ(value(p.planes[f], p.points[u]), 0); });
        // Directions stay, signs too.
        const Vector n{form.planes[f].n[0], form.planes[f].n[1], form.planes[f].n[2]};
        ASSERT_EQ(cross(normal(p.planes[f]), n), (Vector{0, 0, 0}));
        ASSERT_GT(dot(normal(p.planes[f]), n), 0);
      }
      EXPECT_EQ(sixfold_volume(p), 6 * booleans::volume(body) * lattice.step * lattice.step * lattice.step);
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

TEST(PolyhedronTest, SixfoldVolume) {
  EXPECT_EQ(sixfold_volume(Polyhedron{}), 0);
  EXPECT_EQ(sixfold_volume(cube()), 6);
  EXPECT_EQ(sixfold_volume(shifted(cube(), {Rational(1, 3), -7, 100})), 6);
  EXPECT_EQ(sixfold_volume(made(convex_hull(std::vector<Vector>{{0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {0, 0, 5}}))), 30);
}

/// Triangles, none degenerate and all turned as their faces, that fill the area of the faces and are closed: a tiling.
void expect_tiling(const Polyhedron& p) {
  const auto triangles = triangulated(p);
  ASSERT_TRUE(triangles.has_value());
  std::map<WidePlane, Rational> area;
  for (std::uint32_t f = 0; f < p.face_count(); ++f)
    p.for_edges(f, [&](std::uint32_t u, std::uint32_t v) {
      area[p.planes[f]] += dot(normal(p.planes[f]), cross(p.points[u], p.points[v]));
    });
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;
  std::vector<bool> used(p.points.size());
  for (const auto& t : *triangles) {
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
  q.face_loops.push_back(0);
  q.add_loop(std::array<std::uint32_t, 4>{0, 1, 2, 3});
  EXPECT_FALSE(triangulated(q).has_value());
  // A hole turned as the outline.
  Polyhedron r;
  for (const Vector& v : {Vector{0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {1, 1, 0}, {2, 1, 0}, {1, 2, 0}}) r.add_point(v);
  r.add_face({std::array<std::uint32_t, 3>{0, 1, 2}, std::array<std::uint32_t, 3>{3, 4, 5}});
  EXPECT_FALSE(triangulated(r).has_value());
}

void expect_consistent(const Polyhedron& p) {
  const auto t = trihedral(p);
  ASSERT_TRUE(t.has_value());
  ASSERT_EQ(t->faces.size(), p.points.size());
  ASSERT_EQ(t->sign.size(), p.points.size());
  for (std::size_t v = 0; v < p.points.size(); ++v) {
    const auto& [f, g, h] = t->faces[v];
    ASSERT_TRUE(f < g && g < h);
    for (const std::uint32_t face : t->faces[v]) {
      ASSERT_EQ(value(p.planes[face], p.points[v]), 0);
      bool listed = false;
      p.for_edges(face, [&](std::uint32_t u, std::uint32_t) { listed = listed || u == v; });
      ASSERT_TRUE(listed);
    }
    const Rational d = determinant({normal(p.planes[f]), normal(p.planes[g]), normal(p.planes[h])});
    ASSERT_EQ(t->sign[v], sign_of(d));
    ASSERT_NE(t->sign[v], 0);
  }
  // Every directed edge once, with a plane through its end alone.
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges, ordered;
  for (std::uint32_t f = 0; f < p.face_count(); ++f)
    p.for_edges(f, [&](std::uint32_t u, std::uint32_t v) { edges.insert({u, v}); });
  for (const auto& o : t->orders) {
    ASSERT_TRUE(ordered.insert({o.from, o.to}).second);
    ASSERT_EQ(value(p.planes[o.face], p.points[o.to]), 0);
    ASSERT_EQ(sign_of(value(p.planes[o.face], p.points[o.from])), o.side);
    ASSERT_NE(o.side, 0);
  }
  EXPECT_EQ(ordered, edges);
}

TEST(PolyhedronTest, TrihedralOnes) {
  expect_consistent(cube());
  expect_consistent(made(wedge({3, 2, 1}, 5)));
  for (const std::uint32_t sides : {3u, 8u}) expect_consistent(made(frustum(sides, 2, 1, 3, Fit::inscribed)));
  expect_consistent(made(frustum(3, 2, 0, 3, Fit::inscribed)));
  // Not convex, with a hole, in parts.
  expect_consistent(made(extrusion(
      {{{{0, 0}, {9, 0}, {9, 9}, {4, 3}}, {{4, 1}, {5, 1}, {5, 2}}}, {{{20, 0}, {21, 0}, {20, 5}}}}, {1, 2, 3})));
  // A cavity, two parts, a dent.
  for (const std::size_t i : {1u, 3u, 4u, 5u, 6u}) expect_consistent(polyhedron_of(booleans::canonical(bodies()[i])));
}

TEST(PolyhedronTest, OnesThatAreNot) {
  const Polyhedron pyramid = made(frustum(4, 2, 0, 3, Fit::inscribed));
  EXPECT_FALSE(trihedral(pyramid).has_value());
  EXPECT_FALSE(trihedral(made(sphere(1, 4))).has_value());
  EXPECT_FALSE(trihedral(made(torus(2, 1, 3, 3))).has_value());
  // An edge of four faces, also as canonical forms have it.
  Polyhedron p = cube();
  append(p, shifted(cube(), {1, 1, 0}));
  EXPECT_EQ(p.points.size(), 14u);
  EXPECT_FALSE(trihedral(p).has_value());
  EXPECT_FALSE(trihedral(polyhedron_of(booleans::canonical(bodies()[7]))).has_value());
  // A touching edge or vertex inside a face.
  EXPECT_FALSE(trihedral(polyhedron_of(booleans::canonical(bodies()[9]))).has_value());
  EXPECT_FALSE(trihedral(polyhedron_of(booleans::canonical(bodies()[10]))).has_value());
  // A vertex of two parts with six planes.
  p = cube();
  append(p, made(convex_hull(std::vector<Vector>{{1, 1, 1}, {5, 2, 2}, {2, 6, 2}, {3, 2, 7}})));
  EXPECT_EQ(p.points.size(), 11u);
  EXPECT_FALSE(trihedral(p).has_value());
  // An open boundary, and a point on no face.
  p = cube();
  p.planes.pop_back();
  p.face_loops.pop_back();
  p.loop_corners.pop_back();
  p.corners.resize(p.loop_corners.back());
  EXPECT_FALSE(trihedral(p).has_value());
  p = cube();
  p.add_point({5, 5, 5});
  EXPECT_FALSE(trihedral(p).has_value());
}

// Two cubes that touch in a vertex have the same three planes there: their planes still determine them.
TEST(PolyhedronTest, CubesThatTouchInAVertex) {
  Polyhedron p = cube();
  append(p, shifted(cube(), {1, 1, 1}));
  EXPECT_EQ(p.points.size(), 15u);
  const auto t = trihedral(p);
  ASSERT_TRUE(t.has_value());
  EXPECT_EQ(t->orders.size(), 48u);
  EXPECT_TRUE(trihedral(polyhedron_of(booleans::canonical(bodies()[8]))).has_value());
}

}  // namespace
}  // namespace quoin::rounding::testing
