#include "rounding/primitives.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "rounding/enclosure.h"
#include "tests/rounding/support.h"

namespace quoin::rounding::testing {
namespace {

using Loop = std::vector<PlanePoint>;
using Polygons = std::vector<std::vector<Loop>>;
using Edge = std::pair<std::uint32_t, std::uint32_t>;

constexpr Fit all_fits[] = {Fit::inscribed, Fit::circumscribed, Fit::equal_area};

Rational half() { return Rational(1, 2); }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Rational volume(const Polyhedron& p) { return sixfold_volume(p) / 6; }
std::size_t loop_count(const Polyhedron& p) { return p.loop_corners.size() - 1; }

/// The first thing that is wrong with a boundary; nothing when it is closed, planar, oriented and its faces maximal.
std::string fault(const Polyhedron& p) {
  if (std::set(p.points.begin(), p.points.end()).size() != p.points.size()) return "a point is there twice";
  if (p.face_loops.size() != p.planes.size() + 1 || p.face_loops.back() != loop_count(p) ||
      p.loop_corners.back() != p.corners.size())
    return "lists do not fit";
  std::map<Edge, std::uint32_t> faces;
  std::vector<bool> used(p.points.size());
  for (std::uint32_t f = 0; f < p.face_count(); ++f) {
    const std::string face = "face " + std::to_string(f);
    const WidePlane& plane = p.planes[f];
    if (plane != wide_plane({plane.n[0], plane.n[1], plane.n[2]}, plane.d)) return face + ": not in lowest terms";
    Vector area{0, 0, 0};
    bool on = true, single = true;
    p.for_edges(f, [&](std::uint32_t u, std::uint32_t v) {
      on = on && value(plane, p.points[u]) == 0;
      single = single && u != v && faces.try_emplace({u, v}, f).second;
      area = area + cross(p.points[u], p.points[v]);
      used[u] = true;
    });
    if (!on) return face + ": a corner off its plane";
    if (!single) return face + ": an edge is there twice";
    const Vector n{plane.n[0], plane.n[1], plane.n[2]};
    if (cross(area, n) != Vector{0, 0, 0} || dot(area, n) <= 0) return face + ": turned round";
    if (p.face_loops[f] == p.face_loops[f + 1]) return face + ": no loop";
    for (std::uint32_t j = p.face_loops[f]; j < p.face_loops[f + 1]; ++j) {
      const auto l = p.loop(j);
      if (l.size() < 3) return face + ": a loop of two";
      Vector part{0, 0, 0};
      for (std::size_t i = 0; i < l.size(); ++i) {
        const Vector &a = p.points[l[i]], &b = p.points[l[(i + 1) % l.size()]], &c = p.points[l[(i + 2) % l.size()]];
        part = part + cross(a, b);
        if (cross(b - a, c - b) == Vector{0, 0, 0}) return face + ": a straight corner";
      }
      if ((dot(part, n) > 0) != (j == p.face_loops[f])) return face + ": a loop turned round";
    }
  }
  for (const auto& [edge, f] : faces) {
    const auto other = faces.find({edge.second, edge.first});
    if (other == faces.end()) return "an open edge";
    if (p.planes[other->second] == p.planes[f]) return "two neighbours on one plane";
  }
  if (std::find(used.begin(), used.end(), false) != used.end()) return "a point on no face";
  if (sixfold_volume(p) <= 0) return "inside out";
  return "";
}

/// Vertices - edges + faces - loops beyond the first: 2 for a ball.
long euler(const Polyhedron& p) {
  return static_cast<long>(p.points.size()) - static_cast<long>(p.corners.size() / 2) +
         2 * static_cast<long>(p.face_count()) - static_cast<long>(loop_count(p));
}

Polyhedron made(const Result<Polyhedron>& r) {
  EXPECT_TRUE(r.has_value()) << r.error().message;
  return r ? r.value() : Polyhedron{};
}
/// A sound primitive.
Polyhedron sound(const Result<Polyhedron>& r, long characteristic = 2) {
  const Polyhedron p = made(r);
  EXPECT_EQ(fault(p), "");
  EXPECT_EQ(euler(p), characteristic);
  return p;
}
template <class T>
void expect_refusal(const Result<T>& r) {
  ASSERT_FALSE(r.has_value());
  EXPECT_EQ(r.error().code, "bad-primitive");
  EXPECT_GT(r.error().message.size(), 10u);
}

Rational positive(std::mt19937_64& random) { return magnitude(random_rational(random, 40)) + Rational(1, 1000); }

Rational doubled_area(const Loop& l) {
  Rational sum = 0;
  for (std::size_t i = 0; i < l.size(); ++i) {
    const PlanePoint &a = l[i], &b = l[(i + 1) % l.size()];
    sum += a[0] * b[1] - a[1] * b[0];
  }
  return sum;
}
Loop reversed(Loop l) {
  std::reverse(l.begin(), l.end());
  return l;
}
Loop square(const Rational& x, const Rational& y, const Rational& size) {
  return {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
}
/// A star-shaped polygon about (x, y), of radius at most `radius`.
Loop star(std::mt19937_64& random, const Rational& x, const Rational& y, const Rational& radius) {
  Loop l;
  const auto n = 3 + below(random, 9);
  for (std::uint64_t i = 0; i < n; ++i) {
    const PlanePoint p = circle_point(Rational(360 * i, n) + Rational(below(random, 20), 10), 1 << 6);
    const Rational r = radius * (1 + Rational(below(random, 100))) / 100;
    l.push_back({x + p[0] * r, y + p[1] * r});
  }
  return l;
}

// Circles.

TEST(PrimitivesTest, CirclePointsAreOnTheCircle) {
  std::mt19937_64 random = generator(601);
  for (int i = 0; i < 400; ++i) {
    const Rational degrees = i < 72 ? Rational(5 * i) : random_rational(random, 30);
    const Integer precision = power_of_2(1 + static_cast<unsigned>(below(random, 40)));
    const PlanePoint p = circle_point(degrees, precision);
    ASSERT_EQ(p[0] * p[0] + p[1] * p[1], 1) << degrees;
    ASSERT_EQ(circle_point(degrees + 360, precision), p);
    // About the axes, and about the diagonals but for the points next to them: those themselves are irrational.
    ASSERT_EQ(circle_point(-degrees, precision), (PlanePoint{p[0], Rational(-p[1])})) << degrees;
    ASSERT_EQ(circle_point(180 - degrees, precision), (PlanePoint{Rational(-p[0]), p[1]})) << degrees;
    if (denominator(Rational(degrees / 45)) == 1 && denominator(Rational(degrees / 90)) != 1) continue;
    ASSERT_EQ(circle_point(90 - degrees, precision), (PlanePoint{p[1], p[0]})) << degrees;
  }
  EXPECT_EQ(circle_point(0, 9), (PlanePoint{1, 0}));
  EXPECT_EQ(circle_point(90, 9), (PlanePoint{0, 1}));
  EXPECT_EQ(circle_point(180, 9), (PlanePoint{-1, 0}));
  EXPECT_EQ(circle_point(-180, 9), (PlanePoint{-1, 0}));
  EXPECT_EQ(circle_point(270, 9), (PlanePoint{0, -1}));
  EXPECT_EQ(circle_point(360, 9), (PlanePoint{1, 0}));
  // tan(15 degrees) = 0.2679 and 3/11 = 0.2727, 4/15 = 0.2667.
  EXPECT_EQ(circle_point(30, 4), (PlanePoint{Rational(15, 17), Rational(8, 17)}));
  EXPECT_EQ(circle_point(30, 11), (PlanePoint{Rational(56, 65), Rational(33, 65)}));
  EXPECT_EQ(circle_point(60, 15), (PlanePoint{Rational(120, 241), Rational(209, 241)}));
}

// The stated angle: |t - tan(angle / 2)| <= 1 / (2 Q), and no fraction is closer.
TEST(PrimitivesTest, CirclePointsAreTheClosest) {
  std::mt19937_64 random = generator(602);
  for (int i = 0; i < 150; ++i) {
    const Rational degrees = Rational(1 + below(random, 45'000'000), 1'000'000);
    const std::uint64_t limit = 1 + below(random, 60);
    const auto distance = [&](const Rational& t) {
      const Rational low = true_tangent(degrees / 2, MPFR_RNDD), high = true_tangent(degrees / 2, MPFR_RNDU);
      EXPECT_LT(high - low, Rational(1, power_of_2(500)));
      return std::pair(std::min(magnitude(t - low), magnitude(t - high)),
                       std::max(magnitude(t - low), magnitude(t - high)));
    };
    for (const Integer& precision : {Integer(limit), Integer(limit) * 100'000'007}) {
      const PlanePoint p = circle_point(degrees, precision);
      const Rational t = p[1] / (1 + p[0]);
      ASSERT_LE(denominator(t), precision);
      ASSERT_LE(distance(t).second, Rational(1, 2 * precision) + Rational(1, power_of_2(500)));
      if (precision > 60) continue;
      for (std::uint64_t q = 1; q <= limit; ++q) {
        const Rational other(nearest_integer(true_tangent(degrees / 2, MPFR_RNDD) * q), q);
        if (other != t) {
          ASSERT_GT(distance(other).second, distance(t).first) << degrees;
        }
      }
    }
  }
}

TEST(PrimitivesTest, PolygonsAreConvexAndSymmetric) {
  for (const std::uint32_t sides : {3u, 4u, 5u, 6u, 7u, 8u, 12u, 16u, 17u, 36u, 48u, 100u, 360u}) {
    for (const Fit fit : all_fits) {
      const Loop l = circle_polygon(sides, Rational(7, 3), fit);
      ASSERT_EQ(l.size(), sides);
      for (std::size_t i = 0; i < sides; ++i) {
        const PlanePoint &a = l[i], &b = l[(i + 1) % sides], &c = l[(i + 2) % sides];
        ASSERT_GT((b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]), 0) << sides;
        ASSERT_GT(a[0] * b[1] - a[1] * b[0], 0);
      }
      std::set<PlanePoint> set(l.begin(), l.end());
      ASSERT_EQ(set.size(), sides);
      for (const PlanePoint& p : l) {
        ASSERT_EQ(set.count({p[0], -p[1]}), 1u) << sides;
        if (sides % 2 == 0) {
          ASSERT_EQ(set.count({-p[0], p[1]}), 1u) << sides;
        }
        if (sides % 4 == 0 && sides % 8 != 0) {
          ASSERT_EQ(set.count({p[1], p[0]}), 1u) << sides;
        }
      }
    }
  }
}

TEST(PrimitivesTest, Fits) {
  std::mt19937_64 random = generator(603);
  const Enclosure pi = enclosed_pi(80);
  ASSERT_LE(pi.low, true_pi(MPFR_RNDD));
  ASSERT_GE(pi.high, true_pi(MPFR_RNDU));
  for (const std::uint32_t sides : {3u, 4u, 5u, 8u, 11u, 32u, 100u}) {
    const Rational r = positive(random);
    Rational areas[3];
    for (std::size_t k = 0; k < 3; ++k) areas[k] = doubled_area(circle_polygon(sides, r, all_fits[k])) / 2;
    for (const PlanePoint& p : circle_polygon(sides, r, Fit::inscribed)) ASSERT_EQ(p[0] * p[0] + p[1] * p[1], r * r);
    const Loop around = circle_polygon(sides, r, Fit::circumscribed);
    for (std::size_t i = 0; i < sides; ++i) {
      const PlanePoint &a = around[i], &b = around[(i + 1) % sides];
      const Rational x = b[0] - a[0], y = b[1] - a[1], moment = a[0] * b[1] - a[1] * b[0];
      ASSERT_EQ(moment * moment, r * r * (x * x + y * y));
      // It touches between its corners.
      ASSERT_LT(a[0] * x + a[1] * y, 0);
      ASSERT_GT(b[0] * x + b[1] * y, 0);
    }
    const Rational bound = Rational(1, power_of_2(40));
    EXPECT_GT(areas[2], pi.low * r * r * (1 - bound));
    EXPECT_LT(areas[2], pi.high * r * r * (1 + bound));
    EXPECT_LT(areas[0], pi.low * r * r);
    EXPECT_GT(areas[1], pi.high * r * r);
  }
}

// Solids with plane sides.

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

// Round solids.

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

// Extrusions.

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

TEST(PrimitivesTest, ExtrusionsDropStraightCorners) {
  const Loop plain = square(0, 0, 2);
  const Loop more{{1, 0}, {Rational(3, 2), 0}, {2, 0}, {2, half()}, {2, 1}, {2, 2}, {0, 2}, {0, 1},
                  {0, 0}, {half(), 0}};
  for (const Loop& l : {more, reversed(more)}) {
    const Polyhedron p = sound(extrusion({{l}}, {0, 0, 1}));
    EXPECT_EQ(p.face_count(), 6u);
    EXPECT_EQ(p.points.size(), 8u);
    EXPECT_EQ(volume(p), 4);
  }
}

// A corner given twice in a row is no corner more, or a refusal; never another polygon.
TEST(PrimitivesTest, ExtrusionsWithRepeatedCorners) {
  for (std::size_t at = 0; at < 4; ++at)
    for (std::size_t times = 1; times <= 2; ++times) {
      Loop l = square(0, 0, 2);
      l.insert(l.begin() + static_cast<std::ptrdiff_t>(at), times, PlanePoint(l[at]));
      const auto p = extrusion({{l}}, {0, 0, 1});
      if (p) {
        EXPECT_EQ(volume(p.value()), 4) << at;
      } else {
        EXPECT_EQ(p.error().code, "bad-primitive");
      }
    }
  // The first corner again at the end.
  Loop closed = square(0, 0, 2);
  closed.push_back(closed.front());
  const auto p = extrusion({{closed}}, {0, 0, 1});
  if (p) {
    EXPECT_EQ(volume(p.value()), 4);
  }
}

TEST(PrimitivesTest, ExtrusionsRefuseWhatIsNoRegion) {
  const Vector up{0, 0, 1};
  const Loop big = square(0, 0, 10);
  expect_refusal(extrusion({{big}}, {1, 2, 0}));
  expect_refusal(extrusion({{big}}, {0, 0, 0}));
  expect_refusal(extrusion({{}}, up));
  expect_refusal(extrusion({{big}, {}}, up));
  expect_refusal(extrusion({{Loop{}}}, up));
  expect_refusal(extrusion({{{{0, 0}, {1, 1}}}}, up));
  expect_refusal(extrusion({{{{0, 0}, {1, 1}, {3, 3}}}}, up));
  expect_refusal(extrusion({{big, {{1, 1}, {2, 2}, {3, 3}, {2, 2}}}}, up));
  // A bow tie, with areas that cancel and with ones that do not.
  expect_refusal(extrusion({{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}}}, up));
  expect_refusal(extrusion({{{{0, 0}, {3, 3}, {3, 0}, {0, 2}}}}, up));
  // A corner on another side; a corner that is two.
  expect_refusal(extrusion({{{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}}}, up));
  expect_refusal(extrusion({{{{0, 0}, {4, 0}, {2, 2}, {4, 4}, {0, 4}, {2, 2}}}}, up));
  // Holes outside, around, crossing, touching, in one another, twice.
  expect_refusal(extrusion({{big, square(20, 0, 1)}}, up));
  expect_refusal(extrusion({{big, square(-1, -1, 12)}}, up));
  expect_refusal(extrusion({{big, square(8, 8, 4)}}, up));
  expect_refusal(extrusion({{big, square(8, 4, 2)}}, up));
  expect_refusal(extrusion({{big, square(9, 9, 1)}}, up));
  expect_refusal(extrusion({{big, {{5, 0}, {6, 3}, {4, 3}}}}, up));
  expect_refusal(extrusion({{big, big}}, up));
  expect_refusal(extrusion({{big, square(2, 2, 4), square(3, 3, 1)}}, up));
  expect_refusal(extrusion({{big, square(3, 3, 1), square(2, 2, 4)}}, up));
  expect_refusal(extrusion({{big, square(2, 2, 4), square(5, 5, 3)}}, up));
  expect_refusal(extrusion({{big, square(2, 2, 2), square(4, 2, 2)}}, up));
  expect_refusal(extrusion({{big, square(2, 2, 2), square(4, 4, 2)}}, up));
  // Polygons that overlap, touch, lie in one another.
  expect_refusal(extrusion({{big}, {square(5, 5, 10)}}, up));
  expect_refusal(extrusion({{big}, {square(10, 0, 10)}}, up));
  expect_refusal(extrusion({{big}, {square(10, 10, 10)}}, up));
  expect_refusal(extrusion({{big}, {square(5, 5, 1)}}, up));
  expect_refusal(extrusion({{square(5, 5, 1)}, {big}}, up));
  expect_refusal(extrusion({{big}, {big}}, up));
  expect_refusal(extrusion({{big, square(2, 2, 4)}, {square(2, 2, 4)}}, up));
  expect_refusal(extrusion({{big, square(2, 2, 4)}, {square(7, 7, 1)}}, up));
  // A side that runs out and back.
  expect_refusal(extrusion({{{{0, 0}, {4, 0}, {4, 6}, {4, 4}, {0, 4}}}}, up));
}

// Second way for crossings: all pairs of sides in all small pentagons.
TEST(PrimitivesTest, ExtrusionsRefuseAllCrossings) {
  std::mt19937_64 random = generator(609);
  const auto orient = [](const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
    return sign_of(Rational((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])));
  };
  const auto between_ends = [&](const PlanePoint& p, const PlanePoint& a, const PlanePoint& b) {
    return orient(a, b, p) == 0 && (p[0] - a[0]) * (p[0] - b[0]) + (p[1] - a[1]) * (p[1] - b[1]) <= 0;
  };
  int simple_ones = 0;
  for (int i = 0; i < 4000; ++i) {
    Loop l(4 + below(random, 3));
    for (PlanePoint& p : l) p = {between(random, 0, 4), between(random, 0, 4)};
    const std::size_t n = l.size();
    bool simple = true, straight = false;
    for (std::size_t a = 0; a < n; ++a) {
      straight = straight || orient(l[a], l[(a + 1) % n], l[(a + 2) % n]) == 0;
      for (std::size_t b = 0; b < n; ++b) {
        if (b != a && b != (a + 1) % n) simple = simple && !between_ends(l[b], l[a], l[(a + 1) % n]);
        const PlanePoint &p = l[a], &q = l[(a + 1) % n], &r = l[b], &s = l[(b + 1) % n];
        simple = simple && !(orient(p, q, r) * orient(p, q, s) < 0 && orient(r, s, p) * orient(r, s, q) < 0);
      }
    }
    // Straight corners have a test of their own.
    if (straight) continue;
    simple_ones += simple ? 1 : 0;
    const auto p = extrusion({{l}}, {0, 0, 1});
    ASSERT_EQ(p.has_value(), simple);
    if (p) {
      ASSERT_EQ(volume(sound(p)), magnitude(doubled_area(l)) / 2);
    }
  }
  EXPECT_GT(simple_ones, 200);
}

// Hulls.

TEST(PrimitivesTest, HullOfACubeGrid) {
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
TEST(PrimitivesTest, HullsAgainstTheSearch) {
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
    ASSERT_EQ(again.corners, p.corners);
  }
  EXPECT_GT(solid, 60);
  EXPECT_GT(flat, 10);
}

TEST(PrimitivesTest, HullsOfManyPoints) {
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

TEST(PrimitivesTest, HullsOfFlatPointsAreRefused) {
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

TEST(PrimitivesTest, HullsAgainFromTheirPlanes) {
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

TEST(PrimitivesTest, WhatPlanesDoNotBound) {
  const Polyhedron cube = made(block({2, 2, 2}));
  std::vector<WidePlane> planes = cube.planes;
  expect_same(sound(convex_polyhedron(planes, {1, Rational(1, 3), Rational(1, 7)})), cube);
  while (!planes.empty()) {
    planes.pop_back();
    const auto open = convex_polyhedron(planes, {1, 1, 1});
    ASSERT_FALSE(open.has_value()) << planes.size();
    EXPECT_EQ(open.error().code, "unbounded");
  }
}

}  // namespace
}  // namespace quoin::rounding::testing
