#include "grid/weld.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "tests/grid/random.h"
#include "tests/grid/with_thresholds.h"

namespace quoin::grid {
namespace {

using exact::GridPoint;

/// Welds by a table, by one that gives way to sorting at the first collision, by sorting, and by std::map.
void check(const Array<GridPoint>& points, const Array<double>& input, std::size_t expected) {
  std::map<GridPoint, std::uint32_t> seen;
  std::map<GridPoint, std::set<std::array<double, 3>>> positions;
  Array<GridPoint> kept;
  Array<std::uint32_t> ids;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto [at, fresh] = seen.emplace(points[i], static_cast<std::uint32_t>(kept.size()));
    if (fresh) kept.push_back(points[i]);
    ids.push_back(at->second);
    positions[points[i]].insert({input[3 * i], input[3 * i + 1], input[3 * i + 2]});
  }
  if (kept.size() == points.size()) ids.clear();
  std::uint64_t merged = 0;
  for (const auto& [p, all] : positions) merged += all.size() - 1;

  const auto expect = [&](auto&& way) {
    Array<GridPoint> mine = points;
    const Weld w = way(mine);
    EXPECT_EQ(mine, kept);
    EXPECT_EQ(w.ids, ids);
    EXPECT_EQ(w.merged, merged);
  };
  expect([&](auto& mine) { return weld(mine, input, expected); });
  expect([&](auto& mine) {
    const testing::WithThresholds giving_way(testing::with(&Thresholds::collisions, std::size_t{0}));
    return weld(mine, input, expected);
  });
  expect([&](auto& mine) { return weld_by_sorting(mine, input); });
}

TEST(Weld, agrees_with_a_map) {
  auto random = seeded_generator();
  for (int round = 0; round < 60; ++round) {
    const std::size_t n = random() % 3000;
    const std::uint64_t range = std::uint64_t{1} << (1 + random() % 29);
    Array<GridPoint> points(n);
    Array<double> input;
    for (GridPoint& p : points)
      for (auto& c : p.c) {
        c = static_cast<std::int32_t>(random() % range) - static_cast<std::int32_t>(range / 2);
        input.push_back(c + (round % 2 == 0 ? 0.0 : static_cast<double>(random() % 3) / 8));
      }
    check(points, input, random() % (2 * n + 1));
  }
}

TEST(Weld, zeros_of_both_signs_are_one_position) {
  Array<GridPoint> points(4, GridPoint{{0, 0, 0}});
  const Array<double> input{0.0, 0, 0, -0.0, 0, 0, 0.25, 0.0, 0, 0.25, -0.0, 0};
  const Weld w = weld(points, input, 4);
  EXPECT_EQ(points.size(), 1U);
  EXPECT_EQ(w.merged, 1U);
}

TEST(Weld, regular_lattices) {
  Array<GridPoint> points;
  Array<double> input;
  for (int x = 0; x < 40; ++x)
    for (int y = 0; y < 40; ++y)
      for (int z = 0; z < 40; ++z) {
        points.push_back({{x << 20, y << 20, -(z << 20)}});
        for (auto c : points.back().c) input.push_back(c);
      }
  check(points, input, 16);
  points.push_back(points.front());
  for (auto c : points.back().c) input.push_back(c);
  check(points, input, 16);
}

}  // namespace
}  // namespace quoin::grid
