// What is written, read as exact numbers, bounds a solid: judged by exact_mesh.h, which shares no code with the export.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "quoin/quoin.h"
#include "tests/api/exact_mesh.h"
#include "tests/api/solids.h"
#include "tests/booleans/support.h"

namespace quoin {
namespace {

using api_test::box;
using api_test::Corner;
using api_test::grid_of;
using api_test::tetrahedron;
using booleans::testing::case_count;
using booleans::testing::case_name;
using booleans::testing::Random;

double small(Random& random) { return static_cast<double>(random.between(-4, 4)); }

/// A mesh whose points are moved by some steps of the grid.
Solid shaken(Mesh mesh, double step, const Grid& grid, Random& random) {
  for (double& x : mesh.points) x += small(random) * step;
  ImportOptions options;
  options.grid = grid;
  return Solid::from_triangles(mesh.points, mesh.triangles, options).value();
}

/// Two boxes that nearly coincide, one crossed by needles, a thin plate cut by a tetrahedron, spikes of one apex.
Solid hostile(Random& random, std::string& name) {
  static const std::array<const char*, 3> steps{"1/1024", "1/1000", "1/3"};
  static const std::array<double, 3> sizes{1. / 1024, 1. / 1000, 1. / 3};
  const auto which = random.below(3);
  const Grid grid = grid_of(steps[which]);
  const double step = sizes[which];
  const double far = random.one_in(3) ? static_cast<double>(random.between(-400000, 400000)) * step * 4 : 0;
  const auto at = [&](double x) { return far + x * step; };
  const auto any_corner = [&](std::int64_t size) {
    return Corner{at(static_cast<double>(random.between(-size, size))),
                  at(static_cast<double>(random.between(-size, size))),
                  at(static_cast<double>(random.between(-size, size)))};
  };
  const auto one = [&]() -> Solid {
    for (;;) {
      Mesh mesh = api_test::box_mesh({at(-1000), at(-900), at(-1100)}, {at(1000), at(1100), at(1050)});
      switch (random.below(4)) {
        case 0:
          return shaken(mesh, step, grid, random);
        case 1: {  // a plate
          mesh = api_test::box_mesh({at(-5000), at(-4000), at(-3)}, {at(5000), at(4000), at(3)});
          for (double& x : mesh.points) x += static_cast<double>(random.between(-1, 1)) * step;
          return Solid::from_triangles(mesh.points, mesh.triangles, grid).value();
        }
        case 2: {  // a needle
          const Corner a = any_corner(20000);
          const auto near = [&](const Corner& c) {
            return Corner{c[0] + small(random) * step, c[1] + small(random) * step, c[2] + small(random) * step};
          };
          const std::array<Corner, 4> c{a, near(a), near(a), any_corner(20000)};
          ImportOptions options;
          options.grid = grid;
          std::vector<double> points;
          for (const auto& p : c) points.insert(points.end(), p.begin(), p.end());
          for (const bool turned : {false, true}) {
            const std::vector<std::uint32_t> t = turned
                                                     ? std::vector<std::uint32_t>{0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0}
                                                     : std::vector<std::uint32_t>{0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
            const auto solid = Solid::from_triangles(points, t, options);
            if (solid && !solid.value().is_empty()) return solid.value();
          }
          break;
        }
        default: {
          std::array<Corner, 4> c;
          for (Corner& p : c) p = any_corner(3000);
          std::vector<double> points;
          for (const auto& p : c) points.insert(points.end(), p.begin(), p.end());
          const auto solid =
              Solid::from_triangles(points, std::vector<std::uint32_t>{0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3}, grid);
          if (solid && !solid.value().is_empty()) return solid.value();
        }
      }
    }
  };
  Solid solid = one();
  name = std::string("step ") + steps[which] + " far " + std::to_string(far);
  for (std::uint64_t n = 1 + random.below(3); n > 0; --n) {
    const Solid other = one();
    switch (random.below(4)) {
      case 0:
        solid = solid + other;
        break;
      case 1:
        solid = solid - other;
        break;
      case 2:
        solid = solid ^ other;
        break;
      default:
        solid = solid.is_empty() ? other : solid & other;
    }
  }
  return solid;
}

TEST(ValidExport, HostileSolidsAreWrittenValid) {
  std::uint64_t spoiled = 0, written = 0;
  const std::uint64_t cases = case_count(60);
  for (std::uint64_t number = 0; number < cases; ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0xA11D, number);
    std::string name;
    const Solid solid = hostile(random, name);
    SCOPED_TRACE(name);
    const Mesh exact = solid.to_triangles({.topology = Topology::indexed, .validity = Validity::fast}).value();
    for (const bool float32 : {false, true})
      for (const Topology topology : {Topology::manifold, Topology::indexed}) {
        ExportOptions options{.topology = topology, .float32 = float32};
        ExportReport report;
        const Mesh mesh = solid.to_triangles(options, &report).value();
        options.validity = Validity::fast;
        ExportReport fast_report;
        const Mesh fast = solid.to_triangles(options, &fast_report).value();
        ++written;
        ASSERT_EQ(exact_mesh::fault(mesh), "") << "float32 " << float32;
        ASSERT_TRUE(report.valid);
        ASSERT_TRUE(report.closed);
        ASSERT_EQ(report.flipped + report.collapsed, 0u);
        for (const double x : mesh.points) ASSERT_TRUE(!float32 || static_cast<double>(static_cast<float>(x)) == x);

        // What is valid as it is rounded stays as it is, to the byte; what is not is mended.
        const bool same = mesh.points == fast.points && mesh.triangles == fast.triangles;
        const bool was_spoiled =
            fast_report.flipped + fast_report.collapsed > 0 || (!same && !exact_mesh::fault(fast).empty());
        ASSERT_EQ(was_spoiled, report.mending_rounds > 0 || report.shared_edges > 0);
        ASSERT_TRUE(same || was_spoiled);
        ASSERT_TRUE(was_spoiled || report.max_round == fast_report.max_round);
        spoiled += was_spoiled;
        // The doubles of the exact mesh are off by far less than the slack.
        const double slack = 1e-9 * (report.max_round + 1e-6 * std::fabs(exact.points.empty() ? 0 : exact.points[0]));
        ASSERT_LE(exact_mesh::farthest(mesh, exact), report.max_round + slack + 1e-12);
      }
  }
  std::cout << written << " written, " << spoiled << " mended\n";
  EXPECT_TRUE(cases < 60 || spoiled > 0);
}

TEST(ValidExport, ExactPointsDoNotMove) {
  ExportReport report;
  const Solid solid = box({0, 0, 0}, {3, 2, 1}) - box({1, 1, 0}, {2, 3, 1});
  for (const bool float32 : {false, true}) {
    ASSERT_TRUE(solid.to_triangles({.float32 = float32}, &report));
    EXPECT_EQ(report.max_round, 0);
    EXPECT_TRUE(report.valid);
    EXPECT_EQ(report.mending_rounds, 0u);
  }
  // A third is not a double: at most half a unit in its last place away, in each direction.
  ASSERT_TRUE(box({0, 0, 0}, {1, 1, 1}, grid_of("1/3")).to_triangles({}, &report));
  EXPECT_GT(report.max_round, 0);
  EXPECT_LT(report.max_round, 0x1p-52);
}

TEST(ValidExport, RecentredIsTheSameSolidElsewhere) {
  const Solid solid =
      box({1000001, -70000, 3}, {1000005, -69999, 4}) - box({1000002, -70000, 3}, {1000003, -69999, 3.5});
  const Mesh there = solid.to_triangles().value();
  ExportReport report;
  Mesh here = solid.to_triangles({.recentre = true}, &report).value();
  EXPECT_EQ(report.recentred, (std::array<double, 3>{1000004, -70000, 4}));
  for (std::size_t i = 0; i < here.points.size(); ++i) here.points[i] += report.recentred[i % 3];
  EXPECT_EQ(here.points, there.points);
  EXPECT_EQ(here.triangles, there.triangles);
}

}  // namespace
}  // namespace quoin
