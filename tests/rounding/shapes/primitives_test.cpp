#include "rounding/shapes/primitives.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "rounding/numbers/enclosure.h"
#include "rounding/shapes/hull.h"
#include "tests/rounding/shapes/soundness.h"

namespace quoin::rounding::testing {
namespace {

constexpr Fit all_fits[] = {Fit::inscribed, Fit::circumscribed, Fit::equal_area};

TEST(PrimitivesTest, Blocks) {
  std::mt19937_64 random = generator(604);
  for (int i = 0; i < 20; ++i) {
    const Vector size{positive(random), positive(random), positive(random)};
    const Polyhedron p = sound(block(size));
    EXPECT_EQ(p.points.size(), 8u);
    EXPECT_EQ(p.face_count(), 6u);
    EXPECT_EQ(volume(p), size[0] * size[1] * size[2]);
    EXPECT_TRUE(trihedral(p).has_value());
    for (const Vector& v : p.points)
      for (std::size_t k = 0; k < 3; ++k) ASSERT_TRUE(v[k] == 0 || v[k] == size[k]);
  }
  for (std::size_t k = 0; k < 3; ++k)
    for (const int bad : {0, -1}) {
      Vector size{1, 2, 3};
      size[k] = bad;
      expect_refusal(block(size));
      expect_refusal(wedge(size, 1));
    }
}

TEST(PrimitivesTest, Wedges) {
  std::mt19937_64 random = generator(605);
  for (int i = 0; i < 20; ++i) {
    const Vector size{positive(random), positive(random), positive(random)};
    // Shorter than the base, as long, longer.
    const Rational top = i == 0 ? size[0] : positive(random);
    const Polyhedron p = sound(wedge(size, top));
    EXPECT_EQ(p.points.size(), 6u);
    EXPECT_EQ(p.face_count(), 5u);
    EXPECT_EQ(volume(p), size[1] * size[2] * (2 * size[0] + top) / 6);
    EXPECT_TRUE(trihedral(p).has_value());
    EXPECT_EQ(std::count_if(p.points.begin(), p.points.end(),
                            [&](const Vector& v) { return v[2] == size[2] && v[1] == size[1] / 2; }),
              2);
  }
  expect_refusal(wedge({1, 1, 1}, 0));
  expect_refusal(wedge({1, 1, 1}, -1));
}

TEST(PrimitivesTest, Frustums) {
  std::mt19937_64 random = generator(606);
  for (const std::uint32_t sides : {3u, 4u, 5u, 8u, 13u, 40u})
    for (const Fit fit : all_fits) {
      const Rational area = doubled_area(circle_polygon(sides, 1, fit)) / 2, h = positive(random);
      const Rational b = positive(random), t = positive(random);
      for (const auto& [bottom, top] : {std::pair(b, t), {t, b}, {b, b}, {b, Rational(0)}, {Rational(0), t}}) {
        const Polyhedron p = sound(frustum(sides, bottom, top, h, fit));
        EXPECT_EQ(volume(p), area * h * (bottom * bottom + bottom * top + top * top) / 3);
        const bool cone = bottom == 0 || top == 0;
        EXPECT_EQ(p.face_count(), sides + (cone ? 1 : 2));
        EXPECT_EQ(p.points.size(), cone ? sides + 1 : 2 * sides);
        EXPECT_EQ(trihedral(p).has_value(), !cone || sides == 3) << sides;
        for (const Vector& v : p.points) ASSERT_TRUE(v[2] == 0 || v[2] == h);
      }
    }
  expect_refusal(frustum(2, 1, 1, 1, Fit::inscribed));
  expect_refusal(frustum(0, 1, 1, 1, Fit::inscribed));
  expect_refusal(frustum(65537, 1, 1, 1, Fit::inscribed));
  expect_refusal(frustum(8, 1, 1, 0, Fit::inscribed));
  expect_refusal(frustum(8, 1, 1, -1, Fit::inscribed));
  expect_refusal(frustum(8, 0, 0, 1, Fit::inscribed));
  expect_refusal(frustum(8, -1, 1, 1, Fit::inscribed));
  expect_refusal(frustum(8, 1, -1, 1, Fit::inscribed));
}

TEST(PrimitivesTest, Spheres) {
  const Rational r(5, 3);
  Rational before = 0;
  for (const std::uint32_t sides : {4u, 6u, 8u, 10u, 16u, 30u}) {
    const Polyhedron p = sound(sphere(r, sides));
    for (const Vector& v : p.points) ASSERT_EQ(dot(v, v), r * r);
    EXPECT_EQ(p.points.size(), 2 + sides * (sides / 2 - 1));
    EXPECT_EQ(p.face_count(), sides * (sides / 2));
    EXPECT_FALSE(trihedral(p).has_value());
    EXPECT_GT(volume(p), before);
    before = volume(p);
    EXPECT_LT(before, true_pi(MPFR_RNDD) * 4 / 3 * r * r * r);
  }
  EXPECT_GT(before, true_pi(MPFR_RNDU) * 4 / 3 * r * r * r * 97 / 100);
  expect_refusal(sphere(1, 2));
  expect_refusal(sphere(1, 3));
  expect_refusal(sphere(1, 5));
  expect_refusal(sphere(1, 4098));
  expect_refusal(sphere(0, 8));
  expect_refusal(sphere(-1, 8));
}

TEST(PrimitivesTest, Tori) {
  const Rational R(7, 2), r(4, 3);
  for (const auto& [sides, minor_sides] : {std::pair(3u, 3u), {3u, 8u}, {4u, 4u}, {12u, 5u}, {20u, 9u}}) {
    const Polyhedron p = sound(torus(R, r, sides, minor_sides), 0);
    EXPECT_EQ(p.points.size(), sides * minor_sides);
    EXPECT_EQ(p.face_count(), sides * minor_sides);
    EXPECT_FALSE(trihedral(p).has_value());
    for (const Vector& v : p.points) {
      const Rational w = v[0] * v[0] + v[1] * v[1], s = w + v[2] * v[2] + R * R - r * r;
      ASSERT_EQ(s * s, 4 * R * R * w);
    }
    EXPECT_LT(volume(p), 2 * true_pi(MPFR_RNDD) * true_pi(MPFR_RNDD) * R * r * r);
  }
  expect_refusal(torus(2, 1, 2, 8));
  expect_refusal(torus(2, 1, 8, 2));
  expect_refusal(torus(2, 1, 65537, 8));
  expect_refusal(torus(2, 1, 4096, 1025));
  expect_refusal(torus(2, 0, 8, 8));
  expect_refusal(torus(2, -1, 8, 8));
  expect_refusal(torus(1, 1, 8, 8));
  expect_refusal(torus(1, 2, 8, 8));
}

TEST(PrimitivesTest, TangentSpheres) {
  const Rational r(3, 7);
  for (std::uint32_t n = 4; n <= 100; n += n < 24 ? 1 : 19) {
    const auto made = tangent_sphere(r, n);
    ASSERT_TRUE(made.has_value());
    const auto& planes = made.value();
    ASSERT_EQ(planes.size(), n);
    ASSERT_EQ(std::set(planes.begin(), planes.end()).size(), n);
    std::vector<Vector> touching;
    for (const WidePlane& p : planes) {
      const Vector normal{p.n[0], p.n[1], p.n[2]};
      ASSERT_LT(p.d, 0);
      ASSERT_EQ(Rational(p.d * p.d), r * r * dot(normal, normal));
      touching.push_back(Rational(-p.d) / dot(normal, normal) * normal);
      ASSERT_EQ(value(p, touching.back()), 0);
    }
    // Between them they leave no way out: the origin is inside the hull of the points of contact.
    const auto hull = convex_hull(touching);
    ASSERT_TRUE(hull.has_value()) << n;
    for (const WidePlane& p : hull.value().planes) EXPECT_LT(value(p, {0, 0, 0}), 0) << n;
  }
  expect_refusal(tangent_sphere(1, 3));
  expect_refusal(tangent_sphere(1, 65537));
  expect_refusal(tangent_sphere(0, 8));
  expect_refusal(tangent_sphere(-1, 8));
}

TEST(PrimitivesTest, ExtrusionsOfOnePolygon) {
  std::mt19937_64 random = generator(607);
  for (int i = 0; i < 60; ++i) {
    const Loop l = star(random, random_rational(random, 10), random_rational(random, 10), positive(random));
    if (std::set(l.begin(), l.end()).size() != l.size()) continue;
    Vector along = random_vector(random, 10);
    if (along[2] == 0) along[2] = i % 2 == 0 ? 1 : -2;
    const Polyhedron p = sound(extrusion({{l}}, along));
    EXPECT_EQ(volume(p), magnitude(doubled_area(l) / 2 * along[2]));
    EXPECT_TRUE(trihedral(p).has_value());
    // In either orientation the same.
    const Polyhedron q = sound(extrusion({{reversed(l)}}, along));
    EXPECT_EQ(std::set(p.points.begin(), p.points.end()), std::set(q.points.begin(), q.points.end()));
    EXPECT_EQ(std::set(p.planes.begin(), p.planes.end()), std::set(q.planes.begin(), q.planes.end()));
    // The polygon itself is one end, whatever the sign of z.
    for (const Vector& v : p.points) ASSERT_TRUE(v[2] == 0 || v[2] == along[2]);
    for (const PlanePoint& c : l) {
      ASSERT_NE(std::find(p.points.begin(), p.points.end(), Vector{c[0], c[1], 0}), p.points.end());
      ASSERT_NE(std::find(p.points.begin(), p.points.end(), Vector{c[0] + along[0], c[1] + along[1], along[2]}),
                p.points.end());
    }
  }
}

TEST(PrimitivesTest, ExtrusionsWithHoles) {
  std::mt19937_64 random = generator(608);
  for (int i = 0; i < 20; ++i) {
    std::vector<Loop> polygon{square(0, 0, 40)};
    Rational area = 1600;
    const auto holes = static_cast<long>(below(random, 5));
    for (long h = 0; h < holes; ++h) {
      Loop hole = star(random, 5 + 8 * h, 10 + Rational(below(random, 20)), 3);
      area -= magnitude(doubled_area(hole)) / 2;
      polygon.push_back(below(random, 2) == 0 ? hole : reversed(hole));
    }
    if (below(random, 2) == 0) polygon[0] = reversed(polygon[0]);
    const Rational z = below(random, 2) == 0 ? Rational(3, 2) : Rational(-5, 7);
    const Polyhedron p = sound(extrusion({polygon}, {1, -2, z}), 2 - 2 * holes);
    EXPECT_EQ(volume(p), area * magnitude(z));
    EXPECT_TRUE(trihedral(p).has_value());
    EXPECT_EQ(loop_count(p), p.face_count() + 2 * static_cast<std::size_t>(holes));
  }
}

TEST(PrimitivesTest, ExtrusionsOfSeveralPolygons) {
  // Side by side, one in the hole of another, and one in the hole of that.
  const Polygons nested{{square(10, 10, 10), square(12, 12, 6)},
                        {square(0, 0, 30), square(5, 5, 20)},
                        {square(13, 13, 1)},
                        {square(15, 13, 1)},
                        {square(40, 0, 5)}};
  for (int turn = 0; turn < 5; ++turn) {
    Polygons polygons = nested;
    std::rotate(polygons.begin(), polygons.begin() + turn, polygons.end());
    // Two rings of genus 1, three blocks.
    const Polyhedron p = sound(extrusion(polygons, {0, 0, 2}), 6);
    EXPECT_EQ(volume(p), 2 * (100 - 36 + 900 - 400 + 1 + 1 + 25));
    EXPECT_TRUE(trihedral(p).has_value());
  }
}

}  // namespace
}  // namespace quoin::rounding::testing
