#include "examples/models.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace quoin::examples {
namespace {

std::uint64_t seed() {
  const char* text = std::getenv("QUOIN_SEED");
  const std::uint64_t value = text != nullptr ? std::strtoull(text, nullptr, 10) : 1;
  std::cout << "QUOIN_SEED=" << value << '\n';
  return value;
}

std::size_t triangle_count(const Mesh& mesh) { return mesh.triangles.size() / 3; }

double volume(const Mesh& mesh) {
  const auto at = [&](std::size_t corner, std::size_t axis) { return mesh.points[3 * mesh.triangles[corner] + axis]; };
  double sum = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      sum += at(t, i) * (at(t + 1, j) * at(t + 2, k) - at(t + 1, k) * at(t + 2, j));
    }
  }
  return sum / 6;
}

// Every directed edge occurs once and its reverse once; every point is used.
void expect_closed_manifold(const Mesh& mesh, const std::string& name) {
  ASSERT_EQ(mesh.points.size() % 3, 0u) << name;
  ASSERT_EQ(mesh.triangles.size() % 3, 0u) << name;
  ASSERT_FALSE(mesh.triangles.empty()) << name;
  std::vector<bool> used(mesh.points.size() / 3);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges, reversed;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = mesh.triangles[t + i], b = mesh.triangles[t + (i + 1) % 3];
      ASSERT_LT(a, used.size()) << name;
      ASSERT_NE(a, b) << name;
      used[a] = true;
      edges.emplace_back(a, b);
      reversed.emplace_back(b, a);
    }
  }
  std::sort(edges.begin(), edges.end());
  std::sort(reversed.begin(), reversed.end());
  EXPECT_EQ(std::adjacent_find(edges.begin(), edges.end()), edges.end()) << name;
  EXPECT_TRUE(edges == reversed) << name;
  EXPECT_EQ(std::count(used.begin(), used.end(), false), 0) << name;
  EXPECT_GT(volume(mesh), 0) << name;
}

// Vertices - edges + faces: 2 for a sphere, 0 for a torus.
std::int64_t euler_characteristic(const Mesh& mesh) {
  const auto faces = static_cast<std::int64_t>(triangle_count(mesh));
  return static_cast<std::int64_t>(mesh.points.size() / 3) - faces / 2;
}

TEST(Models, BoxIsExact) {
  const Mesh mesh = box({-1, -2, -3}, {1, 2, 3});
  expect_closed_manifold(mesh, "box");
  EXPECT_EQ(triangle_count(mesh), 12u);
  EXPECT_EQ(volume(mesh), 48);
}

TEST(Models, SphereMeetsItsTarget) {
  for (const std::size_t target : {8u, 20u, 100u, 1000u, 12345u, 400000u}) {
    const Mesh mesh = sphere({1, 2, 3}, 2, target);
    expect_closed_manifold(mesh, "sphere");
    EXPECT_EQ(euler_characteristic(mesh), 2);
    const auto difference = static_cast<std::int64_t>(triangle_count(mesh)) - static_cast<std::int64_t>(target);
    EXPECT_LE(difference * difference, static_cast<std::int64_t>(target)) << target;
  }
}

TEST(Models, IcosphereTriangleCounts) {
  std::size_t expected = 20;
  for (unsigned level = 0; level <= 5; ++level, expected *= 4) {
    const Mesh mesh = icosphere({0, 0, 0}, 1, level);
    expect_closed_manifold(mesh, "icosphere");
    EXPECT_EQ(triangle_count(mesh), expected);
    EXPECT_EQ(euler_characteristic(mesh), 2);
  }
  expect_closed_manifold(geodesic_sphere({0, 0, 0}, 1, 7), "geodesic");
}

TEST(Models, BumpySpheresDependOnTheirSeedAlone) {
  const std::uint64_t s = seed();
  const Mesh a = bumpy_sphere({0, 0, 0}, 1, 20000, s);
  const Mesh b = bumpy_sphere({0, 0, 0}, 1, 20000, s + 1);
  expect_closed_manifold(a, "bumpy");
  EXPECT_EQ(a.points, bumpy_sphere({0, 0, 0}, 1, 20000, s).points);
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_NE(a.points, b.points);
  // The edges along which one lies inside at one end and outside at the other: the two surfaces cross there.
  const auto deeper = [&](std::uint32_t v) {
    double difference = 0;
    for (std::size_t i = 3 * std::size_t{v}; i < 3 * std::size_t{v} + 3; ++i) {
      difference += a.points[i] * a.points[i] - b.points[i] * b.points[i];
    }
    return difference < 0;
  };
  std::size_t crossings = 0;
  for (std::size_t i = 0; i < a.triangles.size(); ++i) {
    const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
    if (deeper(a.triangles[i]) != deeper(a.triangles[next])) ++crossings;
  }
  EXPECT_GT(crossings, 2000u);
}

TEST(Models, RoundSolids) {
  const Mesh ring = torus({1, 0, 0}, 2, 0.5, 40, 12);
  expect_closed_manifold(ring, "torus");
  EXPECT_EQ(triangle_count(ring), 2u * 40 * 12);
  EXPECT_EQ(euler_characteristic(ring), 0);

  const Mesh bend = torus_cut({1, 0, 0}, 2, 0.5, 1.5, 10, 12);
  expect_closed_manifold(bend, "torus_cut");
  EXPECT_EQ(triangle_count(bend), 2u * 10 * 12 + 2 * 12);
  EXPECT_EQ(euler_characteristic(bend), 2);

  for (const Knot& winding : {Knot{}, Knot{3, 8, 1, 0.5, 0.05}, Knot{1, 5, 2, 0.4, 0.1}}) {
    const Mesh knot = torus_knot({0, 0, 1}, winding, 500, 9);
    expect_closed_manifold(knot, "torus_knot");
    EXPECT_EQ(euler_characteristic(knot), 0);
  }
  const std::vector<Point> ends{{0, 0, 5}, {0, 0, -5}, {5, 0, 0}, {1, 2, 3}, {-3, 0.1, 0}};
  for (const Point& end : ends) {
    const Mesh prism = cylinder({0, 0, 0}, end, 0.5, 7);
    expect_closed_manifold(prism, "cylinder");
    EXPECT_EQ(triangle_count(prism), 28u);
  }
}

TEST(Models, GearAndStrip) {
  const Mesh wheel = gear({});
  expect_closed_manifold(wheel, "gear");
  EXPECT_EQ(triangle_count(wheel), 4u * 24 * 16);
  EXPECT_EQ(euler_characteristic(wheel), 2);
  for (const std::size_t n : {8u, 100u, 40000u}) {
    const Mesh strip = diagonal_strip(n, 10);
    expect_closed_manifold(strip, "diagonal_strip");
    EXPECT_EQ(triangle_count(strip), n + n + 4);
    EXPECT_EQ(euler_characteristic(strip), 2);
  }
}

TEST(Models, NeedlesAndSpheresAreSets) {
  const std::uint64_t s = seed();
  const std::vector<Mesh> bundle = needles(20, {1, 1, 1}, 10, 0.05, 4, s);
  ASSERT_EQ(bundle.size(), 20u);
  for (const Mesh& needle : bundle) expect_closed_manifold(needle, "needle");
  EXPECT_EQ(bundle[7].points, needles(8, {1, 1, 1}, 10, 0.05, 4, s)[7].points);
  for (const Mesh& ball : sphere_cloud(10, 100, s)) expect_closed_manifold(ball, "sphere_cloud");
  for (const Mesh& drill : drills(3, 2, 12)) expect_closed_manifold(drill, "drill");
}

TEST(Models, MengerSponge) {
  std::size_t cells = 1, holes = 0, holes_of_level = 3;
  for (unsigned level = 0; level <= 3; ++level) {
    const std::vector<Mesh> cubes = menger_cells(level);
    const std::vector<Mesh> prisms = menger_holes(level);
    EXPECT_EQ(cubes.size(), cells);
    EXPECT_EQ(prisms.size(), holes);
    if (level <= 2) {
      for (const Mesh& cube : cubes) EXPECT_EQ(volume(cube), 1);
      for (const Mesh& prism : prisms) expect_closed_manifold(prism, "menger_holes");
    }
    cells *= 20;
    holes += holes_of_level;
    holes_of_level *= 8;
  }
  EXPECT_EQ(cube_grid(4, 1).size(), 64u);
}

TEST(Models, JoinedKeepsEveryPart) {
  const std::vector<Mesh> parts = cube_grid(3, 1.5);
  const Mesh all = joined(parts);
  expect_closed_manifold(all, "joined");
  EXPECT_EQ(triangle_count(all), 27u * 12);
  EXPECT_EQ(volume(all), 27);
}

}  // namespace
}  // namespace quoin::examples
