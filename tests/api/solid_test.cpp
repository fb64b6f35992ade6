#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <span>
#include <sstream>
#include <string>

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
  EXPECT_EQ(split(a, {{"0", "0", "0", "1"}}).error().code, ErrorCode::bad_plane);
  EXPECT_EQ(split(a, {{"x", "0", "0", "1"}}).error().code, ErrorCode::bad_plane);
  EXPECT_EQ(split(a, {{"1e30", "1", "0", "1"}}, {.grid_rule = GridRule::exact}).error().code, ErrorCode::bad_plane);
  EXPECT_EQ(split(~a, {{"1", "0", "0", "-1"}}).error().code, ErrorCode::unbounded);
}

/// The code of the exception; "" where there is none.
template <class Work>
std::string thrown(Work&& work) {
  try {
    (void)work();
    return "";
  } catch (const Exception& exception) {
    return to_string(exception.error().code);
  }
}

TEST(Solid, OperatorsFindACommonGrid) {
  const Solid a = box({0, 0, 0}, {1, 1, 1}), b = box({0, 0, 0}, {1, 1, 1}, grid_of("1/2"));
  EXPECT_TRUE(a + b == a);
  EXPECT_TRUE((a - b).is_empty());
  EXPECT_TRUE((a & b) == b);
  EXPECT_TRUE((b ^ a).is_empty());
  EXPECT_EQ((a + b).grid().step(), "1/2");
  // Of one step, but between each other.
  const Solid c = box({.5, 0, 0}, {1.5, 1, 1}, Grid::with_step_and_origin("1", {"1/2", "0", "0"}).value());
  EXPECT_EQ(volume(a + c), "3/2");
  EXPECT_EQ((a + c).to_quoin(), (c + a).to_quoin());
  EXPECT_TRUE(a == b);
  EXPECT_FALSE(a == box({0, 0, 0}, {1, 1, 1.5}, grid_of("1/2")));
  const Solid both = unite({a, b}).value();
  EXPECT_EQ(both.grid().step(), "1/2");
  EXPECT_TRUE(both == a);
}

/// Two tetrahedra that cross, as one mesh whose import is told that it does not cross itself.
Solid crossing_tetrahedra_trusted() {
  const std::vector<double> points{-2, -3, 0,  -3, 3, 3,  3,  2, -1, -3, 3,  -4,  //
                                   2,  2,  -4, 3,  0, -1, -3, 1, -4, -4, -4, 4};
  const std::vector<std::uint32_t> triangles{0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3, 4, 5, 6, 4, 7, 5, 5, 7, 6, 6, 7, 4};
  return Solid::from_triangles(points, triangles, {.grid = Grid(), .trust = Trust::embedded}).value();
}

TEST(Solid, OperatorsThrowWhatNamedFunctionsReturn) {
  const Solid a = crossing_tetrahedra_trusted(), b = box({-1, -1, -1}, {3, 3, 3});
  // It has no value: no operator may make one up.
  ASSERT_EQ(difference(a, {b}).error().code, ErrorCode::inconsistent);
  EXPECT_EQ(thrown([&] { return a - b; }), "inconsistent");
  // The place is a corner of a face whose sides contradict each other.
  const std::string where = difference(a, {b}).error().where;
  std::set<std::string> corners;
  for (const Solid& solid : {a, b}) {
    const Mesh mesh = solid.to_triangles().value();
    for (std::size_t i = 0; i < mesh.points.size(); i += 3) {
      std::ostringstream text;
      text << '(' << mesh.points[i] << ", " << mesh.points[i + 1] << ", " << mesh.points[i + 2] << ") grid steps";
      corners.insert(text.str());
    }
  }
  EXPECT_EQ(corners.count(where), 1U) << where;

  const auto agree = [](const Result<Solid>& named, auto&& work) {
    EXPECT_EQ(thrown(work), named ? "" : to_string(named.error().code));
    if (named) {
      EXPECT_EQ(work().to_quoin(), named->to_quoin());
    }
  };
  agree(unite({a, b}), [&] { return a + b; });
  agree(intersect({a, b}), [&] { return a & b; });
  agree(symmetric_difference({a, b}), [&] { return a ^ b; });
  agree(difference(b, {a}), [&] { return b - a; });
}

TEST(Solid, FloatsAndSignedIndicesAreTheSameMesh) {
  const Mesh mesh = box_mesh({0, 0, 0}, {1, 2, 3});
  const std::vector<float> floats(mesh.points.begin(), mesh.points.end());
  const std::vector<std::int32_t> indices(mesh.triangles.begin(), mesh.triangles.end());
  const std::string text = box({0, 0, 0}, {1, 2, 3}).to_quoin();
  EXPECT_EQ(Solid::from_triangles(floats, mesh.triangles, Grid()).value().to_quoin(), text);
  EXPECT_EQ(Solid::from_triangles(mesh.points, indices, Grid()).value().to_quoin(), text);
  EXPECT_EQ(Solid::from_triangles(std::span(floats), std::span(indices), Grid()).value().to_quoin(), text);

  const std::vector<std::int32_t> starts{0, 4, 8, 12, 16, 20, 24};
  const std::vector<std::int32_t> corners{0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
  EXPECT_EQ(Solid::from_polygons(floats, starts, corners, {.grid = Grid()}).value().to_quoin(), text);
}

TEST(Solid, FloatsAreTakenExactly) {
  // 0.1f is 13421773 / 2^27.
  const std::array<float, 12> floats{0, 0, 0, 0.1f, 0, 0, 0, 1, 0, 0, 0, 1};
  const std::array<std::int32_t, 12> triangles{0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
  ImportReport report;
  const auto solid = Solid::from_triangles(floats, triangles, {.grid = grid_of("1/134217728")}, &report);
  ASSERT_TRUE(solid) << solid.error().message;
  EXPECT_EQ(volume(*solid), "13421773/805306368");
  EXPECT_EQ(report.max_snap, 0);
}

TEST(Solid, NegativeIndicesNameNothing) {
  const Mesh mesh = box_mesh({0, 0, 0}, {1, 1, 1});
  std::vector<std::int32_t> triangles(mesh.triangles.begin(), mesh.triangles.end());
  triangles[7] = -1;
  const Error error = Solid::from_triangles(mesh.points, triangles).error();
  EXPECT_EQ(error.code, ErrorCode::bad_index);
  EXPECT_EQ(error.where, "corner 7");
  const std::vector<std::int32_t> starts{0, -3, 3}, corners{0, 1, 2};
  EXPECT_EQ(Solid::from_polygons(mesh.points, starts, corners).error().where, "start 1");
  const std::vector<std::int32_t> whole{0, 3}, negative{0, 1, -2147483647 - 1};
  EXPECT_EQ(Solid::from_polygons(mesh.points, whole, negative).error().where, "corner 2");
}

TEST(Solid, BoxCountsAndAreaAreThoseOfInfo) {
  auto random = random_engine();
  const Grid third = Grid::with_step_and_origin("1/3", {"1/7", "-5", "1e6"}).value();
  for (int round = 0; round < 20; ++round) {
    const Solid a = random_tetrahedron(random, 9, third), b = random_tetrahedron(random, 9, third);
    for (const Solid& solid : {a, a + b, a - b, a & b, a ^ b, ~a}) {
      const Info info = solid.info();
      EXPECT_EQ(solid.counts(), (Counts{info.vertices, info.edges, info.faces}));
      EXPECT_EQ(solid.area(), info.area_approx);
      EXPECT_EQ(solid.box(), info.box);
      if (!info.box) continue;
      // The second way: all corners that are written.
      const Mesh mesh = (solid.is_bounded() ? solid : ~solid).to_triangles().value();
      Box box{{{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}}};
      for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        box[0][i % 3] = std::min(box[0][i % 3], mesh.points[i]);
        box[1][i % 3] = std::max(box[1][i % 3], mesh.points[i]);
      }
      EXPECT_EQ(*info.box, box);
    }
  }
  EXPECT_EQ(Solid().counts(), Counts{});
  EXPECT_FALSE(Solid().box());
  EXPECT_EQ(Solid::full(Grid()).area(), 0);
}

TEST(Solid, BoxOfAMeshPassesOverUnusedPoints) {
  Mesh mesh = box_mesh({0, 0, 0}, {1, 2, 3});
  mesh.points.insert(mesh.points.end(), {-9, 9, 9});
  const Solid solid = Solid::from_triangles(mesh.points, mesh.triangles, Grid()).value();
  EXPECT_EQ(solid.box(), (Box{{{0, 0, 0}, {1, 2, 3}}}));
  EXPECT_EQ(solid.area(), 22);
}

TEST(Solid, ComplementByNameAndByOperator) {
  const Solid a = box({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(complement(a).to_quoin(), (~a).to_quoin());
  EXPECT_EQ(evaluate(Expression::complement(a)).value().to_quoin(), (~a).to_quoin());
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
  EXPECT_EQ(Solid::from_triangles(mesh.points, open).error().code, ErrorCode::open_boundary);
  auto turned = mesh.triangles;
  for (std::size_t t = 0; t < turned.size(); t += 3) std::swap(turned[t], turned[t + 1]);
  EXPECT_EQ(Solid::from_triangles(mesh.points, turned).error().code, ErrorCode::inside_out);
  auto infinite = mesh.points;
  infinite[4] = HUGE_VAL;
  EXPECT_EQ(Solid::from_triangles(infinite, mesh.triangles).error().code, ErrorCode::non_finite);
  auto wrong = mesh.triangles;
  wrong[5] = 8;
  EXPECT_EQ(Solid::from_triangles(mesh.points, wrong).error().code, ErrorCode::bad_index);
  EXPECT_EQ(Solid::from_triangles(mesh.points, mesh.triangles, grid_of("1e-12")).error().code, ErrorCode::out_of_range);
  const Cancel cancel = true;
  ImportOptions options;
  options.run.cancel = &cancel;
  EXPECT_EQ(Solid::from_triangles(mesh.points, mesh.triangles, options).error().code, ErrorCode::cancelled);
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
  const Info rounded = a.info({}, nullptr, Volume::rounded);
  EXPECT_EQ(rounded.volume, "");
  EXPECT_EQ(rounded.volume_approx, .027);
  EXPECT_EQ(a.info({}, nullptr, Volume::exact_if_short).volume, "27/1000");
  EXPECT_EQ(info.triangles, 12u);
  EXPECT_TRUE(info.manifold);
  ASSERT_TRUE(info.box);
  EXPECT_EQ((*info.box)[0], (std::array<double, 3>{.1, .2, .3}));
  EXPECT_EQ((*info.box)[1], (std::array<double, 3>{.4, .5, .6}));
}

// Cubes turned by angles of their own: each adds some hundred bits to the denominator.
TEST(Solid, InfoOfALongVolume) {
  std::vector<Solid> cubes;
  for (int i = 0; i < 360; ++i) {
    const Motion turn = Motion::rotation({"1", "2", "3"}, std::to_string(i + 1) + ".7").value();
    const Motion shift = Motion::translation({std::to_string(4 * i), "0", "0"}).value();
    cubes.push_back(moved(box({0, 0, 0}, {1, 1, 1}, grid_of("1/65536")), turn.then(shift)).value());
  }
  const auto exact_if_short = [](const Solid& s) { return s.info({}, nullptr, Volume::exact_if_short); };
  const Solid all = unite(cubes).value();
  const Info info = exact_if_short(all), exact = all.info();
  EXPECT_EQ(info.volume, "");
  EXPECT_GT(exact.volume.size(), 20000u);
  EXPECT_EQ(info.volume_approx, exact.volume_approx);
  EXPECT_EQ(exact_if_short(cubes[0]).volume, cubes[0].info().volume);
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
  EXPECT_EQ(unite({a, b}, options).error().code, ErrorCode::cancelled);
  EXPECT_EQ(a.to_triangles({.run = options}).error().code, ErrorCode::cancelled);
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
