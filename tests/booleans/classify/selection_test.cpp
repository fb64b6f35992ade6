#include "booleans/classify/selection.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/booleans/lattice_regions.h"
#include "tests/booleans/stages.h"

namespace quoin::booleans::testing {
namespace {

/// The expression that is one operand.
Expression operand(std::uint32_t o) {
  Expression e;
  e.add({Rule::operand, false, o, none});
  return e;
}

// Selecting one operand keeps its own surface and nothing else, facet by facet, whatever the others do to it.
TEST(Selection, OfOneOperandIsItsSurface) {
  for_families(0x5E1E, 30, [](Solids& solids, Random&) {
    const Body a = solids.next(), b = solids.next();
    const std::vector<Body> bodies{odd(a, b), solids.next(), complement(b)};
    const Arrangement arrangement = arranged(bodies);
    const Cells cells = find_cells(arrangement);
    for (std::uint32_t o = 0; o < bodies.size(); ++o) {
      const Selection s = select(arrangement, cells, operand(o));
      ASSERT_TRUE(s.is_consistent);
      ASSERT_EQ(s.full_at_infinity, bodies[o].full_at_infinity);
      for (const NodeId n : Ids<NodeId>(arrangement.node_count())) {
        int jump = 0;
        arrangement.for_jumps(n, [&](OperandId by, int change) { jump += by == OperandId(o) ? change : 0; });
        ASSERT_EQ(int{s.kept[n]}, jump);
      }
    }
  });
}

std::vector<std::string> selection_of(const std::vector<Body>& bodies, const Expression& expression) {
  const Arrangement a = arranged(bodies);
  return lines_of(dump(select(a, find_cells(a), expression)));
}

// The facet that both share, 0, goes in a union; the lower one without the upper one keeps it, looking up, and so does
// the lower one with all that is not in the upper one. They have no common inside.
TEST(Selection, TetrahedraThatShareAFace) {
  const std::vector<Body> bodies{*tetrahedron({{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {1, 1, -3}}}),
                                 *tetrahedron({{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {1, 1, 3}}})};
  EXPECT_EQ(selection_of(bodies, Expression::flat(Rule::any, 2)),
            (std::vector<std::string>{"0: 0", "1: -1", "2: -1", "3: 1", "4: -1", "5: -1", "6: 1", "infinity: 0"}));
  EXPECT_EQ(selection_of(bodies, Expression::flat(Rule::all, 2)),
            (std::vector<std::string>{"0: 0", "1: 0", "2: 0", "3: 0", "4: 0", "5: 0", "6: 0", "infinity: 0"}));
  EXPECT_EQ(selection_of(bodies, Expression::flat(Rule::all, 2, 1)),
            (std::vector<std::string>{"0: 1", "1: -1", "2: -1", "3: 1", "4: 0", "5: 0", "6: 0", "infinity: 0"}));
  EXPECT_EQ(selection_of(bodies, Expression::flat(Rule::any, 2, 1)),
            (std::vector<std::string>{"0: 1", "1: 0", "2: 0", "3: 0", "4: 1", "5: 1", "6: -1", "infinity: 1"}));
}

/// How many kept facets and untouched faces have an edge, which they are asked for one by one.
std::map<std::pair<VertexId, VertexId>, int> kept_at_edges(const Arrangement& a, const Selection& selection) {
  std::map<std::pair<VertexId, VertexId>, int> counts;
  for (const SheetId s : a.sheets.ids()) {
    const Sheet& sheet = a.sheets[s];
    for (std::uint32_t h = 0; h < sheet.half_edges(); ++h)
      if (sheet.facet[h] != none && selection.kept[a.sheets.node(s, sheet.facet[h])] != 0)
        ++counts[std::minmax(sheet.origin(h), sheet.target(h))];
  }
  a.for_untouched([&](FaceId f, NodeId n) {
    if (selection.kept[n] == 0) return;
    const auto [operand, face] = a.operands.own(f);
    const OperandNames& names = a.names.operands[operand];
    a.operands[operand].for_edges(face, [&](std::uint32_t u, std::uint32_t v) {
      if (names.of(u) != none && names.of(v) != none) ++counts[std::minmax(names.of(u), names.of(v))];
    });
  });
  return counts;
}

// Sets of tetrahedra of one lattice and a random expression: a node is kept, and looks out, as the expression's values
// in the regions on both sides say; how many kept ones meet at an element is counted.
TEST(Selection, KeepsWhatTheRegionsOnBothSidesSay) {
  std::size_t kept = 0;
  for (std::uint64_t number = 0; number < case_count(40); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0x5E1F, number);
    std::vector<Filling> fillings(1 + random.below(4));
    for (Filling& f : fillings) f = Filling(random.below(5));
    const auto sets = lattice_sets(random, random.vector(1, 3), fillings);
    std::vector<Body> bodies = boundaries(sets);
    std::vector<bool> is_complement;
    for (Body& b : bodies) {
      is_complement.push_back(random.one_in(4));
      if (is_complement.back()) b = complement(b);
    }
    const Expression e = random_expression(random, bodies.size(), 3);
    const Arrangement a = arranged(bodies);
    const Selection s = select(a, find_cells(a), e);
    ASSERT_TRUE(s.is_consistent);

    LatticeRegions regions(sets, a);
    const auto value = [&](std::uint32_t region) {
      const std::vector<bool> label = regions.label(region);
      return holds(e, [&](std::uint32_t o) { return label[o] != is_complement[o]; });
    };
    ASSERT_EQ(s.full_at_infinity, value(regions.infinity()));
    for (const NodeId n : Ids<NodeId>(a.node_count()))
      for (const std::uint32_t front : regions.seen_by(front_of(n)))
        for (const std::uint32_t back : regions.seen_by(back_of(n)))
          ASSERT_EQ(int{s.kept[n]}, int{value(back)} - int{value(front)});

    const auto counts = kept_at_edges(a, s);
    for (const SheetId sheet : a.sheets.ids())
      for (std::uint32_t i = 0; i < a.sheets[sheet].elements.size(); ++i) {
        const Sheet::Element& element = a.sheets[sheet].elements[i];
        const auto at = counts.find(std::minmax(element.a, element.b));
        ASSERT_EQ(int{s.kept_at[a.sheets.element(sheet, i)]}, at == counts.end() ? 0 : at->second);
      }
    kept += static_cast<std::size_t>(std::count_if(s.kept.begin(), s.kept.end(), [](int k) { return k != 0; }));
  }
  EXPECT_GT(kept, case_count(40));
}

}  // namespace
}  // namespace quoin::booleans::testing
