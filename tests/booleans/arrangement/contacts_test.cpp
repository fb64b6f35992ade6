#include "booleans/arrangement/contacts.h"

#include <gtest/gtest.h>

#include "tests/booleans/stages.h"

namespace quoin::booleans::testing {
namespace {

std::vector<std::string> contacts_of(const std::vector<Body>& bodies) {
  const Drawn drawn(bodies);
  return sorted_lines(dump(drawn.contacts, drawn.names));
}

// Each face of one cube that reaches into the other meets two faces of that one; both sheets get the segment.
TEST(Contacts, CornerOfACubeInACube) {
  const std::vector<Body> bodies{box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3})};
  EXPECT_EQ(contacts_of(bodies), (std::vector<std::string>{
                                     "on [0 0 1 -1]: (1, 2, 1) - (2, 2, 1)",
                                     "on [0 0 1 -1]: (2, 1, 1) - (2, 2, 1)",
                                     "on [0 0 1 -2]: (1, 1, 2) - (1, 2, 2)",
                                     "on [0 0 1 -2]: (1, 1, 2) - (2, 1, 2)",
                                     "on [0 1 0 -1]: (1, 1, 2) - (2, 1, 2)",
                                     "on [0 1 0 -1]: (2, 1, 1) - (2, 1, 2)",
                                     "on [0 1 0 -2]: (1, 2, 1) - (1, 2, 2)",
                                     "on [0 1 0 -2]: (1, 2, 1) - (2, 2, 1)",
                                     "on [1 0 0 -1]: (1, 1, 2) - (1, 2, 2)",
                                     "on [1 0 0 -1]: (1, 2, 1) - (1, 2, 2)",
                                     "on [1 0 0 -2]: (2, 1, 1) - (2, 1, 2)",
                                     "on [1 0 0 -2]: (2, 1, 1) - (2, 2, 1)",
                                 }));
}

// A tip that only touches a face is a point on the sheets of all that meet in it.
TEST(Contacts, TipOnAFace) {
  const std::vector<Body> bodies{box({-4, -4, -4}, {4, 4, 0}),
                                 *tetrahedron({{{0, 0, 0}, {2, 0, 2}, {0, 2, 2}, {-2, -2, 2}}})};
  const auto lines = contacts_of(bodies);
  EXPECT_EQ(lines.size(), 6u);
  for (const std::string& line : lines) EXPECT_NE(line.find(": (0, 0, 0)"), std::string::npos) << line;
}

// Two faces on one plane have no contacts: their sheet draws both.
TEST(Contacts, FacesOnOnePlane) {
  const std::vector<Body> bodies{box({0, 0, 0}, {2, 2, 2}), box({0, 0, 2}, {2, 2, 4})};
  for (const std::string& line : contacts_of(bodies))
    EXPECT_EQ(line.find("on [0 0 1 -2]: (0, 0, 2) - (2, 2, 2)"), std::string::npos);
}

// A face of many edges is asked through a tree; a hole of it may hold the other face, and then nothing meets.
TEST(Contacts, BarThroughTheHoleOfAFaceOfManyEdges) {
  const WithThresholds thresholds(grid::testing::with(&grid::Thresholds::large_face, std::uint32_t{4}));
  const Body plate = minus(box({0, 0, 0}, {10, 10, 1}), box({2, 2, -1}, {8, 8, 2}));
  EXPECT_TRUE(contacts_of({plate, box({4, 4, -3}, {5, 5, 3})}).empty());
  EXPECT_FALSE(contacts_of({plate, box({1, 4, -3}, {3, 5, 3})}).empty());
}

}  // namespace
}  // namespace quoin::booleans::testing
