#include "grid/area.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <vector>

#include "tests/grid/random.h"

namespace quoin::grid {
namespace {

bool has_area(const std::vector<double>& points, Look look) {
  std::vector<std::uint32_t> face(points.size() / 3);
  std::iota(face.begin(), face.end(), 0U);
  return has_area(points, face, look);
}

// The second way: small integers, all cross products of three corners.
TEST(Area, AgreesWithIntegers) {
  auto random = seeded_generator();
  int flat = 0, seen_by_signs = 0;
  for (int round = 0; round < 20000; ++round) {
    const std::size_t n = 1 + random() % 5;
    const int size = 1 + static_cast<int>(random() % 3);
    std::vector<std::array<int, 3>> corners(n);
    const bool on_a_line = random() % 2 == 0;
    const std::array<int, 3> from{1, -2, 0}, along{2, static_cast<int>(random() % 3) - 1, -1};
    for (auto& c : corners) {
      const int t = static_cast<int>(random() % 5);
      for (std::size_t k = 0; k < 3; ++k)
        c[k] = on_a_line ? from[k] + t * along[k] : static_cast<int>(random() % (2 * size + 1)) - size;
    }

    bool expected = false;
    for (const auto& p : corners)
      for (const auto& q : corners)
        for (const auto& r : corners)
          for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
            expected = expected || (q[i] - p[i]) * (r[j] - p[j]) != (q[j] - p[j]) * (r[i] - p[i]);
          }
    std::vector<double> points;
    for (const auto& c : corners) points.insert(points.end(), c.begin(), c.end());

    EXPECT_EQ(has_area(points, Look::exactly), expected);
    if (has_area(points, Look::at_signs)) {
      EXPECT_TRUE(expected);
      ++seen_by_signs;
    }
    flat += expected ? 0 : 1;
  }
  EXPECT_GT(flat, 2000);
  EXPECT_GT(seen_by_signs, 2000);
}

TEST(Area, WhatRoundingWouldHide) {
  constexpr double tiny = std::numeric_limits<double>::denorm_min(), huge = std::numeric_limits<double>::max();
  // Differences that overflow, products that underflow.
  EXPECT_TRUE(has_area({-huge, -huge, 0, huge, huge, 0, 0, tiny, 0}, Look::exactly));
  EXPECT_FALSE(has_area({-huge, -huge, 0, huge, huge, 0, tiny, tiny, 0}, Look::exactly));
  EXPECT_TRUE(has_area({0, 0, 0, tiny, tiny, 0, tiny, 2 * tiny, 0}, Look::exactly));
  EXPECT_FALSE(has_area({0, 0, 0, tiny, tiny, 0, 2 * tiny, 2 * tiny, 0}, Look::exactly));
  // Thirds of a segment, rounded, are not on it.
  EXPECT_TRUE(has_area({0, 0, 0, 1, 3, 0, 1. / 3, 1, 0}, Look::exactly));
  EXPECT_FALSE(has_area({0, 0, 0, -0., 0, 0, 1, 1, 1}, Look::exactly));
  EXPECT_FALSE(has_area({}, Look::exactly));
}

}  // namespace
}  // namespace quoin::grid
