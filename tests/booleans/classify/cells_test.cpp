#include "booleans/classify/cells.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "tests/booleans/lattice_regions.h"
#include "tests/booleans/stages.h"

namespace quoin::booleans::testing {
namespace {

std::vector<std::string> cells_of(const std::vector<Body>& bodies) {
  return lines_of(dump(find_cells(arranged(bodies))));
}

// Outside, in one cube (1), in the other (2), in both (3). The last two nodes are patches.
TEST(Cells, CornerOfACubeInACube) {
  const std::vector<Body> bodies{box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3})};
  EXPECT_EQ(cells_of(bodies),
            (std::vector<std::string>{"0: infinity, 1", "1: 2, 3", "2: infinity, 1", "3: 2, 3", "4: infinity, 1",
                                      "5: 2, 3", "6: 3, 1", "7: 2, infinity", "8: 3, 1", "9: 2, infinity", "10: 3, 1",
                                      "11: 2, infinity", "12: infinity, 1", "13: infinity, 2"}));
}

// The facet that both share is between their insides, the upper one (0) in front.
TEST(Cells, TetrahedraThatShareAFace) {
  const std::vector<Body> bodies{*tetrahedron({{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {1, 1, -3}}}),
                                 *tetrahedron({{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {1, 1, 3}}})};
  EXPECT_EQ(cells_of(bodies), (std::vector<std::string>{"0: 0, 1", "1: 1, infinity", "2: 1, infinity", "3: infinity, 1",
                                                        "4: 0, infinity", "5: 0, infinity", "6: infinity, 0"}));
}

// Facets of both cubes around their common edge: what is outside is one cell all the same. A tip on a face touches it
// over no edge, and is joined to the outside by a ray.
TEST(Cells, TouchingInEdgesAndTips) {
  const std::vector<Body> edge{box({0, 0, 0}, {1, 1, 1}), box({1, 1, 0}, {2, 2, 1})};
  EXPECT_EQ(cells_of(edge),
            (std::vector<std::string>{"0: infinity, 1", "1: 2, infinity", "2: 2, infinity", "3: infinity, 1",
                                      "4: 1, infinity", "5: 2, infinity", "6: infinity, 2", "7: infinity, 1",
                                      "8: infinity, 1", "9: infinity, 2"}));
  const std::vector<Body> tip{box({-4, -4, -4}, {4, 4, 0}),
                              *tetrahedron({{{0, 0, 0}, {2, 0, 2}, {0, 2, 2}, {-2, -2, 2}}})};
  EXPECT_EQ(cells_of(tip), (std::vector<std::string>{"0: infinity, 1", "1: infinity, 3", "2: infinity, 3",
                                                     "3: 3, infinity", "4: infinity, 1", "5: infinity, 3"}));
}

// A cube in a cube, a hollow around both, all in a void of what is full at infinity: from the inner one outwards the
// cells are 1, 0, 2, 5, 4. Then a void alone.
TEST(Cells, NestedShells) {
  const std::vector<Body> bodies{box({3, 3, 3}, {4, 4, 4}), box({2, 2, 2}, {5, 5, 5}),
                                 minus(box({0, 0, 0}, {7, 7, 7}), box({1, 1, 1}, {6, 6, 6})),
                                 complement(box({-1, -1, -1}, {8, 8, 8}))};
  EXPECT_EQ(cells_of(bodies), (std::vector<std::string>{"0: 0, 1", "1: 2, 0", "2: 4, 5", "3: 2, 5", "4: 4, infinity"}));
  EXPECT_EQ(cells_of({complement(box({0, 0, 0}, {1, 1, 1}))}), (std::vector<std::string>{"0: 0, infinity"}));
}

// Sets of tetrahedra of one lattice, which touch and coincide everywhere: sides that see one region are in one cell,
// and those of one cell see regions of one label.
TEST(Cells, SidesOfOneRegionAreInOneCell) {
  std::size_t cells_seen = 0;
  for (std::uint64_t number = 0; number < case_count(40); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0xCE11, number);
    std::vector<Filling> fillings(1 + random.below(3));
    for (Filling& f : fillings) f = Filling(random.below(5));
    const auto sets = lattice_sets(random, random.vector(1, 3), fillings);
    const std::vector<Body> bodies = boundaries(sets);
    const Arrangement a = arranged(bodies);
    const Cells cells = find_cells(a);
    ASSERT_TRUE(cells.is_consistent);

    LatticeRegions regions(sets, a);
    std::map<std::uint32_t, CellId> cell_of{{regions.infinity(), cells.infinity}};
    std::map<CellId, std::vector<bool>> labels;
    for (const SideId s : Ids<SideId>(2 * a.node_count())) {
      for (const std::uint32_t r : regions.seen_by(s)) {
        ASSERT_EQ(cell_of.try_emplace(r, cells.of[s]).first->second, cells.of[s]);
        ASSERT_EQ(labels.try_emplace(cells.of[s], regions.label(r)).first->second, regions.label(r));
      }
    }
    cells_seen += labels.size();
  }
  EXPECT_GT(cells_seen, 2 * case_count(40));
}

/// Two triangles of derived points on one plane, back to back.
Body flap() {
  const auto plane = [](std::array<std::int64_t, 3> n, std::int64_t d) { return exact::reduced_plane(n, d); };
  const exact::Plane own = plane({0, 0, 2}, -9), x = plane({2, 0, 0}, -9), y = plane({0, 2, 0}, -9),
                     slope = plane({1, 1, 0}, -10);
  Body body;
  for (const auto& [p, q] : {std::pair(x, y), std::pair(slope, y), std::pair(x, slope)})
    body.points.push_back(*exact::meet(own, p, q));
  for (const bool up : {true, false}) {
    body.planes.push_back(up ? own : own.opposite());
    body.polygons.add_loop(std::array<std::uint32_t, 3>{0, up ? 1u : 2u, up ? 2u : 1u});
    body.polygons.end_face();
  }
  body.is_proved = false;
  return body;
}

// A trusted flap within a cube bounds nothing: no ray can start there.
TEST(Cells, AFlapIsInconsistent) {
  const std::vector<Body> bodies{box({0, 0, 0}, {9, 9, 9}), flap()};
  EXPECT_FALSE(find_cells(arranged(bodies)).is_consistent);
}

}  // namespace
}  // namespace quoin::booleans::testing
