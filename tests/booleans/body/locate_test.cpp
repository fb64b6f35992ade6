#include "booleans/body/locate.h"

#include <gtest/gtest.h>

#include "tests/booleans/support.h"

namespace quoin::booleans::testing {
namespace {

using exact::Rational;
using Place = std::array<Rational, 3>;

/// The second way for a convex raw mesh: the sides of all planes.
int side_of_convex(const Body& body, const Place& p) {
  int most = -1;
  for (std::uint32_t f = 0; f < body.face_count(); ++f) {
    const exact::Plane plane = body.plane(f);
    Rational value = exact::to_integer(plane.d);
    for (std::size_t k = 0; k < 3; ++k) value += plane.n[k] * p[k];
    most = std::max(most, value > 0 ? 1 : value < 0 ? -1 : 0);
  }
  return -most;
}

/// Points on corners, edges and faces as often as elsewhere.
Place any_point(Random& random, const Body& body) {
  Place p{0, 0, 0};
  std::int64_t weight = 0;
  const std::uint32_t f = static_cast<std::uint32_t>(random.below(body.face_count()));
  body.for_corners(f, [&](std::uint32_t v) {
    const auto w = static_cast<std::int64_t>(random.below(3));
    for (std::size_t k = 0; k < 3; ++k) p[k] += w * exact::coordinate(body.point(v), static_cast<int>(k));
    weight += w;
  });
  for (auto& x : p) x = weight == 0 ? Rational(random.between(-6, 6)) : Rational(x / weight);
  if (random.one_in(3)) p[random.below(3)] += Rational(random.between(-3, 3)) / 2;
  return p;
}

TEST(Locate, InConvexSolids) {
  std::array<int, 3> seen{};
  for (std::uint64_t number = 0; number < case_count(300); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0x10C, number);
    std::array<Vector, 4> p;
    for (Vector& v : p) v = random.vector(-5, 5);
    const auto body = tetrahedron(p);
    if (!body) continue;
    for (int i = 0; i < 5; ++i) {
      const Place at = any_point(random, *body);
      const int found = locate(*body, at);
      EXPECT_EQ(found, side_of_convex(*body, at));
      EXPECT_EQ(locate(complement(*body), at), -found);
      ++seen[static_cast<std::size_t>(found + 1)];
    }
  }
  for (const int count : seen) EXPECT_GT(count, 0);
}

// Where a point is in the parts says where it is in the whole, unless it is on a boundary.
TEST(Locate, InResults) {
  for (std::uint64_t number = 0; number < case_count(200); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0x10D, number);
    Solids solids(random, families[number % 3]);
    const Body a = solids.next(), b = solids.next();
    const Body r = odd(a, b);
    if (r.face_count() == 0) continue;
    const Place at = any_point(random, r);
    const int in_a = locate(a, at), in_b = locate(b, at);
    if (in_a != 0 && in_b != 0) {
      EXPECT_EQ(locate(r, at), in_a == in_b ? -1 : 1);
    }
  }
}

// The top at 1 + 2^-60 is at 1 by doubles: points below it are beyond the boxes of the sides, and on it beyond its own.
TEST(Locate, BeyondTheRoundedBox) {
  const Rational hair(1, exact::Integer(exact::Integer(1) << 60));
  const exact::Plane top{{0, 0, std::int64_t{1} << 60}, -(exact::int128(1) << 60) - 1};
  const Body slab = half_space_body(top, {{0, 0, 0}}, {{4, 4, 4}});
  EXPECT_EQ(bounds(slab)->high[2], 1);
  EXPECT_EQ(locate(slab, {Rational(2), Rational(2), Rational(1 + hair / 2)}), 1);
  EXPECT_EQ(locate(slab, {Rational(2), Rational(2), Rational(1 + hair)}), 0);
  EXPECT_EQ(locate(slab, {Rational(2), Rational(2), Rational(1 + 2 * hair)}), -1);
}

TEST(Locate, Bounds) {
  EXPECT_FALSE(bounds(Body{}));
  const auto box_of = bounds(half_space_body({{0, 0, 2}, -3}, {{0, 0, 0}}, {{4, 4, 4}}));
  ASSERT_TRUE(box_of);
  EXPECT_EQ(box_of->low, (std::array<std::int32_t, 3>{0, 0, 0}));
  EXPECT_EQ(box_of->high, (std::array<std::int32_t, 3>{4, 4, 2}));
}

// A derived point in the middle of an edge: its whole coordinates are those of the edge.
TEST(Locate, BoundsAreThoseOfThePointSet) {
  const Boundary without = canonical(box({0, 0, 0}, {4, 4, 1}));
  Boundary with;
  with.vertices = without.vertices;
  with.planes = without.planes;
  const auto middle = static_cast<std::uint32_t>(with.vertices.size());
  with.vertices.push_back(*exact::meet({{1, 0, 0}, -4}, {{0, 1, 0}, -4}, {{0, 0, 2}, -1}));
  const auto is_end = [&](std::uint32_t v) {
    const exact::GridPoint p = exact::grid_point(with.vertices[v]);
    return p[0] == 4 && p[1] == 4;
  };
  for (std::size_t f = 0; f < without.face_count(); ++f) {
    without.faces.for_edges(f, [&](std::uint32_t u, std::uint32_t v) {
      with.faces.corners.push_back(u);
      if (is_end(u) && is_end(v)) with.faces.corners.push_back(middle);
    });
    with.faces.end_loop();
    with.faces.end_face();
  }

  const Body a = body_of(without), b = body_of(with);
  EXPECT_EQ(b.points.size(), 1u);
  EXPECT_EQ(bounds(a)->low, bounds(b)->low);
  EXPECT_EQ(bounds(a)->high, bounds(b)->high);
  EXPECT_TRUE(canonical(a) == canonical(b));
}

}  // namespace
}  // namespace quoin::booleans::testing
