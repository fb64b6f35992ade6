#include "booleans/arrangement/contacts.h"

#include <algorithm>
#include <functional>

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

// Many pairs are counted into buckets, few are compared: the same list, ascending and each pair once; and the same
// faces are touched, in the same order.
TEST(Contacts, PairsSortedByCountingAsByComparing) {
  for_families(7301, 60, [](Solids& solids, Random&) {
    const std::vector<Body> bodies{solids.next(), solids.next(), solids.next()};
    const auto with = [&](std::size_t few_keys) {
      const WithThresholds thresholds(grid::testing::with(&grid::Thresholds::few_keys, few_keys));
      const Drawn drawn(bodies);
      const Array<TouchedPair> pairs = touched_pairs(drawn.touched, drawn.pairs);
      std::vector<std::array<std::uint32_t, 2>> list;
      for (const auto& [f, g] : pairs) list.push_back({f.value, g.value});
      for (const FaceId f : drawn.touched.members) list.push_back({f.value, f.value});
      EXPECT_EQ(std::adjacent_find(pairs.begin(), pairs.end(), std::not_fn(std::less<>())), pairs.end());
      return list;
    };
    ASSERT_EQ(with(0), with(std::size_t{1} << 30));
  });
}

// Faces that a line enters and leaves once are met by signs alone, others along the line: with the same contacts.
TEST(Contacts, BySignsAloneAsAlongLines) {
  std::size_t known = 0;
  for_families(0xC0A7, 12, [&](Solids& solids, Random&) {
    const std::vector<Body> bodies{solids.next(), solids.next(), solids.next()};
    const Drawn drawn(bodies);
    for (const ContactSegment& s : drawn.contacts.segments) known += s.at_a != unknown_place;
    const WithThresholds along_lines(grid::testing::with(&grid::Thresholds::large_face, std::uint32_t{0}));
    ASSERT_EQ(sorted_lines(dump(drawn.contacts, drawn.names)), contacts_of(bodies));
  });
  EXPECT_GT(known, 1000u);
}

// An end that is said to lie inside a boundary edge does, and one inside the face lies on no edge.
TEST(Contacts, EndsLieWhereTheyAreSaidTo) {
  for_families(0xE4D5, 12, [&](Solids& solids, Random&) {
    const std::vector<Body> bodies{solids.next(), solids.next()};
    const Drawn d(bodies);
    for (const ContactSegment& s : d.contacts.segments) {
      if (s.at_a == unknown_place) continue;
      const auto on_edge = [&](VertexId v, const BoundaryEdge& e) {
        return d.names.side(v, e.other) == 0 && v != e.from && v != e.to;
      };
      for (const auto& [v, at] : {std::pair(s.a, s.at_a), std::pair(s.b, s.at_b)}) {
        if (at != inside_face) {
          ASSERT_TRUE(on_edge(v, d.touched.edges[at]));
          continue;
        }
        for (const TouchedId t : Ids<TouchedId>(d.touched.faces.size())) {
          if (d.touched.faces[t].plane != s.plane || d.touched.faces[t].operand == s.other) continue;
          for (const BoundaryEdge& e : d.touched.edges_of(t)) ASSERT_TRUE(v != e.from && v != e.to);
        }
      }
    }
  });
}

// Of coinciding faces of two solids, what meets the one is a neighbour of the other: nothing is posted.
TEST(Contacts, CoincidingSolidsMakeNone) {
  const std::vector<Body> boxes{box({0, 0, 0}, {2, 2, 2}), box({0, 0, 0}, {2, 2, 2})};
  EXPECT_TRUE(contacts_of(boxes).empty());
}

// A face may have a twin and be met by faces that have none: those are posted.
TEST(Contacts, TwinsMetByOthers) {
  const std::vector<Body> bodies{box({0, 0, 0}, {4, 4, 4}), box({0, 0, 4}, {4, 4, 8}), box({1, 1, 2}, {2, 2, 6})};
  const auto lines = contacts_of(bodies);
  EXPECT_EQ(std::count_if(lines.begin(), lines.end(),
                          [](const std::string& line) { return line.starts_with("on [0 0 1 -4]"); }),
            8);
}

}  // namespace
}  // namespace quoin::booleans::testing
