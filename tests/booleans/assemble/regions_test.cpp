#include "booleans/assemble/regions.h"

#include <gtest/gtest.h>

#include "tests/booleans/stages.h"

namespace quoin::booleans::testing {
namespace {

struct Counts {
  std::size_t regions = 0, holes = 0, points = 0;
  friend bool operator==(const Counts&, const Counts&) = default;
};

Counts regions_of(const std::vector<Body>& bodies, Rule rule, std::uint32_t negated_from = none) {
  const Arrangement a = arranged(bodies);
  const Expression e = Expression::flat(rule, static_cast<std::uint32_t>(bodies.size()), negated_from);
  Counts counts;
  for (const Regions& r : merged_regions(a, select(a, find_cells(a), e)))
    for (std::size_t i = 0; i < r.size(); ++i) {
      ++counts.regions;
      counts.holes += r.loops.loop_count(i) - 1;
      r.loops.for_points(i, [&](VertexId) { ++counts.points; });
    }
  return counts;
}

// The shared face vanishes; its four neighbours on each side merge, where they are touched, into one face each.
TEST(Regions, BlocksThatShareAFace) {
  EXPECT_EQ(regions_of({box({0, 0, 0}, {2, 2, 2}), box({0, 0, 2}, {2, 2, 4})}, Rule::any), (Counts{4, 0, 0}));
}

// What is cut out of the middle of a face is a hole: a second loop. Of the pocket the four walls are regions; its floor
// is touched by nothing.
TEST(Regions, PocketInAFace) {
  EXPECT_EQ(regions_of({box({0, 0, 0}, {6, 6, 2}), box({2, 2, 1}, {4, 4, 3})}, Rule::all, 1), (Counts{5, 1, 0}));
}

// A tip that touches a face from outside stays on it as a loop of one corner.
TEST(Regions, TipOnAFace) {
  const Body tip = *tetrahedron({{{0, 0, 0}, {2, 0, 2}, {0, 2, 2}, {-2, -2, 2}}});
  EXPECT_EQ(regions_of({box({-4, -4, -4}, {4, 4, 0}), tip}, Rule::any), (Counts{4, 1, 1}));
}

// A block fits into the corner of a plate: each of its three faces on the plate's merges with what is around it there,
// and the corner inside that face, at which all elements vanish, is left as a point.
TEST(Regions, ACornerAtWhichAllElementsVanishIsAPoint) {
  EXPECT_EQ(regions_of({box({-4, -4, -2}, {4, 4, 0}), box({-4, -4, -1}, {0, 0, 0})}, Rule::any), (Counts{3, 3, 3}));
}

}  // namespace
}  // namespace quoin::booleans::testing
