#include <gtest/gtest.h>

#include <map>

#include "grid/repair/cures.h"
#include "tests/api/doors/damaged_meshes.h"
#include "tests/grid/random.h"

namespace quoin::grid {
namespace {

using exact::GridPoint;

/// 64 steps a unit.
Surface surface_of(const Mesh& mesh) {
  Surface surface;
  std::map<GridPoint, std::uint32_t> known;
  Array<std::uint32_t> id;
  for (std::size_t i = 0; i < mesh.points.size(); i += 3) {
    GridPoint p{};
    for (std::size_t k = 0; k < 3; ++k) p.c[k] = static_cast<std::int32_t>(mesh.points[i + k] * 64);
    const auto [entry, is_new] = known.try_emplace(p, static_cast<std::uint32_t>(surface.points.size()));
    if (is_new) surface.points.push_back(p);
    id.push_back(entry->second);
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3)
    surface.triangles.push_back({id[mesh.triangles[t]], id[mesh.triangles[t + 1]], id[mesh.triangles[t + 2]]});
  surface.sort();
  return surface;
}

// Torn at random, and welded with tolerances up to several edges.
TEST(WeldBoundary, TheEndsOfAnEdgeStayTwo) {
  auto random = seeded_generator();
  std::uint64_t welded = 0, short_edges = 0;
  for (int round = 0; round < 60; ++round) {
    Mesh mesh = damaged::bumpy_block(3, random);
    for (const std::size_t t : damaged::some_of(damaged::size_of(mesh), 12, 6, random))
      damaged::tear_off(mesh, t, {static_cast<double>(random() % 32) / 64, static_cast<double>(random() % 8) / 64, 0});
    const Surface before = surface_of(mesh);
    Surface after = before;
    const auto tolerance = static_cast<std::int64_t>(random() % 256);
    welded += weld_boundary(after, Reach(tolerance)).count;

    ASSERT_EQ(before.triangles.size(), after.triangles.size());
    for (std::size_t t = 0; t < before.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        const GridPoint &from = before.points[before.triangles[t][k]], &to = after.points[after.triangles[t][k]],
                        &next = before.points[before.triangles[t][(k + 1) % 3]];
        EXPECT_NE(after.triangles[t][k], after.triangles[t][(k + 1) % 3]) << round;
        EXPECT_LE(squared_distance(from, to), tolerance * tolerance) << round;
        short_edges += squared_distance(from, next) <= tolerance * tolerance;
      }
  }
  EXPECT_GT(welded, 1000u);
  EXPECT_GT(short_edges, 1000u);
}

}  // namespace
}  // namespace quoin::grid
