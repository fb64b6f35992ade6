#include "booleans/crowded_shells.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "booleans/body/locate.h"
#include "booleans/resolve.h"
#include "tests/booleans/support.h"
#include "tests/grid/with_thresholds.h"

namespace quoin::booleans::testing {
namespace {

using exact::Rational;
using grid::testing::with;
using grid::testing::WithThresholds;

Body cube(std::int64_t low, std::int64_t high) { return box({low, low, low}, {high, high, high}); }

CrowdedShells shells_of(const Body& mesh) { return crowded_shells(mesh, stars(mesh)); }
Body resolved(const Body& mesh, std::uint64_t& crossings) { return sound(resolve(mesh, crossings)); }
Body resolved(const Body& mesh) {
  std::uint64_t crossings = 0;
  return resolved(mesh, crossings);
}
/// The same in one arrangement of all faces.
Body resolved_at_once(const Body& mesh) {
  const WithThresholds never(with(&grid::Thresholds::group, std::size_t{1} << 30));
  return resolved(mesh);
}

/// Some shells of random orientation in one place, and where points are.
struct Crowd {
  std::vector<Body> plain, parts;
  std::vector<int> orientation;

  Crowd(Random& random, Family family) {
    Solids solids(random, family);
    const std::uint64_t inwards = random.below(3);
    for (std::uint64_t n = 6 + random.below(8); n > 0; --n) add(solids.raw(), inwards > 0 && random.one_in(6) ? -1 : 1);
    if (family == Family::world || random.one_in(2)) return;
    // Something hollow stands beside them.
    add(cube(20, 26), 1);
    add(cube(21, 24), -1);
  }
  void add(const Body& solid, int turn) {
    plain.push_back(solid);
    orientation.push_back(turn);
    parts.push_back(turn > 0 ? solid : inside_out(solid));
  }
  /// The sum of the winding numbers; nothing on the surface of a part.
  std::optional<int> winding(const std::array<Rational, 3>& p) const {
    int sum = 0;
    for (std::size_t i = 0; i < plain.size(); ++i) {
      const int where = locate(plain[i], p);
      if (where == 0) return std::nullopt;
      if (where > 0) sum += orientation[i];
    }
    return sum;
  }
};

TEST(CrowdedShells, MakeThePointsOfPositiveWindingNumber) {
  std::size_t split = 0, with_rest = 0;
  for (const Family family : {Family::tiny, Family::lattice, Family::skew, Family::world})
    for (std::uint64_t i = 0; i < case_count(30); ++i) {
      SCOPED_TRACE(std::string(name_of(family)) + ", " + case_name(i));
      Random random(220 + static_cast<std::uint64_t>(family), i);
      Crowd crowd(random, family);
      const Body mesh = merged(crowd.parts);
      const CrowdedShells shells = shells_of(mesh);
      split += !shells.solids.empty();
      with_rest += !shells.solids.empty() && !shells.rest.triangles.empty();

      const Body r = resolved(mesh);
      ASSERT_TRUE(same(r, resolved_at_once(mesh)));
      if (family == Family::world) continue;
      for (int k = 0; k < 40; ++k) {
        std::array<Rational, 3> p;
        const std::int64_t beside = random.one_in(4) ? 20 : 0;
        for (Rational& x : p) x = beside + Rational(random.between(-12, 12), random.between(1, 5));
        if (const auto winding = crowd.winding(p)) {
          ASSERT_EQ(locate(r, p), *winding > 0 ? 1 : -1);
        }
      }
    }
  if (usual_thresholds()) {
    EXPECT_GT(split, 20u);
    EXPECT_GT(with_rest, 5u);
  }
}

// Solids are taken out where no box of another kind of shell meets theirs.
TEST(CrowdedShells, WhatMeetsAVoidStaysWithIt) {
  if (!usual_thresholds()) GTEST_SKIP();
  const std::size_t n = 20;
  std::vector<Body> parts(n, cube(0, 4));
  const auto counts = [&] {
    const CrowdedShells shells = shells_of(merged(parts));
    return std::array{shells.solids.size(), shells.rest.triangles.size()};
  };
  EXPECT_EQ(counts(), (std::array<std::size_t, 2>{n, 0}));
  parts.push_back(inside_out(cube(10, 11)));
  EXPECT_EQ(counts(), (std::array<std::size_t, 2>{n, 12}));
  parts.push_back(cube(9, 12));
  EXPECT_EQ(counts(), (std::array<std::size_t, 2>{n, 24}));
  EXPECT_TRUE(same(resolved(merged(parts)), any(cube(0, 4), minus(cube(9, 12), cube(10, 11)))));
  // Boxes that touch meet.
  parts.push_back(inside_out(cube(4, 5)));
  EXPECT_EQ(counts(), (std::array<std::size_t, 2>{0, 0}));
  EXPECT_TRUE(same(resolved(merged(parts)), any(cube(0, 4), minus(cube(9, 12), cube(10, 11)))));
}

/// A prism over a polygon that may cross itself: its winding numbers are those of the polygon.
using Polygon = std::vector<std::array<std::int64_t, 2>>;
const Polygon pentagram{{0, 10}, {-6, -8}, {9, 3}, {-9, 3}, {6, -8}};
/// A lobe of 1 and a smaller one of -1.
const Polygon bow_tie{{0, 0}, {8, 1}, {8, 5}, {0, -3}};

// Shells that cross themselves are solids where their winding number is nowhere negative.
TEST(CrowdedShells, ShellsThatCrossThemselves) {
  const Body star = extruded(pentagram, 0, 4), tie = extruded(bow_tie, 1, 3);
  std::vector<Body> parts;
  for (std::int64_t i = 0; i < 20; ++i) parts.push_back(*moved(star, {i % 4, i % 3, i % 2}));
  std::uint64_t crossings = 0;
  EXPECT_TRUE(same(resolved(merged(parts), crossings), resolved_at_once(merged(parts))));
  EXPECT_GT(crossings, 20u);
  EXPECT_TRUE(!usual_thresholds() || shells_of(merged(parts)).solids.size() == 20);

  parts.push_back(*moved(tie, {40, 0, 0}));
  EXPECT_TRUE(same(resolved(merged(parts)), resolved_at_once(merged(parts))));
  EXPECT_TRUE(!usual_thresholds() || shells_of(merged(parts)).solids.size() == 20);
  EXPECT_TRUE(!usual_thresholds() || shells_of(merged(parts)).rest.triangles.size() == tie.triangles.size());
  parts.push_back(tie);
  EXPECT_TRUE(same(resolved(merged(parts)), resolved_at_once(merged(parts))));
  EXPECT_TRUE(shells_of(merged(parts)).solids.empty());
}

TEST(CrowdedShells, FewShellsOrOnesApartAreLeftAsTheyAre) {
  std::vector<Body> parts;
  const std::size_t group = grid::Thresholds{}.group;
  for (std::size_t i = 0; i < group; ++i) parts.push_back(cube(0, 4));
  EXPECT_TRUE(!usual_thresholds() || shells_of(merged(parts)).solids.empty());
  for (std::int64_t i = 1; i < 100; ++i) parts.push_back(cube(5 * i, 5 * i + 4));
  EXPECT_TRUE(!usual_thresholds() || shells_of(merged(parts)).solids.empty());
}

// One solid n times in one mesh: pairs of faces that meet, and so the work, grow as n does.
TEST(CrowdedShells, PairsOfStackedDuplicatesGrowLikeTheirNumber) {
  const Body one = *tetrahedron({{{0, 0, 0}, {7, 1, 0}, {2, 9, 1}, {1, 2, 8}}});
  for (const std::size_t n : {5u, 50u, 500u}) {
    std::uint64_t crossings = 0;
    EXPECT_TRUE(same(resolved(merged(std::vector<Body>(n, one)), crossings), one));
    EXPECT_GT(crossings, 0u);
    EXPECT_TRUE(!usual_thresholds() || crossings < 40 * n) << crossings;
  }
}

// Needles through one point, each face of which meets those of all others: the arrangement of n has n^3 vertices, their
// union about n^2.
TEST(CrowdedShells, NeedlesThroughOnePoint) {
  Random random(230, 0);
  std::vector<Body> needles;
  while (needles.size() < 40) {
    const Vector d = random.vector(-1000, 1000), p = random.vector(-9, 9), q = random.vector(-9, 9);
    const Vector a = p - d, b = q - d, c = Vector{0, 0, 0} - p - q - d;
    if (auto needle = prism(a, b, c, 2 * d)) needles.push_back(std::move(*needle));
  }
  const Expression all = Expression::flat(Rule::any, static_cast<std::uint32_t>(needles.size()));
  EXPECT_TRUE(same(resolved(merged(needles)), evaluated(needles, all)));
}

}  // namespace
}  // namespace quoin::booleans::testing
