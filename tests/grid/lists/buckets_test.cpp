#include "grid/lists/buckets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <string>

#include "tests/booleans/support.h"

namespace quoin::grid::testing {
namespace {

using booleans::testing::case_count;
using booleans::testing::case_name;
using booleans::testing::Random;

std::vector<std::uint32_t> random_keys(Random& random) {
  const std::uint64_t bound = 1 + random.below(random.one_in(2) ? 5 : 200);
  std::vector<std::uint32_t> keys(random.below(100));
  for (std::uint32_t& k : keys) k = static_cast<std::uint32_t>(random.below(bound));
  return keys;
}
std::size_t bound_of(const std::vector<std::uint32_t>& keys, Random& random) {
  const std::size_t largest = keys.empty() ? 0 : *std::max_element(keys.begin(), keys.end());
  return largest + 1 + random.below(3);
}

// Against the standard library's stable sort.
TEST(Buckets, AStableSort) {
  for (std::uint64_t number = 0; number < case_count(500); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0xB0C, number);
    const auto keys = random_keys(random);
    std::vector<std::uint32_t> order(keys.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) { return keys[i] < keys[j]; });

    const std::size_t count = bound_of(keys, random);
    const Buckets<> buckets = in_buckets(keys.size(), count, [&](std::uint32_t i) { return keys[i]; });
    ASSERT_EQ(buckets.size(), count);
    ASSERT_TRUE(std::equal(order.begin(), order.end(), buckets.items().begin(), buckets.items().end()));

    for (std::uint32_t k = 0; k < count; ++k) {
      const auto begin = std::find_if(order.begin(), order.end(), [&](std::uint32_t i) { return keys[i] >= k; });
      const auto end = std::find_if(order.begin(), order.end(), [&](std::uint32_t i) { return keys[i] > k; });
      ASSERT_EQ(buckets.start(k), begin - order.begin());
      ASSERT_TRUE(std::equal(begin, end, buckets[k].begin(), buckets[k].end()));
    }
  }
}

// Items that own memory: each arrives whole, once.
TEST(Buckets, ItemsThatOwnMemory) {
  for (std::uint64_t number = 0; number < case_count(100); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0xB0D, number);
    const auto keys = random_keys(random);
    const std::size_t count = bound_of(keys, random);
    std::vector<std::string> items, expected;
    for (std::size_t i = 0; i < keys.size(); ++i)
      items.push_back(std::to_string(keys[i]) + " with more than a short string holds, " + std::to_string(i));
    expected = items;

    const auto key_of = [](const std::string& item) { return static_cast<std::size_t>(std::stoul(item)); };
    std::stable_sort(expected.begin(), expected.end(),
                     [&](const std::string& a, const std::string& b) { return key_of(a) < key_of(b); });
    const Buckets<std::string> buckets(count, [&](auto&& visit) {
      for (const std::string& item : items) visit(key_of(item), item);
    });
    ASSERT_TRUE(std::equal(expected.begin(), expected.end(), buckets.items().begin(), buckets.items().end()));
  }
}

// Any number of items from one step: the edges of triangles by their lower end.
TEST(Buckets, SeveralItemsAStep) {
  const std::vector<std::uint32_t> corners = {0, 3, 1, 3, 0, 2};
  const Buckets<std::pair<std::uint32_t, std::size_t>> edges(4, [&](auto&& visit) {
    for (std::size_t c = 0; c < corners.size(); ++c) {
      const std::uint32_t u = corners[c], v = corners[c % 3 == 2 ? c - 2 : c + 1];
      visit(std::min(u, v), std::pair{std::max(u, v), c});
    }
  });
  using Edges = std::vector<std::pair<std::uint32_t, std::size_t>>;
  const auto at = [&](std::size_t v) { return Edges(edges[v].begin(), edges[v].end()); };
  EXPECT_EQ(at(0), (Edges{{3, 0}, {1, 2}, {3, 3}, {2, 4}}));
  EXPECT_EQ(at(1), (Edges{{3, 1}}));
  EXPECT_EQ(at(2), (Edges{{3, 5}}));
  EXPECT_EQ(at(3), Edges{});
}

// In one memory, which grows, is moved away and begins anew: as if made each time.
TEST(Buckets, AssignedAgain) {
  Buckets<> again, elsewhere;
  for (std::uint64_t number = 0; number < case_count(500); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0xB0E, number);
    const auto keys = random_keys(random);
    const std::size_t count = bound_of(keys, random);
    if (random.one_in(20)) elsewhere = std::move(again);

    again.assign(count, [&](auto&& visit) {
      for (std::uint32_t i = 0; i < keys.size(); ++i) visit(keys[i], i);
    });
    const Buckets<> once = in_buckets(keys.size(), count, [&](std::uint32_t i) { return keys[i]; });
    ASSERT_EQ(again.size(), count);
    for (std::uint32_t k = 0; k < count; ++k)
      ASSERT_TRUE(std::equal(again[k].begin(), again[k].end(), once[k].begin(), once[k].end()));
    ASSERT_EQ(again.items().size(), keys.size());
  }
}

// In memory of the caller, of items that carry their keys.
TEST(CountingSort, IsStable) {
  using Keyed = std::pair<std::uint32_t, std::uint32_t>;  // key, index
  for (std::uint64_t number = 0; number < case_count(100); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0xB0F, number);
    const auto keys = random_keys(random);
    std::vector<Keyed> given, placed(keys.size());
    for (std::uint32_t i = 0; i < keys.size(); ++i) given.push_back({keys[i], i});

    std::vector<std::uint32_t> start(bound_of(keys, random) + 2);
    const auto for_items = [&](auto&& visit) {
      for (const Keyed& x : given) visit(x.first, x);
    };
    counting_sort(std::span(start), for_items, [&](std::size_t n) {
      EXPECT_EQ(n, keys.size());
      return placed.data();
    });
    std::sort(given.begin(), given.end());
    ASSERT_EQ(placed, given);
    for (std::size_t i = 0; i < placed.size(); ++i) {
      ASSERT_LE(start[placed[i].first], i);
      ASSERT_GT(start[placed[i].first + 1], i);
    }
  }
}

TEST(Buckets, Nothing) {
  EXPECT_EQ(Buckets<>().size(), 0u);
  EXPECT_TRUE(Buckets<>().items().empty());
  const auto buckets = in_buckets(0, 3, [](std::uint32_t) { return 0u; });
  EXPECT_EQ(buckets.size(), 3u);
  EXPECT_TRUE(buckets[2].empty());
}

}  // namespace
}  // namespace quoin::grid::testing
