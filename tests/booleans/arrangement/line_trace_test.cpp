#include "booleans/arrangement/line_trace.h"

#include <gtest/gtest.h>

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
    ASSERT_EQ(contacts(0), contacts(1u << 30));
  });
}

}  // namespace
}  // namespace quoin::booleans::testing
