#include <gtest/gtest.h>

#include <map>
#include <set>

#include "booleans/assemble/assemble.h"
#include "tests/booleans/stages.h"

namespace quoin::booleans::testing {
namespace {

/// The vertices next to each vertex of a body, along all edges of its faces.
std::map<std::uint32_t, std::set<std::uint32_t>> neighbours(const Body& body) {
  std::map<std::uint32_t, std::set<std::uint32_t>> all;
  for (std::uint32_t f = 0; f < body.face_count(); ++f)
    body.for_edges(f, [&](std::uint32_t u, std::uint32_t v) {
      all[u].insert(v);
      all[v].insert(u);
    });
  return all;
}

// A vertex with two neighbours would lie inside a straight edge; what is one triangle between grid points is stored as
// one.
TEST(Joined, ResultsHaveOnlyTheVerticesThatTheyNeed) {
  std::size_t holes = 0, derived = 0;
  for_families(0x901D, 80, [&](Solids& solids, Random& random) {
    const std::vector<Body> bodies{random.one_in(2) ? solids.next() : complement(solids.next()), solids.next(),
                                   solids.next()};
    const Expression e = random.one_in(2) ? Expression::flat(Rule::odd, 3) : random_expression(random, 3, 2);
    const Body body = packed(evaluated(bodies, e));

    const auto next_to = neighbours(body);
    for (std::uint32_t v = 0; v < body.vertex_count(); ++v)
      EXPECT_GE(next_to.contains(v) ? next_to.at(v).size() : 0, 3u) << v;
    for (std::uint32_t i = 0; i < body.polygon_count(); ++i) {
      const auto corners = body.polygons.corners_of(i);
      const bool is_grid =
          std::all_of(corners.begin(), corners.end(), [&](std::uint32_t v) { return body.is_grid(v); });
      EXPECT_FALSE(is_grid && corners.size() == 3 && body.polygons.loop_count(i) == 1) << i;
      holes += body.polygons.loop_count(i) - 1;
    }
    derived += body.points.size();
  });
  EXPECT_GT(holes, case_count(80) / 8);
  EXPECT_GT(derived, 10 * case_count(80));
}

using Loops = std::vector<std::vector<exact::GridPoint>>;

/// The loops of the faces on a plane, each from its least corner on. All corners are grid points.
Loops loops_on(const Body& body, const exact::Plane& plane) {
  Loops loops;
  const auto add = [&](std::span<const std::uint32_t> corners) {
    auto& loop = loops.emplace_back();
    for (const std::uint32_t v : corners) loop.push_back(body.grid_points[v]);
    std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
  };
  for (std::uint32_t f = 0; f < body.face_count(); ++f) {
    if (body.plane(f) != plane) continue;
    if (f < body.triangles.size())
      add(body.triangles[f]);
    else
      body.polygons.for_loops(body.polygon(f), add);
  }
  std::sort(loops.begin(), loops.end());
  return loops;
}

// Two blocks that share a face: where it was the walls are one, and the corners in the middle of their edges are gone.
TEST(Joined, BlocksThatShareAFace) {
  const Body tower = packed(any(box({0, 0, 0}, {2, 2, 2}), box({0, 0, 2}, {2, 2, 4})));
  EXPECT_EQ(tower.grid_points.size(), 8u);
  EXPECT_EQ(tower.triangles.size(), 4u) << "the bottom and the top, which nothing touched";
  EXPECT_EQ(tower.polygon_count(), 4u);
  EXPECT_EQ(loops_on(tower, {{1, 0, 0}, -2}), (Loops{{{{2, 0, 0}}, {{2, 2, 0}}, {{2, 2, 4}}, {{2, 0, 4}}}}));
}

// A tip that stands on a face is a loop of one corner; when what stands there is taken away, nothing of it stays.
TEST(Joined, ATipOnAFace) {
  const Body table = box({-4, -4, -4}, {4, 4, 0});
  const Body tip = *tetrahedron({{{0, 0, 0}, {2, 0, 2}, {0, 2, 2}, {-2, -2, 2}}});
  const exact::Plane top{{0, 0, 1}, 0};
  const Loops::value_type rim{{{-4, -4, 0}}, {{4, -4, 0}}, {{4, 4, 0}}, {{-4, 4, 0}}}, point{{{0, 0, 0}}};
  EXPECT_EQ(loops_on(packed(any(table, tip)), top), (Loops{rim, point}));
  EXPECT_EQ(loops_on(packed(minus(table, tip)), top), (Loops{rim}));
}

// The faces of the tip are copied when the face under it is cut far from it: the point has its name and stays.
TEST(Joined, ATipOnAFaceThatIsCutElsewhere) {
  const Body table = box({-4, -4, -4}, {4, 4, 0});
  const Body tip = *tetrahedron({{{0, 0, 0}, {2, 0, 2}, {0, 2, 2}, {-2, -2, 2}}});
  const Body rest = packed(minus(packed(any(table, tip)), box({3, 3, -1}, {5, 5, 1})));
  const Loops::value_type rim{{{-4, -4, 0}}, {{4, -4, 0}}, {{4, 3, 0}}, {{3, 3, 0}}, {{3, 4, 0}}, {{-4, 4, 0}}};
  EXPECT_EQ(loops_on(rest, {{0, 0, 1}, 0}), (Loops{rim, {{{0, 0, 0}}}}));
}

// The corner that a plane cuts off a cube leaves triangles between grid points, which are raw, and squares.
TEST(Joined, ACornerThatIsCutOff) {
  const Body corner = *tetrahedron({{{4, 4, 4}, {0, 4, 4}, {4, 0, 4}, {4, 4, 0}}});
  const Body rest = packed(minus(box({0, 0, 0}, {4, 4, 4}), corner));
  EXPECT_EQ(rest.triangles.size(), 4u);
  EXPECT_EQ(rest.polygon_count(), 3u);
  EXPECT_EQ(loops_on(rest, {{1, 1, 1}, -8}), (Loops{{{{0, 4, 4}}, {{4, 0, 4}}, {{4, 4, 0}}}}));
  EXPECT_EQ(loops_on(rest, {{0, 0, 1}, -4}), (Loops{{{{0, 0, 4}}, {{4, 0, 4}}, {{0, 4, 4}}}}));
}

// Nothing, and all of space.
TEST(Joined, NothingIsLeft) {
  const Body cube = box({0, 0, 0}, {4, 4, 4});
  EXPECT_EQ(dump(minus(cube, cube)), "");
  EXPECT_EQ(dump(any(cube, complement(cube))), "full at infinity\n");
}

}  // namespace
}  // namespace quoin::booleans::testing
