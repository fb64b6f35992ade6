#include "booleans/arrangement/touched.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "tests/booleans/stages.h"

namespace quoin::booleans::testing {
namespace {

std::vector<std::string> touched_of(const std::vector<Body>& bodies) {
  const Drawn drawn(bodies);
  return lines_of(dump(drawn.touched, drawn.names));
}

// A tip on the middle of a face: the face, whose triangles both meet it, and the three faces of the tip. Each with its
// outward plane and the edges that have it on their left.
TEST(Touched, TipOnAFace) {
  const std::vector<Body> bodies{box({-4, -4, -4}, {4, 4, 0}),
                                 *tetrahedron({{{0, 0, 0}, {2, 0, 2}, {0, 2, 2}, {-2, -2, 2}}})};
  EXPECT_EQ(touched_of(bodies), (std::vector<std::string>{
                                    "face 0 of operand 0 on [0 0 1 0]",
                                    "  (-4, -4, 0) -> (4, -4, 0)",
                                    "  (4, -4, 0) -> (4, 4, 0)",
                                    "  (4, 4, 0) -> (-4, 4, 0)",
                                    "  (-4, 4, 0) -> (-4, -4, 0)",
                                    "face 1 of operand 1 on [1 1 -1 0]",
                                    "  (0, 0, 0) -> (0, 2, 2)",
                                    "  (0, 2, 2) -> (2, 0, 2)",
                                    "  (2, 0, 2) -> (0, 0, 0)",
                                    "face 2 of operand 1 on [1 -2 -1 0]",
                                    "  (0, 0, 0) -> (2, 0, 2)",
                                    "  (2, 0, 2) -> (-2, -2, 2)",
                                    "  (-2, -2, 2) -> (0, 0, 0)",
                                    "face 3 of operand 1 on [-2 1 -1 0]",
                                    "  (0, 0, 0) -> (-2, -2, 2)",
                                    "  (-2, -2, 2) -> (0, 2, 2)",
                                    "  (0, 2, 2) -> (0, 0, 0)",
                                }));
}

// The bottom of a plate has a hole, and a dot where a void ends in a tip; the tip of a tetrahedron below touches it.
TEST(Touched, HolesAndDots) {
  const WithThresholds usual{grid::Thresholds{}};  // loops begin where they do, and none is spared
  const Body plate = minus(minus(box({0, 0, 0}, {8, 4, 4}), box({4, 1, -1}, {6, 3, 2})),
                           *tetrahedron({{{2, 2, 0}, {1, 1, 2}, {3, 1, 2}, {2, 3, 2}}}));
  EXPECT_EQ(touched_of({plate, *tetrahedron({{{1, 3, 0}, {0, 3, -2}, {2, 3, -2}, {1, 4, -2}}})}),
            (std::vector<std::string>{
                "face 0 of operand 0 on [0 0 -1 0]",  "  (0, 0, 0) -> (0, 4, 0)",
                "  (0, 4, 0) -> (8, 4, 0)",           "  (8, 4, 0) -> (8, 0, 0)",
                "  (8, 0, 0) -> (0, 0, 0)",           "  (4, 3, 0) -> (4, 1, 0)",
                "  (4, 1, 0) -> (6, 1, 0)",           "  (6, 1, 0) -> (6, 3, 0)",
                "  (6, 3, 0) -> (4, 3, 0)",           "  point (2, 2, 0)",
                "face 1 of operand 1 on [0 -1 0 3]",  "  (1, 3, 0) -> (0, 3, -2)",
                "  (0, 3, -2) -> (2, 3, -2)",         "  (2, 3, -2) -> (1, 3, 0)",
                "face 2 of operand 1 on [-2 2 1 -4]", "  (1, 3, 0) -> (1, 4, -2)",
                "  (1, 4, -2) -> (0, 3, -2)",         "  (0, 3, -2) -> (1, 3, 0)",
                "face 3 of operand 1 on [2 2 1 -8]",  "  (1, 3, 0) -> (2, 3, -2)",
                "  (2, 3, -2) -> (1, 4, -2)",         "  (1, 4, -2) -> (1, 3, 0)",
            }));
}

// The two triangles of a square are one face, whose diagonal is no edge.
TEST(Touched, DiagonalsAreNoEdges) {
  const std::vector<Body> bodies{box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3})};
  const Drawn drawn(bodies);
  EXPECT_EQ(drawn.touched.faces.size(), 6u);
  EXPECT_EQ(drawn.touched.members.size(), 12u);
  for (const TouchedId t : Ids<TouchedId>(6)) EXPECT_EQ(drawn.touched.edges_of(t).size(), 4u);
}

// At the six edges where a touched face of a cube meets an untouched one, the latter is listed.
TEST(Touched, UntouchedNeighboursAreListed) {
  const std::vector<Body> bodies{box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3})};
  const Drawn drawn(bodies);
  EXPECT_EQ(drawn.touched.untouched.size(), 2u * 6u);
}

// Three tetrahedra at each of two edges, which end in the vertex of the highest number: each edge of a face has a plane
// through it, not the face's, though faces at an edge of many are looked at once for all.
TEST(Touched, EdgesOfManyFaces) {
  const WithThresholds set(grid::testing::with(&grid::Thresholds::few_faces_at_edge, 0u));
  std::vector<Vector> points{{0, 0, -8}, {8, 0, 0}};
  std::vector<Triangle> triangles;
  for (const std::int64_t y : {-4, -1, 2})
    for (const std::uint32_t end : {0, 1}) {
      const std::int64_t x = end == 0 ? -4 : 4;
      const auto p = static_cast<std::uint32_t>(points.size());
      points.insert(points.end(), {{x, y, x}, {x, y + 1, x}});
      constexpr std::uint32_t middle = 14;
      const std::array<Triangle, 4> faces{
          {{middle, end, p}, {middle, p + 1, end}, {middle, p, p + 1}, {end, p + 1, p}}};
      for (const Triangle& t : faces) triangles.push_back(end == 0 ? t : Triangle{t[0], t[2], t[1]});
    }
  points.push_back({0, 0, 0});
  const std::vector<Body> bodies{*mesh(points, triangles), box({-10, -10, -1}, {10, 10, 1})};

  const Drawn drawn(bodies);
  std::size_t edges = 0;
  for (const TouchedId t : Ids<TouchedId>(drawn.touched.faces.size()))
    for (const BoundaryEdge& e : drawn.touched.edges_of(t)) {
      ++edges;
      EXPECT_NE(e.other, drawn.touched.faces[t].plane);
      for (const VertexId v : {e.from, e.to}) EXPECT_EQ(drawn.names.side(v, e.other), 0);
    }
  EXPECT_GE(edges, 3u * 3 * 6);
}

// Faces are maximal: no two of one operand lie on one oriented plane and share an edge of exactly two faces.
TEST(Touched, FacesAreMaximal) {
  for_families(0x70C4, 40, [](Solids& solids, Random&) {
    const std::vector<Body> bodies{solids.next(), solids.next()};
    const Drawn drawn(bodies);
    const Touched& touched = drawn.touched;

    std::map<std::array<std::uint32_t, 3>, std::vector<TouchedId>> at;  // by operand and edge
    for (const TouchedId t : Ids<TouchedId>(touched.faces.size()))
      for (const BoundaryEdge& e : touched.edges_of(t))
        at[{touched.faces[t].operand.value, std::min(e.from, e.to).value, std::max(e.from, e.to).value}].push_back(t);
    std::set<std::array<std::uint32_t, 3>> with_untouched;
    for (const UntouchedUse& u : touched.untouched)
      with_untouched.insert({u.operand.value, std::min(u.from, u.to).value, std::max(u.from, u.to).value});

    for (const auto& [edge, faces] : at) {
      if (faces.size() != 2 || faces[0] == faces[1] || with_untouched.contains(edge)) continue;
      const TouchedFace &f = touched.faces[faces[0]], &g = touched.faces[faces[1]];
      EXPECT_FALSE(f.plane == g.plane && f.along == g.along);
    }
  });
}

// An edge at which all faces are folded onto one plane gets an axis-parallel line.
TEST(Touched, EdgeOfATwoSidedFlap) {
  Body flap;
  for (const auto& p : std::vector<exact::GridPoint>{{{0, 0, 0}}, {{4, 0, 0}}, {{0, 4, 0}}})
    flap.grid_points.push_back(p);
  flap.triangles.push_back({0, 1, 2});
  flap.triangles.push_back({0, 2, 1});
  const Operands operands({&flap}, false);
  Names names;
  const Touched touched = collect_touched(operands, {{FaceId(0), FaceId(1)}}, names);
  ASSERT_EQ(touched.faces.size(), 2u);
  for (const BoundaryEdge& e : touched.edges)
    EXPECT_FALSE(exact::parallel(names.planes[e.other], names.planes[touched.faces[TouchedId(0)].plane]));
}

}  // namespace
}  // namespace quoin::booleans::testing
