#include "booleans/arrangement/sheets.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/booleans/stages.h"

namespace quoin::booleans::testing {
namespace {

// A tip on a face is a point in its facet, and a corner of facets on three other sheets.
TEST(Sheets, TipOnAFace) {
  const std::vector<Body> bodies{box({-4, -4, -4}, {4, 4, 0}),
                                 *tetrahedron({{{0, 0, 0}, {2, 0, 2}, {0, 2, 2}, {-2, -2, 2}}})};
  const Drawn drawn(bodies);
  EXPECT_EQ(lines_of(dump(drawn.sheets, drawn.names)), (std::vector<std::string>{
                                                           "sheet [0 0 1 0]",
                                                           "  facet 0 of 0",
                                                           "    (-4, -4, 0) -> (4, -4, 0)",
                                                           "    (-4, 4, 0) -> (-4, -4, 0)",
                                                           "    (4, -4, 0) -> (4, 4, 0)",
                                                           "    (4, 4, 0) -> (-4, 4, 0)",
                                                           "  point (0, 0, 0) in facet 0",
                                                           "sheet [1 1 -1 0]",
                                                           "  facet 1 of 1",
                                                           "    (0, 0, 0) -> (0, 2, 2)",
                                                           "    (2, 0, 2) -> (0, 0, 0)",
                                                           "    (0, 2, 2) -> (2, 0, 2)",
                                                           "sheet [1 -2 -1 0]",
                                                           "  facet 2 of 2",
                                                           "    (0, 0, 0) -> (2, 0, 2)",
                                                           "    (-2, -2, 2) -> (0, 0, 0)",
                                                           "    (2, 0, 2) -> (-2, -2, 2)",
                                                           "sheet [2 -1 1 0]",
                                                           "  facet 3 of 3",
                                                           "    (0, 0, 0) -> (0, 2, 2)",
                                                           "    (-2, -2, 2) -> (0, 0, 0)",
                                                           "    (0, 2, 2) -> (-2, -2, 2)",
                                                       }));
}

/// The edges of facets, whatever their numbers, and as many lines as there are facets.
std::vector<std::string> edges_of(const std::string& text) {
  std::vector<std::string> lines = sorted_lines(text);
  for (std::string& line : lines)
    if (const std::size_t at = line.find("facet"); at != std::string::npos) line.resize(at);
  std::sort(lines.begin(), lines.end());
  return lines;
}

// Sheets of one face whose contacts' ends have known places are drawn as if nobody knew: crossing points may get their
// names in another order.
TEST(Sheets, KnownPlacesChangeNothing) {
  for_families(0x5EE7, 12, [&](Solids& solids, Random& random) {
    std::vector<Body> bodies{solids.next(), solids.next()};
    if (random.one_in(2)) bodies.push_back(solids.next());
    const Drawn drawn(bodies);
    Names names;
    const Touched touched = collect_touched(drawn.operands, drawn.pairs, names);
    Contacts contacts = find_contacts(touched, touched_pairs(touched, drawn.pairs), names);
    for (ContactSegment& s : contacts.segments) s.at_a = s.at_b = unknown_place;
    const Sheets sheets = draw_sheets(touched, contacts, names);
    ASSERT_EQ(edges_of(dump(drawn.sheets, drawn.names)), edges_of(dump(sheets, names)));
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

// In how many stretches sheets are drawn side by side shows in no number and no line, although those that wait for the
// names of new points are drawn after the others of their stretch.
TEST(Sheets, AreTheSameInAnyStretches) {
  std::size_t new_points = 0;
  for_families(0x5EE8, 15, [&](Solids& solids, Random&) {
    const std::vector<Body> bodies{solids.next(), solids.next(), solids.next()};
    const Operands operands(Drawn::pointers(bodies));
    const FacePairs pairs = foreign_pairs(operands);
    Names before;
    const Touched touched = collect_touched(operands, pairs, before);
    const Contacts contacts = find_contacts(touched, touched_pairs(touched, pairs), before);

    const auto draw = [&](std::size_t stretch) {
      const WithThresholds thresholds(grid::testing::with(&grid::Thresholds::stretch, stretch));
      Names names = before;
      const Sheets sheets = draw_sheets(touched, contacts, names);
      new_points += names.vertices.size() - before.vertices.size();
      return lines_of(dump(sheets, names));
    };
    ASSERT_EQ(draw(3), draw(64));
  });
  EXPECT_GT(new_points, 0u);
}

// Facets and elements of all sheets are numbered through.
TEST(Sheets, NodesAndElementsAreNumberedThrough) {
  const std::vector<Body> bodies{box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3})};
  const Sheets sheets = Drawn(bodies).sheets;
  std::uint32_t node = 0, element = 0;
  for (const SheetId s : sheets.ids()) {
    for (const FacetId f : Ids<FacetId>(sheets[s].facet_count())) {
      EXPECT_EQ(sheets.node(s, f), NodeId(node));
      EXPECT_EQ(sheets.sheet_of(node), s);
      EXPECT_EQ(sheets.facet_of(node), f);
      ++node;
    }
    for (std::uint32_t e = 0; e < sheets[s].elements.size(); ++e) EXPECT_EQ(sheets.element(s, e), ElementId(element++));
  }
  EXPECT_EQ(sheets.facet_count(), node);
  EXPECT_EQ(sheets.element_count(), element);
  EXPECT_TRUE(sheets.is_facet(node - 1));
  EXPECT_FALSE(sheets.is_facet(node));
}

}  // namespace
}  // namespace quoin::booleans::testing
