#include "booleans/arrangement/sheets.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "exact/rational.h"
#include "tests/booleans/stages.h"

namespace quoin::booleans::testing {
namespace {

using exact::Rational;

/// What an edge adds to twice the signed area of the projection along an axis.
Rational twice_area(const Names& names, VertexId u, VertexId v, std::size_t axis) {
  const int i = static_cast<int>((axis + 1) % 3), j = static_cast<int>((axis + 2) % 3);
  const exact::Point p = names.vertices.point(u), q = names.vertices.point(v);
  return exact::coordinate(p, i) * exact::coordinate(q, j) - exact::coordinate(q, i) * exact::coordinate(p, j);
}

/// Facets tile their faces: areas of facets, as often as they are covered, sum to the areas of the faces.
void expect_areas_add_up(const Drawn& drawn) {
  const Names& names = drawn.names;
  for (const Sheet& sheet : drawn.sheets) {
    const std::size_t axis = exact::longest_component(names.planes[sheet.plane].n);
    Rational facets = 0, faces = 0;
    for (std::uint32_t h = 0; h < sheet.half_edges(); ++h)
      if (sheet.facet[h] != none)
        facets += sheet.covers(sheet.facet[h]).size() * twice_area(names, sheet.origin(h), sheet.target(h), axis);
    for (const TouchedId t : Ids<TouchedId>(drawn.touched.faces.size())) {
      const TouchedFace& face = drawn.touched.faces[t];
      if (face.plane != sheet.plane) continue;
      for (const BoundaryEdge& e : drawn.touched.edges_of(t))
        faces += face.jump() * twice_area(names, e.from, e.to, axis);
    }
    EXPECT_EQ(facets, faces);
  }
}

/// Every facet lies on one side of each of its elements, and all of a facet's half-edges form closed loops.
void expect_loops_close(const Drawn& drawn) {
  for (const Sheet& sheet : drawn.sheets)
    for (const FacetId f : Ids<FacetId>(sheet.facet_count())) {
      std::map<VertexId, int> balance;
      for (std::uint32_t h = 0; h < sheet.half_edges(); ++h) {
        if (sheet.facet[h] != f) continue;
        ++balance[sheet.origin(h)];
        --balance[sheet.target(h)];
      }
      for (const auto& [v, sum] : balance) EXPECT_EQ(sum, 0);
    }
}

TEST(Sheets, FacetsTileTheirFaces) {
  for_families(0x5EE7, 40, [](Solids& solids, Random&) {
    const Body a = solids.next(), b = solids.next(), c = solids.next();
    const std::vector<Body> bodies{odd(a, b), c, b};
    const Drawn drawn(bodies);
    expect_areas_add_up(drawn);
    expect_loops_close(drawn);
  });
}

// The corner of one cube in another: each face that takes part is cut into an L and a square.
TEST(Sheets, CornerOfACubeInACube) {
  const std::vector<Body> bodies{box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3})};
  const Drawn drawn(bodies);
  ASSERT_EQ(drawn.sheets.size(), 6u);
  for (const Sheet& sheet : drawn.sheets) {
    ASSERT_EQ(sheet.facet_count(), 2u);
    std::multiset<std::size_t> sizes;
    for (const FacetId f : Ids<FacetId>(2)) {
      EXPECT_EQ(sheet.covers(f).size(), 1u);
      sizes.insert(static_cast<std::size_t>(std::count(sheet.facet.begin(), sheet.facet.end(), f)));
    }
    EXPECT_EQ(sizes, (std::multiset<std::size_t>{4, 6}));
  }
}

// Two blocks that share a face: one facet that both cover.
TEST(Sheets, SharedFaceIsOneFacetOfTwoCovers) {
  const std::vector<Body> bodies{box({0, 0, 0}, {2, 2, 2}), box({0, 0, 2}, {2, 2, 4})};
  const Drawn drawn(bodies);
  std::size_t shared = 0;
  for (const Sheet& sheet : drawn.sheets)
    for (const FacetId f : Ids<FacetId>(sheet.facet_count())) shared += sheet.covers(f).size() == 2;
  EXPECT_EQ(shared, 1u);
}

}  // namespace
}  // namespace quoin::booleans::testing
