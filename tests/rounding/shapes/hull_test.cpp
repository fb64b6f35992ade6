#include "rounding/shapes/hull.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>
#include <vector>

#include "rounding/shapes/primitives.h"
#include "tests/rounding/shapes/soundness.h"

namespace quoin::rounding::testing {
namespace {

TEST(HullTest, HullOfACubeGrid) {
  for (const int n : {2, 3, 5}) {
    std::vector<Vector> points;
    for (int i = 0; i < n * n * n; ++i) points.push_back({i % n, i / n % n, i / (n * n)});
    const Polyhedron p = sound(convex_hull(points));
    EXPECT_EQ(volume(p), (n - 1) * (n - 1) * (n - 1));
    EXPECT_EQ(p.face_count(), 6u);
    EXPECT_EQ(p.points.size(), 8u);
    EXPECT_TRUE(trihedral(p).has_value());
  }
}

// Second way: a face is on every plane of three points that has no point above.
TEST(HullTest, HullsAgainstTheSearch) {
  std::mt19937_64 random = generator(610);
  int solid = 0, flat = 0;
  for (int i = 0; i < 150; ++i) {
    const auto n = 1 + below(random, 16);
    const std::int64_t size = std::array{1, 2, 4, 40}[below(random, 4)];
    const Rational unit = positive(random);
    std::vector<Vector> points;
    for (std::uint64_t k = 0; k < n; ++k) {
      Vector v{between(random, -size, size), between(random, -size, size), between(random, -size, size)};
      if (i % 5 == 0) v[2] = v[0] + v[1] + (i % 10 == 0 && below(random, 4) == 0 ? 1 : 0);
      points.push_back(unit * v);
    }
    const auto repeated = points[below(random, n)];
    points.push_back(repeated);
    std::set<WidePlane> planes;
    const std::size_t m = points.size();
    for (std::size_t a = 0; a < m; ++a)
      for (std::size_t b = a + 1; b < m; ++b)
        for (std::size_t c = b + 1; c < m; ++c) {
          const Vector normal = cross(points[b] - points[a], points[c] - points[a]);
          if (normal == Vector{0, 0, 0}) continue;
          const WidePlane plane = wide_plane(normal, -dot(normal, points[a]));
          int above = 0, under = 0;
          for (const Vector& v : points) {
            const int s = sign_of(value(plane, v));
            above += s > 0 ? 1 : 0;
            under += s < 0 ? 1 : 0;
            if (above > 0 && under > 0) break;
          }
          if (above == 0) planes.insert(plane);
          if (under == 0) planes.insert(plane.opposite());
        }
    // Flat points have one plane with both sides, or none.
    const bool is_flat = planes.empty() || (planes.size() == 2 && planes.begin()->opposite() == *planes.rbegin());
    const auto hull = convex_hull(points);
    ASSERT_EQ(hull.has_value(), !is_flat);
    (is_flat ? flat : solid) += 1;
    if (is_flat) {
      expect_refusal(hull);
      continue;
    }
    const Polyhedron p = sound(hull);
    ASSERT_EQ(std::set(p.planes.begin(), p.planes.end()), planes);
    ASSERT_EQ(p.planes.size(), planes.size());
    // Extreme: on three planes of different directions.
    std::set<Vector> extreme;
    for (const Vector& v : points) {
      std::vector<Vector> normals;
      for (const WidePlane& plane : planes)
        if (value(plane, v) == 0) normals.push_back({plane.n[0], plane.n[1], plane.n[2]});
      for (std::size_t a = 0; a < normals.size(); ++a)
        for (std::size_t b = a + 1; b < normals.size(); ++b)
          for (std::size_t c = b + 1; c < normals.size(); ++c)
            if (determinant({normals[a], normals[b], normals[c]}) != 0) extreme.insert(v);
    }
    ASSERT_EQ(std::set(p.points.begin(), p.points.end()), extreme);
    // The order of the points decides nothing.
    std::shuffle(points.begin(), points.end(), random);
    const Polyhedron again = made(convex_hull(points));
    ASSERT_EQ(again.points, p.points);
    ASSERT_EQ(again.planes, p.planes);
    ASSERT_EQ(again.faces.corners, p.faces.corners);
  }
  EXPECT_GT(solid, 60);
  EXPECT_GT(flat, 10);
}

TEST(HullTest, HullsOfManyPoints) {
  // Of points on a sphere all remain; inner ones go.
  const Polyhedron ball = made(sphere(3, 20));
  std::vector<Vector> points = ball.points;
  for (const Vector& v : ball.points) points.push_back(Rational(99, 100) * v);
  const Polyhedron hull = sound(convex_hull(points));
  EXPECT_EQ(std::set(hull.points.begin(), hull.points.end()), std::set(ball.points.begin(), ball.points.end()));
  EXPECT_EQ(std::set(hull.planes.begin(), hull.planes.end()), std::set(ball.planes.begin(), ball.planes.end()));
  EXPECT_EQ(volume(hull), volume(ball));
  // A cone's base is one face of many points.
  const Polyhedron cone = made(frustum(60, 2, 0, 5, Fit::inscribed));
  points = cone.points;
  for (const Vector& v : cone.points) points.push_back({v[0] / 2, v[1] / 2, 0});
  const Polyhedron same = sound(convex_hull(points));
  EXPECT_EQ(same.face_count(), 61u);
  EXPECT_EQ(volume(same), volume(cone));
}

TEST(HullTest, HullsOfFlatPointsAreRefused) {
  const Vector a{0, 0, 0}, b{1, 2, 3}, c{5, 1, 0}, d{6, 3, 3};
  expect_refusal(convex_hull({}));
  expect_refusal(convex_hull(std::vector{a}));
  expect_refusal(convex_hull(std::vector{a, b, c}));
  expect_refusal(convex_hull(std::vector{a, b, c, d}));
  expect_refusal(convex_hull(std::vector{a, a, a, a, a}));
  expect_refusal(convex_hull(std::vector{a, b, b, a, c}));
  expect_refusal(convex_hull(std::vector<Vector>{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {9, 9, 9}}));
  const Polyhedron p = sound(convex_hull(std::vector<Vector>{a, b, c, {1, 1, 5}}));
  EXPECT_EQ(p.face_count(), 4u);
  EXPECT_TRUE(trihedral(p).has_value());
}

/// The same points and planes, in any order.
void expect_same(const Polyhedron& p, const Polyhedron& q) {
  EXPECT_EQ(std::set(p.points.begin(), p.points.end()), std::set(q.points.begin(), q.points.end()));
  EXPECT_EQ(std::set(p.planes.begin(), p.planes.end()), std::set(q.planes.begin(), q.planes.end()));
}

TEST(HullTest, HullsAgainFromTheirPlanes) {
  std::mt19937_64 random = generator(690);
  for (int i = 0; i < 40; ++i) {
    std::vector<Vector> points;
    const unsigned bits = i % 2 == 0 ? 8 : 90;
    for (int n = 4 + static_cast<int>(below(random, 12)); n > 0; --n) points.push_back(random_vector(random, bits));
    const auto hull = convex_hull(points);
    if (!hull) continue;
    const Polyhedron& expected = hull.value();
    Vector inside{0, 0, 0};
    for (const Vector& p : expected.points) inside = inside + Rational(1, expected.points.size()) * p;
    std::vector<WidePlane> planes = expected.planes;
    expect_same(sound(convex_polyhedron(planes, inside)), expected);
    // Planes that touch in a corner or an edge, pass by, or stand twice, change nothing.
    for (std::size_t k = 0; k + 1 < expected.planes.size(); ++k) {
      const WidePlane &p = expected.planes[k], &q = expected.planes[k + 1];
      if (p.n == std::array<Integer, 3>{-q.n[0], -q.n[1], -q.n[2]}) continue;
      const Vector n{p.n[0] + q.n[0], p.n[1] + q.n[1], p.n[2] + q.n[2]};
      Rational least = -dot(n, expected.points[0]);
      for (const Vector& v : expected.points) least = std::min<Rational>(least, -dot(n, v));
      planes.push_back(wide_plane(n, least - (k % 3 == 0 ? 1 : 0)));
      planes.push_back(p);
    }
    expect_same(sound(convex_polyhedron(planes, inside)), expected);
  }
}

TEST(HullTest, WhatPlanesDoNotBound) {
  const Polyhedron cube = made(block({2, 2, 2}));
  std::vector<WidePlane> planes = cube.planes;
  expect_same(sound(convex_polyhedron(planes, {1, Rational(1, 3), Rational(1, 7)})), cube);
  while (!planes.empty()) {
    planes.pop_back();
    const auto open = convex_polyhedron(planes, {1, 1, 1});
    ASSERT_FALSE(open.has_value()) << planes.size();
    EXPECT_EQ(open.error().code, ErrorCode::unbounded);
  }
}

}  // namespace
}  // namespace quoin::rounding::testing
