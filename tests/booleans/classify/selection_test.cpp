#include "booleans/classify/selection.h"

#include <gtest/gtest.h>

#include <set>

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

// Outside, in one cube, in the other, in both.
TEST(Cells, CornerOfACubeInACube) {
  const std::vector<Body> bodies{box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3})};
  const Arrangement a = arranged(bodies);
  const Cells cells = find_cells(a);
  std::set<std::uint32_t> ids{cells.infinity.value};
  for (const CellId c : cells.of) ids.insert(c.value);
  EXPECT_EQ(ids.size(), 4u);
}

// Boxes within boxes and beside each other, none touching: a union keeps those that lie in no other.
TEST(Seeds, BoxesWithinBoxes) {
  for (std::uint64_t number = 0; number < case_count(40); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0x5EED, number);
    std::vector<Body> bodies;
    std::vector<std::array<Vector, 2>> boxes;
    const auto apart = [](const auto& p, const auto& q) {
      for (std::size_t k = 0; k < 3; ++k)
        if (p[1][k] < q[0][k] || q[1][k] < p[0][k]) return true;
      return false;
    };
    const auto within = [](const auto& p, const auto& q) {
      for (std::size_t k = 0; k < 3; ++k)
        if (p[0][k] <= q[0][k] || p[1][k] >= q[1][k]) return false;
      return true;
    };
    for (int tries = 0; tries < 60; ++tries) {
      const Vector low = random.vector(-20, 20), size = random.vector(1, random.one_in(3) ? 20 : 4);
      const std::array<Vector, 2> next{low, low + size};
      if (!std::all_of(boxes.begin(), boxes.end(),
                       [&](const auto& b) { return apart(b, next) || within(b, next) || within(next, b); }))
        continue;
      boxes.push_back(next);
      bodies.push_back(box(next[0], next[1]));
    }

    const Arrangement a = arranged(bodies);
    const Selection s =
        select(a, find_cells(a), Expression::flat(Rule::any, static_cast<std::uint32_t>(bodies.size())));
    for (std::uint32_t o = 0; o < bodies.size(); ++o) {
      const bool is_hidden =
          std::any_of(boxes.begin(), boxes.end(), [&](const auto& b) { return within(boxes[o], b); });
      for (std::uint32_t f = 0; f < bodies[o].face_count(); ++f)
        EXPECT_EQ(int{s.kept[a.patches().of[a.operands.face(o, f)]]}, is_hidden ? 0 : 1);
    }
  }
}

}  // namespace
}  // namespace quoin::booleans::testing
