#include "booleans/arrangement/uses.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <tuple>

#include "tests/booleans/stages.h"
#include "tests/grid/with_thresholds.h"

namespace quoin::booleans::testing {
namespace {

/// Every facet is at each of its elements, on the side where it lies, and every touched face's neighbour is there.
void expect_complete(const Arrangement& a) {
  std::map<std::array<std::uint32_t, 4>, int> expected, found;  // (low, high, node, left)
  for (const SheetId s : a.sheets.ids()) {
    const Sheet& sheet = a.sheets[s];
    for (std::uint32_t h = 0; h < sheet.half_edges(); ++h) {
      if (sheet.facet[h] == none) continue;
      const VertexId u = sheet.origin(h), v = sheet.target(h);
      ++expected[{std::min(u, v).value, std::max(u, v).value, a.sheets.node(s, sheet.facet[h]).value, u < v}];
    }
  }
  a.uses.for_edges([&](VertexId low, std::span<const Use> uses) {
    for (const Use& u : uses)
      if (u.is_facet()) ++found[{low.value, u.high().value, u.node().value, u.left()}];
  });
  EXPECT_EQ(found, expected);
}

TEST(Uses, HoldEveryFacetAtEachOfItsElements) {
  for_families(0x05E5, 30, [](Solids& solids, Random&) {
    const std::vector<Body> bodies{solids.next(), solids.next(), solids.next()};
    expect_complete(arranged(bodies));
  });
}

// Where a face of one cube runs through another, four facets meet at each of the six contact segments; at the edges of
// a touched face there are two.
TEST(Uses, CornerOfACubeInACube) {
  const std::vector<Body> bodies{box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3})};
  std::map<std::size_t, int> fans;
  arranged(bodies).uses.for_edges([&](VertexId, std::span<const Use> uses) { ++fans[uses.size()]; });
  EXPECT_EQ(fans[4], 6);
  EXPECT_EQ(fans.size(), 2u);
  EXPECT_TRUE(fans.contains(2));
}

// At the edges of the face under a tip its facet and a patch; of the tip two facets, or a facet and a patch.
TEST(Uses, TipOnAFace) {
  const std::vector<Body> bodies{box({-4, -4, -4}, {4, 4, 0}),
                                 *tetrahedron({{{0, 0, 0}, {2, 0, 2}, {0, 2, 2}, {-2, -2, 2}}})};
  const Arrangement a = arranged(bodies);
  EXPECT_EQ(lines_of(dump(a.uses, a.names)), (std::vector<std::string>{
                                                 "(-4, -4, 0) - (4, -4, 0): 0 left patch 4 right",
                                                 "(-4, -4, 0) - (-4, 4, 0): 0 right patch 4 left",
                                                 "(4, -4, 0) - (4, 4, 0): 0 left patch 4 right",
                                                 "(4, 4, 0) - (-4, 4, 0): 0 left patch 4 right",
                                                 "(0, 0, 0) - (0, 2, 2): 1 left 3 left",
                                                 "(0, 0, 0) - (2, 0, 2): 1 right 2 left",
                                                 "(0, 0, 0) - (-2, -2, 2): 2 right 3 right",
                                                 "(0, 2, 2) - (2, 0, 2): 1 left patch 5 right",
                                                 "(0, 2, 2) - (-2, -2, 2): 3 left patch 5 left",
                                                 "(2, 0, 2) - (-2, -2, 2): 2 left patch 5 right",
                                             }));
}

TEST(Use, SaysWhatItIs) {
  for (const std::uint32_t node : {0u, 1u, 0x7FFFFFFEu})
    for (const bool left : {false, true}) {
      const Use facet = Use::of_facet(none - 2, node, left, PlaneId(5), ElementId(none - 1)),
                patch = Use::of_patch(7, node, left, FaceId(none - 1));
      EXPECT_EQ(facet.high().value, none - 2);
      EXPECT_EQ(patch.high().value, 7u);
      for (const Use& u : {facet, patch}) {
        EXPECT_EQ(u.node().value, node);
        EXPECT_EQ(u.left(), left);
      }
      EXPECT_TRUE(facet.is_facet());
      EXPECT_EQ(facet.plane().value, 5u);
      EXPECT_EQ(facet.element().value, none - 1);
      EXPECT_FALSE(patch.is_facet());
      EXPECT_EQ(patch.face().value, none - 1);
    }
}

// Two blocks of one operand have an edge in common; of its four faces two are touched, and each of the others hangs at
// both of these.
TEST(Uses, AFaceThatHangsAtTwoTouchedOnesIsThereOnce) {
  const std::vector<Body> bodies{packed(any(box({0, 0, 0}, {4, 4, 4}), box({4, 4, 0}, {8, 8, 4}))),
                                 box({3, 1, 1}, {5, 3, 3}), box({3, 5, 1}, {5, 7, 3})};
  for (const std::uint32_t few_faces : {8u, 0u}) {
    grid::Thresholds t = grid::thresholds();
    t.few_faces_at_edge = few_faces;
    const grid::testing::WithThresholds set(t);
    const Arrangement a = arranged(bodies);
    std::size_t patches = 0;
    a.uses.for_edges([&](VertexId, std::span<const Use> uses) {
      for (std::size_t i = 0; i < uses.size(); ++i) {
        patches += !uses[i].is_facet();
        EXPECT_TRUE(i == 0 || uses[i] != uses[i - 1]);
      }
    });
    EXPECT_EQ(a.touched.untouched.size(), patches + (few_faces == 8 ? 2 : 0));  // an edge is looked at once, or by each
  }
}

// Edges come by their ends, each once.
TEST(Uses, AreInOrderAtEachLowEnd) {
  for_families(0x05E6, 10, [](Solids& solids, Random&) {
    const std::vector<Body> bodies{solids.next(), solids.next(), solids.next(), solids.next()};
    const Arrangement a = arranged(bodies);
    VertexId last_low = 0, last_high = 0;
    a.uses.for_edges([&](VertexId low, std::span<const Use> uses) {
      const VertexId high = uses[0].high();
      EXPECT_LT(low, high);
      EXPECT_TRUE(last_low < low || (last_low == low && last_high < high));
      for (const Use& u : uses) EXPECT_EQ(u.high(), high);
      std::tie(last_low, last_high) = std::tie(low, high);
    });
  });
}

}  // namespace
}  // namespace quoin::booleans::testing
