#include "booleans/pairs/fan_proof.h"

#include <gtest/gtest.h>

#include "booleans/embedding.h"
#include "booleans/pairs/own_pairs.h"
#include "tests/booleans/pairs/fans.h"
#include "tests/grid/with_thresholds.h"

namespace quoin::booleans::testing {
namespace {

using grid::testing::WithThresholds;

// Against all pairs.
TEST(FanProof, ProvedTrianglesMeetAllOthersAsTheyShould) {
  std::size_t fans_proved = 0;
  for (std::uint64_t number = 0; number < case_count(200); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0xFA9, number);
    const auto mesh = with_fans(random);
    if (!mesh) continue;
    const auto proved = proved_in_fans(*mesh, stars(*mesh));
    if (proved.empty()) continue;
    for (const auto& [s, t] : improper_by_pairs(*mesh)) EXPECT_FALSE(proved[s.value] || proved[t.value]);
    fans_proved += std::count(proved.begin(), proved.end(), 1) > 0 ? 1 : 0;
  }
  if (usual_thresholds()) {
    EXPECT_GT(fans_proved, case_count(200) / 10);
  }
}

/// A pyramid over the points of a parabola: a flat fan of 14 triangles around (0, 0, 0), a cone of 16 around its apex.
Body pyramid() {
  constexpr std::uint32_t n = 16;
  std::vector<Vector> points;
  std::vector<Triangle> triangles;
  for (std::uint32_t i = 0; i < n; ++i) {
    points.push_back({10 * i, 10 * i * i, 0});
    triangles.push_back({i, (i + 1) % n, n});
    if (i > 0 && i + 1 < n) triangles.push_back({0, i + 1, i});
  }
  points.push_back({75, 750, 600});
  return *mesh(points, triangles);
}

// What meets a fan in its corners and edges only leaves it proved; all else, and what is beside a cone, does not.
TEST(FanProof, APyramidAndATetrahedron) {
  struct Case {
    const char* name;
    std::array<Vector, 4> tetrahedron;
    std::ptrdiff_t proved;
  };
  static constexpr std::array<Case, 11> cases{{
      {"apart, on the plane of the base", {{{1000, 0, 0}, {1010, 0, 0}, {1000, 10, 0}, {1000, 0, -10}}}, 30},
      {"tip in the hub of the base", {{{0, 0, 0}, {-10, -10, -100}, {10, -10, -100}, {0, 10, -100}}}, 30},
      {"tip in another corner", {{{50, 250, 0}, {40, 240, -100}, {60, 240, -100}, {50, 260, -100}}}, 30},
      {"edge on an edge", {{{50, 250, 0}, {60, 360, 0}, {50, 300, -100}, {70, 300, -100}}}, 30},
      {"edge on an inner edge of the base", {{{0, 0, 0}, {60, 360, 0}, {20, 200, -100}, {50, 200, -100}}}, 30},
      {"tip within the base", {{{75, 750, 0}, {70, 740, -100}, {80, 740, -100}, {75, 760, -100}}}, 16},
      {"edge within the base", {{{75, 750, 0}, {80, 800, 0}, {70, 750, -100}, {80, 790, -100}}}, 16},
      {"face within the base", {{{70, 740, 0}, {80, 740, 0}, {75, 750, 0}, {75, 745, -100}}}, 16},
      {"through the base", {{{75, 750, 10}, {70, 740, -100}, {80, 740, -100}, {75, 760, -100}}}, 0},
      {"through the sides", {{{75, 750, 100}, {400, 740, 110}, {400, 760, 110}, {400, 750, 90}}}, 14},
      {"within", {{{75, 750, 100}, {70, 740, 110}, {70, 760, 110}, {75, 750, 120}}}, 14},
  }};
  const WithThresholds usual{grid::Thresholds{}};
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name);
    const Body both = merged(std::vector<Body>{pyramid(), *tetrahedron(c.tetrahedron)});
    const auto proved = proved_in_fans(both, stars(both));
    EXPECT_EQ(std::count(proved.begin(), proved.end(), 1), c.proved);
    for (const auto& [s, t] : improper_by_pairs(both)) EXPECT_FALSE(proved[s.value] || proved[t.value]);
  }
}

// A fan that winds around its hub twice covers its plane twice: none of it is proved.
TEST(FanProof, AFlatFanThatOverlapsItself) {
  const WithThresholds all(grid::testing::with(&grid::Thresholds::large_fan, std::size_t{0}));
  const std::vector<Vector> points{{0, 0, 0}, {8, 0, 0}, {-4, 7, 0}, {-4, -7, 0}, {9, 1, 0}, {-5, 8, 0}, {-4, -8, 0}};
  const std::vector<Triangle> once{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}};
  std::vector<Triangle> twice = once;
  for (const Triangle& t : {Triangle{0, 4, 5}, Triangle{0, 5, 6}, Triangle{0, 6, 4}}) twice.push_back(t);
  const auto proved = [&](const std::vector<Triangle>& triangles) {
    const Body fan = *mesh(points, triangles);
    const auto marks = proved_in_fans(fan, Array<Star>(points.size(), Star::other));
    return std::count(marks.begin(), marks.end(), 1);
  };
  EXPECT_EQ(proved(once), exact::checked ? 3 : 0);
  EXPECT_EQ(proved(twice), 0);

  // A triangle on its plane, of its outer edges: both cover the same.
  std::vector<Triangle> covered = once;
  covered.push_back({3, 2, 1});
  EXPECT_EQ(proved(covered), 0);
}

// What pierces a cone above its base is on one side of the base, and so is what passes by.
TEST(FanProof, AConeThatIsPiercedAboveItsBase) {
  constexpr std::uint32_t n = 100;
  std::vector<Vector> points;
  std::vector<Triangle> triangles;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double turn = 2 * std::numbers::pi * i / n;
    points.push_back({std::llround(1e4 * std::cos(turn)), std::llround(1e4 * std::sin(turn)), 0});
    triangles.push_back({i, (i + 1) % n, n});
    if (i > 0 && i + 1 < n) triangles.push_back({0, i + 1, i});
  }
  points.push_back({0, 0, 10000});
  const Body cone = *mesh(points, triangles);
  for (const std::int64_t from : {-100, 9000}) {
    const auto needle = tetrahedron({{{from, 50, 2000}, {20000, 50, 2000}, {20000, 350, 2000}, {20000, 50, 2300}}});
    const std::vector<Body> parts{cone, *needle};
    const Body both = merged(parts);
    const auto found = improper_pairs(both, stars(both));
    EXPECT_EQ(std::set<FacePair>(found.begin(), found.end()), improper_by_pairs(both));
    EXPECT_EQ(found.empty(), from > 8000);
  }
}

// Nothing is left to compare where fans are all there is.
TEST(FanProof, FansAreProvedAsAWhole) {
  std::vector<std::array<std::int64_t, 2>> circle;
  for (int i = 0; i < 500; ++i)
    circle.push_back({std::llround(1e6 * std::cos(i * std::numbers::pi / 250)),
                      std::llround(1e6 * std::sin(i * std::numbers::pi / 250))});
  const Body prism = extruded(circle, 0, 1000);
  const auto proved = proved_in_fans(prism, stars(prism));
  if (usual_thresholds()) {
    EXPECT_GE(std::count(proved.begin(), proved.end(), 1), 2 * 498);
  }
}

// Two apices over a rim that zigzags: each fan meets the other near the rim only, whatever the boxes of its triangles
// say. With a tooth that reaches through the other fan only that one is not proved.
TEST(FanProof, ARimThatZigzags) {
  constexpr std::uint32_t n = 400;
  for (const std::int64_t tooth : {0, 600000}) {
    std::vector<Vector> points;
    std::vector<Triangle> triangles;
    for (std::uint32_t i = 0; i < n; ++i) {
      const double turn = 2 * std::numbers::pi * i / n;
      points.push_back({std::llround(1e6 * std::cos(turn)), std::llround(1e6 * std::sin(turn)), i % 2 == 0 ? 50 : 0});
      triangles.push_back({i, (i + 1) % n, n});
      triangles.push_back({(i + 1) % n, i, n + 1});
    }
    points.push_back({0, 0, 1000000});
    points.push_back({1000, 0, -1000000});
    std::vector<Body> parts{*mesh(points, triangles)};
    if (tooth != 0)
      parts.push_back(*tetrahedron(
          {{{-600000, 0, 2000000}, {-tooth, 3, -100000}, {-tooth, -3, -100000}, {-tooth - 3, 0, -100000}}}));
    const Body both = merged(parts);

    const auto proved = proved_in_fans(both, stars(both));
    if (proved.empty()) continue;
    for (const auto& [s, t] : improper_by_pairs(both)) EXPECT_FALSE(proved[s.value] || proved[t.value]);
    if (tooth == 0 && usual_thresholds()) {
      EXPECT_EQ(std::count(proved.begin(), proved.end(), 1), 2 * n);
    }
  }
}

// The tip of a long tooth of the rim comes through a triangle of which one corner lies higher than that tip, and which
// the tooth passes far from the edges.
TEST(FanProof, AToothThroughATriangle) {
  const WithThresholds all(grid::testing::with(&grid::Thresholds::large_fan, std::size_t{0}));
  const std::vector<Vector> points{{500, -500, 0}, {3000, 0, -300}, {500, 500, 0}, {-400, 600, 0},
                                   {-1000, 0, 0},  {-400, -600, 0}, {0, 0, 1000},  {0, 0, -1000}};
  std::vector<Triangle> triangles;
  for (std::uint32_t i = 0; i < 6; ++i) {
    triangles.push_back({i, (i + 1) % 6, 6});
    triangles.push_back({(i + 1) % 6, i, 7});
  }
  for (const std::int64_t side : {1, -1}) {
    const auto wall = tetrahedron({{{2500, side * 700, 0},
                                    {2500, side * -30000, -1000},
                                    {2500, side * 700, -1000},
                                    {20000, side * -5000, -5000}}});
    const Body both = merged(std::vector<Body>{*mesh(points, triangles), *wall});
    const auto improper = improper_by_pairs(both);
    EXPECT_FALSE(improper.empty());
    const auto proved = proved_in_fans(both, stars(both));
    for (const auto& [a, b] : improper) EXPECT_FALSE(!proved.empty() && (proved[a.value] || proved[b.value]));
  }
}

// A nick in the rim takes two triangles of a cone of 300 away, and cuts one of their edges: the others are proved as
// ever.
TEST(FanProof, AConeWithANick) {
  constexpr std::uint32_t n = 300;
  std::vector<Vector> points;
  std::vector<Triangle> triangles;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double turn = 2 * std::numbers::pi * i / n;
    points.push_back({std::llround(1e6 * std::cos(turn)), std::llround(1e6 * std::sin(turn)), 0});
    triangles.push_back({i, (i + 1) % n, n});
    if (i > 0 && i + 1 < n) triangles.push_back({0, i + 1, i});
  }
  points.push_back({0, 0, 1000000});
  const Body cone = *mesh(points, triangles);
  const Body nicked = packed(minus(cone, box({990000, -5000, -10}, {1010000, 5000, 3000})));

  const auto proved = proved_in_fans(nicked, stars(nicked));
  if (usual_thresholds()) {
    EXPECT_GE(std::count(proved.begin(), proved.end(), 1), n - 4);
    EXPECT_LT(doubtful_pairs(nicked).size(), 20u);
  }
  EXPECT_EQ(embedding_fault(nicked).value_or(""), "");
}

}  // namespace
}  // namespace quoin::booleans::testing
