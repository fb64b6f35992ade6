#include "booleans/pairs/crowd.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "booleans/body/body.h"
#include "tests/booleans/support.h"

namespace quoin::booleans::testing {
namespace {

Box box_between(std::array<std::int32_t, 3> low, std::array<std::int32_t, 3> high) { return {low, high}; }

// As users have it: a box meets more than two that also meet each other.
TEST(Crowd, ManyBoxesInOnePlaceAreOne) {
  if (!usual_thresholds()) GTEST_SKIP();
  Array<Box> row, stack, walls, grid;
  for (std::int32_t i = 0; i < 200; ++i) {
    row.push_back(box_between({10 * i, 0, 0}, {10 * i + 15, 9, 9}));
    stack.push_back(box_between({0, 0, 0}, {9, 9, 9}));
    walls.push_back(box_between({10 * i, 0, 0}, {10 * i + 5, 2000, 2000}));
    walls.push_back(box_between({0, 10 * i, 0}, {2000, 10 * i + 5, 2000}));
  }
  for (std::int32_t i = 0; i < 1000; ++i) {
    const std::int32_t x = i / 100, y = i / 10 % 10, z = i % 10;
    grid.push_back(box_between({x, y, z}, {x + 1, y + 1, z + 1}));
  }
  EXPECT_FALSE(are_crowded({}));
  EXPECT_FALSE(are_crowded({stack[0]}));
  EXPECT_FALSE(are_crowded(row));
  EXPECT_TRUE(are_crowded(stack));
  EXPECT_TRUE(are_crowded(grid));
  // Each wall meets half of the others, which lie apart; with walls across both that is no longer so.
  EXPECT_FALSE(are_crowded(walls));
  for (std::int32_t i = 0; i < 200; ++i) walls.push_back(box_between({0, 0, 10 * i}, {2000, 2000, 10 * i + 5}));
  EXPECT_TRUE(are_crowded(walls));
}

// A stack of a tenth of all boxes, wherever it stands in the list.
TEST(Crowd, APartOfTheBoxesMayBeOne) {
  if (!usual_thresholds()) GTEST_SKIP();
  Array<Box> boxes;
  for (std::int32_t i = 0; i < 2000; ++i)
    boxes.push_back(i % 10 == 0 ? box_between({-9, 0, 0}, {-1, 9, 9})
                                : box_between({10 * i, 0, 0}, {10 * i + 5, 9, 9}));
  EXPECT_TRUE(are_crowded(boxes));
  std::reverse(boxes.begin(), boxes.end());
  EXPECT_TRUE(are_crowded(boxes));
}

}  // namespace
}  // namespace quoin::booleans::testing
