#include "booleans/body/labels.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/booleans/support.h"

namespace quoin::booleans {
namespace {

using testing::Random;

Origins::Pointer origin(std::uint32_t id, const std::string& name) {
  return std::make_shared<const Origin>(Origin{id, name, 4, {0, 0, 1, 1}, {}, nullptr});
}

TEST(Origins, AreFoundByWhatTheyAre) {
  Origins origins;
  for (std::uint32_t id = 0; id < 50; ++id) origins.add(origin(id, "part"));
  origins.add(nullptr);
  for (std::uint32_t id = 0; id < 50; ++id) EXPECT_EQ(origins.find(origin(id, "part")), id);
  EXPECT_EQ(origins.find(nullptr), 50u);
  EXPECT_EQ(origins.find(origin(3, "other")), 51u);
  EXPECT_EQ(origins.size(), 51u);
}

TEST(Origins, HaveAnOrderOfTheirOwn) {
  Origins origins;
  for (std::uint32_t id = 0; id < 4; ++id) origins.add(origin(id, ""));
  EXPECT_EQ(origins.in_order(), (grid::Array<std::uint32_t>{0, 1, 2, 3}));
  origins.set_order(grid::Array<std::uint32_t>{2, 0, 3, 1});
  EXPECT_EQ(origins.in_order(), (grid::Array<std::uint32_t>{2, 0, 3, 1}));
  EXPECT_TRUE(origins.comes_before({2, 3}, {0, 0}));
  EXPECT_FALSE(origins.comes_before({1, 0}, {3, 3}));
  EXPECT_TRUE(origins.comes_before({1, 0}, {1, 2}));
}

TEST(Origins, SurfacesAreLabelsUnlessTheySaySo) {
  Origins origins;
  origins.add(origin(1, ""));
  origins.add(std::make_shared<const Origin>(Origin{2, "", 4, {0, 0, 1, 1}, {0, 1, 2, 2}, nullptr}));
  origins.add(nullptr);
  EXPECT_TRUE(origins.is_same_surface({0, 0}, {0, 1}));
  EXPECT_FALSE(origins.is_same_surface({0, 1}, {0, 2}));
  EXPECT_FALSE(origins.is_same_surface({0, 0}, {0, 1, true}));
  EXPECT_FALSE(origins.is_same_surface({1, 0}, {1, 1}));
  EXPECT_TRUE(origins.is_same_surface({1, 2}, {1, 3}));
  EXPECT_FALSE(origins.is_same_surface({0, 0}, {1, 0}));
  EXPECT_TRUE(origins.is_same_surface({2, 0}, {2, 5}));
  EXPECT_EQ(origins.label({0, 3}), 1u);
  EXPECT_EQ(origins.label({2, 3}), 0u);
}

// A loop and its reverse: the edge from u to v begins elsewhere, and is the same edge.
TEST(Labels, BordersGoWithTheirEdgesWhenLoopsAreReversed) {
  Random random(16, 1);
  for (int round = 0; round < 200; ++round) {
    const auto begin = static_cast<std::uint32_t>(random.below(5));
    const auto size = static_cast<std::uint32_t>(2 + random.below(6)), end = begin + size;
    std::vector<std::uint32_t> loop(end);
    for (std::uint32_t i = begin; i < end; ++i) loop[i] = 100 + i;
    std::vector<std::uint32_t> reversed = loop;
    std::reverse(reversed.begin() + begin, reversed.end());
    const auto next = [&](const std::vector<std::uint32_t>& l, std::uint32_t i) {
      return l[i + 1 < end ? i + 1 : begin];
    };

    Labels labels;
    for (std::uint32_t i = begin; i < end; ++i)
      if (random.one_in(2)) labels.borders.push_back({i, {{1, 0, 0}, static_cast<exact::int128>(i)}});
    Labels other;
    other.append_reversed_borders(labels, begin, end, begin);
    ASSERT_EQ(other.borders.size(), labels.borders.size());
    for (const Border& b : other.borders) {
      const auto was = static_cast<std::uint32_t>(b.other.d);
      EXPECT_EQ(reversed[b.corner], next(loop, was));
      EXPECT_EQ(next(reversed, b.corner), loop[was]);
    }
    EXPECT_TRUE(std::is_sorted(other.borders.begin(), other.borders.end(),
                               [](const Border& a, const Border& b) { return a.corner < b.corner; }));

    other.reverse_loops(std::vector<std::uint32_t>{begin, end});
    for (std::size_t i = 0; i < labels.borders.size(); ++i) {
      EXPECT_EQ(other.borders[i].corner, labels.borders[i].corner);
      EXPECT_EQ(other.borders[i].other, labels.borders[i].other);
    }
    Labels copied;
    copied.append_borders(labels, begin, end, begin + 7);
    for (std::size_t i = 0; i < labels.borders.size(); ++i)
      EXPECT_EQ(copied.borders[i].corner, labels.borders[i].corner + 7);
  }
}

}  // namespace
}  // namespace quoin::booleans
