#include "booleans/arrangement/subdivision.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "exact/rational.h"
#include "grid/lists/partition.h"
#include "tests/booleans/arrangement/sketch.h"
#include "tests/booleans/stages.h"

namespace quoin::booleans::testing {
namespace {

using exact::Rational;
using Place = Sketch::Place;
using RationalPlace = Sketch::RationalPlace;

// A plate with a hole, a triangle in the hole that looks the other way, a cut from the hole to the border, a slit, and
// two points: one in the plate, one in the hole, where nothing covers it. The cut does not cut the plate in two.
TEST(Subdivision, PlateWithAHole) {
  Sketch sketch;
  sketch.add_face({{{0, 0}, {6, 0}, {6, 6}, {0, 6}}, {{2, 2}, {2, 5}, {5, 5}, {5, 2}}}, true);
  sketch.add_face({{{3, 3}, {4, 3}, {3, 4}}}, false);
  sketch.add_segment({5, 3}, {6, 3});
  sketch.add_segment({1, 4}, {1, 5});
  sketch.add_point({1, 1});
  sketch.add_point({4, 4});
  EXPECT_EQ(lines_of(dump(sketch.sheets(), sketch.names)), (std::vector<std::string>{
                                                               "sheet [0 0 1 0]",
                                                               "  facet 0 of 0",
                                                               "    (0, 0, 0) -> (6, 0, 0)",
                                                               "    (0, 6, 0) -> (0, 0, 0)",
                                                               "    (6, 0, 0) -> (6, 3, 0)",
                                                               "    (6, 6, 0) -> (0, 6, 0)",
                                                               "    (2, 2, 0) -> (2, 5, 0)",
                                                               "    (5, 2, 0) -> (2, 2, 0)",
                                                               "    (2, 5, 0) -> (5, 5, 0)",
                                                               "    (5, 3, 0) -> (5, 2, 0)",
                                                               "    (5, 5, 0) -> (5, 3, 0)",
                                                               "    (5, 3, 0) -> (6, 3, 0)",
                                                               "    (6, 3, 0) -> (5, 3, 0)",
                                                               "    (6, 3, 0) -> (6, 6, 0)",
                                                               "    (1, 4, 0) -> (1, 5, 0)",
                                                               "    (1, 5, 0) -> (1, 4, 0)",
                                                               "  facet 1 of 1",
                                                               "    (3, 3, 0) -> (4, 3, 0)",
                                                               "    (3, 4, 0) -> (3, 3, 0)",
                                                               "    (4, 3, 0) -> (3, 4, 0)",
                                                               "  point (1, 1, 0) in facet 0",
                                                           }));
}

// An arch between two chains of many elements, y = x (24 - x) and nine more, on a plate that covers everything: points
// below it, within it and above it, where the chains turn and between.
TEST(Subdivision, PointsBelowAndAboveLongChains) {
  const auto height = [](std::int64_t x) { return x * (24 - x); };
  Sketch::Loop arch;
  for (std::int64_t x = 0; x <= 24; x += 2) arch.push_back({x, height(x)});
  for (std::int64_t x = 24; x >= 0; x -= 2) arch.push_back({x, height(x) + 9});

  Sketch sketch;
  sketch.add_face({{{-9, -9}, {30, -9}, {30, 200}, {-9, 200}}}, true);
  sketch.add_face({arch}, false);
  std::map<RationalPlace, std::size_t> covers;
  for (const std::int64_t x : {1, 13, 14, 22})
    for (const std::int64_t above : {-4, 4, 12}) {
      sketch.add_point({x, height(x) + above});
      covers[{x, height(x) + above}] = above == 4 ? 2 : 1;
    }

  const Sheets sheets = sketch.sheets();
  const Sheet& sheet = sheets[SheetId(0)];
  EXPECT_EQ(sheet.facet_count(), 2u);
  std::map<RationalPlace, std::size_t> found;
  for (const Sheet::Isolated& i : sheet.isolated) found[sketch.place(i.vertex)] = sheet.covers(i.facet).size();
  EXPECT_EQ(found, covers);
}

Rational dot(const RationalPlace& p, const RationalPlace& q) { return p[0] * q[0] + p[1] * q[1]; }
Rational cross(const RationalPlace& p, const RationalPlace& q) { return p[0] * q[1] - p[1] * q[0]; }

/// Just left of a place on a line that runs `along`. Its ray runs to the left, infinitely little ahead of the place.
class Spot {
 public:
  Spot(const RationalPlace& at, const RationalPlace& along)
      : along_(along), ahead_(dot(along, at)), left_(cross(along, at)) {}

  /// How far a place is ahead, and to the left.
  Rational ahead(const RationalPlace& p) const { return dot(along_, p) - ahead_; }
  Rational left(const RationalPlace& p) const { return cross(along_, p) - left_; }

 private:
  RationalPlace along_;
  Rational ahead_, left_;
};

/// Where a ray crosses a segment; nearer ones come first.
struct Crossing {
  Rational distance, slope;
  bool forward;  // the segment has the spot on its left

  bool operator<(const Crossing& c) const { return distance != c.distance ? distance < c.distance : slope < c.slope; }
};

std::optional<Crossing> crossing(const Spot& spot, const RationalPlace& p, const RationalPlace& q) {
  const Rational at_p = spot.ahead(p), at_q = spot.ahead(q);
  if ((at_p > 0) == (at_q > 0)) return std::nullopt;
  const Rational slope = (spot.left(q) - spot.left(p)) / (at_q - at_p), distance = spot.left(p) - slope * at_p;
  if (distance <= 0) return std::nullopt;
  return Crossing{distance, slope, at_p > 0};
}

/// A sheet, what it was drawn from, and its places, counter-clockwise as seen from the canonical normal.
class Picture {
 public:
  template <class PlaceOf>
  Picture(const Touched& touched, const Sheet& sheet, PlaceOf&& place_of) : sheet_(sheet) {
    for (std::uint32_t h = 0; h < sheet.half_edges(); ++h) origin_.push_back(place_of(sheet.origin(h)));
    for (const Sheet::Isolated& i : sheet.isolated) isolated_.push_back(place_of(i.vertex));
    for (const TouchedId t : Ids<TouchedId>(touched.faces.size())) {
      const TouchedFace& face = touched.faces[t];
      if (face.plane != sheet.plane) continue;
      auto& edges = faces_.emplace_back(t, std::vector<Edge>()).second;
      for (const BoundaryEdge& e : touched.edges_of(t))
        edges.push_back({place_of(face.along ? e.from : e.to), place_of(face.along ? e.to : e.from)});
    }
  }

  /// What is on the left of each half-edge, and around each isolated point, by rays.
  void expect_facets() const {
    for (std::uint32_t h = 0; h < sheet_.half_edges(); ++h) {
      const RationalPlace &p = origin_[h], &q = origin_[h ^ 1];
      const Spot spot({(p[0] + q[0]) / 2, (p[1] + q[1]) / 2}, {q[0] - p[0], q[1] - p[1]});
      ASSERT_NO_FATAL_FAILURE(expect_facet(spot, sheet_.facet[h]));
    }
    for (std::size_t i = 0; i < isolated_.size(); ++i)
      ASSERT_NO_FATAL_FAILURE(expect_facet(Spot(isolated_[i], {1, 0}), sheet_.isolated[i].facet));
  }
  /// Each facet has an area; those of all facets, as often as they are covered, sum to those of the faces.
  void expect_areas() const {
    std::vector<Rational> areas(sheet_.facet_count());
    for (std::uint32_t h = 0; h < sheet_.half_edges(); ++h)
      if (sheet_.facet[h] != none) areas[sheet_.facet[h].value] += cross(origin_[h], origin_[h ^ 1]);

    Rational facets = 0, faces = 0;
    for (const FacetId f : Ids<FacetId>(sheet_.facet_count())) {
      ASSERT_GT(areas[f.value], 0);
      facets += areas[f.value] * sheet_.covers(f).size();
    }
    for (const auto& [t, edges] : faces_)
      for (const Edge& e : edges) faces += cross(e[0], e[1]);
    EXPECT_EQ(facets, faces);
  }
  /// V - E + F = 1 + C, where a face covers all but the outside.
  void expect_euler() const {
    std::set<VertexId> vertices;
    for (std::uint32_t h = 0; h < sheet_.half_edges(); ++h) vertices.insert(sheet_.origin(h));
    for (const Sheet::Isolated& i : sheet_.isolated) ASSERT_TRUE(vertices.insert(i.vertex).second);

    std::size_t components = vertices.size();
    grid::Partition together(vertices.empty() ? 0 : vertices.rbegin()->value + 1);
    for (const Sheet::Element& e : sheet_.elements) {
      components -= together.find(e.a.value) != together.find(e.b.value);
      together.unite(e.a.value, e.b.value);
    }
    EXPECT_EQ(vertices.size() + sheet_.facet_count() + 1, sheet_.elements.size() + 1 + components);
  }

 private:
  using Edge = std::array<RationalPlace, 2>;

  /// The same faces cover facet and spot, and the facet is that on the near side of what the ray meets first.
  void expect_facet(const Spot& spot, FacetId facet) const {
    std::vector<TouchedId> expected;
    for (const auto& [t, edges] : faces_) {
      int times = 0;
      for (const Edge& e : edges)
        if (const auto c = crossing(spot, e[0], e[1])) times += c->forward ? 1 : -1;
      expected.insert(expected.end(), static_cast<std::size_t>(times), t);
    }
    const auto found = facet == none ? std::span<const TouchedId>() : sheet_.covers(facet);
    ASSERT_EQ(std::vector<TouchedId>(found.begin(), found.end()), expected);

    std::optional<Crossing> first;
    FacetId seen = none;
    for (std::uint32_t e = 0; e < sheet_.elements.size(); ++e) {
      const auto c = crossing(spot, origin_[2 * e], origin_[2 * e + 1]);
      if (!c || (first && !(*c < *first))) continue;
      first = c;
      seen = sheet_.facet[2 * e + (c->forward ? 0 : 1)];
    }
    ASSERT_EQ(facet, seen);
  }

  const Sheet& sheet_;
  std::vector<RationalPlace> origin_, isolated_;                // by half-edge, by isolated point
  std::vector<std::pair<TouchedId, std::vector<Edge>>> faces_;  // on the left of their edges
};

using Loop = Sketch::Loop;

/// Counter-clockwise; nothing when it is flat.
std::optional<Loop> any_triangle(Random& random, const std::vector<std::int64_t>& scale) {
  Loop t{any_place(random, scale), any_place(random, scale), any_place(random, scale)};
  const exact::int128 area =
      exact::int128(t[1][0] - t[0][0]) * (t[2][1] - t[0][1]) - exact::int128(t[1][1] - t[0][1]) * (t[2][0] - t[0][0]);
  if (area < 0) std::swap(t[1], t[2]);
  return area != 0 ? std::optional(t) : std::nullopt;
}
Loop rectangle(const Place& low, const Place& high) { return {low, {high[0], low[1]}, high, {low[0], high[1]}}; }
Loop turned_round(Loop loop) {
  std::reverse(loop.begin(), loop.end());
  return loop;
}

/// Triangles, perhaps two or with a slit, and rectangles, perhaps with a hole that may touch the border.
std::vector<Loop> any_loops(Random& random, const std::vector<std::int64_t>& scale) {
  std::vector<Loop> loops;
  if (random.one_in(2)) {
    for (std::uint64_t n = 1 + random.below(2); n > 0; --n)
      if (const auto t = any_triangle(random, scale)) loops.push_back(*t);
    if (random.one_in(3))
      if (const Place p = any_place(random, scale), q = any_place(random, scale); p != q) loops.push_back({p, q});
    return loops;
  }

  std::array<std::vector<std::int64_t>, 2> at;  // four coordinates in order, the inner ones different
  for (auto& x : at)
    while (x.size() < 4 || x[1] == x[2]) {
      x.clear();
      for (int i = 0; i < 4; ++i) x.push_back(scale[random.below(scale.size())]);
      std::sort(x.begin(), x.end());
    }
  loops.push_back(rectangle({at[0][0], at[1][0]}, {at[0][3], at[1][3]}));
  if (random.one_in(2)) loops.push_back(turned_round(rectangle({at[0][1], at[1][1]}, {at[0][2], at[1][2]})));
  return loops;
}

// Faces of all sorts, contacts and points, in a frame that covers everything: each half-edge and each isolated point is
// in the facet that rays find there, facets are as many as Euler says, and tile the faces.
TEST(Subdivision, FacetsAreWhatRaysFind) {
  std::size_t facets = 0, isolated = 0;
  for (std::uint64_t number = 0; number < case_count(40); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0x5D17, number);
    const bool far = random.one_in(3);
    Sketch sketch = far ? Sketch() : any_sketch(random);
    const std::vector<std::int64_t> scale = far ? far_scale() : any_scale(random);
    const std::int64_t low = scale.front() - 1, high = scale.back() + 1;
    sketch.add_face({rectangle({low, low}, {high, high})}, random.one_in(2));
    for (std::uint64_t n = random.below(6); n > 0; --n) {
      const auto loops = any_loops(random, scale);
      const bool along = random.one_in(2);
      sketch.add_face(loops, along, {any_place(random, scale)});
    }
    for (std::uint64_t n = random.below(10); n > 0; --n)
      if (const Place p = any_place(random, scale), q = any_place(random, scale); p != q) sketch.add_segment(p, q);
    for (std::uint64_t n = random.below(5); n > 0; --n) sketch.add_point(any_place(random, scale));

    const Sheets sheets = sketch.sheets();
    ASSERT_EQ(sheets.size(), 1u);
    const Sheet& sheet = sheets[SheetId(0)];
    const Picture picture(sketch.touched, sheet, [&](VertexId v) { return sketch.place(v); });
    ASSERT_NO_FATAL_FAILURE(picture.expect_facets());
    picture.expect_areas();
    picture.expect_euler();

    std::set<VertexId> alone(sketch.touched.isolated.begin(), sketch.touched.isolated.end()), listed;
    for (const ContactPoint& p : sketch.contacts.points) alone.insert(p.vertex);
    for (std::uint32_t h = 0; h < sheet.half_edges(); ++h) alone.erase(sheet.origin(h));
    for (const Sheet::Isolated& i : sheet.isolated) listed.insert(i.vertex);
    ASSERT_EQ(listed, alone);
    facets += sheet.facet_count();
    isolated += listed.size();
  }
  EXPECT_GT(facets, 10 * case_count(40));
  EXPECT_GT(isolated, case_count(40));
}

// The same of sheets of solids; areas along the axis in which the normal is longest.
TEST(Subdivision, FacetsTileTheFacesOfSolids) {
  for_families(0x5EE7, 12, [](Solids& solids, Random&) {
    const Body a = solids.next(), b = solids.next(), c = solids.next();
    const std::vector<Body> bodies{odd(a, b), c, b};
    const Drawn drawn(bodies);
    for (const Sheet& sheet : drawn.sheets) {
      const exact::Plane& plane = drawn.names.planes[sheet.plane];
      const std::size_t axis = exact::longest_component(plane.n);
      const int i = static_cast<int>((axis + 1) % 3), j = static_cast<int>((axis + 2) % 3);
      const auto place = [&](VertexId v) {
        const exact::Point p = drawn.names.vertices.point(v);
        const Rational x = exact::coordinate(p, i), y = exact::coordinate(p, j);
        return plane.n[axis] > 0 ? RationalPlace{x, y} : RationalPlace{y, x};
      };
      const Picture picture(drawn.touched, sheet, place);
      ASSERT_NO_FATAL_FAILURE(picture.expect_facets());
      picture.expect_areas();
    }
  });
}

}  // namespace
}  // namespace quoin::booleans::testing
