#include "booleans/pairs/box_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "tests/booleans/support.h"
#include "tests/grid/with_thresholds.h"

namespace quoin::booleans::testing {
namespace {

using Item = BoxTree::Item;
using IdPairs = Array<std::array<std::uint32_t, 2>>;

Box cuboid(const Vector& low, const Vector& high) {
  Box b;
  for (std::size_t k = 0; k < 3; ++k) {
    b.low[k] = static_cast<std::int32_t>(low[k]);
    b.high[k] = static_cast<std::int32_t>(high[k]);
  }
  return b;
}

Box random_box(Random& random, std::int64_t reach) {
  const std::int64_t size = random.one_in(20) ? 2 * reach : random.one_in(4) ? 0 : std::max<std::int64_t>(1, reach / 4);
  const Vector low = random.vector(-reach, reach);
  Vector high{};
  for (std::size_t k = 0; k < 3; ++k) high[k] = std::min(low[k] + random.between(0, size), reach);
  return cuboid(low, high);
}

/// Boxes, flat ones and points among them, over a few steps or the whole world; of one group, a few or many.
struct Boxes {
  std::int64_t reach;
  Array<Item> items;

  explicit Boxes(Random& random) : reach(std::array<std::int64_t, 4>{1, 6, 1000, exact::world}[random.below(4)]) {
    const auto count = static_cast<std::uint32_t>(random.below(random.one_in(4) ? 700 : 80));
    const std::uint64_t groups = 1 + random.below(random.one_in(2) ? 3 : 100);
    for (std::uint32_t i = 0; i < count; ++i)
      items.push_back({random_box(random, reach), count - i, static_cast<std::uint32_t>(random.below(groups))});
  }
  /// The ids count down to 1.
  const Item& item(std::uint32_t id) const { return items[items.size() - id]; }
};

/// check(boxes, tree, random) for trees of both orders.
template <class Check>
void for_trees(std::uint64_t salt, std::uint64_t count, Check&& check) {
  for (std::uint64_t number = 0; number < case_count(count); ++number)
    for (const BoxTree::Order order : {BoxTree::Order::by_place, BoxTree::Order::by_group}) {
      SCOPED_TRACE(case_name(number));
      Random random(salt, number);
      const Boxes boxes(random);
      check(boxes, BoxTree(boxes.items, order), random);
    }
}

IdPairs pairs_of(const BoxTree& tree, BoxTree::Pairs wanted) {
  IdPairs pairs;
  tree.pairs([&](std::uint32_t a, std::uint32_t b) { pairs.push_back({std::min(a, b), std::max(a, b)}); }, wanted);
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

IdPairs pairs_by_all(const Array<Item>& items, BoxTree::Pairs wanted) {
  IdPairs pairs;
  for (std::size_t i = 0; i < items.size(); ++i)
    for (std::size_t j = i + 1; j < items.size(); ++j)
      if (items[i].box.meets(items[j].box) && (wanted == BoxTree::Pairs::all || items[i].group != items[j].group))
        pairs.push_back({std::min(items[i].id, items[j].id), std::max(items[i].id, items[j].id)});
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

// Against all pairs, each once.
TEST(BoxTree, FindsThePairsThatBoxesHave) {
  for_trees(0xB07E, 60, [](const Boxes& boxes, const BoxTree& tree, Random&) {
    for (const BoxTree::Pairs wanted : {BoxTree::Pairs::all, BoxTree::Pairs::foreign})
      EXPECT_EQ(pairs_of(tree, wanted), pairs_by_all(boxes.items, wanted));
  });
}

// A touches B in a corner, B touches C; B and C are of one group.
TEST(BoxTree, BoxesThatTouchMeet) {
  const Array<Item> items{
      {cuboid({0, 0, 0}, {2, 2, 2}), 5, 0}, {cuboid({2, 2, 2}, {4, 4, 4}), 6, 1}, {cuboid({4, 2, 2}, {4, 2, 2}), 7, 1}};
  const BoxTree tree(items);
  EXPECT_EQ(pairs_of(tree, BoxTree::Pairs::all), (IdPairs{{5, 6}, {6, 7}}));
  EXPECT_EQ(pairs_of(tree, BoxTree::Pairs::foreign), (IdPairs{{5, 6}}));
}

TEST(BoxTree, NothingAndOneBox) {
  const Box unit = cuboid({0, 0, 0}, {1, 1, 1});
  const BoxTree nothing({}), one({{unit, 7, 0}});
  for (const BoxTree::Pairs wanted : {BoxTree::Pairs::all, BoxTree::Pairs::foreign}) {
    EXPECT_EQ(pairs_of(nothing, wanted), IdPairs{});
    EXPECT_EQ(pairs_of(one, wanted), IdPairs{});
  }

  Array<std::uint32_t> seen;
  nothing.meeting(unit, [&](std::uint32_t id) { seen.push_back(id); });
  EXPECT_EQ(seen, Array<std::uint32_t>{});
  one.meeting(cuboid({1, 1, 1}, {2, 2, 2}), [&](std::uint32_t id) { seen.push_back(id); });
  EXPECT_EQ(seen, Array<std::uint32_t>{7});
}

TEST(BoxTree, MeetingFindsTheBoxesThatMeetABox) {
  for_trees(0xB07F, 40, [](const Boxes& boxes, const BoxTree& tree, Random& random) {
    for (int i = 0; i < 20; ++i) {
      const Box asked = random_box(random, boxes.reach);
      Array<std::uint32_t> found, expected;
      tree.meeting(asked, [&](std::uint32_t id) { found.push_back(id); });
      for (const Item& x : boxes.items)
        if (x.box.meets(asked)) expected.push_back(x.id);
      std::sort(found.begin(), found.end());
      std::sort(expected.begin(), expected.end());
      EXPECT_EQ(found, expected);
    }
  });
}

// Boxes below the top of one that was seen are not asked for any more; the highest top is found all the same.
TEST(BoxTree, AVisitorMayShrinkTheBox) {
  for_trees(0xB080, 40, [](const Boxes& boxes, const BoxTree& tree, Random& random) {
    Box asked = random_box(random, boxes.reach);
    asked.high[1] = INT32_MAX;
    std::int32_t highest = asked.low[1];
    for (const Item& x : boxes.items)
      if (x.box.meets(asked)) highest = std::max(highest, x.box.high[1]);

    tree.meeting(asked, [&](std::uint32_t id) {
      EXPECT_TRUE(boxes.item(id).box.meets(asked));
      asked.low[1] = std::max(asked.low[1], boxes.item(id).box.high[1]);
    });
    EXPECT_EQ(asked.low[1], highest);
  });
}

TEST(BoxTree, BoxesOfABlockThatReachFurtherUpComeFirst) {
  Array<Item> items;
  for (const std::int64_t top : {3, 1, 4, 10, 5, 9, 2, 6})
    items.push_back({cuboid({0, 0, 0}, {1, top, 1}), static_cast<std::uint32_t>(top), 0});
  Array<std::uint32_t> seen;
  BoxTree(items).meeting(cuboid({0, 0, 0}, {1, 20, 1}), [&](std::uint32_t id) { seen.push_back(id); });
  EXPECT_EQ(seen, (Array<std::uint32_t>{10, 9, 6, 5, 4, 3, 2, 1}));
}

// Eight boxes at the corners of a cube, x being the last digit of a place.
TEST(BoxTree, OrderByPlaceAndByGroup) {
  Array<Item> items;
  for (std::uint32_t i = 8; i-- > 0;) {
    const Vector low{10 * (i & 1), 10 * (i >> 1 & 1), 10 * (i >> 2)};
    items.push_back({cuboid(low, low + Vector{1, 1, 1}), i, i & 1});
  }
  EXPECT_EQ(BoxTree(items).ids(), (Array<std::uint32_t>{0, 1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(BoxTree(items, BoxTree::Order::by_group).ids(), (Array<std::uint32_t>{0, 2, 4, 6, 1, 3, 5, 7}));
}

TEST(BoxTree, ItemsStayWithTheirBoxes) {
  for_trees(0xB081, 40, [](const Boxes& boxes, const BoxTree& tree, Random&) {
    Array<std::uint32_t> ids = tree.ids();
    for (std::uint32_t i = 0; i < ids.size(); ++i) {
      EXPECT_EQ(tree.box(i).low, boxes.item(ids[i]).box.low);
      EXPECT_EQ(tree.box(i).high, boxes.item(ids[i]).box.high);
    }
    std::sort(ids.begin(), ids.end());
    Array<std::uint32_t> all(boxes.items.size());
    std::iota(all.begin(), all.end(), 1);
    EXPECT_EQ(ids, all);
  });
}

// Sorted by comparison and by digits.
TEST(BoxTree, TheOrderIsOneForAnyNumberOfKeys) {
  for (std::uint64_t number = 0; number < case_count(40); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0xB082, number);
    const Boxes boxes(random);
    const auto ids = [&](BoxTree::Order order, std::size_t few_keys) {
      const grid::testing::WithThresholds t(grid::testing::with(&grid::Thresholds::few_keys, few_keys));
      return BoxTree(boxes.items, order).ids();
    };
    EXPECT_EQ(ids(BoxTree::Order::by_place, 0), ids(BoxTree::Order::by_place, 1 << 20));

    const Array<std::uint32_t> by_group = ids(BoxTree::Order::by_group, 0);
    EXPECT_EQ(by_group, ids(BoxTree::Order::by_group, 1 << 20));
    EXPECT_TRUE(std::is_sorted(by_group.begin(), by_group.end(), [&](std::uint32_t a, std::uint32_t b) {
      return boxes.item(a).group < boxes.item(b).group;
    }));
  }
}

}  // namespace
}  // namespace quoin::booleans::testing
