#include "grid/cut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "grid/seal.h"
#include "tests/grid/random.h"

namespace quoin::grid {
namespace {

using exact::GridPoint;
using exact::int128;
using Triangle = std::array<std::uint32_t, 3>;
using Flat = Array<std::array<std::int32_t, 2>>;

std::map<std::pair<std::uint32_t, std::uint32_t>, int> edge_sum(std::span<const std::uint32_t> loop) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sum;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const std::uint32_t a = loop[i], b = loop[(i + 1) % loop.size()];
    if (a < b) ++sum[{a, b}];
    if (a > b) --sum[{b, a}];
  }
  return sum;
}

void expect_same_edges(const Array<std::uint32_t>& loop, const Array<Triangle>& triangles) {
  auto sum = edge_sum(loop);
  for (const Triangle& t : triangles)
    for (const auto& [edge, count] : edge_sum(t)) sum[edge] -= count;
  for (const auto& [edge, count] : sum) EXPECT_EQ(count, 0) << edge.first << " - " << edge.second;
}

/// Cuts a simple polygon, given flat, on a sloping plane seen from both sides and along all axes.
void check_simple(const Flat& flat) {
  for (int axis = 0; axis < 3; ++axis)
    for (int view = 0; view < 4; ++view) {
      const bool upside_down = view % 2 != 0, sloping = view >= 2;
      Array<GridPoint> points;
      for (const auto& p : flat) {
        GridPoint g{};
        g.c[static_cast<std::size_t>((axis + 1) % 3)] = p[0];
        g.c[static_cast<std::size_t>((axis + 2) % 3)] = p[1];
        g.c[static_cast<std::size_t>(axis)] = sloping ? -p[1] : 7;
        points.push_back(g);
      }
      Array<std::uint32_t> loop(flat.size());
      std::iota(loop.begin(), loop.end(), 0U);
      if (upside_down) std::reverse(loop.begin(), loop.end());
      Array<Triangle> triangles;
      Cutter cutter(points);
      EXPECT_TRUE(cutter.cut(loop, triangles));
      ASSERT_EQ(triangles.size(), flat.size() - 2);
      expect_same_edges(loop, triangles);
      // Positive areas that add up to the polygon's: no overlap.
      const auto area_of = [&](const auto& corners) {
        int128 sum = 0;
        for (std::size_t i = 2; i < corners.size(); ++i)
          sum += area(flat[corners[0]], flat[corners[i - 1]], flat[corners[i]]) * (upside_down ? -1 : 1);
        return sum;
      };
      int128 sum = 0;
      for (const Triangle& t : triangles) {
        EXPECT_TRUE(area_of(t) > 0);
        sum += area_of(t);
      }
      EXPECT_TRUE(sum == area_of(loop));
    }
}

TEST(Cut, convex) {
  check_simple({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  check_simple({{0, 0}, {4, -1}, {6, 2}, {4, 5}, {1, 4}});
}

TEST(Cut, collinear_corners_stay) {
  check_simple({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 3}});
  check_simple({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}});
  check_simple({{0, 0}, {2, 0}, {4, 0}, {2, 2}, {1, 1}});
}

TEST(Cut, l_shape_with_collinear_corners) {
  check_simple({{0, 0}, {2, 0}, {4, 0}, {4, 2}, {3, 2}, {2, 2}, {2, 3}, {2, 4}, {0, 4}, {0, 2}});
}

TEST(Cut, extreme_coordinates) {
  const std::int32_t w = 1 << 29;
  check_simple({{-w, -w}, {w, -w}, {w, w}, {w - 1, w}, {0, -w + 1}, {-w + 1, w}, {-w, w}});
}

TEST(Cut, combs_and_spirals) {
  Flat comb;
  for (int i = 0; i < 2000; ++i) comb.push_back({i, 0});
  for (int i = 1999; i >= 0; --i) comb.push_back({i, i % 2 == 0 ? 1 : 1000});
  check_simple(comb);
  Flat spiral;
  const int turns = 200;
  for (int i = 0; i < turns; ++i) {  // inwards along the outer wall, back along the inner one
    const int r = 4 * (turns - i) + 8;
    spiral.insert(spiral.end(), {{-r, -r}, {r, -r}, {r, r}, {-r + 4, r}});
  }
  for (int i = turns - 1; i >= 0; --i) {
    const int r = 4 * (turns - i) + 6;
    spiral.insert(spiral.end(), {{-r + 4, r}, {r, r}, {r, -r}, {-r, -r}});
  }
  check_simple(spiral);
}

TEST(Cut, random_star_shapes) {
  auto random = seeded_generator();
  for (int round = 0; round < 200; ++round) {
    // Directions in counter-clockwise order around the origin, less than a half turn apart.
    std::set<std::pair<double, std::array<std::int32_t, 2>>> around;
    const int n = 4 + static_cast<int>(random() % 200);
    std::set<double> angles;
    for (int i = 0; i < n; ++i) {
      const auto x = static_cast<std::int32_t>(random() % 2001) - 1000,
                 y = static_cast<std::int32_t>(random() % 2001) - 1000;
      if (x == 0 && y == 0) continue;
      const double angle = std::atan2(y, x);
      if (angles.insert(angle).second) around.insert({angle, {x, y}});
    }
    Flat flat;
    for (const auto& [angle, p] : around) flat.push_back(p);
    bool star = flat.size() >= 4;
    for (std::size_t i = 0; star && i < flat.size(); ++i) star = area({0, 0}, flat[i], flat[(i + 1) % flat.size()]) > 0;
    if (star) check_simple(flat);
  }
}

TEST(Cut, a_hole_on_a_bridge) {
  const Array<GridPoint> points{{{0, 0, 0}}, {{9, 0, 0}}, {{9, 9, 0}}, {{0, 9, 0}},
                                {{3, 3, 0}}, {{3, 6, 0}}, {{6, 6, 0}}, {{6, 3, 0}}};
  const Array<std::uint32_t> loop{0, 1, 2, 3, 0, 4, 5, 6, 7, 4};
  Array<Triangle> triangles;
  Cutter cutter(points);
  EXPECT_TRUE(cutter.cut(loop, triangles));
  expect_same_edges(loop, triangles);
  std::int64_t sum = 0;
  for (const Triangle& t : triangles) {
    const auto flat = [&](std::uint32_t v) { return FlatPoint{points[v].c[0], points[v].c[1]}; };
    const std::int64_t a = area(flat(t[0]), flat(t[1]), flat(t[2]));
    EXPECT_GT(a, 0);
    sum += a;
  }
  EXPECT_EQ(sum, 2 * (81 - 9));
}

TEST(Cut, polygons_that_are_not_simple_are_right_as_sums) {
  auto random = seeded_generator();
  for (int round = 0; round < 2000; ++round) {
    Array<GridPoint> points;
    const std::uint64_t range = 2 + random() % 5;
    const std::size_t n = 4 + random() % 9;
    Array<std::uint32_t> loop;
    for (std::uint32_t i = 0; i < range * range; ++i)
      points.push_back({{static_cast<std::int32_t>(i % range), static_cast<std::int32_t>(i / range),
                         round % 2 == 0 ? 0 : static_cast<std::int32_t>(random() % 3)}});
    while (loop.size() < n) {
      const auto v = static_cast<std::uint32_t>(random() % points.size());
      if (loop.empty() || (v != loop.back() && (loop.size() + 1 < n || v != loop.front()))) loop.push_back(v);
    }
    Array<Triangle> triangles;
    Cutter cutter(points);
    const bool planar = cutter.cut(loop, triangles);
    EXPECT_TRUE(planar || round % 2 != 0);
    EXPECT_EQ(triangles.size(), n - 2);
    expect_same_edges(loop, triangles);
  }
}

TEST(Cut, planarity) {
  const Array<GridPoint> points{{{0, 0, 0}}, {{4, 0, 4}}, {{4, 4, 8}},  {{0, 4, 4}},
                                {{0, 4, 5}}, {{8, 0, 8}}, {{12, 0, 12}}};
  Array<Triangle> triangles;
  Cutter cutter(points);
  EXPECT_TRUE(cutter.cut(Array<std::uint32_t>{0, 1, 2, 3}, triangles));
  EXPECT_FALSE(cutter.cut(Array<std::uint32_t>{0, 1, 2, 4}, triangles));
  EXPECT_TRUE(cutter.cut(Array<std::uint32_t>{0, 1, 5, 6}, triangles));  // on a line
  EXPECT_TRUE(cutter.cut(Array<std::uint32_t>{0, 2, 1, 3}, triangles));  // a bow-tie
}

}  // namespace
}  // namespace quoin::grid
