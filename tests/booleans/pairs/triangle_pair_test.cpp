#include "booleans/pairs/triangle_pair.h"

#include <gtest/gtest.h>

#include "tests/booleans/support.h"

namespace quoin::booleans::testing {
namespace {

GridTriangle random_triangle(Random& random, std::int64_t size) {
  for (;;) {
    GridTriangle t;
    for (auto& p : t)
      for (auto& x : p.c) x = static_cast<std::int32_t>(random.between(-size, size));
    if (exact::plane_through(t[0], t[1], t[2])) return t;
  }
}

/// The second way: an edge of one meets the other.
bool edges_meet(const GridTriangle& p, const GridTriangle& q) {
  for (std::size_t i = 0; i < 3; ++i)
    if (meet(p[i], p[(i + 1) % 3], q) || meet(q[i], q[(i + 1) % 3], p)) return true;
  return false;
}

TEST(TrianglePair, MeetsExactlyWhenAnEdgeOfOneMeetsTheOther) {
  std::size_t meeting = 0, cases = 0;
  // Small sizes touch and overlap in every way, the largest one has the largest numbers.
  for (const std::int64_t size : {1, 2, 3, 6, 1 << 29}) {
    for (std::uint64_t i = 0; i < case_count(20000); ++i, ++cases) {
      Random random(static_cast<std::uint64_t>(size), i);
      const GridTriangle p = random_triangle(random, size), q = random_triangle(random, size);
      const bool expected = edges_meet(p, q);
      meeting += expected;
      ASSERT_EQ(meet(p, q), expected) << case_name(i) << ", size " << size;
      ASSERT_EQ(meet(q, p), expected) << case_name(i) << ", size " << size;
    }
  }
  EXPECT_GT(meeting, cases / 10);
  EXPECT_LT(meeting, cases - cases / 10);
}

}  // namespace
}  // namespace quoin::booleans::testing
