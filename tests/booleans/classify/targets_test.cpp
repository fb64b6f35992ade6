#include "booleans/classify/targets.h"

#include <gtest/gtest.h>

#include "tests/booleans/classify/rational_rays.h"

namespace quoin::booleans::testing {
namespace {

constexpr Box everything{{-exact::world, -exact::world, -exact::world}, {exact::world, exact::world, exact::world}};

std::string text_of(const Targets& targets, std::uint32_t t) {
  bool turned = false;
  exact::Plane p = targets.plane(t, turned);
  p = exact::reduced_plane(p.n, p.d);
  std::string text = "node " + std::to_string(targets.node(t).value) + " on [";
  for (const std::int64_t x : p.n) text += std::to_string(x) + " ";
  text += std::to_string(static_cast<std::int64_t>(p.d)) + "]" + (turned ? " turned:" : ":");
  for (std::size_t k = 0; k < 3; ++k)
    text += " " + std::to_string(targets.box(t).low[k]) + ".." + std::to_string(targets.box(t).high[k]);
  return text;
}

// A tip on a box: of the untouched faces those near a point of the bottom, whose outward normal is not the canonical
// one; after them the facets.
TEST(Targets, AreUntouchedFacesOfARegionAndFacets) {
  const std::vector<Body> bodies{box({-4, -4, -4}, {4, 4, 0}),
                                 *tetrahedron({{{0, 0, 0}, {2, 0, 2}, {0, 2, 2}, {-2, -2, 2}}})};
  const Arrangement a = arranged(bodies);
  const Targets targets(a, {{0, 0, -9}, {0, 0, -4}});
  std::vector<std::string> text;
  for (std::uint32_t t = 0; t < targets.size(); ++t) text.push_back(text_of(targets, t));
  EXPECT_EQ(text, (std::vector<std::string>{
                      "node 4 on [0 0 1 4] turned: -4..4 -4..4 -4..-4",
                      "node 4 on [0 0 1 4] turned: -4..4 -4..4 -4..-4",
                      "node 0 on [0 0 1 0]: -4..4 -4..4 0..0",
                      "node 1 on [1 1 -1 0]: 0..2 0..2 0..2",
                      "node 2 on [1 -2 -1 0]: -2..2 -2..0 0..2",
                      "node 3 on [2 -1 1 0]: -2..0 -2..2 0..2",
                  }));
}

/// The target on a plane y = constant that looks towards +y.
std::uint32_t target_on(const Targets& targets, std::int64_t y) {
  for (std::uint32_t t = 0; t < targets.size(); ++t) {
    bool turned = false;
    if (targets.plane(t, turned) == exact::Plane{{0, 1, 0}, -exact::int128(y)} && !turned) return t;
  }
  return none;
}

// A plate with a hole from above: rays that begin straight above its corners and edges are shifted as their direction
// says, then back in z, then forth in x.
TEST(Targets, PlateWithAHole) {
  const std::vector<Body> bodies{minus(box({0, 0, 0}, {6, 1, 6}), box({2, -1, 2}, {4, 2, 4}))};
  for (const std::uint32_t large : {0u, 48u}) {
    const WithThresholds thresholds(grid::testing::with(&grid::Thresholds::large_face, large));
    const Arrangement a = arranged(bodies);
    Targets targets(a, everything);
    const std::uint32_t top = target_on(targets, 1);
    ASSERT_NE(top, none);
    targets.prepare(std::array{top});
    const auto crossed = [&](const Vector& v, const Vector& d) {
      bool turned = false;
      const exact::GridPoint p{{std::int32_t(v[0]), std::int32_t(v[1]), std::int32_t(v[2])}};
      const Direction direction{exact::Int<127>(d[0]), exact::Int<127>(d[1]), exact::Int<127>(d[2])};
      return targets.crossed(top, targets.plane(top, turned), {exact::point(p), direction});
    };
    EXPECT_TRUE(crossed({1, 5, 1}, {0, 0, 1}));
    EXPECT_FALSE(crossed({3, 5, 3}, {0, 0, 1}));
    EXPECT_FALSE(crossed({7, 5, 3}, {0, 0, 1}));
    EXPECT_FALSE(crossed({2, 5, 2}, {0, 0, 1}));
    EXPECT_TRUE(crossed({2, 5, 2}, {0, 0, -1}));
    EXPECT_TRUE(crossed({2, 5, 2}, {1, 0, 0}));
    EXPECT_TRUE(crossed({4, 5, 3}, {0, 0, 1}));
    EXPECT_FALSE(crossed({3, 5, 4}, {1, 0, 0}));
    EXPECT_TRUE(crossed({0, 5, 3}, {0, 0, 1}));
    EXPECT_FALSE(crossed({6, 5, 3}, {0, 0, 1}));
    EXPECT_TRUE(crossed({0, 5, 6}, {1, 0, 0}));
    EXPECT_FALSE(crossed({0, 5, 6}, {1, 0, 1}));
    EXPECT_FALSE(crossed({0, 5, 0}, {1, 2, 0}));
    EXPECT_TRUE(crossed({0, 5, 0}, {1, 2, 1}));
  }
}

/// A vertex of the arrangement; the way to another one of grid points, or any.
RayStart any_start(const Arrangement& a, Random& random) {
  const auto vertex = [&] {
    const Body& body = a.operands[OperandId(static_cast<std::uint32_t>(random.below(a.operands.bodies.size())))];
    if (a.names.vertices.size() > 0 && random.one_in(2))
      return a.names.vertices.point(static_cast<std::uint32_t>(random.below(a.names.vertices.size())));
    return exact::point(body.grid_points[random.below(body.grid_points.size())]);
  };
  const exact::Point v = vertex(), w = vertex();
  Vector d = random.vector(-2, 2);
  if (exact::is_grid(v) && exact::is_grid(w) && !random.one_in(4))
    d = vector(exact::grid_point(w)) - vector(exact::grid_point(v));
  if (d[0] < 0) d = -1 * d;
  if (d[0] == 0) d = {0, 0, random.one_in(2) ? 1 : -1};
  return {v, {exact::Int<127>(d[0]), exact::Int<127>(d[1]), exact::Int<127>(d[2])}};
}

// Rays from vertices of the arrangement, along its edges or not, against rationals; through trees and edge by edge.
TEST(Targets, AreCrossedWhereRationalsSay) {
  std::size_t crossed = 0, missed = 0;
  for_families(0x7A26, 8, [&](Solids& solids, Random& random) {
    const Body b = solids.next();
    const std::vector<Body> bodies{odd(solids.next(), b), random.one_in(2) ? b : solids.next()};
    const WithThresholds thresholds(
        grid::testing::with(&grid::Thresholds::large_face, random.one_in(2) ? 0u : 1u << 30));
    const Arrangement a = arranged(bodies);
    if (std::any_of(bodies.begin(), bodies.end(), [](const Body& body) { return body.grid_points.empty(); })) return;

    Targets targets(a, everything);
    const auto polygons = polygons_of(a);
    ASSERT_EQ(targets.size(), polygons.size());
    std::vector<std::uint32_t> all;
    for (std::uint32_t t = 0; t < targets.size(); ++t) all.push_back(t);
    targets.prepare(all);
    for (int i = 0; i < 5; ++i) {
      const RayStart s = any_start(a, random);
      const auto place = shifted(s);
      for (const std::uint32_t t : all) {
        ASSERT_EQ(targets.node(t), polygons[t].node);
        bool turned = false;
        const exact::Plane plane = targets.plane(t, turned);
        ASSERT_TRUE(exact::is_canonical(plane));
        for (const auto& [p, q] : polygons[t].edges) ASSERT_EQ(exact::side(plane, p), 0);
        if (plane.n[1] == 0) continue;
        const bool expected = is_in(place, polygons[t].edges);
        ASSERT_EQ(targets.crossed(t, plane, s), expected);
        ++(expected ? crossed : missed);
      }
    }
  });
  EXPECT_GT(crossed, 100u);
  EXPECT_GT(missed, 100u);
}

}  // namespace
}  // namespace quoin::booleans::testing
