#include "booleans/arrangement/uses.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "tests/booleans/stages.h"

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
  a.uses.for_edges([&](std::span<const Use> uses) {
    for (const Use& u : uses)
      if (a.sheets.is_facet(u.node)) ++found[{u.low.value, u.high.value, u.node.value, u.left}];
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
  arranged(bodies).uses.for_edges([&](std::span<const Use> uses) { ++fans[uses.size()]; });
  EXPECT_EQ(fans[4], 6);
  EXPECT_EQ(fans.size(), 2u);
  EXPECT_TRUE(fans.contains(2));
}

// The untouched faces of each cube hang together: one patch each.
TEST(Patches, OneForTheRestOfACube) {
  const std::vector<Body> bodies{box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3})};
  const Arrangement a = arranged(bodies);
  std::set<std::pair<std::uint32_t, std::uint32_t>> patches;
  for (std::uint32_t f = 0; f < a.operands.face_count(); ++f)
    if (const NodeId n = a.patches().of[FaceId(f)]; n != none) patches.insert({n.value, a.patches().operand(n).value});
  EXPECT_EQ(patches.size(), 2u);
}

}  // namespace
}  // namespace quoin::booleans::testing
