#include "grid/lists/shared_list.h"

#include <gtest/gtest.h>

#include "tests/booleans/support.h"

namespace quoin::grid::testing {
namespace {

using booleans::testing::case_count;
using booleans::testing::case_name;
using booleans::testing::Random;

// Copies of copies that grow, settle and change, against vectors.
TEST(SharedList, CopiesDoNotSeeEachOther) {
  for (std::uint64_t number = 0; number < case_count(300); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0x5A, number);
    std::vector<SharedList<int>> lists(1);
    std::vector<std::vector<int>> expected(1);
    for (int step = 0; step < 200; ++step) {
      const std::size_t i = random.below(lists.size());
      const int value = static_cast<int>(random.below(1000));
      switch (random.below(7)) {
        case 0:
          lists.push_back(lists[i]);
          expected.push_back(expected[i]);
          break;
        case 1:
          lists[i].settle();
          break;
        case 2:
          if (!expected[i].empty())
            lists[i].edit()[value % expected[i].size()] = value, expected[i][value % expected[i].size()] = value;
          break;
        case 3: {
          const std::vector<int> more(random.below(9), value);
          lists[i].append(more.begin(), more.end());
          expected[i].insert(expected[i].end(), more.begin(), more.end());
          break;
        }
        case 4:
          lists[i] = lists[random.below(lists.size())];
          expected[i].assign(lists[i].begin(), lists[i].end());
          break;
        default:
          lists[i].push_back(value);
          expected[i].push_back(value);
      }
    }
    for (std::size_t i = 0; i < lists.size(); ++i)
      ASSERT_TRUE(std::equal(lists[i].begin(), lists[i].end(), expected[i].begin(), expected[i].end()));
  }
}

TEST(SharedList, GrowsInPlaceBehindSettledItems) {
  SharedList<int> list;
  list.reserve(10);
  list.push_back(1);
  list.settle();
  SharedList<int> first = list, second = list;
  first.push_back(2);
  second.push_back(3);
  EXPECT_EQ(first.data(), list.data());
  EXPECT_NE(second.data(), list.data());
  EXPECT_EQ(list.size(), 1u);
  EXPECT_EQ(first, (SharedList<int>{1, 2}));
  EXPECT_EQ(second, (SharedList<int>{1, 3}));
}

}  // namespace
}  // namespace quoin::grid::testing
