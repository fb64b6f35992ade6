#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tests/api/solids.h"

namespace quoin::api_test {
namespace {

TEST(Solid, DefaultIsEmptyAndFullIsItsComplement) {
  const Solid empty;
  EXPECT_TRUE(empty.is_empty());
  EXPECT_TRUE(empty.is_bounded());
  EXPECT_EQ(volume(empty), "0");
  EXPECT_EQ(empty.grid().step(), "1");
  const Solid full = Solid::full(Grid());
  EXPECT_TRUE(~empty == full);
  EXPECT_TRUE(~full == empty);
  EXPECT_FALSE(full == empty);
  EXPECT_FALSE(full.is_empty());
  EXPECT_FALSE(full.is_bounded());
  EXPECT_FALSE(full.volume().has_value());
  EXPECT_EQ(full.classify({1e300, -1e-300, 0.1}), Location::inside);
  EXPECT_EQ(empty.classify({1e300, -1e-300, 0.1}), Location::outside);
}

TEST(Solid, MovedFromIsEmpty) {
  Solid a = box({0, 0, 0}, {1, 1, 1});
  const Solid b = std::move(a);
  EXPECT_EQ(volume(b), "1");
  EXPECT_TRUE(a.is_empty());  // NOLINT: what this test is about
  EXPECT_EQ(volume(a + b), "1");
}

TEST(Solid, VolumesOfTwoCubesAreExact) {
  const Grid half = grid_of("1/2");
  const Solid a = box({0, 0, 0}, {1, 1, 1}, half), b = box({.5, .5, .5}, {1.5, 1.5, 1.5}, half);
  EXPECT_EQ(volume(a + b), "15/8");
  EXPECT_EQ(volume(a & b), "1/8");
  EXPECT_EQ(volume(a - b), "7/8");
  EXPECT_EQ(volume(b - a), "7/8");
  EXPECT_EQ(volume(a ^ b), "7/4");
  EXPECT_EQ(volume(unite({a, b}).value()), "15/8");
  EXPECT_EQ(volume(intersect({a, b}).value()), "1/8");
  EXPECT_EQ(volume(difference(a, {b}).value()), "7/8");
  EXPECT_EQ(volume(symmetric_difference({a, b, a}).value()), "1");
}

TEST(Solid, CoplanarFacesJoin) {  // E28
  const Solid a = box({0, 0, 0}, {2, 2, 2}), b = box({0, 0, 2}, {2, 2, 4});
  EXPECT_TRUE((a & b).is_empty());
  const Solid both = a + b;
  const Info info = both.info();
  EXPECT_EQ(info.vertices, 8u);
  EXPECT_EQ(info.edges, 12u);
  EXPECT_EQ(info.faces, 6u);
  EXPECT_EQ(info.shells, 1u);
  EXPECT_EQ(info.volume, "16");
  EXPECT_TRUE(both == box({0, 0, 0}, {2, 2, 4}));
  const Solid inner = box({0, 0, 0}, {1, 1, 2});
  EXPECT_TRUE((a & inner) == inner);
  EXPECT_TRUE((a + inner) == a);
}

TEST(Solid, CubesSharingAnEdge) {  // E30
  const Solid a = box({0, 0, 0}, {1, 1, 1}), b = box({1, 1, 0}, {2, 2, 1});
  const Info info = (a + b).info();
  EXPECT_EQ(info.vertices, 14u);
  EXPECT_EQ(info.edges, 23u);
  EXPECT_EQ(info.faces, 12u);
  EXPECT_EQ(info.shells, 2u);
  EXPECT_EQ(info.genus, 0);
  EXPECT_FALSE(info.manifold);
  const Info outside = (~(a + b)).info();
  EXPECT_EQ(outside.shells, 1u);
  EXPECT_EQ(outside.volume, "");
  EXPECT_FALSE(outside.bounded);
  EXPECT_TRUE((a & b).is_empty());
}

TEST(Solid, CubesSharingAVertex) {  // E30
  const Info info = (box({0, 0, 0}, {1, 1, 1}) + box({1, 1, 1}, {2, 2, 2})).info();
  EXPECT_EQ(info.vertices, 15u);
  EXPECT_EQ(info.edges, 24u);
  EXPECT_EQ(info.faces, 12u);
  EXPECT_EQ(info.shells, 2u);
  EXPECT_EQ(info.genus, 0);
  EXPECT_FALSE(info.manifold);
}

TEST(Solid, PillarInABox) {  // E27
  const Solid a = box({0, 0, 0}, {4, 4, 4}), b = box({1, 1, 3}, {2, 2, 6});
  EXPECT_TRUE((a & b) == box({1, 1, 3}, {2, 2, 4}));
  EXPECT_EQ(volume(a + b), "66");
  EXPECT_EQ((a + b).info().faces, 11u);
}

TEST(Solid, BracketWithAHole) {  // E13, a square hole
  const Solid upright = box({0, 0, 0}, {1, 4, 8}), foot = box({1, 0, 0}, {9, 4, 1}), hole = box({4, 1, 0}, {6, 3, 1});
  const Solid bracket = (upright + foot) - hole;
  const Info info = bracket.info();
  EXPECT_EQ(info.volume, "60");
  EXPECT_EQ(info.genus, 1);
  EXPECT_EQ(info.shells, 1u);
  EXPECT_TRUE(info.manifold);
  EXPECT_EQ(bracket.classify({2, 1, .3}), Location::inside);
  EXPECT_EQ(bracket.classify({1, 1, .5}), Location::inside);  // no internal wall
  EXPECT_EQ(bracket.classify({5, 2, .5}), Location::outside);
  EXPECT_EQ(bracket.classify({4, 2, .5}), Location::boundary);
  EXPECT_EQ(bracket.classify({4, 1, 1}), Location::boundary);
  EXPECT_EQ(bracket.classify({2, 1, 1.0000000000000002}), Location::outside);
  EXPECT_EQ(bracket.classify({2, 1, 0.9999999999999999}), Location::inside);
}

TEST(Solid, ClassifyIsExactOnRationalVertices) {
  const Solid a = tetrahedron({Corner{0, 0, 0}, Corner{1, 0, 0}, Corner{0, 1, 0}, Corner{0, 0, 1}});
  EXPECT_EQ(a.classify({1. / 3, 1. / 3, 1. / 3}), Location::inside);  // 1/3 rounds down
  EXPECT_EQ(a.classify({.25, .25, .5}), Location::boundary);
  EXPECT_EQ(a.classify({.25, .25, .5000000000000001}), Location::outside);
  EXPECT_EQ(a.classify({1, 0, 0}), Location::boundary);
  EXPECT_EQ(a.classify({1e308, 1e308, -1e308}), Location::outside);
}

TEST(Solid, LawsOnRandomTetrahedra) {
  auto random = random_engine();
  for (int round = 0; round < 20; ++round) {
    const Solid a = random_tetrahedron(random, 4), b = random_tetrahedron(random, 4), c = random_tetrahedron(random, 4);
    EXPECT_TRUE(((a - (a & b)) - (a - b)).is_empty());
    EXPECT_TRUE((a - (a - b)) == (a & b));
    EXPECT_TRUE((a - (a - b)) == (b - (b - a)));
    EXPECT_TRUE(~(a + b) == (~a & ~b));
    EXPECT_TRUE((a + (a & b)) == a);
    EXPECT_TRUE((a & (b + c)) == ((a & b) + (a & c)));
    EXPECT_TRUE(((a ^ b) ^ c) == symmetric_difference({c, a, b}).value());
    EXPECT_EQ(((a ^ b) ^ c).to_quoin(), (c ^ (b ^ a)).to_quoin());
    EXPECT_TRUE((a - a).is_empty());
    EXPECT_FALSE(a == ~a);
    EXPECT_TRUE(~~a == a);
  }
}

TEST(Solid, SplitAndUniteIsTheSolid) {
  auto random = random_engine();
  for (int round = 0; round < 20; ++round) {
    const Solid a = random_tetrahedron(random, 5) + random_tetrahedron(random, 5);
    HalfSpace plane;
    for (auto& coefficient : plane.plane) coefficient = std::to_string(static_cast<int>(random() % 9) - 4);
    plane.plane[0] = "3/7";
    const auto parts = split(a, plane);
    ASSERT_TRUE(parts) << parts.error().message;
    const auto& [above, below] = parts.value();
    EXPECT_TRUE((above & below).is_empty());
    EXPECT_EQ((above + below).to_quoin(), a.to_quoin());
  }
}

TEST(Solid, SplitSides) {
  const Solid a = box({0, 0, 0}, {4, 1, 1});
  const auto parts = split(a, {{"1", "0", "0", "-1"}});
  ASSERT_TRUE(parts);
  EXPECT_TRUE(parts.value()[0] == box({1, 0, 0}, {4, 1, 1}));
  EXPECT_TRUE(parts.value()[1] == box({0, 0, 0}, {1, 1, 1}));
  // A plane that misses the solid, and one far outside the world.
  for (const char* d : {"-5", "-1e18"}) {
    const auto whole = split(a, {{"1", "0", "0", d}});
    ASSERT_TRUE(whole) << whole.error().message;
    EXPECT_TRUE(whole.value()[0].is_empty());
    EXPECT_TRUE(whole.value()[1] == a);
  }
  EXPECT_EQ(split(a, {{"0", "0", "0", "1"}}).error().code, "bad-plane");
  EXPECT_EQ(split(a, {{"x", "0", "0", "1"}}).error().code, "bad-plane");
  EXPECT_EQ(split(a, {{"1e30", "1", "0", "1"}}).error().code, "bad-plane");
  EXPECT_EQ(split(~a, {{"1", "0", "0", "-1"}}).error().code, "unbounded");
}

TEST(Solid, OperatorsNeedOneGrid) {
  const Solid a = box({0, 0, 0}, {1, 1, 1}), b = box({0, 0, 0}, {1, 1, 1}, grid_of("1/2"));
  EXPECT_THROW(a + b, std::invalid_argument);
  EXPECT_THROW(a - b, std::invalid_argument);
  EXPECT_THROW(a & b, std::invalid_argument);
  EXPECT_THROW(a ^ b, std::invalid_argument);
  EXPECT_TRUE(a == b);
  EXPECT_FALSE(a == box({0, 0, 0}, {1, 1, 1.5}, grid_of("1/2")));
  const Solid both = unite({a, b}).value();
  EXPECT_EQ(both.grid().step(), "1/2");
  EXPECT_TRUE(both == a);
}

TEST(Solid, ImportReportsAndErrors) {
  const Mesh mesh = box_mesh({0, 0, 0}, {1, 1, 1});
  ImportReport report;
  const auto fitted = Solid::from_triangles(mesh.points, mesh.triangles, ImportOptions{}, &report);
  ASSERT_TRUE(fitted);
  EXPECT_EQ(fitted.value().grid().step(), "1/67108864");
  EXPECT_EQ(report.max_snap, 0);
  EXPECT_EQ(report.resolved_crossings, 0u);

  auto open = mesh.triangles;
  open.resize(open.size() - 3);
  EXPECT_EQ(Solid::from_triangles(mesh.points, open).error().code, "open-boundary");
  auto turned = mesh.triangles;
  for (std::size_t t = 0; t < turned.size(); t += 3) std::swap(turned[t], turned[t + 1]);
  EXPECT_EQ(Solid::from_triangles(mesh.points, turned).error().code, "inside-out");
  auto infinite = mesh.points;
  infinite[4] = HUGE_VAL;
  EXPECT_EQ(Solid::from_triangles(infinite, mesh.triangles).error().code, "non-finite");
  auto wrong = mesh.triangles;
  wrong[5] = 8;
  EXPECT_EQ(Solid::from_triangles(mesh.points, wrong).error().code, "bad-index");
  EXPECT_EQ(Solid::from_triangles(mesh.points, mesh.triangles, grid_of("1e-12")).error().code, "out-of-range");
  const Cancel cancel = true;
  ImportOptions options;
  options.run.cancel = &cancel;
  EXPECT_EQ(Solid::from_triangles(mesh.points, mesh.triangles, options).error().code, "cancelled");
  EXPECT_TRUE(Solid::from_triangles({}, std::span<const std::uint32_t>()).value().is_empty());
}

TEST(Solid, OverlappingPartsOfAMeshAreResolved) {
  Mesh mesh = box_mesh({0, 0, 0}, {2, 2, 2});
  const Mesh other = box_mesh({1, 1, 1}, {3, 3, 3});
  for (const std::uint32_t v : other.triangles) mesh.triangles.push_back(v + 8);
  mesh.points.insert(mesh.points.end(), other.points.begin(), other.points.end());
  ImportReport report;
  ImportOptions options;
  options.grid = Grid();
  const auto solid = Solid::from_triangles(mesh.points, mesh.triangles, options, &report);
  ASSERT_TRUE(solid);
  EXPECT_GT(report.resolved_crossings, 0u);
  EXPECT_TRUE(solid.value() == box({0, 0, 0}, {2, 2, 2}) + box({1, 1, 1}, {3, 3, 3}));
}

TEST(Solid, PolygonsMakeTheSameSolid) {
  const Mesh mesh = box_mesh({0, 0, 0}, {1, 2, 3});
  const std::vector<std::uint32_t> corners{0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
  const std::vector<std::uint32_t> starts{0, 4, 8, 12, 16, 20, 24};
  ImportOptions options;
  options.grid = Grid();
  const auto solid = Solid::from_polygons(mesh.points, starts, corners, options);
  ASSERT_TRUE(solid) << solid.error().message;
  EXPECT_EQ(solid.value().to_quoin(), box({0, 0, 0}, {1, 2, 3}).to_quoin());
}

TEST(Solid, InfoOfEmptyAndFull) {
  const Info empty = Solid().info();
  EXPECT_EQ(empty.vertices + empty.edges + empty.faces + empty.triangles + empty.shells, 0u);
  EXPECT_EQ(empty.volume, "0");
  EXPECT_TRUE(empty.closed && empty.manifold && empty.bounded);
  EXPECT_FALSE(empty.box);
  const Info full = Solid::full(Grid()).info();
  EXPECT_EQ(full.volume, "");
  EXPECT_FALSE(full.bounded || full.box);
}

TEST(Solid, InfoInModelUnits) {
  const Solid a = box({.1, .2, .3}, {.4, .5, .6}, grid_of("1/10"));
  const Info info = a.info();
  EXPECT_EQ(info.volume, "27/1000");
  EXPECT_EQ(info.volume_approx, .027);
  EXPECT_EQ(info.triangles, 12u);
  EXPECT_TRUE(info.manifold);
  ASSERT_TRUE(info.box);
  EXPECT_EQ((*info.box)[0], (std::array<double, 3>{.1, .2, .3}));
  EXPECT_EQ((*info.box)[1], (std::array<double, 3>{.4, .5, .6}));
}

TEST(Solid, ThreadsDoNotChangeBytes) {
  const Solid a = box({0, 0, 0}, {3, 3, 3}),
              b = tetrahedron({Corner{-1, 0, 1}, Corner{5, 1, 0}, Corner{2, 7, 1}, Corner{1, 2, 6}});
  Options one, three;
  one.threads = 1;
  three.threads = 3;
  EXPECT_EQ(unite({a, b}, one).value().to_quoin(), unite({a, b}, three).value().to_quoin());
}

TEST(Solid, CancelAndProgress) {
  const Solid a = box({0, 0, 0}, {2, 2, 2}), b = box({1, 1, 1}, {3, 3, 3});
  const Cancel cancel = true;
  Options options;
  options.cancel = &cancel;
  EXPECT_EQ(unite({a, b}, options).error().code, "cancelled");
  EXPECT_EQ(a.to_triangles({.run = options}).error().code, "cancelled");
  options.cancel = nullptr;
  std::vector<double> fractions;
  options.progress = [&](double f) { fractions.push_back(f); };
  EXPECT_TRUE(a.to_triangles({.run = options}));
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_EQ(fractions.back(), 1);
  std::vector<double> seen;
  Options shown;
  shown.progress = [&](double done) { seen.push_back(done); };
  ASSERT_TRUE(split(a, {{"1", "0", "0", "-1"}}, shown));
  ASSERT_FALSE(seen.empty());
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
  EXPECT_GE(seen.front(), 0);
  EXPECT_EQ(seen.back(), 1);
}

}  // namespace
}  // namespace quoin::api_test
