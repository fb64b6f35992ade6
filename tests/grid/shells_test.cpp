#include "grid/shells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "tests/grid/random.h"

namespace quoin::grid {
namespace {

using exact::GridPoint;
using Triangle = std::array<std::uint32_t, 3>;

/// Cubes one behind the other, equal points shared.
struct Cubes {
  Array<GridPoint> points;
  Array<Triangle> triangles;
  std::map<GridPoint, std::uint32_t> ids;

  /// From (x, y, z) on, `size` wide; turned round when the size is negative.
  void add(const GridPoint& low, std::int32_t size) {
    std::array<std::uint32_t, 8> v{};
    for (std::size_t i = 0; i < 8; ++i) {
      GridPoint p = low;
      for (std::size_t k = 0; k < 3; ++k) p.c[k] += (i >> k & 1) != 0 ? std::abs(size) : 0;
      v[i] = ids.emplace(p, static_cast<std::uint32_t>(points.size())).first->second;
      if (v[i] == points.size()) points.push_back(p);
    }
    constexpr std::array<std::array<std::uint32_t, 4>, 6> faces{
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
    for (const auto& f : faces)
      for (const Triangle& t : {Triangle{f[0], f[1], f[2]}, Triangle{f[0], f[2], f[3]}})
        triangles.push_back(size > 0 ? Triangle{v[t[0]], v[t[1]], v[t[2]]} : Triangle{v[t[0]], v[t[2]], v[t[1]]});
  }
  Shells shells() const { return grid::shells(points, triangles); }
};

TEST(Shells, OfOneCube) {
  Cubes cubes;
  cubes.add({{1, 2, 3}}, 2);
  const Shells s = cubes.shells();
  EXPECT_EQ(s.six_volumes, Array<exact::int128>{48});
  EXPECT_EQ(s.of_triangle, Array<std::uint32_t>(12, 0));
  EXPECT_EQ(lowest_corner(s, 0, cubes.points, cubes.triangles), (GridPoint{{1, 2, 3}}));
  EXPECT_TRUE(shells({}, {}).six_volumes.empty());
}

TEST(Shells, AtTheEndsOfTheWorld) {
  Cubes cubes;
  cubes.add({{-(1 << 29), -(1 << 29), -(1 << 29)}}, -(1 << 30));
  EXPECT_EQ(cubes.shells().six_volumes[0], -6 * (exact::int128(1) << 90));
}

// Cells of a lattice touch in corners, along edges and in faces; the same cell may be there again.
TEST(Shells, BodiesOneBehindTheOtherAreOneEach) {
  auto random = seeded_generator();
  for (int round = 0; round < 300; ++round) {
    Cubes cubes;
    Array<exact::int128> volumes;
    Array<std::uint32_t> owners;
    for (std::uint32_t n = 0; n < 9; ++n) {
      const auto coordinate = [&] { return static_cast<std::int32_t>(random() % 3); };
      const std::int32_t size = random() % 2 == 0 ? 1 : -1;
      cubes.add({{coordinate(), coordinate(), coordinate()}}, size);
      volumes.push_back(6 * size);
      owners.insert(owners.end(), 12, n);
    }
    const Shells s = cubes.shells();
    ASSERT_EQ(s.six_volumes, volumes);
    ASSERT_EQ(s.of_triangle, owners);
  }
}

// In any order of triangles every shell is closed, and together they enclose what the mesh does.
TEST(Shells, AreClosedInAnyOrder) {
  auto random = seeded_generator();
  for (int round = 0; round < 300; ++round) {
    Cubes cubes;
    for (int n = 0; n < 6; ++n) {
      const auto coordinate = [&] { return static_cast<std::int32_t>(random() % 2); };
      cubes.add({{coordinate(), coordinate(), coordinate()}}, random() % 2 == 0 ? 1 : -1);
    }
    std::shuffle(cubes.triangles.begin(), cubes.triangles.end(), random);
    const Shells s = cubes.shells();
    std::map<std::array<std::uint32_t, 3>, int> balance;  // shell, smaller end, larger end
    for (std::size_t t = 0; t < cubes.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = cubes.triangles[t][k], b = cubes.triangles[t][(k + 1) % 3];
        balance[{s.of_triangle[t], std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
      }
    for (const auto& [edge, sum] : balance) ASSERT_EQ(sum, 0);
    for (std::uint32_t shell = 0; shell < s.six_volumes.size(); ++shell)
      ASSERT_NE(std::find(s.of_triangle.begin(), s.of_triangle.end(), shell), s.of_triangle.end());
  }
}

}  // namespace
}  // namespace quoin::grid
