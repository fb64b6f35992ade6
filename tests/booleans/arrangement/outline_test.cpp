#include "booleans/arrangement/outline.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "tests/booleans/arrangement/bundles.h"
#include "tests/booleans/arrangement/sketch.h"
#include "tests/booleans/stages.h"

namespace quoin::booleans::testing {
namespace {

using exact::Rational;
using Place = Sketch::Place;
using RationalPlace = Sketch::RationalPlace;

/// "from - to: where it is split, face and change of its cover", then the points.
std::vector<std::string> lines_of(const Sketch& sketch, const Outline& outline) {
  std::vector<std::string> lines;
  for (std::uint32_t i = 0; i < outline.segments.size(); ++i) {
    const Outline::Segment& s = outline.segments[i];
    std::string line = text_of(sketch.place(s.a)) + " - " + text_of(sketch.place(s.b)) + ":";
    std::set<RationalPlace> splits;
    for (const Outline::Split& split : outline.splits)
      if (split.segment == i) splits.insert(sketch.place(split.vertex.named()));
    for (const RationalPlace& p : splits) line += " " + text_of(p);
    for (std::uint32_t c = outline.change_start[i]; c < outline.change_start[i + 1]; ++c)
      line += ", face " + std::to_string(outline.changes[c].face.value) + (outline.changes[c].by > 0 ? " +" : " ") +
              std::to_string(outline.changes[c].by);
    lines.push_back(line);
  }
  for (const VertexId v : outline.points) lines.push_back("point " + text_of(sketch.place(v)));
  std::sort(lines.begin(), lines.end());
  return lines;
}

// On the first segment: one crosses, one ends, one overlaps its end, one lies in it up to a common end, one touches its
// end, one crosses two of them between grid points. Points on it and on an end.
TEST(Outline, SegmentsThatCrossTouchAndOverlap) {
  Sketch sketch;
  sketch.add_segment({0, 0}, {6, 0});
  sketch.add_segment({2, 1}, {2, -1});
  sketch.add_segment({4, 0}, {4, 3});
  sketch.add_segment({5, 0}, {9, 0});
  sketch.add_segment({0, 0}, {3, 0});
  sketch.add_segment({3, 0}, {0, 0});
  sketch.add_segment({0, 0}, {0, 5});
  sketch.add_segment({1, -1}, {2, 1});
  for (const Place& p : {Place{1, 0}, Place{6, 0}, Place{7, 7}, Place{1, 0}}) sketch.add_point(p);
  const Outline outline = sketch.outline();
  EXPECT_EQ(lines_of(sketch, outline), (std::vector<std::string>{
                                           "(0, 0) - (0, 5):",
                                           "(0, 0) - (3, 0): (1, 0) (3/2, 0) (2, 0)",
                                           "(0, 0) - (6, 0): (1, 0) (3/2, 0) (2, 0) (3, 0) (4, 0) (5, 0)",
                                           "(1, -1) - (2, 1): (3/2, 0)",
                                           "(2, -1) - (2, 1): (2, 0)",
                                           "(4, 0) - (4, 3):",
                                           "(5, 0) - (9, 0): (6, 0)",
                                           "point (1, 0)",
                                           "point (6, 0)",
                                           "point (7, 7)",
                                       }));
  EXPECT_TRUE(outline.new_points.empty());
}

// Two squares side by side that look in opposite directions, a third face on half of the first, a dot, a contact along
// an edge: a face covers what is on the left of +1, and on the right of -1, whichever way it looks.
TEST(Outline, FacesBeginAndEndAtTheirEdges) {
  Sketch sketch;
  sketch.add_face({{{0, 0}, {2, 0}, {2, 2}, {0, 2}}}, true, {{1, 1}});
  sketch.add_face({{{2, 0}, {4, 0}, {4, 2}, {2, 2}}}, false);
  sketch.add_face({{{0, 0}, {2, 0}, {2, 2}}}, false);
  sketch.add_segment({4, 2}, {4, 0});
  EXPECT_EQ(lines_of(sketch, sketch.outline()), (std::vector<std::string>{
                                                    "(0, 0) - (0, 2):, face 0 -1",
                                                    "(0, 0) - (2, 0):, face 0 +1, face 2 +1",
                                                    "(0, 0) - (2, 2): (1, 1), face 2 -1",
                                                    "(0, 2) - (2, 2):, face 0 -1",
                                                    "(2, 0) - (2, 2):, face 0 +1, face 1 -1, face 2 +1",
                                                    "(2, 0) - (4, 0):, face 1 +1",
                                                    "(2, 2) - (4, 2):, face 1 -1",
                                                    "(4, 0) - (4, 2):, face 1 +1",
                                                    "point (1, 1)",
                                                }));
}

using Segment = std::array<RationalPlace, 2>;

RationalPlace operator-(const RationalPlace& p, const RationalPlace& q) { return {p[0] - q[0], p[1] - q[1]}; }
Rational cross(const RationalPlace& p, const RationalPlace& q) { return p[0] * q[1] - p[1] * q[0]; }
Rational dot(const RationalPlace& p, const RationalPlace& q) { return p[0] * q[0] + p[1] * q[1]; }

/// Is a point strictly inside a segment?
bool inside(const Segment& s, const RationalPlace& p) {
  const RationalPlace along = s[1] - s[0];
  return cross(along, p - s[0]) == 0 && dot(along, p - s[0]) > 0 && dot(along, p - s[1]) < 0;
}

/// The places strictly inside s that t gives it: the ends of t, and where both cross.
std::set<RationalPlace> splits_by(const Segment& s, const Segment& t) {
  std::set<RationalPlace> all;
  for (const RationalPlace& end : t)
    if (inside(s, end)) all.insert(end);
  const RationalPlace u = s[1] - s[0], v = t[1] - t[0];
  const Rational det = cross(u, v);
  if (det == 0) return all;
  const Rational at = cross(t[0] - s[0], v) / det;
  const RationalPlace p{s[0][0] + at * u[0], s[0][1] + at * u[1]};
  if (inside(s, p) && inside(t, p)) all.insert(p);
  return all;
}

/// Adds segments and points, and compares the splits with those of all pairs; equal places have one name. How many
/// there are.
std::size_t expect_splits_of_all_pairs(Sketch& sketch, const std::vector<std::array<Place, 2>>& segments,
                                       const std::vector<Place>& points) {
  std::map<Segment, std::set<RationalPlace>> expected, found;
  for (const auto& [p, q] : segments) {
    sketch.add_segment(p, q);
    expected[{RationalPlace{std::min(p, q)[0], std::min(p, q)[1]}, {std::max(p, q)[0], std::max(p, q)[1]}}];
  }
  for (const Place& p : points) sketch.add_point(p);
  std::size_t splits = 0;
  for (auto& [s, places] : expected) {
    for (const auto& [t, _] : expected) places.merge(splits_by(s, t));
    for (const Place& p : points)
      if (const RationalPlace at{p[0], p[1]}; inside(s, at)) places.insert(at);
    splits += places.size();
  }

  const Outline outline = sketch.outline();
  std::vector<std::set<RationalPlace>> places(outline.segments.size());
  std::map<RationalPlace, VertexId> names;
  for (const Outline::Split& s : outline.splits) {
    const VertexId v = s.vertex.named();
    const RationalPlace p = sketch.place(v);
    EXPECT_EQ(names.try_emplace(p, v).first->second, v);
    places[s.segment].insert(p);
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    const RationalPlace p = sketch.place(outline.segments[i].a), q = sketch.place(outline.segments[i].b);
    EXPECT_TRUE(found.try_emplace({std::min(p, q), std::max(p, q)}, places[i]).second);
  }
  EXPECT_EQ(found, expected);
  return splits;
}

/// Random segments and points against rationals, pair by pair.
TEST(Outline, SplitsAreThoseOfAllPairs) {
  std::size_t splits = 0;
  for (std::uint64_t number = 0; number < case_count(60); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0x0071, number);
    const WithThresholds thresholds(grid::testing::with(&grid::Thresholds::few_segments, random.one_in(2) ? 0u : 24u));
    const bool far = random.one_in(3);
    Sketch sketch = far ? Sketch() : any_sketch(random);
    const std::vector<std::int64_t> scale = far ? far_scale() : any_scale(random);

    std::vector<std::array<Place, 2>> segments;
    for (std::uint64_t n = random.between(2, 35); n > 0; --n) {
      const Place p = any_place(random, scale), q = any_place(random, scale);
      if (p != q) segments.push_back({p, q});
    }
    std::vector<Place> points;
    for (std::uint64_t n = random.below(8); n > 0; --n) points.push_back(any_place(random, scale));
    splits += expect_splits_of_all_pairs(sketch, segments, points);
  }
  EXPECT_GT(splits, 20 * case_count(60));
}

// Segments from one point, which may lie on each other, and others whose boxes all overlap.
TEST(Outline, SplitsOfBundles) {
  std::size_t splits = 0;
  for (std::uint64_t number = 0; number < case_count(40); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0xB0D1, number);
    const WithThresholds thresholds(random.one_in(2) ? grid::Thresholds::smallest() : grid::Thresholds{});
    Sketch sketch;
    const auto segments = any_bundles(random, random.one_in(2) ? 12 : 5000, 70);
    std::vector<Place> points;
    for (const auto& s : segments)
      if (random.one_in(10)) points.push_back(s[0]);
    splits += expect_splits_of_all_pairs(sketch, segments, points);
  }
  EXPECT_GT(splits, 20 * case_count(40));
}

}  // namespace
}  // namespace quoin::booleans::testing
