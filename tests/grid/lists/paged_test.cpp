#include "grid/lists/paged.h"

#include <gtest/gtest.h>

#include <map>
#include <vector>

#include "tests/booleans/support.h"

namespace quoin::grid::testing {
namespace {

using booleans::testing::case_count;
using booleans::testing::case_name;
using booleans::testing::Random;

// Writes and ranges in any order, against a plain list.
TEST(Paged, IsAListThatIsMostlyNotWritten) {
  for (std::uint64_t number = 0; number < case_count(100); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0x9A6ED, number);
    const std::size_t size = random.below(6000);
    Paged<int> paged(size, -1);
    std::vector<int> plain(size, -1);
    for (std::uint64_t step = 1 + random.below(30); step > 0 && size > 0; --step) {
      const int value = static_cast<int>(random.below(5));
      const std::size_t begin = random.below(size), end = begin + random.below(size - begin + 1);
      if (random.one_in(2)) {
        paged.fill(begin, end, value);
        std::fill(plain.begin() + static_cast<std::ptrdiff_t>(begin), plain.begin() + static_cast<std::ptrdiff_t>(end),
                  value);
      } else {
        paged.at(begin) = plain[begin] = value;
      }
    }
    ASSERT_EQ(paged.size(), size);
    for (std::size_t i = 0; i < size; ++i) ASSERT_EQ(paged[i], plain[i]) << i;
  }
}

TEST(Paged, CopiesAreTheirOwn) {
  Paged<int> a(5000, 7);
  a.at(4999) = 1;
  Paged<int> b = a;
  b.at(0) = 2;
  EXPECT_EQ(a[0], 7);
  EXPECT_EQ(b[0], 2);
  EXPECT_EQ(b[4999], 1);
}

// In the order in which they come, each once.
TEST(Numbering, InTheOrderOfArrival) {
  Numbering numbers(3000);
  const std::vector<std::size_t> order{2999, 0, 1500, 0, 2999, 7};
  const std::vector<std::uint32_t> expected{0, 1, 2, 1, 0, 3};
  for (std::size_t i = 0; i < order.size(); ++i) EXPECT_EQ(numbers.add(order[i]), expected[i]);
  EXPECT_EQ(numbers.size(), 4u);
  EXPECT_EQ(numbers[1500], 2u);
  EXPECT_EQ(numbers[1501], Numbering::none);
}

}  // namespace
}  // namespace quoin::grid::testing
