// Closed but otherwise arbitrary meshes become the solids of their positive winding numbers.
#include <gtest/gtest.h>

#include <algorithm>

#include "booleans/body/locate.h"
#include "booleans/resolve.h"
#include "tests/booleans/support.h"

namespace quoin::booleans::testing {
namespace {

using exact::Rational;

Body resolved(std::span<const Body> parts, std::uint64_t& crossings) {
  return sound(resolve(merged(parts), crossings));
}
Body resolved(std::initializer_list<Body> parts) {
  std::uint64_t crossings = 0;
  return resolved(std::vector<Body>(parts), crossings);
}
Body cube(std::int64_t low, std::int64_t high) { return box({low, low, low}, {high, high, high}); }

TEST(Resolve, CleanMeshesStay) {
  std::uint64_t crossings = 7;
  const Body a = cube(0, 2);
  EXPECT_TRUE(same(resolved(std::vector{a}, crossings), a));
  EXPECT_EQ(crossings, 0u);
  EXPECT_TRUE(same(resolved(std::vector{a, cube(5, 6)}, crossings), any(a, cube(5, 6))));
  EXPECT_EQ(crossings, 0u);
}

TEST(Resolve, OverlappingBoxes) {
  const Body a = cube(0, 2), b = cube(1, 3);
  std::uint64_t crossings = 0;
  const Body r = resolved(std::vector{a, b}, crossings);
  EXPECT_GT(crossings, 0u);
  EXPECT_TRUE(same(r, any(a, b)));
  EXPECT_EQ(volume(r), 15);
}

TEST(Resolve, NestedShellsOfOneOrientation) {
  EXPECT_TRUE(same(resolved({cube(0, 6), cube(1, 5)}), cube(0, 6)));
  EXPECT_TRUE(same(resolved({cube(0, 6), cube(1, 5), cube(2, 4)}), cube(0, 6)));
}

TEST(Resolve, InsideOutShellsAreVoids) {
  const Body outer = cube(0, 6), hollow = resolved({outer, inside_out(cube(1, 5))});
  EXPECT_TRUE(same(hollow, minus(outer, cube(1, 5))));
  EXPECT_EQ(volume(hollow), 216 - 64);
  EXPECT_TRUE(same(resolved({outer, inside_out(cube(1, 5)), cube(2, 4)}), any(hollow, cube(2, 4))));
  // A void that reaches out of its solid takes nothing from the outside: the winding number there is -1.
  EXPECT_TRUE(same(resolved({outer, inside_out(cube(3, 9))}), minus(outer, cube(3, 9))));
  // One void in two overlapping solids leaves the winding number 1 where both are.
  EXPECT_TRUE(same(resolved({outer, outer, inside_out(cube(1, 5))}), outer));
}

TEST(Resolve, DuplicatedShells) {
  EXPECT_TRUE(same(resolved({cube(0, 2), cube(0, 2)}), cube(0, 2)));
  EXPECT_TRUE(same(resolved({cube(0, 2), cube(0, 2), cube(0, 2)}), cube(0, 2)));
  EXPECT_TRUE(empty(resolved({cube(0, 2), inside_out(cube(0, 2))})));
}

TEST(Resolve, TouchingShells) {
  const Body a = cube(0, 2);
  EXPECT_TRUE(same(resolved({a, box({2, 0, 0}, {4, 2, 2})}), box({0, 0, 0}, {4, 2, 2})));          // in a face
  EXPECT_TRUE(same(resolved({a, box({2, 1, 1}, {4, 3, 3})}), any(a, box({2, 1, 1}, {4, 3, 3}))));  // in part of one
  EXPECT_TRUE(same(resolved({a, box({2, 2, 0}, {4, 4, 2})}), any(a, box({2, 2, 0}, {4, 4, 2}))));  // in an edge
  EXPECT_TRUE(same(resolved({a, cube(2, 4)}), any(a, cube(2, 4))));                                // in a vertex
  // A void that touches the outside from within, in a face, an edge and a vertex.
  const Body outer = cube(0, 6);
  for (const Body& hole : {box({0, 1, 1}, {2, 3, 3}), box({0, 0, 1}, {2, 2, 3}), cube(0, 2)})
    EXPECT_TRUE(same(resolved({outer, inside_out(hole)}), minus(outer, hole)));
}

// Two boxes side by side, one of which is cut away from the wall between them: that has four faces at each edge, two of
// which become parts of one face when the wall is gone (B4).
TEST(Resolve, FacesJoinedWhereAWallIsGone) {
  const Body a = cube(0, 4), b = box({4, 0, 0}, {8, 4, 4}), post = box({1, 1, 2}, {2, 2, 6});
  const Body r = resolved({a, b, post});
  EXPECT_TRUE(same(r, any(box({0, 0, 0}, {8, 4, 4}), post)));
  for (const auto& t : r.triangles)  // the face with the post is a polygon
    EXPECT_FALSE(std::all_of(t.begin(), t.end(), [&](std::uint32_t v) { return r.grid_points[v][2] == 4; }));
}

TEST(Resolve, CoplanarOverlaps) {
  const Body a = box({0, 0, 0}, {4, 4, 2}), b = box({2, 1, 0}, {6, 3, 2}), c = box({1, 1, 2}, {3, 3, 4});
  EXPECT_TRUE(same(resolved({a, b}), any(a, b)));
  EXPECT_TRUE(same(resolved({a, c}), any(a, c)));
  EXPECT_TRUE(same(resolved({a, b, c}), combined(Rule::any, {&a, &b, &c})));
}

/// The prism over the closed polygon 0, 1, .., 4 of a pentagram: winding number 2 in the middle, 1 in the tips.
TEST(Resolve, OneSelfCrossingShell) {
  const std::array<std::array<std::int64_t, 2>, 5> tips{{{0, 10}, {-6, -8}, {9, 3}, {-9, 3}, {6, -8}}};
  std::vector<Vector> points{{0, 0, 0}, {0, 0, 4}};
  for (const auto& p : tips)
    for (const std::int64_t z : {0, 4}) points.push_back({p[0], p[1], z});
  std::vector<Triangle> faces;
  for (std::uint32_t i = 0; i < 5; ++i) {
    const std::uint32_t a = 2 + 2 * i, b = 2 + 2 * ((i + 1) % 5);
    faces.insert(faces.end(), {{0, b, a}, {1, a + 1, b + 1}, {a, b, b + 1}, {a, b + 1, a + 1}});
  }
  const Body star = *mesh(points, faces);
  std::uint64_t crossings = 0;
  const Body r = sound(resolve(star, crossings));
  EXPECT_GT(crossings, 0u);
  EXPECT_EQ(locate(r, {Rational(0), Rational(0), Rational(2)}), 1);
  EXPECT_EQ(locate(r, {Rational(0), Rational(9), Rational(2)}), 1);
  EXPECT_EQ(locate(r, {Rational(0), Rational(-7), Rational(2)}), -1);
  const Canonical form = canonical(r);
  EXPECT_EQ(form.face_count(), 12u);  // ten sides, top and bottom
  EXPECT_EQ(form.vertices.size(), 20u);
  // The five triangles centre, tip, next tip, whose union the star is.
  std::vector<Body> parts;
  for (std::size_t i = 0; i < 5; ++i) {
    const auto &p = tips[i], &q = tips[(i + 1) % 5];
    parts.push_back(*prism({0, 0, 0}, {p[0], p[1], 0}, {q[0], q[1], 0}, {0, 0, 4}));
  }
  EXPECT_TRUE(same(r, evaluated(parts, Expression::flat(Rule::any, 5))));
}

TEST(Resolve, RandomSoupsAreTheirUnions) {
  for (const Family family : families) {
    for (std::uint64_t i = 0; i < (family == Family::spheres ? 6u : 50u); ++i) {
      SCOPED_TRACE(std::string(name_of(family)) + ", " + case_name(i));
      Random random(200 + static_cast<std::uint64_t>(family), i);
      Solids solids(random, family);
      std::vector<Body> parts;
      for (std::uint64_t n = 1 + random.below(4); n > 0; --n) parts.push_back(solids.raw());
      std::uint64_t crossings = 0;
      const Body r = resolved(parts, crossings);
      ASSERT_TRUE(same(r, evaluated(parts, Expression::flat(Rule::any, static_cast<std::uint32_t>(parts.size())))));
    }
  }
}

/// Shells of either orientation: the winding number of a point is the sum over the parts.
TEST(Resolve, RandomSoupsOfEitherOrientationByPoints) {
  for (const Family family : {Family::tiny, Family::lattice, Family::skew}) {
    for (std::uint64_t i = 0; i < 50; ++i) {
      SCOPED_TRACE(std::string(name_of(family)) + ", " + case_name(i));
      Random random(210 + static_cast<std::uint64_t>(family), i);
      Solids solids(random, family);
      // One part more stands far away, so that the mesh is never a single inverted shell.
      std::vector<Body> plain{box({50, 50, 50}, {51, 51, 51})}, parts = plain;
      std::vector<int> orientation{1};
      for (std::uint64_t n = 2 + random.below(3); n > 0; --n) {
        plain.push_back(solids.raw());
        orientation.push_back(random.one_in(3) ? -1 : 1);
        parts.push_back(orientation.back() > 0 ? plain.back() : inside_out(plain.back()));
      }
      std::uint64_t crossings = 0;
      const Body r = resolved(parts, crossings);
      for (int k = 0; k < 40; ++k) {
        std::array<Rational, 3> p;
        for (Rational& x : p) x = Rational(random.between(-12, 12), random.between(1, 5));
        int winding = 0;
        bool on = false;
        for (std::size_t j = 0; j < plain.size(); ++j) {
          const int where = locate(plain[j], p);
          on = on || where == 0;
          if (where > 0) winding += orientation[j];
        }
        if (!on) {
          ASSERT_EQ(locate(r, p), winding > 0 ? 1 : -1);
        }
      }
    }
  }
}

}  // namespace
}  // namespace quoin::booleans::testing
