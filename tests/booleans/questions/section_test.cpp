#include "booleans/questions/section.h"

#include <gtest/gtest.h>

#include <set>

#include "booleans/body/measure.h"
#include "tests/booleans/questions/places.h"

namespace quoin::booleans::testing {
namespace {

using exact::Integer;

Body bounded_solid(Random& random, Family family) {
  Solids solids(random, family);
  for (;;) {
    Body body = solids.next();
    if (random.one_in(2)) body = odd(body, solids.next());
    body = packed(body);
    if (body.face_count() > 0) return body;
  }
}

Rational value_on(const IntegerPlane& plane, const RationalPlace& p) {
  return plane[0] * p[0] + plane[1] * p[1] + plane[2] * p[2] + plane[3];
}

/// Of whole normal numbers, through a place of the body: vertices, edges and faces lie on it as often as not.
IntegerPlane any_plane(Random& random, const Body& body) {
  IntegerPlane plane;
  if (random.one_in(3)) {  // that of a face
    const exact::Plane p = body.plane(static_cast<std::uint32_t>(random.below(body.face_count())));
    return {p.n[0], p.n[1], p.n[2], exact::to_integer(p.d)};
  }
  do {
    for (std::size_t k = 0; k < 3; ++k) plane[k] = random.between(-2, 2);
  } while (plane[0] == 0 && plane[1] == 0 && plane[2] == 0);
  plane[3] = 0;
  const Rational at = value_on(plane, any_place(random, body));
  for (std::size_t k = 0; k < 3; ++k) plane[k] *= denominator(at);
  plane[3] = -numerator(at);
  return plane;
}

/// Of the plane's axes without the longest of the normal, counter-clockwise seen from above.
std::array<std::size_t, 2> axes_of(const IntegerPlane& plane) {
  const std::size_t k = exact::longest_component(std::array<Integer, 3>{plane[0], plane[1], plane[2]});
  std::array<std::size_t, 2> r{(k + 1) % 3, (k + 2) % 3};
  if (plane[k] < 0) std::swap(r[0], r[1]);
  return r;
}

/// How often the loops go round a point of the plane; nothing on a loop.
std::optional<int> turns_about(const Section& section, const IntegerPlane& plane, const RationalPlace& p) {
  const auto [i, j] = axes_of(plane);
  int turns = 0;
  bool is_on = false;
  for (std::size_t f = 0; f + 1 < section.polygons.face_start.size(); ++f)
    section.polygons.for_edges(f, [&, i = i, j = j](std::uint32_t from, std::uint32_t to) {
      const auto &u = section.vertices[from], &v = section.vertices[to];
      const Rational ui = u[i] - p[i], uj = u[j] - p[j], vi = v[i] - p[i], vj = v[j] - p[j];
      const Rational cross = ui * vj - vi * uj;
      if (cross == 0 && ui * vi <= 0 && uj * vj <= 0) is_on = true;
      if (uj <= 0 && vj > 0 && cross > 0) ++turns;
      if (uj > 0 && vj <= 0 && cross < 0) --turns;
    });
  return is_on ? std::nullopt : std::optional(turns);
}

/// A point of the plane near the body.
RationalPlace on_plane(Random& random, const Body& body, const IntegerPlane& plane) {
  RationalPlace p = any_place(random, body);
  const std::size_t k = exact::longest_component(std::array<Integer, 3>{plane[0], plane[1], plane[2]});
  p[k] -= value_on(plane, p) / plane[k];
  return p;
}

/// Infinitely little above or below.
RationalPlace beside(const IntegerPlane& plane, const RationalPlace& p, int side) {
  const Rational hair(side, exact::Integer(exact::Integer(1) << 400));
  return {Rational(p[0] + plane[0] * hair), Rational(p[1] + plane[1] * hair), Rational(p[2] + plane[2] * hair)};
}

// What is inside the solid is inside the section; what is outside, or on the boundary with no inside around it in the
// plane, is not: the winding numbers of the loops agree with the scan of all faces.
TEST(Section, AgreesWithPointsOfThePlane) {
  std::array<int, 2> seen{};
  int within = 0;
  for (const Family family : families)
    for (std::uint64_t number = 0; number < case_count(25); ++number) {
      SCOPED_TRACE(std::string(name_of(family)) + " " + case_name(number));
      Random random(0x5EC, number);
      const Body body = bounded_solid(random, family);
      const Index index(body);
      const IntegerPlane plane = any_plane(random, body);
      const auto found = section(index, plane);
      ASSERT_TRUE(found);
      for (const auto& v : found->vertices) ASSERT_EQ(value_on(plane, v), 0);
      for (int i = 0; i < 8; ++i) {
        const RationalPlace p = on_plane(random, body, plane);
        const int where = locate(body, p);
        const auto turns = turns_about(*found, plane, p);
        if (!turns) {
          ASSERT_EQ(where, 0);
          continue;
        }
        ASSERT_TRUE(*turns == 0 || *turns == 1);
        if (where != 0) {
          ASSERT_EQ(*turns, where > 0 ? 1 : 0);
        } else if (locate(body, beside(plane, p, 1)) * locate(body, beside(plane, p, -1)) < 0) {
          ASSERT_EQ(*turns, 0);  // within a face on the plane
          ++within;
        }
        ++seen[static_cast<std::size_t>(*turns)];
      }
    }
  for (const int count : seen) EXPECT_GT(count, 0);
  EXPECT_GT(within, 0);
}

/// From above and from below: each is the other's mirror image, with the same area.
TEST(Section, FromAboveAndFromBelow) {
  for (const Family family : families)
    for (std::uint64_t number = 0; number < case_count(25); ++number) {
      SCOPED_TRACE(std::string(name_of(family)) + " " + case_name(number));
      Random random(0x5ED, number);
      const Body body = bounded_solid(random, family);
      const Index index(body);
      const IntegerPlane plane = any_plane(random, body);
      const auto above = section(index, plane),
                 below =
                     section(index, {Integer(-plane[0]), Integer(-plane[1]), Integer(-plane[2]), Integer(-plane[3])});
      ASSERT_EQ(above->vertices, below->vertices);
      ASSERT_EQ(above->projected_area, below->projected_area);
      ASSERT_EQ(above->polygons.face_start.size(), below->polygons.face_start.size());
    }
}

// Cavalieri: between the heights of vertices the area is a polynomial of degree 2, of which Simpson's rule is exact.
TEST(Section, AreasAddUpToTheVolume) {
  for (const Family family : families)
    for (std::uint64_t number = 0; number < case_count(12); ++number) {
      SCOPED_TRACE(std::string(name_of(family)) + " " + case_name(number));
      Random random(0x5EE, number);
      const Body body = bounded_solid(random, family);
      const Index index(body);
      std::array<std::int64_t, 3> n{};
      while (n == std::array<std::int64_t, 3>{}) n = random.vector(-2, 2);
      const std::size_t k = exact::longest_component(n);

      std::set<Rational> heights;
      for (std::uint32_t v = 0; v < body.vertex_count(); ++v) {
        const RationalPlace p = place_of(body, v);
        heights.insert(Rational(n[0] * p[0] + n[1] * p[1] + n[2] * p[2]));
      }
      const auto area_at = [&](const Rational& h) {
        const Integer d = denominator(h);
        return section(index, {Integer(n[0] * d), Integer(n[1] * d), Integer(n[2] * d), Integer(-numerator(h))})
            ->projected_area;
      };
      Rational sum = 0;
      std::optional<Rational> last;
      for (const Rational& h : heights) {
        if (last) {
          // The areas just above `last` and just below h follow from three within, as polynomials.
          const Rational width = h - *last;
          const auto inner = [&](int quarter) { return area_at(*last + width * quarter / 4); };
          sum += width * (2 * inner(1) - inner(2) + 2 * inner(3)) / 3;
        }
        last = h;
      }
      ASSERT_EQ(Rational(sum / std::abs(n[k])), volume(body));
    }
}

TEST(Section, OfABoxWithAHole) {
  const Body bored = minus(box({0, 0, 0}, {6, 6, 4}), box({2, 2, -1}, {4, 4, 5}));
  const auto found = section(Index(bored), {0, 0, 2, -3});
  EXPECT_EQ(found->projected_area, 32);
  ASSERT_EQ(found->vertices.size(), 8u);
  EXPECT_EQ(found->vertices[1], (std::array<Rational, 3>{0, 6, Rational(3, 2)}));
  ASSERT_EQ(found->polygons.loop_count(), 2u);
  ASSERT_EQ(found->polygons.face_start.size(), 2u);
  const auto loop = [&](std::size_t i) {
    const auto l = found->polygons.loop(i);
    return std::vector<std::uint32_t>(l.begin(), l.end());
  };
  EXPECT_EQ(loop(0), (std::vector<std::uint32_t>{0, 6, 7, 1}));
  EXPECT_EQ(loop(1), (std::vector<std::uint32_t>{2, 3, 5, 4}));

  // On the top there is nothing of the interior; where two boxes are stacked, what they have in common.
  EXPECT_EQ(section(Index(bored), {0, 0, 1, -4})->vertices.size(), 0u);
  EXPECT_EQ(section(Index(bored), {0, 0, 1, 0})->vertices.size(), 0u);
  const Body stacked = any(box({0, 0, 0}, {4, 4, 1}), box({1, 2, 1}, {9, 3, 2}));
  EXPECT_EQ(section(Index(stacked), {0, 0, 1, -1})->projected_area, 3);
  EXPECT_EQ(section(Index(stacked), {0, 0, -1, 1})->projected_area, 3);
}

// Boxes that touch along edges: squares that share a corner are two polygons, a square ring closed at a corner is one.
TEST(Section, PartsThatTouch) {
  const Body two = any(box({0, 0, 0}, {1, 1, 2}), box({1, 1, 0}, {2, 2, 2}));
  const auto found = section(Index(two), {0, 0, 1, -1});
  EXPECT_EQ(found->projected_area, 2);
  EXPECT_EQ(found->vertices.size(), 7u);
  EXPECT_EQ(found->polygons.face_start.size(), 3u);
  EXPECT_EQ(found->polygons.loop_count(), 2u);

  const Body notched = minus(box({0, 0, 0}, {4, 4, 2}), box({1, 1, 0}, {2, 2, 2}));
  const Body ring = minus(notched, box({2, 2, 0}, {3, 3, 2}));
  const auto holes = section(Index(ring), {0, 0, 1, -1});
  EXPECT_EQ(holes->projected_area, 14);
  EXPECT_EQ(holes->polygons.face_start.size(), 2u);
  EXPECT_EQ(holes->polygons.loop_count(), 2u);  // both holes are one loop
  EXPECT_EQ(holes->polygons.loop(1).size(), 8u);
}

// Islands in holes: the solid between two boxes, and a box within.
TEST(Section, Nested) {
  const Body shell = minus(box({0, 0, 0}, {20, 20, 20}), box({2, 2, 2}, {18, 18, 18}));
  const Body nest = any(shell, minus(box({4, 4, 4}, {16, 16, 16}), box({6, 6, 6}, {14, 14, 14})));
  const auto found = section(Index(nest), {0, 0, 1, -10});
  EXPECT_EQ(found->projected_area, 400 - 256 + 144 - 64);
  ASSERT_EQ(found->polygons.face_start.size(), 3u);
  for (std::size_t f = 0; f < 2; ++f) EXPECT_EQ(found->polygons.loop_count(f), 2u);
  EXPECT_EQ(found->polygons.corners_of(0).front(), 0u);
  EXPECT_EQ(found->vertices[found->polygons.loop(3).front()][0], 6);
}

}  // namespace
}  // namespace quoin::booleans::testing
