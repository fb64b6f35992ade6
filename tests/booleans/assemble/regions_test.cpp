#include "booleans/assemble/regions.h"

#include <gtest/gtest.h>

#include "tests/booleans/stages.h"

namespace quoin::booleans::testing {
namespace {

Regions<VertexId> regions_of(const std::vector<Body>& bodies, Rule rule, std::uint32_t negated_from = none) {
  const Arrangement a = arranged(bodies);
  const Expression e = Expression::flat(rule, static_cast<std::uint32_t>(bodies.size()), negated_from);
  return merged_regions(a, select(a, find_cells(a), e));
}

// The shared face vanishes; its four neighbours on each side merge, where they are touched, into one face each.
TEST(Regions, BlocksThatShareAFace) {
  const Regions<VertexId> r = regions_of({box({0, 0, 0}, {2, 2, 2}), box({0, 0, 2}, {2, 2, 4})}, Rule::any);
  EXPECT_EQ(r.size(), 4u);
  for (std::size_t i = 0; i < r.size(); ++i) EXPECT_EQ(r.loops.loop_count(i), 1u);
}

// What is cut out of the middle of a face is a hole: a second loop.
TEST(Regions, PocketInAFace) {
  const Regions<VertexId> r = regions_of({box({0, 0, 0}, {6, 6, 2}), box({2, 2, 1}, {4, 4, 3})}, Rule::all, 1);
  std::size_t holes = 0;
  for (std::size_t i = 0; i < r.size(); ++i) holes += r.loops.loop_count(i) - 1;
  EXPECT_EQ(holes, 1u);
  EXPECT_EQ(r.size(), 5u);  // the top and the pocket's four walls; its floor is touched by nothing
}

// A tip that touches a face from outside stays on it as a loop of one corner.
TEST(Regions, TipOnAFace) {
  const Regions<VertexId> r = regions_of(
      {box({-4, -4, -4}, {4, 4, 0}), *tetrahedron({{{0, 0, 0}, {2, 0, 2}, {0, 2, 2}, {-2, -2, 2}}})}, Rule::any);
  std::size_t points = 0;
  for (std::size_t i = 0; i < r.size(); ++i) r.loops.for_points(i, [&](VertexId) { ++points; });
  EXPECT_EQ(points, 1u);
}

}  // namespace
}  // namespace quoin::booleans::testing
