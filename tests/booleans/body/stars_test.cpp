#include "booleans/body/stars.h"

#include <gtest/gtest.h>

#include <set>

#include "booleans/pairs/triangle_pair.h"
#include "tests/booleans/support.h"

namespace quoin::booleans::testing {
namespace {

GridTriangle corners(const Body& mesh, std::uint32_t t) {
  const auto& c = mesh.triangles[t];
  return {mesh.grid_points[c[0]], mesh.grid_points[c[1]], mesh.grid_points[c[2]]};
}

/// The second way: every pair of triangles at v.
bool meet_properly(const Body& mesh, std::uint32_t v) {
  std::vector<std::uint32_t> at;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    if (std::find(mesh.triangles[t].begin(), mesh.triangles[t].end(), v) != mesh.triangles[t].end()) at.push_back(t);
  for (std::uint32_t s : at)
    for (std::uint32_t t : at) {
      if (s == t) continue;
      std::set<std::uint32_t> common, other;
      for (std::uint32_t x : mesh.triangles[s])
        (std::count(mesh.triangles[t].begin(), mesh.triangles[t].end(), x) ? common : other).insert(x);
      if (common.size() == 3) return false;
      // A corner of s that t lacks must not lie in t, nor its edges meet t but in common corners.
      const GridTriangle q = corners(mesh, t);
      for (std::uint32_t x : other)
        if (meet(mesh.grid_points[x], mesh.grid_points[x], q)) return false;
      if (common.size() == 1) {
        std::vector<std::uint32_t> far(other.begin(), other.end());
        if (meet(mesh.grid_points[far[0]], mesh.grid_points[far[1]], q)) return false;
      }
      if (common.size() == 2) {  // coplanar on one side of the common edge
        std::uint32_t third = 0;
        for (std::uint32_t x : mesh.triangles[t])
          if (!common.contains(x)) third = x;
        const auto& p = mesh.grid_points;
        const std::uint32_t a = *common.begin(), b = *common.rbegin(), c = *other.begin();
        const auto n = exact::plane_through(p[a], p[b], p[c]), m = exact::plane_through(p[a], p[b], p[third]);
        if (*n == *m) return false;
      }
    }
  return true;
}

bool is_one_fan(const Body& mesh, std::uint32_t v) {
  std::map<std::uint32_t, std::vector<std::uint32_t>> next;
  std::size_t count = 0;
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      if (t[k] == v) next[t[(k + 1) % 3]].push_back(t[(k + 2) % 3]), ++count;
  std::uint32_t w = next.begin()->first;
  const std::uint32_t first = w;
  for (std::size_t i = 0; i < count; ++i) {
    if (next[w].size() != 1) return false;
    w = next[w][0];
    if (w == first) return i + 1 == count;
  }
  return false;
}

TEST(Stars, TheSecondWay) {
  std::array<std::uint64_t, 3> seen{};
  for (std::uint64_t number = 0; number < case_count(400); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0x57A, number);
    Solids solids(random, families[number % families.size()]);
    const std::vector<Body> two{solids.raw(), solids.raw()};
    const Body mesh = random.one_in(2) ? merged(two) : two[0];
    const Array<Star> star_of = stars(mesh);
    for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
      const bool used = std::any_of(mesh.triangles.begin(), mesh.triangles.end(),
                                    [&](const auto& t) { return std::find(t.begin(), t.end(), v) != t.end(); });
      if (!used) continue;
      EXPECT_EQ(star_of[v] != Star::other, is_one_fan(mesh, v)) << "vertex " << v;
      if (star_of[v] == Star::embedded) {
        EXPECT_TRUE(meet_properly(mesh, v)) << "vertex " << v;
      }
      ++seen[static_cast<std::size_t>(star_of[v])];
    }
  }
  std::printf("other %llu, ring %llu, embedded %llu\n", static_cast<unsigned long long>(seen[0]),
              static_cast<unsigned long long>(seen[1]), static_cast<unsigned long long>(seen[2]));
  for (std::uint64_t count : seen) EXPECT_GT(count, 0u);
}

// Results have polygons at many vertices, also with edges that end at derived points: what is said of the triangles
// holds whatever the polygons do.
TEST(Stars, TrianglesAmongPolygons) {
  std::size_t proved = 0;
  for (std::uint64_t number = 0; number < case_count(300); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0x57B, number);
    Solids solids(random, families[number % families.size()]);
    const Body a = solids.raw(), body = packed(random.one_in(2) ? minus(a, solids.raw()) : any(a, solids.raw()));
    const Array<Star> star_of = stars(body);

    std::vector<int> triangles(body.grid_points.size());
    std::vector<std::uint8_t> has_polygon(body.grid_points.size());
    for (const auto& t : body.triangles)
      for (const std::uint32_t v : t) ++triangles[v];
    for (const std::uint32_t v : body.polygons.corners)
      if (body.is_grid(v)) has_polygon[v] = 1;
    for (std::uint32_t v = 0; v < triangles.size(); ++v) {
      if (star_of[v] != Star::embedded || triangles[v] < 2) continue;
      EXPECT_TRUE(meet_properly(body, v)) << "vertex " << v;
      proved += has_polygon[v];
    }
  }
  EXPECT_GT(proved, case_count(300) / 10);
}

// A fan that turns counter-clockwise everywhere but goes round twice, closed by triangles to a point far below.
TEST(Stars, AFanThatWindsTwiceIsNotEmbedded) {
  Body mesh;
  mesh.grid_points = {{{0, 0, 0}}, {{0, 0, -100}}};
  const std::array<std::array<std::int32_t, 2>, 6> around{{{10, 0}, {-5, 9}, {-5, -9}, {11, 1}, {-6, 8}, {-4, -10}}};
  for (const auto& p : around) mesh.grid_points.push_back({{p[0], p[1], -1}});
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::uint32_t a = 2 + i, b = 2 + (i + 1) % 6;
    mesh.triangles.push_back({0, a, b});
    mesh.triangles.push_back({1, b, a});
  }
  const auto star_of = stars(mesh);
  EXPECT_EQ(star_of[0], Star::ring);
  EXPECT_FALSE(meet_properly(mesh, 0));
}

// A corner of a regular tetrahedron, seen along no axis as a fan. One of its three faces is cut into ten triangles:
// they count as much as the other two, each, or the direction to look from would be far off.
TEST(Stars, ItDoesNotMatterIntoHowManyTrianglesAFaceIsCut) {
  Body mesh;
  mesh.grid_points = {{{60, 60, 60}}, {{-60, -60, 60}}};
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) { mesh.triangles.push_back({a, b, c}); };
  constexpr std::uint32_t pieces = 10;
  for (std::uint32_t i = 0; i <= pieces; ++i) {
    const auto at = 120 * static_cast<std::int32_t>(i) / static_cast<std::int32_t>(pieces);
    mesh.grid_points.push_back({{60 - at, at - 60, -60}});
  }
  for (std::uint32_t i = 2; i < 2 + pieces; ++i) {
    add(0, i, i + 1);
    add(1, i + 1, i);
  }
  add(0, 2 + pieces, 1);
  add(0, 1, 2);
  EXPECT_EQ(fault(mesh).value_or(""), "");
  EXPECT_EQ(volume(mesh), 8 * 60 * 60 * 60 / 3);
  EXPECT_TRUE(meet_properly(mesh, 0));
  EXPECT_EQ(stars(mesh)[0], Star::embedded);
}

TEST(Stars, CornersOfBoxesAreProved) {
  const Body cube = box({0, 0, 0}, {8, 8, 8});
  for (const Star s : stars(cube)) EXPECT_EQ(s, Star::embedded);
  for (const Star s :
       stars(box({-exact::world, -exact::world, -exact::world}, {exact::world, exact::world, exact::world})))
    EXPECT_EQ(s, Star::embedded);
}

}  // namespace
}  // namespace quoin::booleans::testing
