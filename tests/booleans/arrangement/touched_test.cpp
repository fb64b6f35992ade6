#include "booleans/arrangement/touched.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "tests/booleans/stages.h"

namespace quoin::booleans::testing {
namespace {

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
