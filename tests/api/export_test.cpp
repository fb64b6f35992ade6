// What an export writes, and what `info` says of it.
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <optional>
#include <vector>

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
    }
    // All vertices are grid points: what is written is the solid.
    const Mesh mesh = solid.to_triangles().value();
    ASSERT_TRUE(Solid::from_triangles(mesh.points, mesh.triangles, Grid()).value() == solid);
    // Counts are of the point set, however it is stored.
    ASSERT_EQ(solid.info().shells, read_back.info().shells);
    ASSERT_EQ(solid.info().genus, read_back.info().genus);
  }
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
