#include "grid/lists/loops.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace quoin::grid::testing {
namespace {

using Corners = std::vector<std::uint32_t>;

Corners loop_of(std::uint32_t n) {
  Corners loop(n);
  std::iota(loop.begin(), loop.end(), 10u);
  return loop;
}

// Against lists that are rotated as a whole.
TEST(LoopsTest, PlacesFollowEachOtherAround) {
  for (std::uint32_t n = 1; n < 9; ++n) {
    const Corners loop = loop_of(n);
    Corners later = loop, earlier = loop;
    std::rotate(later.begin(), later.begin() + 1, later.end());
    std::rotate(earlier.rbegin(), earlier.rbegin() + 1, earlier.rend());
    for (std::uint32_t i = 0; i < n; ++i) {
      EXPECT_EQ(loop[next_in_loop(i, n)], later[i]);
      EXPECT_EQ(loop[previous_in_loop(i, n)], earlier[i]);
    }
  }
}

TEST(LoopsTest, EdgesLeadFromEachCornerToTheNext) {
  for (std::uint32_t n = 0; n < 9; ++n) {
    const Corners loop = loop_of(n);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges, expected;
    for_loop_edges(loop, [&](std::uint32_t u, std::uint32_t v) { edges.emplace_back(u, v); });
    for (std::size_t i = 0; n > 1 && i < n; ++i) expected.emplace_back(loop[i], loop[(i + 1) % n]);
    EXPECT_EQ(edges, expected) << n;
  }
}

}  // namespace
}  // namespace quoin::grid::testing
