#include "grid/import.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "grid/balance.h"
#include "grid/seal.h"
#include "tests/grid/random.h"

namespace quoin::grid {
namespace {

using exact::GridPoint;
using exact::Integer;
using exact::Rational;
using Triangle = std::array<std::uint32_t, 3>;

struct Polygons {
  Array<double> points;
  Array<std::uint32_t> starts = {0}, corners;
  void add(std::initializer_list<std::uint32_t> face) {
    corners.insert(corners.end(), face);
    starts.push_back(static_cast<std::uint32_t>(corners.size()));
  }
  Result<ImportedMesh> import(const Lattice& l = {}) const { return import_polygons(points, starts, corners, l); }
};

/// Corner i has the coordinates x = bit 0, y = bit 1, z = bit 2 of i.
Polygons cube(double size = 1) {
  Polygons c;
  for (int i = 0; i < 8; ++i)
    for (int k = 0; k < 3; ++k) c.points.push_back((i >> k & 1) * size);
  c.add({0, 2, 3, 1});
  c.add({4, 5, 7, 6});
  c.add({0, 1, 5, 4});
  c.add({2, 6, 7, 3});
  c.add({0, 4, 6, 2});
  c.add({1, 3, 7, 5});
  return c;
}

Array<std::uint32_t> cube_triangles() {
  Array<std::uint32_t> t;
  const Polygons c = cube();
  for (std::size_t i = 0; i < c.corners.size(); i += 4)
    for (std::size_t j : {0U, 1U, 2U, 0U, 2U, 3U}) t.push_back(c.corners[i + j]);
  return t;
}

Integer six_volumes(const ImportedMesh& m) {
  Integer sum = 0;
  for (const Triangle& t : m.triangles) {
    std::array<std::array<Integer, 3>, 3> v;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k) v[i][k] = m.points[t[i]].c[k];
    for (std::size_t k = 0; k < 3; ++k)
      sum += v[0][k] * (v[1][(k + 1) % 3] * v[2][(k + 2) % 3] - v[1][(k + 2) % 3] * v[2][(k + 1) % 3]);
  }
  return sum;
}

/// The second way: all directed edges in a map.
std::map<std::pair<std::uint32_t, std::uint32_t>, std::int64_t> edge_map(std::span<const Triangle> triangles) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::int64_t> sum;
  for (const Triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      sum[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
    }
  std::erase_if(sum, [](const auto& e) { return e.second == 0; });
  return sum;
}

/// What every imported mesh promises.
void expect_sound(const ImportedMesh& m) {
  EXPECT_TRUE(edge_map(m.triangles).empty());
  for (const Triangle& t : m.triangles) EXPECT_FALSE(collinear(m.points[t[0]], m.points[t[1]], m.points[t[2]]));
  Array<GridPoint> sorted = m.points;
  std::sort(sorted.begin(), sorted.end());
  EXPECT_EQ(std::adjacent_find(sorted.begin(), sorted.end()), sorted.end());
  EXPECT_GE(six_volumes(m), 0);
}

TEST(Import, cube) {
  const auto m = cube().import();
  ASSERT_TRUE(m.has_value()) << m.error().message;
  expect_sound(m.value());
  EXPECT_EQ(m.value().points.size(), 8U);
  EXPECT_EQ(m.value().triangles.size(), 12U);
  EXPECT_EQ(six_volumes(m.value()), 6);
  EXPECT_EQ(m.value().max_snap, 0);
  EXPECT_EQ(m.value().merged_points + m.value().zero_area_triangles + m.value().nonplanar_polygons, 0U);
  const auto t = import_triangles(cube().points, cube_triangles(), Lattice{});
  EXPECT_EQ(t.value().triangles, m.value().triangles);
}

// Many stretches, with triangles in some of them that are nothing. The second way: the mesh without them.
TEST(Import, long_meshes_with_triangles_that_are_nothing) {
  auto random = seeded_generator();
  const auto n = static_cast<std::uint32_t>(130 + random() % 20);  // a grid of n x n quads, folded onto a torus
  Array<double> points;
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < n; ++j) {
      const double a = 2 * M_PI * i / n, b = 2 * M_PI * j / n, r = 3 + std::cos(b);
      points.insert(points.end(), {r * std::cos(a), r * std::sin(a), std::sin(b)});
    }
  Array<std::uint32_t> clean, mixed;
  std::uint64_t nothing = 0;
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < n; ++j) {
      const auto id = [&](std::uint32_t k, std::uint32_t l) { return k % n * n + l % n; };
      const std::uint32_t p = id(i, j), q = id(i + 1, j), r = id(i + 1, j + 1), s = id(i, j + 1);
      for (auto* list : {&clean, &mixed}) list->insert(list->end(), {p, q, r, p, r, s});
      if (random() % 3 != 0 || i < n / 2) continue;
      mixed.insert(mixed.end(), {p, p, static_cast<std::uint32_t>(random() % (n * n))});
      ++nothing;
    }
  const Lattice fine{Rational(1, 1 << 20), {}};
  const auto expected = import_triangles(points, clean, fine), found = import_triangles(points, mixed, fine);
  ASSERT_TRUE(expected.has_value() && found.has_value());
  EXPECT_GT(expected.value().triangles.size(), std::size_t{1} << 15);
  EXPECT_EQ(found.value().triangles, expected.value().triangles);
  EXPECT_EQ(found.value().points, expected.value().points);
  EXPECT_EQ(found.value().max_snap, expected.value().max_snap);
  EXPECT_GT(nothing, 1000U);
  EXPECT_EQ(found.value().zero_area_triangles, nothing);
  std::swap(clean[3 * (clean.size() / 6)], clean[3 * (clean.size() / 6) + 1]);  // one triangle turned over
  EXPECT_EQ(import_triangles(points, clean, fine).error().code, ErrorCode::open_boundary);
}

TEST(Import, nothing_is_a_mesh) {
  EXPECT_TRUE(import_triangles({}, {}, Lattice{}).value().triangles.empty());
  EXPECT_TRUE(import_polygons({}, {}, {}, Lattice{}).value().triangles.empty());
  EXPECT_TRUE(Polygons{}.import().value().triangles.empty());
}

TEST(Import, decimal_steps_and_origins) {
  const Lattice l{Rational(1, 1000), {Rational(1, 2), Rational(-1, 3), 100}};
  const auto m = cube(0.1).import({Rational(1, 1000), {0, 0, 0}});
  EXPECT_EQ(six_volumes(m.value()), 6000000);
  EXPECT_GT(m.value().max_snap, 0);
  EXPECT_LT(m.value().max_snap, 1e-9);
  EXPECT_EQ(six_volumes(cube(16).import(l).value()), Integer(6) * 16000 * 16000 * 16000);
}

TEST(Import, far_away) {
  Polygons c = cube(1.0 / 1024);
  for (double& p : c.points) p += 0x1p20;
  const Lattice l =
      fitting_lattice({0x1p20, 0x1p20, 0x1p20}, {0x1p20 + 0x1p-10, 0x1p20 + 0x1p-10, 0x1p20 + 0x1p-10}).value();
  EXPECT_NE(l.origin, Lattice{}.origin);
  const auto m = c.import(l);
  expect_sound(m.value());
  EXPECT_EQ(m.value().max_snap, 0);
  EXPECT_EQ(Rational(six_volumes(m.value())) * l.step * l.step * l.step, Rational(6, 1 << 30));
}

TEST(Import, the_whole_world) {
  Polygons c = cube(2.0 * exact::world);
  for (double& p : c.points) p -= exact::world;
  const auto m = c.import();
  expect_sound(m.value());
  EXPECT_EQ(six_volumes(m.value()), Integer(6) << 90);
  for (double& p : c.points) p += 1;
  EXPECT_EQ(c.import().error().code, ErrorCode::out_of_range);
}

TEST(Import, soup_like_stl) {
  Array<double> points;
  Array<std::uint32_t> triangles;
  for (std::uint32_t v : cube_triangles()) {
    for (std::size_t k = 0; k < 3; ++k) points.push_back(cube().points[3 * v + k]);
    triangles.push_back(static_cast<std::uint32_t>(triangles.size()));
  }
  const auto m = import_triangles(points, triangles, Lattice{});
  expect_sound(m.value());
  EXPECT_EQ(m.value().points.size(), 8U);
  EXPECT_EQ(m.value().merged_points, 0U);
  points[0] += 1e-9;
  const auto near = import_triangles(points, triangles, Lattice{});
  EXPECT_EQ(near.value().points, m.value().points);
  EXPECT_EQ(near.value().triangles, m.value().triangles);
  EXPECT_EQ(near.value().merged_points, 1U);
}

TEST(Import, an_open_cube_is_located) {
  Polygons c = cube();
  c.starts.pop_back();
  c.corners.resize(c.starts.back());
  const auto m = c.import();
  ASSERT_FALSE(m.has_value());
  EXPECT_EQ(m.error().code, ErrorCode::open_boundary);
  EXPECT_NE(m.error().message.find("4 edges"), std::string::npos);
  EXPECT_EQ(m.error().where, "face 0, edge (1, 1, 0) - (1, 0, 0)");
}

TEST(Import, one_face_turned_over_is_open) {
  Polygons c = cube();
  std::reverse(c.corners.begin() + 20, c.corners.end());
  EXPECT_EQ(c.import().error().code, ErrorCode::open_boundary);
  EXPECT_NE(c.import().error().message.find("8 edges"), std::string::npos);
}

TEST(Import, inside_out) {
  Polygons c = cube();
  std::reverse(c.corners.begin(), c.corners.end());
  EXPECT_EQ(c.import().error().code, ErrorCode::inside_out);
}

TEST(Import, a_flat_pair_of_faces_is_the_empty_set) {
  Polygons c;
  c.points = {0, 0, 0, 4, 0, 0, 0, 4, 0};
  c.add({0, 1, 2});
  c.add({2, 1, 0});
  EXPECT_EQ(c.import().value().triangles.size(), 2U);
}

TEST(Import, faces_without_area_are_no_faces) {
  Polygons c;
  c.points = {0, 0, 0, 4, 8, 12, 1, 2, 3, 0, 0, 0};
  c.add({0, 1, 2});
  c.add({2, 1, 0});
  c.add({0, 1});
  c.add({});
  c.add({0, 3, 0, 2, 1, 2});
  const Error error = c.import().error();
  EXPECT_EQ(error.code, ErrorCode::no_faces);
  EXPECT_NE(error.message.find("none of the 5 faces has an area"), std::string::npos) << error.message;
  EXPECT_EQ(error.where, "face 0");

  // One face with an area is a surface, if an open one; what is rounded may have none.
  const Array<std::uint32_t> one{0, 1, 2}, pair{0, 1, 2, 2, 1, 0};
  EXPECT_EQ(import_triangles(c.points, pair, Lattice{}).error().code, ErrorCode::no_faces);
  EXPECT_TRUE(import_triangles(c.points, pair, Lattice{}, Facing::any).value().triangles.empty());
  c.points[3 * 2] = 1.25;
  EXPECT_EQ(import_triangles(c.points, pair, Lattice{}).value().zero_area_triangles, 2U);
  EXPECT_EQ(import_triangles(c.points, one, Lattice{}).error().code, ErrorCode::open_boundary);

  // Snapping makes an area where there was none.
  c.points = {0, 0, 0, 0.625, 1, 0, 1.25, 2, 0};
  EXPECT_EQ(import_triangles(c.points, pair, Lattice{}).error().code, ErrorCode::no_faces);
}

TEST(Import, bad_indices) {
  const Array<double> p(9);
  const Array<std::uint32_t> t{0, 1, 3}, two{0, 1}, good{0, 1, 2}, down{0, 3, 2}, beyond{0, 4};
  EXPECT_EQ(import_triangles(p, t, Lattice{}).error().code, ErrorCode::bad_index);
  EXPECT_EQ(import_triangles(p, t, Lattice{}).error().where, "face 0");
  EXPECT_EQ(import_triangles(p, two, Lattice{}).error().code, ErrorCode::bad_index);
  EXPECT_EQ(import_triangles(Array<double>(8), good, Lattice{}).error().code, ErrorCode::bad_index);
  EXPECT_EQ(import_polygons(p, down, good, Lattice{}).error().code, ErrorCode::bad_index);
  EXPECT_EQ(import_polygons(p, beyond, good, Lattice{}).error().code, ErrorCode::bad_index);
  EXPECT_EQ(import_polygons(p, {}, t, Lattice{}).error().code, ErrorCode::bad_index);
}

TEST(Import, degenerate_polygons_vanish) {
  Polygons c = cube();
  c.add({0, 0, 0, 0});
  c.add({0, 1});
  c.add({3});
  c.add({});
  c.add({5, 7, 5, 7});
  c.corners[0] = 0;
  const auto m = c.import();
  ASSERT_TRUE(m.has_value());
  expect_sound(m.value());
  EXPECT_EQ(m.value().triangles.size(), 12U);
}

TEST(Import, repeated_corners_are_dropped) {
  Polygons c = cube();
  c.corners = {0, 2, 2, 3, 1, 0};
  c.starts = {0, 6};
  for (const auto& f : {std::array{4U, 5U, 7U, 6U}, std::array{0U, 1U, 5U, 4U}, std::array{2U, 6U, 7U, 3U},
                        std::array{0U, 4U, 6U, 2U}, std::array{1U, 3U, 7U, 5U}})
    c.add({f[0], f[1], f[2], f[3]});
  const auto m = c.import();
  expect_sound(m.value());
  EXPECT_EQ(m.value().triangles.size(), 12U);
  EXPECT_EQ(m.value().zero_area_triangles, 0U);
}

TEST(Import, nonplanar_polygons_are_counted) {
  Polygons c = cube(4);
  c.points[3 * 7] = c.points[3 * 7 + 1] = 5;  // the corner (4, 4, 4) moves: two of its three faces bend
  const auto m = c.import();
  expect_sound(m.value());
  EXPECT_EQ(m.value().nonplanar_polygons, 2U);
}

/// A prism over the L with collinear corners, and its holes in the long edges filled by matching side faces.
TEST(Import, l_prism_keeps_collinear_corners) {
  const Array<std::array<double, 2>> l{{0, 0}, {2, 0}, {4, 0}, {4, 2}, {3, 2}, {2, 2}, {2, 3}, {2, 4}, {0, 4}, {0, 2}};
  const auto n = static_cast<std::uint32_t>(l.size());
  Polygons c;
  for (double z : {0.0, 3.0})
    for (const auto& p : l) c.points.insert(c.points.end(), {p[0], p[1], z});
  for (std::uint32_t i = n; i-- > 0;) c.corners.push_back(i);
  c.starts.push_back(static_cast<std::uint32_t>(c.corners.size()));
  for (std::uint32_t i = 0; i < n; ++i) c.corners.push_back(n + i);
  c.starts.push_back(static_cast<std::uint32_t>(c.corners.size()));
  for (std::uint32_t i = 0; i < n; ++i) c.add({i, (i + 1) % n, n + (i + 1) % n, n + i});
  const auto m = c.import();
  ASSERT_TRUE(m.has_value()) << m.error().message;
  expect_sound(m.value());
  EXPECT_EQ(six_volumes(m.value()), 6 * 12 * 3);
  EXPECT_EQ(m.value().zero_area_triangles, 0U);
  EXPECT_EQ(m.value().triangles.size(), 2 * (10 - 2) + 20U);
}

/// A cube whose top edge (6, 7) carries the middle point 8 on one side only, closed by a sliver.
TEST(Import, slivers_seal_t_junctions) {
  Polygons c = cube(4);
  c.points.insert(c.points.end(), {2, 4, 4});
  c.corners.erase(c.corners.begin() + 12, c.corners.begin() + 16);
  c.starts = {0, 4, 8, 12, 16, 20};
  c.add({2, 6, 8, 7, 3});
  c.add({6, 7, 8});
  const auto m = c.import();
  ASSERT_TRUE(m.has_value()) << m.error().message;
  expect_sound(m.value());
  EXPECT_EQ(m.value().zero_area_triangles, 1U);
  EXPECT_EQ(six_volumes(m.value()), 6 * 64);
  EXPECT_EQ(m.value().triangles.size(), 2 * 5 + 3 + 1U);
}

TEST(Import, a_sliver_that_collapses_by_snapping) {
  Polygons c = cube(4);
  c.points.insert(c.points.end(), {2, 3.75, 4.25});
  c.starts = {0, 4, 8, 12, 16, 20};
  c.corners.erase(c.corners.begin() + 12, c.corners.begin() + 16);
  c.add({2, 6, 8, 7, 3});
  c.add({6, 7, 8});
  const auto m = c.import();
  expect_sound(m.value());
  EXPECT_EQ(m.value().zero_area_triangles, 1U);
  EXPECT_GE(m.value().max_snap, std::sqrt(0.125));
  EXPECT_LT(m.value().max_snap, 0.36);
}

TEST(Import, stacked_slivers) {
  // Points on the edge (6, 7) that the face behind knows, fanned by slivers in several orders.
  auto random = seeded_generator();
  for (int round = 0; round < 300; ++round) {
    Polygons c = cube(64);
    c.corners.erase(c.corners.begin() + 12, c.corners.begin() + 16);
    c.starts = {0, 4, 8, 12, 16, 20};
    Array<std::uint32_t> chain{6};
    const auto count = static_cast<std::uint32_t>(1 + random() % 12);
    for (std::uint32_t i = 0; i < count; ++i) {
      // Sometimes out of order, so that slivers fold back.
      const double x = round % 2 == 0 ? 4.0 * (i + 1) : static_cast<double>(1 + random() % 63);
      c.points.insert(c.points.end(), {x, 64, 64});
      chain.push_back(8 + i);
    }
    chain.push_back(7);
    c.corners.insert(c.corners.end(), {2});
    c.corners.insert(c.corners.end(), chain.begin(), chain.end());
    c.corners.push_back(3);
    c.starts.push_back(static_cast<std::uint32_t>(c.corners.size()));
    // A random triangulation of the collapsed polygon between the chain and the edge.
    while (chain.size() > 2) {
      const std::size_t i = 1 + random() % (chain.size() - 2);
      c.add({chain[i + 1], chain[i], chain[i - 1]});
      chain.erase(chain.begin() + static_cast<std::ptrdiff_t>(i));
    }
    const auto m = c.import();
    ASSERT_TRUE(m.has_value()) << m.error().message;
    expect_sound(m.value());
    EXPECT_EQ(six_volumes(m.value()), Integer(6) * 64 * 64 * 64);
    const auto again = c.import();
    EXPECT_EQ(again.value().triangles, m.value().triangles);
  }
}

TEST(Import, a_sliver_without_neighbour_is_open) {
  Polygons c = cube(4);
  c.points.insert(c.points.end(), {1, 1, 1, 2, 2, 2, 3, 3, 3});
  c.add({8, 9, 10});
  const auto m = c.import();
  ASSERT_FALSE(m.has_value());
  EXPECT_EQ(m.error().code, ErrorCode::open_boundary);
  EXPECT_EQ(m.error().where, "face 6, edge (1, 1, 1) - (2, 2, 2)");
}

TEST(Import, opposite_slivers_cancel) {
  Polygons c = cube(4);
  c.points.insert(c.points.end(), {1, 1, 1, 2, 2, 2, 3, 3, 3});
  c.add({8, 9, 10});
  c.add({10, 9, 8});
  const auto m = c.import();
  expect_sound(m.value());
  EXPECT_EQ(m.value().triangles.size(), 12U);
  EXPECT_EQ(m.value().zero_area_triangles, 2U);
}

TEST(Import, coarse_grids_collapse_meshes_and_leave_them_closed) {
  auto random = seeded_generator();
  for (int round = 0; round < 60; ++round) {
    // A torus of quads with jitter on grids so coarse that most faces collapse.
    const auto n = static_cast<std::uint32_t>(6 + random() % 20);
    Polygons c;
    for (std::uint32_t i = 0; i < n; ++i)
      for (std::uint32_t j = 0; j < n; ++j) {
        const double a = 2 * M_PI * i / n, b = 2 * M_PI * j / n;
        const double r = 3 + std::cos(b) + static_cast<double>(random() % 100) / 1000;
        c.points.insert(c.points.end(), {r * std::cos(a), r * std::sin(a), std::sin(b)});
      }
    const auto id = [&](std::uint32_t i, std::uint32_t j) { return i % n * n + j % n; };
    for (std::uint32_t i = 0; i < n; ++i)
      for (std::uint32_t j = 0; j < n; ++j) {
        const std::uint32_t p = id(i, j), q = id(i + 1, j), r = id(i + 1, j + 1), s = id(i, j + 1);
        if (random() % 2 == 0) {
          c.add({p, q, r, s});
        } else {
          c.add({p, q, r});
          c.add({p, r, s});
        }
      }
    const Lattice l{Rational(1, static_cast<std::int64_t>(1 + random() % 12)), {0, Rational(1, 3), 0}};
    const auto m = c.import(l);
    if (!m) {
      EXPECT_EQ(m.error().code, ErrorCode::inside_out);
      continue;
    }
    expect_sound(m.value());
    EXPECT_LT(m.value().max_snap, exact::to_double(l.step));
  }
}

TEST(Balance, agrees_with_a_map) {
  auto random = seeded_generator();
  for (int round = 0; round < 2000; ++round) {
    const auto n = static_cast<std::uint32_t>(3 + random() % 8);
    Array<Triangle> triangles;
    const auto corner = [&] { return static_cast<std::uint32_t>(random() % n); };
    for (std::size_t i = random() % 12; i > 0; --i) {
      const std::uint32_t a = corner(), b = corner(), c = corner(), d = corner();
      if (a == b || b == c || c == a) continue;
      triangles.push_back({a, b, c});
      if (random() % 4 == 0) continue;
      if (d == a || d == b || d == c) {
        triangles.push_back({c, b, a});
      } else {
        triangles.push_back({a, d, b});
        triangles.push_back({b, d, c});
        triangles.push_back({c, d, a});
      }
    }
    std::shuffle(triangles.begin(), triangles.end(), random);
    const auto expected = edge_map(triangles);
    EXPECT_EQ(is_balanced(corners_of(triangles), n), expected.empty());
    Array<OpenEdge> edges;
    for (const auto& [e, sum] : expected) {
      if (sum > 0)
        edges.push_back({e.first, e.second, static_cast<std::uint64_t>(sum)});
      else
        edges.push_back({e.second, e.first, static_cast<std::uint64_t>(-sum)});
    }
    EXPECT_EQ(open_edges(triangles), edges);
  }
}

}  // namespace
}  // namespace quoin::grid
