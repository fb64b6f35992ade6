#include "booleans/arrangement/line_trace.h"

#include <gtest/gtest.h>

#include "booleans/pairs/own_pairs.h"
#include "tests/booleans/shapes.h"
#include "tests/booleans/stages.h"

namespace quoin::booleans::testing {
namespace {

/// What is left on the line after each stop, for both ways to find stops: the points that both faces' boxes hold.
std::string text_of(const Contacts& contacts, const Names& names) {
  std::string all;
  for (const std::string& line : sorted_lines(dump(contacts, names))) all += line + "\n";
  return all;
}

/// Contacts are what they are, whether faces are searched edge by edge or through trees.
TEST(LineTrace, TreesFindTheContactsThatAllEdgesFind) {
  for_families(0x117E, 80, [](Solids& solids, Random& random) {
    const Body a = solids.next(), b = solids.next();
    const std::vector<Body> bodies{odd(a, b), random.one_in(2) ? b : all(a, b)};
    const auto contacts = [&](std::uint32_t large) {
      const WithThresholds thresholds(grid::testing::with(&grid::Thresholds::large_face, large));
      const Drawn drawn(bodies);
      return text_of(drawn.contacts, drawn.names);
    };
    const std::string by_edges = contacts(1u << 30);
    ASSERT_EQ(contacts(0), by_edges);
    ASSERT_EQ(contacts(static_cast<std::uint32_t>(random.between(3, 6))), by_edges);
  });
}

/// Faces that cover their plane more than once: how often they do where a line begins is counted.
TEST(LineTrace, TreesCountTheCoversOfFoldedFaces) {
  std::size_t found = 0;
  for (std::uint64_t number = 0; number < case_count(150); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0xF01E, number);
    const auto between = [&](std::int64_t low, std::int64_t high) { return random.between(low, high); };
    const auto n = static_cast<std::uint32_t>(random.between(2, 5));
    const auto mesh = folded_sheet(between, n, random.between(2, 8));
    if (!mesh) continue;

    const FacePairs pairs = improper_pairs(*mesh, stars(*mesh));
    const auto contacts = [&](std::uint32_t large) {
      const WithThresholds thresholds(grid::testing::with(&grid::Thresholds::large_face, large));
      const Operands operands({&*mesh}, false);
      Names names;
      const Touched touched = collect_touched(operands, pairs, names);
      return text_of(find_contacts(touched, touched_pairs(touched, pairs), names), names);
    };
    const std::string by_trees = contacts(0);
    ASSERT_EQ(by_trees, contacts(1u << 30));
    found += !by_trees.empty();
  }
  EXPECT_GT(found, 0u);
}

}  // namespace
}  // namespace quoin::booleans::testing
