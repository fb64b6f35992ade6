#include "booleans/pairs/cell_filter.h"

#include <gtest/gtest.h>

#include "grid/lists/stretches.h"
#include "tests/booleans/support.h"

namespace quoin::booleans::testing {
namespace {

struct Grouped {
  Box box;
  std::uint32_t group;
};

/// A box of random size between two corners.
Box box_within(Random& random, const Vector& low, const Vector& high) {
  Box b;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::int64_t from = random.between(low[k], high[k]);
    const std::int64_t reach = (high[k] - from) / random.between(1, 8);
    b.low[k] = static_cast<std::int32_t>(from);
    b.high[k] = static_cast<std::int32_t>(random.between(from, from + reach));
  }
  return b;
}

/// Boxes of a few groups.
Array<Grouped> random_boxes(Random& random, const Vector& low, const Vector& high) {
  const std::uint64_t groups = 1 + random.below(4);
  Array<Grouped> boxes;
  for (std::uint64_t n = 1 + random.below(60); n > 0; --n)
    boxes.push_back({box_within(random, low, high), static_cast<std::uint32_t>(random.below(groups))});
  return boxes;
}

Box bounds_of(const Array<Grouped>& boxes) {
  Box all;
  for (const Grouped& b : boxes) all.add(b.box);
  return all;
}

bool meets_foreign(const Array<Grouped>& boxes, const Grouped& b) {
  return std::any_of(boxes.begin(), boxes.end(),
                     [&](const Grouped& other) { return other.group != b.group && other.box.meets(b.box); });
}

/// What a filter says of boxes that were added one after the other, or side by side.
Array<bool> shared(CellFilter cells, const Array<Grouped>& boxes, bool side_by_side) {
  grid::in_stretches(boxes.size(), side_by_side ? 1 : boxes.size(),
                     [&](std::size_t, std::size_t begin, std::size_t end) {
                       for (std::size_t i = begin; i < end; ++i) cells.add(boxes[i].box, boxes[i].group);
                     });
  Array<bool> r;
  for (const Grouped& b : boxes) r.push_back(cells.is_shared(b.box));
  return r;
}

// Cells of one point with integer coordinates each: boxes that meet have such a point in common.
TEST(CellFilter, TheFinestCellsTellExactlyWhatMeets) {
  for (std::uint64_t number = 0; number < case_count(300); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0xCE11, number);
    const std::int64_t most = exact::world - 8;
    const Vector low = random.one_in(2) ? random.vector(-4, 4) : random.vector(-most - 8, most);
    const Array<Grouped> boxes = random_boxes(random, low, low + random.vector(0, 7));
    Array<bool> expected;
    for (const Grouped& b : boxes) expected.push_back(meets_foreign(boxes, b));

    const CellFilter cells(bounds_of(boxes), {bounds_of(boxes)}, 1, 512);
    EXPECT_EQ(shared(cells, boxes, false), expected);
  }
}

TEST(CellFilter, CoarserCellsLoseNothingThatMeets) {
  for (std::uint64_t number = 0; number < case_count(300); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0xCE12, number);
    const std::int64_t reach = std::array<std::int64_t, 3>{20, 100000, exact::world}[random.below(3)];
    const Array<Grouped> boxes = random_boxes(random, {-reach, -reach, -reach}, {reach, reach, reach});
    Array<Box> sample;
    for (const Grouped& b : boxes)
      if (sample.empty() || random.one_in(3)) sample.push_back(b.box);

    const CellFilter cells(bounds_of(boxes), sample, boxes.size() / sample.size() + 1, 1 + random.below(2000));
    const Array<bool> found = shared(cells, boxes, false);
    for (std::size_t i = 0; i < boxes.size(); ++i) EXPECT_GE(found[i], meets_foreign(boxes, boxes[i]));
    const bool one_group =
        std::all_of(boxes.begin(), boxes.end(), [&](const Grouped& b) { return b.group == boxes[0].group; });
    if (one_group) {
      EXPECT_EQ(found, Array<bool>(boxes.size()));
    }

    EXPECT_EQ(shared(cells, boxes, true), found);
    Array<bool> reversed = shared(cells, {boxes.rbegin(), boxes.rend()}, false);
    std::reverse(reversed.begin(), reversed.end());
    EXPECT_EQ(reversed, found);
  }
}

// Two points side by side, of two groups: in one cell, unless the work allows cells of one step.
TEST(CellFilter, CellsAreAsFineAsTheWorkAllows) {
  const Box all{{0, 0, 0}, {7, 7, 7}}, p{{0, 0, 0}, {0, 0, 0}}, q{{1, 0, 0}, {1, 0, 0}};
  const auto together = [&](std::size_t share, std::size_t work) {
    CellFilter cells(all, {all}, share, work);
    cells.add(p, 0);
    cells.add(q, 1);
    EXPECT_EQ(cells.is_shared(p), cells.is_shared(q));
    return cells.is_shared(p);
  };
  EXPECT_FALSE(together(1, 512));
  EXPECT_TRUE(together(1, 511)) << "fewer cells than points";
  EXPECT_TRUE(together(2, 512)) << "two boxes of 512 cells each";
  EXPECT_FALSE(together(2, 1024));
  EXPECT_TRUE(together(1, 1));
}

// From one end of the world to the other, with one cell for all of it.
TEST(CellFilter, OneCell) {
  constexpr std::int32_t w = exact::world;
  const Box all{{-w, -w, -w}, {w, w, w}}, low{{-w, -w, -w}, {-w, -w, -w}}, high{{w, w, w}, {w, w, w}};
  for (const std::uint32_t other : {3u, 4u}) {
    CellFilter cells(all, {all}, 1, 1);
    cells.add(low, 3);
    EXPECT_FALSE(cells.is_shared(low));
    cells.add(high, other);
    EXPECT_EQ(cells.is_shared(low), other != 3);
    EXPECT_EQ(cells.is_shared(high), other != 3);
  }
}

}  // namespace
}  // namespace quoin::booleans::testing
