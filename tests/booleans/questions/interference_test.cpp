#include "booleans/questions/interference.h"

#include <gtest/gtest.h>

#include "booleans/questions/along_line.h"
#include "tests/booleans/questions/places.h"

namespace quoin::booleans::testing {
namespace {

/// The second way: whether an edge of one has a point in common with the boundary of the other.
bool edges_meet(const Index& a, const Index& b) {
  bool found = false;
  for (std::uint32_t t = 0; t < a.triangle_count(); ++t)
    grid::for_loop_edges(a.corners(t), [&](std::uint32_t from, std::uint32_t to) {
      const RationalPlace p = place_of(a.body(), from), q = place_of(a.body(), to);
      const Line line(QueryPoint(p), {Rational(q[0] - p[0]), Rational(q[1] - p[1]), Rational(q[2] - p[2])});
      found = found || !passage(b, line, Rational(1)).contacts.empty();
    });
  return found;
}

TEST(Interference, AgreesWithIntersectionsAndEdges) {
  std::array<int, 3> seen{};
  for (const Family family : families)
    for (std::uint64_t number = 0; number < case_count(60); ++number) {
      SCOPED_TRACE(std::string(name_of(family)) + " " + case_name(number));
      Random random(0x1F7, number);
      Solids solids(random, family);
      Body a = solids.next(), b = solids.next();
      if (random.one_in(3)) b = minus(b, a);
      if (random.one_in(5)) a = complement(a);
      const Index p(a), q(b);
      const Meeting found = meeting(p, q);
      ASSERT_EQ(meeting(q, p) == Meeting::apart, found == Meeting::apart);
      const bool overlap = !empty(all(a, b));
      const bool touch = edges_meet(p, q) || edges_meet(q, p);
      if (found == Meeting::overlapping) {
        ASSERT_TRUE(overlap);
      } else {
        ASSERT_EQ(found == Meeting::contact, touch);
        if (found == Meeting::apart) {
          ASSERT_FALSE(overlap);
        }
      }
      ++seen[static_cast<std::size_t>(found)];
    }
  for (const int count : seen) EXPECT_GT(count, 0);
}

// Spheres that cross are told by their faces alone, and one within the other by a point.
TEST(Interference, OfSpheres) {
  const auto ball = [](const Vector& centre, double size) {
    return Index(*sphere(centre, 9, 14, [size](std::uint32_t, std::uint32_t) { return size; }));
  };
  EXPECT_EQ(meeting(ball({0, 0, 0}, 1000), ball({700, 300, 200}, 1000)), Meeting::overlapping);
  EXPECT_EQ(meeting(ball({0, 0, 0}, 1000), ball({70, 30, 20}, 500)), Meeting::overlapping);
  EXPECT_EQ(meeting(ball({0, 0, 0}, 1000), ball({1700, 1300, 200}, 1000)), Meeting::apart);
}

}  // namespace
}  // namespace quoin::booleans::testing
