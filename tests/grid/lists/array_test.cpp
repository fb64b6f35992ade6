#include "grid/lists/array.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>
#include <thread>

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

// Blocks that are released are used again, by the thread that released them, and have the size that is asked for.
TEST(Array, SmallBlocksOfAllSizesInAnyOrder) {
  const auto work = [] {
    std::vector<Array<std::uint8_t>> lists;
    for (std::size_t i = 0; i < 3000; ++i) {
      const std::size_t bytes = i * 7919 % 5000;
      if (i % 3 == 2) lists.erase(lists.begin() + static_cast<std::ptrdiff_t>(i % lists.size()));
      lists.emplace_back(bytes, static_cast<std::uint8_t>(bytes));
    }
    for (const auto& list : lists)
      for (const std::uint8_t x : list) ASSERT_EQ(x, static_cast<std::uint8_t>(list.size()));
  };
  std::thread other(work);
  work();
  other.join();

  Array<std::uint8_t> passed;
  std::thread([&] { passed.assign(40, 1); }).join();  // made there, released here
  Array<std::uint8_t>().swap(passed);
  const Array<std::uint8_t> next(64, 2);
  EXPECT_EQ(std::accumulate(next.begin(), next.end(), 0), 128);
}

TEST(Array, TooManyItems) {
  EXPECT_THROW(LargePages<std::uint64_t>().allocate(SIZE_MAX / 4), std::bad_array_new_length);
}

}  // namespace
}  // namespace quoin::grid
