#include "grid/lists/array.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>

namespace quoin::grid {
namespace {

// Both sides of the size from which blocks are in large pages, and of its multiples.
TEST(Array, HoldsWhatWasWritten) {
  for (const std::size_t bytes : {std::size_t{0}, std::size_t{1}, large_block - 1, large_block, large_block + 1,
                                  2 * large_block, 2 * large_block + 1, 5 * large_block}) {
    Array<std::uint8_t> list(bytes, 7);
    EXPECT_EQ(std::accumulate(list.begin(), list.end(), std::uint64_t{0}), 7 * bytes);
    const Array<std::uint8_t> copy = list;
    list.clear();
    list.shrink_to_fit();
    EXPECT_EQ(std::accumulate(copy.begin(), copy.end(), std::uint64_t{0}), 7 * bytes);
  }
}

TEST(Array, GrowsAcrossTheSizeOfLargeBlocks) {
  Array<std::uint32_t> list;
  for (std::uint32_t i = 0; i < large_block; ++i) list.push_back(i);
  for (std::uint32_t i = 0; i < large_block; ++i) ASSERT_EQ(list[i], i);
}

TEST(Array, RoomInAPlainVector) {
  for (const std::size_t n : {std::size_t{0}, std::size_t{3}, 3 * large_block}) {
    std::vector<std::uint32_t> list{1, 2};
    reserve_large(list, n);
    EXPECT_GE(list.capacity(), n);
    list.resize(std::max<std::size_t>(n, 2), 5);
    EXPECT_EQ(list[1], 2u);
    EXPECT_EQ(list.back(), n > 2 ? 5u : 2u);
  }
}

// Blocks of no whole large page are left as they are.
TEST(Array, AWishForLargePagesChangesNothing) {
  std::vector<std::uint8_t> block(3 * large_block, 9);
  for (const std::size_t bytes : {std::size_t{0}, std::size_t{1}, large_block, block.size()})
    prefer_large_pages(block.data(), bytes);
  EXPECT_EQ(std::accumulate(block.begin(), block.end(), std::uint64_t{0}), 9 * block.size());
}

TEST(Array, TooManyItems) {
  EXPECT_THROW(LargePages<std::uint64_t>().allocate(SIZE_MAX / 4), std::bad_array_new_length);
}

}  // namespace
}  // namespace quoin::grid
