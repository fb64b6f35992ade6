// Worked examples whose answers are known by hand, and the laws that no floating-point engine keeps.
#include <gtest/gtest.h>

#include <map>

#include "booleans/body/locate.h"
#include "booleans/surface/separated.h"
#include "booleans/surface/shells.h"
#include "tests/booleans/support.h"

namespace quoin::booleans::testing {
namespace {

using exact::Rational;

/// Vertices, edges, faces, loops of the canonical form; shells and genus of the separated mesh.
struct Counts {
  std::size_t vertices, edges, faces, loops;
  std::uint64_t shells;
  std::int64_t genus;
  friend bool operator==(const Counts&, const Counts&) = default;
  friend std::ostream& operator<<(std::ostream& out, const Counts& c) {
    return out << "V=" << c.vertices << " E=" << c.edges << " F=" << c.faces << " L=" << c.loops << " S=" << c.shells
               << " G=" << c.genus;
  }
};
Counts counts(const Body& body) {
  const Canonical form = canonical(body);
  const Shells s = shells(separated(body, triangulated(body)));
  return {form.vertices.size(), edge_count(form), form.face_count(), form.faces.loop_count(), s.count, s.genus};
}
/// V - E + F - (L - F) - 2 (S - G); 0 for manifold solids.
std::int64_t euler_poincare(const Counts& c) {
  const auto n = [](std::size_t x) { return static_cast<std::int64_t>(x); };
  return n(c.vertices) - n(c.edges) + n(c.faces) - (n(c.loops) - n(c.faces)) - 2 * (n(c.shells) - c.genus);
}
/// Corners of each loop of the face on this plane.
std::vector<std::size_t> loop_sizes(const Body& body, const exact::Plane& plane) {
  const Canonical form = canonical(body);
  std::vector<std::size_t> sizes;
  for (std::size_t f = 0; f < form.face_count(); ++f)
    if (form.planes[f] == plane)
      for (std::uint32_t j = form.faces.face_start[f]; j < form.faces.face_start[f + 1]; ++j)
        sizes.push_back(form.faces.loop_start[j + 1] - form.faces.loop_start[j]);
  std::sort(sizes.begin(), sizes.end());
  return sizes;
}
Body cube(std::int64_t low, std::int64_t high) { return box({low, low, low}, {high, high, high}); }

TEST(Examples, BracketOfTwoBlocksWithASquareHole) {
  const Body upright = box({0, 0, 0}, {1, 4, 8}), foot = box({1, 0, 0}, {9, 4, 1}), hole = box({4, 1, 0}, {6, 3, 1});
  const Body bracket = minus(any(upright, foot), hole);
  EXPECT_EQ(volume(bracket), 60);
  EXPECT_EQ(counts(bracket), (Counts{20, 30, 12, 14, 1, 1}));
  EXPECT_EQ(euler_poincare(counts(bracket)), 0);
  // On both blocks' boundaries, yet inside: there is no wall at x = 1.
  EXPECT_EQ(locate(bracket, {Rational(1), Rational(1), Rational(1, 2)}), 1);
  EXPECT_EQ(locate(bracket, {Rational(2), Rational(1), Rational(3, 10)}), 1);
  EXPECT_EQ(locate(bracket, {Rational(5), Rational(2), Rational(1, 2)}), -1);
  EXPECT_EQ(locate(bracket, {Rational(4), Rational(2), Rational(1, 2)}), 0);
}

TEST(Examples, EulerPoincare) {
  EXPECT_EQ(counts(cube(0, 2)), (Counts{8, 12, 6, 6, 1, 0}));
  const Body ring = minus(box({0, 0, 0}, {9, 6, 4}), box({1, 1, 0}, {3, 3, 4}));
  EXPECT_EQ(counts(ring), (Counts{16, 24, 10, 12, 1, 1}));
  const Body ring_with_void = minus(ring, box({5, 1, 1}, {7, 3, 3}));
  EXPECT_EQ(counts(ring_with_void), (Counts{24, 36, 16, 18, 2, 1}));
  const Body two_holes = minus(ring, box({5, 1, 0}, {7, 3, 4}));
  EXPECT_EQ(counts(two_holes).genus, 2);
  for (const Body& body : {ring, ring_with_void, two_holes}) EXPECT_EQ(euler_poincare(counts(body)), 0);
}

TEST(Examples, EulerPoincareDoesNotAcceptADanglingFace) {
  // A prism and a quad on one of its edges: 8 vertices, 12 edges, 6 faces, and no solid.
  Body body = *prism({0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4});
  body.grid_points.push_back({{8, 0, 0}});
  body.grid_points.push_back({{8, 0, 4}});
  body.triangles.push_back({1, 6, 7});
  body.triangles.push_back({1, 7, 4});
  EXPECT_NE(fault(body), std::nullopt);
}

// A wedge that stands on a face with its edge is a slit of that face; one that stands on its tip, a point of it.
TEST(Examples, FaceCyclesWithSlitsAndPoints) {
  const Body table = box({0, 0, 0}, {8, 8, 2});
  const exact::Plane top{{0, 0, 1}, -2};
  const auto wedge = [](std::int64_t x, std::int64_t y) {
    return *prism({x, y, 2}, {x, y + 1, 4}, {x, y - 1, 4}, {2, 0, 0});
  };
  const Body inner_slit = any(table, wedge(3, 4));
  EXPECT_EQ(loop_sizes(inner_slit, top), (std::vector<std::size_t>{2, 4}));
  EXPECT_EQ(counts(inner_slit), (Counts{14, 21, 11, 12, 2, 0}));
  // From the rim inwards: one loop that runs in and out again.
  const Body outer_slit = any(table, wedge(0, 4));
  EXPECT_EQ(loop_sizes(outer_slit, top), (std::vector<std::size_t>{7}));
  EXPECT_EQ(counts(outer_slit), (Counts{14, 22, 11, 11, 2, 0}));
  const Body point = any(table, *tetrahedron({{{4, 4, 2}, {3, 3, 5}, {5, 3, 5}, {4, 6, 5}}}));
  EXPECT_EQ(loop_sizes(point, top), (std::vector<std::size_t>{1, 4}));
  EXPECT_EQ(counts(point), (Counts{12, 18, 10, 11, 2, 0}));
  // A slit that ends in the middle of a loop of its own: a hole with a slit.
  const Body hole = minus(inner_slit, box({5, 3, 0}, {7, 5, 2}));
  EXPECT_EQ(loop_sizes(hole, top), (std::vector<std::size_t>{4, 7}));
  for (const Body& body : {inner_slit, outer_slit, point, hole}) {
    EXPECT_TRUE(same(body_of(canonical(body)), body));
    EXPECT_TRUE(same(complement(complement(body)), body));
  }
}

TEST(Examples, CanonicalFormDropsNeedlessVertices) {
  const Body plain = body_of(canonical(cube(0, 4)));
  // A dot inside the first face that nothing else touches.
  Body dotted = plain;
  const std::size_t axis = plain.planes[0].n[0] != 0 ? 0 : plain.planes[0].n[1] != 0 ? 1 : 2;
  exact::GridPoint dot{{2, 2, 2}};
  dot.c[axis] = plain.grid_points[plain.polygons.corners[0]][static_cast<int>(axis)];
  ASSERT_EQ(plain.points.size(), 0u);
  dotted.grid_points.push_back(dot);
  const std::uint32_t end = plain.polygons.loop_start[1];
  Array<std::uint32_t> corners(plain.polygons.corners.begin(), plain.polygons.corners.end());
  corners.insert(corners.begin() + end, static_cast<std::uint32_t>(plain.grid_points.size()));
  Array<std::uint32_t> loop_corners(plain.polygons.loop_start.begin(), plain.polygons.loop_start.end());
  loop_corners.insert(loop_corners.begin() + 1, end);
  for (std::size_t j = 2; j < loop_corners.size(); ++j) ++loop_corners[j];
  dotted.polygons.corners = std::move(corners);
  dotted.polygons.loop_start = std::move(loop_corners);
  for (std::uint32_t& loop : dotted.polygons.face_start.edit()) loop += loop != 0;
  ASSERT_EQ(fault(dotted), std::nullopt);
  EXPECT_TRUE(canonical(dotted) == canonical(plain));
  // Twelve triangles and six squares are one form.
  EXPECT_TRUE(canonical(cube(0, 4)) == canonical(plain));
  EXPECT_EQ(plain.face_count(), 6u);
}

// A plane through vertices and edges: those that it only touches are no cut.
TEST(Examples, CutsThroughVertices) {
  const Body stone = *octahedron({0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2});
  const exact::GridPoint low{{-4, -4, -4}}, high{{4, 4, 4}};
  const auto below = [&](const exact::Plane& p) { return half_space_body(p, low, high); };
  EXPECT_TRUE(same(all(stone, below({{0, 0, 1}, -2})), stone));                        // touches the tip
  EXPECT_TRUE(empty(all(stone, below({{0, 0, -1}, 2}))));                              // the tip alone is nothing
  EXPECT_TRUE(same(all(stone, below({{1, 1, 1}, -2})), stone));                        // touches a face
  EXPECT_TRUE(same(all(stone, below({{1, 0, 1}, -2})), stone));                        // touches an edge
  EXPECT_EQ(counts(all(stone, below({{0, 0, 1}, 0}))), (Counts{5, 8, 5, 5, 1, 0}));    // along four edges
  EXPECT_EQ(counts(all(stone, below({{1, -1, 0}, 0}))), (Counts{6, 11, 7, 7, 1, 0}));  // two tips, two edges
}

TEST(Examples, AboveAndBelowTheMeetingOfThreePlanes) {
  const exact::Plane p1{{1, 0, 0}, -1}, p2{{0, 1, 0}, -1}, p3{{0, 0, -1}, 1}, p4{{1, 1, -1}, 0};
  for (const auto& order : {std::array{p1, p2, p3}, std::array{p2, p1, p3}, std::array{p3, p1, p2}}) {
    const auto u = exact::meet(order[0], order[1], order[2]);
    ASSERT_TRUE(u);
    EXPECT_EQ(exact::side(p4, *u), 1);
    EXPECT_EQ(exact::side(p4.opposite(), *u), -1);
    EXPECT_EQ(exact::side(exact::Plane{{1, 1, -2}, 0}, *u), 0);
  }
}

TEST(Examples, ShellForest) {
  const Body solid = minus(cube(0, 9), any(cube(1, 3), cube(5, 8)));
  EXPECT_EQ(counts(solid), (Counts{24, 36, 18, 18, 3, 0}));
  EXPECT_EQ(volume(solid), 729 - 8 - 27);
  const Body inverse = complement(solid);
  EXPECT_TRUE(inverse.full_at_infinity);
  EXPECT_EQ(counts(inverse), counts(solid));
  EXPECT_EQ(volume(inverse), -(729 - 8 - 27));
  EXPECT_TRUE(same(complement(inverse), solid));
  // An island in a void, and a void in the island.
  const Body nested = any(minus(solid, Body{}), minus(box({5, 5, 5}, {8, 8, 8}), box({6, 6, 6}, {7, 7, 7})));
  EXPECT_TRUE(same(nested, minus(minus(cube(0, 9), cube(1, 3)), cube(6, 7))));
}

TEST(Examples, OneBoxThroughTheTopOfAnother) {
  const Body a = cube(0, 4), b = box({1, 1, 3}, {2, 2, 6});
  EXPECT_TRUE(same(all(a, b), box({1, 1, 3}, {2, 2, 4})));
  EXPECT_EQ(volume(any(a, b)), 66);
  EXPECT_EQ(counts(any(a, b)), (Counts{16, 24, 11, 12, 1, 0}));
  EXPECT_EQ(counts(minus(a, b)), (Counts{16, 24, 11, 12, 1, 0}));
}

TEST(Examples, CoplanarFaces) {
  const Body a = cube(0, 2), above = box({0, 0, 2}, {2, 2, 4}), within = box({0, 0, 0}, {1, 1, 2});
  EXPECT_TRUE(empty(all(a, above)));
  EXPECT_TRUE(same(any(a, above), box({0, 0, 0}, {2, 2, 4})));
  EXPECT_EQ(counts(any(a, above)), (Counts{8, 12, 6, 6, 1, 0}));
  EXPECT_TRUE(same(all(a, within), within));
  EXPECT_TRUE(same(any(a, within), a));
}

TEST(Examples, EdgeLyingInAFace) {
  const Body a = box({-2, -2, -4}, {2, 2, 0});
  const Body b = minus(box({-3, -3, -5}, {3, 3, 1}), *prism({0, -9, 0}, {9, -9, -9}, {-9, -9, -9}, {0, 18, 0}));
  const Body both = all(a, b);
  EXPECT_EQ(volume(both), 16);
  // Two prisms that share the edge x = z = 0.
  EXPECT_EQ(counts(both), (Counts{10, 17, 10, 10, 2, 0}));
  EXPECT_EQ(loop_sizes(both, {{0, 0, 1}, 0}), (std::vector<std::size_t>{4, 4}));
}

TEST(Examples, CubesThatShareAnEdgeOrAVertex) {
  const Body a = cube(0, 1), at_edge = any(a, box({1, 1, 0}, {2, 2, 1})), at_vertex = any(a, cube(1, 2));
  EXPECT_EQ(counts(at_edge), (Counts{14, 23, 12, 12, 2, 0}));
  EXPECT_EQ(volume(at_edge), 2);
  // The complement's interior is shrunk instead: around the edge's ends it hangs together.
  EXPECT_EQ(counts(complement(at_edge)).shells, 1u);
  EXPECT_EQ(counts(at_vertex), (Counts{15, 24, 12, 12, 2, 0}));
  EXPECT_TRUE(same(complement(complement(at_edge)), at_edge));
  EXPECT_TRUE(same(complement(complement(at_vertex)), at_vertex));
}

/// Three integer vectors of equal length, pairwise orthogonal: the columns of a rotation times the quaternion's norm.
std::array<Vector, 3> turned(std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d) {
  return {{{a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)},
           {2 * (b * c - a * d), a * a - b * b + c * c - d * d, 2 * (c * d + a * b)},
           {2 * (b * d + a * c), 2 * (c * d - a * b), a * a - b * b - c * c + d * d}}};
}
std::array<Vector, 3> random_turn(Random& random, std::int64_t reach) {
  for (;;) {
    const std::int64_t a = random.between(-reach, reach), b = random.between(-reach, reach),
                       c = random.between(-reach, reach), d = random.between(-reach, reach);
    if (a != 0 || b != 0 || c != 0 || d != 0) return turned(a, b, c, d);
  }
}

TEST(Headlines, BlocksThatShareATurnedFaceBecomeOne) {
  for (std::uint64_t i = 0; i < case_count(400); ++i) {
    SCOPED_TRACE(case_name(i));
    Random random(300, i);
    std::array<Vector, 3> span = random_turn(random, 60);
    if (random.one_in(2)) do
        span = {random.vector(-9999, 9999), random.vector(-9999, 9999), random.vector(-9999, 9999)};
      while (determinant(span[0], span[1], span[2]) == 0);
    // The same blocks with their spanning vectors in any order are other meshes: other vertices, other diagonals.
    const std::size_t k = random.below(3), l = (k + 1 + random.below(2)) % 3, m = 3 - k - l;
    const Vector corner = random.vector(-1'000'000, 1'000'000), &u = span[k], &v = span[l], &w = span[m];
    const std::int64_t length = random.between(1, 5);
    const Body a = *block(corner, u, v, w), b = *block(corner + u, v, length * u, w);
    const Body whole = any(a, b);
    ASSERT_EQ(counts(whole), (Counts{8, 12, 6, 6, 1, 0}));
    ASSERT_TRUE(same(whole, *block(corner, w, v, (length + 1) * u)));
    ASSERT_TRUE(empty(all(a, b)));
    ASSERT_TRUE(same(minus(whole, b), a));
  }
}

std::optional<Body> ball(const Vector& centre, double radius) {
  return sphere(centre, 12, 24, [&](std::uint32_t, std::uint32_t) { return radius; });
}

TEST(Headlines, SplitByAnyPlaneAndReunited) {
  const Body solid = *ball({17, -5, 3}, 1'000'000);
  const exact::GridPoint low{{-2'000'000, -2'000'000, -2'000'000}}, high{{2'000'000, 2'000'000, 2'000'000}};
  for (std::uint64_t i = 0; i < case_count(150); ++i) {
    SCOPED_TRACE(case_name(i));
    Random random(310, i);
    Vector n{};
    while (n == Vector{}) n = random.one_in(5) ? random.vector(-1, 1) : random.vector(-1'000'000, 1'000'000);
    // Through a point inside, one time in three a vertex of the solid.
    const auto& vertices = solid.grid_points;
    const Vector through =
        random.one_in(3) ? vector(vertices[random.below(vertices.size())]) : random.vector(-400'000, 400'000);
    const exact::int128 d =
        -(exact::int128(n[0]) * through[0] + exact::int128(n[1]) * through[1] + exact::int128(n[2]) * through[2]);
    const exact::Plane plane = exact::reduced_plane({n[0], n[1], n[2]}, d);
    const Body under = half_space_body(plane, low, high), over = half_space_body(plane.opposite(), low, high);
    ASSERT_EQ(fault(under), std::nullopt);
    const Body lower = all(solid, under), upper = all(solid, over);
    ASSERT_TRUE(same(any(lower, upper), solid));
    ASSERT_TRUE(same(upper, minus(solid, lower)));
    ASSERT_TRUE(empty(all(lower, upper)));
    ASSERT_EQ(Rational(volume(lower) + volume(upper)), volume(solid));
  }
}

TEST(Headlines, WhatIsTakenTwiceIsNothing) {
  for (std::uint64_t i = 0; i < case_count(200); ++i) {
    SCOPED_TRACE(case_name(i));
    Random random(320, i);
    const Body a = *ball(random.vector(-3000, 3000), static_cast<double>(random.between(5000, 9000)));
    std::array<Vector, 3> span = random_turn(random, 50);
    const Vector centre = random.vector(-5000, 5000);
    const Body b = *block(centre, span[0], span[1], span[2]);
    ASSERT_TRUE(empty(minus(minus(a, all(a, b)), minus(a, b))));
    ASSERT_TRUE(empty(minus(minus(b, all(b, a)), minus(b, a))));
  }
}

}  // namespace
}  // namespace quoin::booleans::testing
