#include "booleans/arrangement/segment_tree.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/booleans/arrangement/bundles.h"
#include "tests/booleans/arrangement/sketch.h"
#include "tests/grid/with_thresholds.h"

namespace quoin::booleans::testing {
namespace {

using grid::testing::WithThresholds;
using Place = Sketch::Place;
using PlaceSegment = std::array<Place, 2>;

std::int64_t turn(const Place& a, const Place& b, const Place& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}
int sign(std::int64_t v) { return v > 0 ? 1 : v < 0 ? -1 : 0; }

bool on(const PlaceSegment& s, const Place& p) {
  return turn(s[0], s[1], p) == 0 && std::min(s[0], s[1]) <= p && p <= std::max(s[0], s[1]);
}
bool meet(const PlaceSegment& s, const PlaceSegment& t) {
  const int s0 = sign(turn(t[0], t[1], s[0])), s1 = sign(turn(t[0], t[1], s[1])), t0 = sign(turn(s[0], s[1], t[0])),
            t1 = sign(turn(s[0], s[1], t[1]));
  return (s0 * s1 < 0 && t0 * t1 < 0) || on(s, t[0]) || on(s, t[1]) || on(t, s[0]) || on(t, s[1]);
}

struct Planted {
  explicit Planted(Random& random)
      : sketch(random.one_in(2) ? Sketch() : Sketch({5, 0, 0}, {1, -1, 0}, {0, 1, -1})),
        size(random.one_in(3)   ? 8
             : random.one_in(2) ? 3000
                                : 100000000),
        places(any_bundles(random, size)) {
    if (random.one_in(2)) places.push_back({places[0][0], places[0][0]});
    for (const auto& [p, q] : places) segments.push_back({sketch.vertex(p), sketch.vertex(q)});
  }
  const exact::Plane& plane() const { return sketch.names.planes[sketch.plane]; }

  Sketch sketch;
  std::int64_t size;
  std::vector<PlaceSegment> places;
  Array<SegmentTree::Segment> segments;
};

// Pairs that meet are visited, but for those that share an end that is returned.
TEST(SegmentTree, PairsAreThoseThatMeet) {
  std::size_t pairs = 0, visited = 0, with_hubs = 0;
  for (std::uint64_t number = 0; number < case_count(200); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0x5E67, number);
    const WithThresholds thresholds(random.one_in(2) ? grid::Thresholds::smallest() : grid::Thresholds{});
    const Planted planted(random);
    SegmentTree tree(planted.plane(), planted.segments, planted.sketch.names.vertices);

    std::set<std::array<std::uint32_t, 2>> found;
    const auto hubs = tree.pairs(planted.sketch.names.vertices, [&](std::uint32_t i, std::uint32_t j) {
      ASSERT_TRUE(found.insert({std::min(i, j), std::max(i, j)}).second);
    });
    ASSERT_TRUE(std::is_sorted(hubs.begin(), hubs.end()));
    with_hubs += !hubs.empty();

    const auto share_hub = [&](std::uint32_t i, std::uint32_t j) {
      return std::any_of(hubs.begin(), hubs.end(), [&](VertexId hub) {
        const auto &s = planted.segments[i], &t = planted.segments[j];
        return (s.a == hub || s.b == hub) && (t.a == hub || t.b == hub);
      });
    };
    for (std::uint32_t i = 0; i < planted.segments.size(); ++i)
      for (std::uint32_t j = i + 1; j < planted.segments.size(); ++j)
        ASSERT_TRUE(!meet(planted.places[i], planted.places[j]) || found.contains({i, j}) || share_hub(i, j));
    pairs += planted.segments.size() * (planted.segments.size() - 1) / 2;
    visited += found.size();
  }
  EXPECT_LT(visited, pairs / 2);
  EXPECT_GT(with_hubs, case_count(200) / 10);
}

// What meets a piece of a line is visited, with strips and without.
TEST(SegmentTree, WhatMeetsAPieceOfALine) {
  std::size_t all = 0, visited = 0, with_strips = 0;
  for (std::uint64_t number = 0; number < case_count(200); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0x11FE, number);
    const WithThresholds thresholds(random.one_in(2) ? grid::Thresholds::smallest() : grid::Thresholds{});
    Planted planted(random);
    const VertexTable& vertices = planted.sketch.names.vertices;
    SegmentTree boxes(planted.plane(), planted.segments, vertices), strips = boxes;
    strips.make_strips(vertices);

    const std::vector<PlaceSegment> pieces = any_bundles(random, planted.size);
    for (std::size_t n = 0; n < 20; ++n) {
      const auto& [p, q] = pieces[random.below(pieces.size())];
      planted.sketch.add_segment(p, q);
      const exact::Plane& line = planted.sketch.names.planes[planted.sketch.contacts.segments.back().line];
      std::array<Box, 2> ends;
      vertices.add_to(ends[0], planted.sketch.vertex(p));
      vertices.add_to(ends[1], planted.sketch.vertex(q));

      std::set<std::uint32_t> by_boxes, by_strips;
      boxes.meeting(line, ends, [&](std::uint32_t i) { by_boxes.insert(i); });
      strips.meeting(line, ends, [&](std::uint32_t i) { by_strips.insert(i); });
      ASSERT_TRUE(std::includes(by_boxes.begin(), by_boxes.end(), by_strips.begin(), by_strips.end()));
      for (std::uint32_t i = 0; i < planted.segments.size(); ++i)
        ASSERT_TRUE(!meet(planted.places[i], {p, q}) || by_strips.contains(i));
      all += planted.segments.size();
      visited += by_boxes.size();
      with_strips += by_strips.size();
    }
  }
  EXPECT_LT(visited, all / 2);
  EXPECT_LT(with_strips, visited);
}

}  // namespace
}  // namespace quoin::booleans::testing
