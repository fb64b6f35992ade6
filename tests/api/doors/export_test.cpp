// What an export writes, and what `info` says of it.
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <optional>
#include <vector>

#include "api/access.h"
#include "examples/models.h"
#include "grid/lists/partition.h"
#include "quoin/quoin.h"
#include "tests/booleans/lattice_sets.h"
#include "tests/booleans/support.h"

namespace quoin {
namespace {

using booleans::testing::case_count;
using booleans::testing::case_name;
using booleans::testing::Random;

/// The full tetrahedra of a set as one soup.
Solid solid_of(const booleans::testing::LatticeSet& set) {
  std::vector<double> points;
  std::vector<std::uint32_t> triangles;
  for (const booleans::Body& t : booleans::testing::solids(set, 1)) {
    const auto base = static_cast<std::uint32_t>(points.size() / 3);
    for (const auto& p : t.grid_points)
      for (int k = 0; k < 3; ++k) points.push_back(p[k]);
    for (const auto& c : t.triangles)
      for (const std::uint32_t v : c) triangles.push_back(base + v);
  }
  return Solid::from_triangles(points, triangles, Grid()).value();
}

/// Components and genera of an index mesh by V - E + F; nothing unless every edge has two triangles.
struct MeshTopology {
  std::uint64_t shells = 0;
  std::int64_t genus = 0;
};
std::optional<MeshTopology> topology_of(const Mesh& mesh) {
  const std::size_t vertices = mesh.points.size() / 3;
  std::map<std::array<std::uint32_t, 2>, std::array<int, 2>> edges;  // uses in either direction
  grid::Partition parts(vertices);
  for (std::size_t c = 0; c < mesh.triangles.size(); ++c) {
    const std::uint32_t u = mesh.triangles[c], v = mesh.triangles[c % 3 == 2 ? c - 2 : c + 1];
    ++edges[{std::min(u, v), std::max(u, v)}][u < v ? 0 : 1];
    parts.unite(u, v);
  }
  for (const auto& [edge, uses] : edges)
    if (uses != std::array{1, 1}) return std::nullopt;

  MeshTopology r;
  for (std::uint32_t v = 0; v < vertices; ++v) r.shells += parts.find(v) == v;
  const auto characteristic = static_cast<std::int64_t>(vertices) - static_cast<std::int64_t>(edges.size()) +
                              static_cast<std::int64_t>(mesh.triangles.size() / 3);
  r.genus = static_cast<std::int64_t>(r.shells) - characteristic / 2;
  return r;
}

/// What `info` counts of the surface.
SurfaceCounts surface_of(const Info& info) { return {info.triangles, info.shells, info.genus, info.manifold}; }

/// What an export of that topology counts.
SurfaceCounts counted(const Solid& solid, Topology topology) {
  SurfaceCounts counts;
  EXPECT_TRUE(solid.to_triangles({.topology = topology}, nullptr, &counts));
  return counts;
}

TEST(Export, InfoCountsTheMeshThatIsWritten) {
  const std::uint64_t cases = case_count(400);
  for (std::uint64_t number = 0; number < cases; ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0xE49, number);
    const auto set = booleans::testing::lattice_set([&](std::uint64_t n) { return random.below(n); });
    if (booleans::testing::boundary(set, 1).triangles.empty()) continue;
    const Solid solid = solid_of(set), read_back = Solid::from_quoin(solid.to_quoin()).value();
    for (const Solid& s : {solid, read_back}) {
      ExportReport report;
      const Mesh mesh = s.to_triangles({}, &report).value();
      const auto written = topology_of(mesh);
      ASSERT_TRUE(written.has_value());
      const Info info = s.info();
      ASSERT_EQ(info.shells, written->shells);
      ASSERT_EQ(info.genus, written->genus);
      ASSERT_EQ(info.triangles, mesh.triangles.size() / 3);
      ASSERT_EQ(info.triangles, report.triangles);

      const std::size_t indexed = s.to_triangles({Topology::indexed}, &report).value().points.size();
      ASSERT_EQ(report.split_edges, 0u);
      ASSERT_EQ(info.manifold, indexed == mesh.points.size());
      for (const Topology topology : {Topology::manifold, Topology::indexed})
        ASSERT_EQ(counted(s, topology), surface_of(info));
    }
    // All vertices are grid points: what is written is the solid.
    const Mesh mesh = solid.to_triangles().value();
    ASSERT_TRUE(Solid::from_triangles(mesh.points, mesh.triangles, Grid()).value() == solid);
    // Counts are of the point set, however it is stored.
    ASSERT_EQ(solid.info().shells, read_back.info().shells);
    ASSERT_EQ(solid.info().genus, read_back.info().genus);
  }
}

// A ball whose surface a bite changed in one place: such a result shares the lists of its operand.
TEST(Export, InfoTakesWhatTheExportCounted) {
  const Mesh ball = examples::icosphere({0, 0, 0}, 1, 4), bite = examples::box({0.9, -0.05, -0.05}, {1.1, 0.05, 0.05});
  const Grid grid = Grid::with_step("1/100000").value();
  const Solid bitten = Solid::from_triangles(ball.points, ball.triangles, grid).value() -
                       Solid::from_triangles(bite.points, bite.triangles, grid).value();
  ASSERT_FALSE(Access::operand(bitten).is_packed);

  const Info info = bitten.info();
  for (const Topology topology : {Topology::manifold, Topology::indexed}) {
    const SurfaceCounts counts = counted(bitten, topology);
    EXPECT_EQ(counts, surface_of(info));
    const Info again = bitten.info({}, &counts);
    EXPECT_EQ(surface_of(again), counts);
    EXPECT_EQ(again.faces, info.faces);
    EXPECT_EQ(again.volume, info.volume);
  }
  // It is taken, not found out again: nothing else would count 77 handles.
  const SurfaceCounts other{.triangles = 5, .shells = 6, .genus = 77, .manifold = false};
  EXPECT_EQ(surface_of(bitten.info({}, &other)), other);
  // What is refused counts nothing.
  SurfaceCounts none = other;
  EXPECT_FALSE((~bitten).to_triangles({}, nullptr, &none));
  EXPECT_EQ(none, SurfaceCounts{});
}

TEST(Export, SplitEdgesAreReportedAndKeepTheSolid) {
  const auto cube = [](std::int64_t x, std::int64_t y, std::int64_t z) {
    return booleans::testing::box({x, y, z}, {x + 1, y + 1, z + 1});
  };
  std::vector<double> points;
  std::vector<std::uint32_t> triangles;
  for (const auto& body : {cube(0, 0, 0), cube(0, 1, 0), cube(1, 0, 0), cube(0, 1, 1), cube(1, 0, 1), cube(0, 0, 2),
                           cube(0, 1, 2), cube(1, 0, 2)}) {
    const auto base = static_cast<std::uint32_t>(points.size() / 3);
    for (const auto& p : body.grid_points)
      for (int k = 0; k < 3; ++k) points.push_back(p[k]);
    for (const auto& c : body.triangles)
      for (const std::uint32_t v : c) triangles.push_back(base + v);
  }
  const Solid solid = Solid::from_triangles(points, triangles).value();
  ExportReport report;
  const Mesh mesh = solid.to_triangles({}, &report).value();
  EXPECT_EQ(report.split_edges, 1u);
  EXPECT_EQ(report.flipped + report.collapsed, 0u);
  EXPECT_TRUE(report.closed);
  EXPECT_EQ(solid.info().genus, 1);
  EXPECT_EQ(topology_of(mesh)->genus, 1);
  EXPECT_TRUE(Solid::from_triangles(mesh.points, mesh.triangles).value() == solid);
}

}  // namespace
}  // namespace quoin
