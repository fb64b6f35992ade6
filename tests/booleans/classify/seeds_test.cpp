#include "booleans/classify/seeds.h"

#include <gtest/gtest.h>

#include <set>

#include "booleans/body/locate.h"
#include "booleans/classify/selection.h"
#include "grid/lists/partition.h"
#include "tests/booleans/lattice_regions.h"
#include "tests/booleans/stages.h"

namespace quoin::booleans::testing {
namespace {

/// Nodes that hang together over edges, numbered in their order.
Components components_of(const Arrangement& a) {
  grid::Partition nodes(a.node_count());
  a.uses.for_edges([&](VertexId, std::span<const Use> uses) {
    for (const Use& u : uses) nodes.unite(uses[0].node().value, u.node().value);
  });
  Components components;
  std::map<std::uint32_t, ComponentId> id;
  for (const NodeId n : Ids<NodeId>(a.node_count()))
    components.of.push_back(id.try_emplace(nodes.find(n.value), static_cast<std::uint32_t>(id.size())).first->second);
  components.count = static_cast<std::uint32_t>(id.size());
  return components;
}

/// Those without faces: a far patch may have none, as touched faces reach far.
ById<ComponentId, std::uint8_t> empty_components(const Arrangement& a, const Components& components) {
  ById<ComponentId, std::uint8_t> is_empty(components.count, 1);
  for (const NodeId n : Ids<NodeId>(a.sheets.facet_count())) is_empty[components.of[n]] = 0;
  a.for_untouched([&](FaceId, NodeId n) { is_empty[components.of[n]] = 0; });
  return is_empty;
}
/// One for each component that has faces, in their order, far patches or not.
ById<ComponentId, Seed> all_seeds(const Arrangement& a, const Components& components) {
  const auto is_empty = empty_components(a, components);
  const std::vector<Seed> found = find_seeds(a, components, is_empty);
  ById<ComponentId, Seed> seeds;
  std::size_t next = 0;
  for (const bool empty : is_empty) seeds.push_back(empty ? Seed{} : found.at(next++));
  EXPECT_EQ(next, found.size());
  return seeds;
}

/// "behind [a b c d]", the canonical plane of a facet, "before patch 8", or "infinity".
std::string text_of(const Arrangement& a, SideId s) {
  if (s == none) return "infinity";
  const NodeId n = node_of(s);
  const std::string side = is_back(s) ? "behind " : "before ";
  if (!a.sheets.is_facet(n)) return side + "patch " + std::to_string(n.value);
  const exact::Plane& p = a.names.planes[a.sheets[a.sheets.sheet_of(n)].plane];
  std::string text = side + "[";
  for (const std::int64_t x : p.n) text += std::to_string(x) + " ";
  return text + std::to_string(static_cast<std::int64_t>(p.d)) + "]";
}
std::vector<std::string> seeds_of(const std::vector<Body>& bodies) {
  const Arrangement a = arranged(bodies);
  std::vector<std::string> text;
  for (const Seed& s : all_seeds(a, components_of(a)))
    text.push_back(text_of(a, s.outer) + ": " + text_of(a, s.beyond));
  return text;
}

// Two tetrahedra with a common first corner, one above the other, in a cube: the ray of the upper one comes down on the
// lower one, whose own ray comes down on the cube's bottom from within.
TEST(Seeds, TetrahedraWithACommonCorner) {
  const std::vector<Body> bodies{*tetrahedron({{{0, 0, 0}, {4, 1, 0}, {4, 2, 0}, {4, 1, 2}}}),
                                 *tetrahedron({{{0, 0, 0}, {4, -2, -1}, {4, -1, -1}, {4, -2, 3}}}),
                                 box({-5, -9, -5}, {9, 9, 9})};
  EXPECT_EQ(seeds_of(bodies),
            (std::vector<std::string>{"behind [0 0 1 0]: before [5 16 4 0]", "behind [1 0 4 0]: behind patch 8",
                                      "before patch 8: infinity"}));
}

// Rays that begin straight above corners and edges of boxes below: they are shifted towards larger x and z, so that
// they meet a box that begins there and miss one that ends there.
TEST(Seeds, RaysAlongBordersAreShifted) {
  const std::vector<Body> bodies{box({0, 0, 0}, {2, 2, 2}), box({2, -9, 2}, {4, -7, 4}), box({2, 5, 2}, {3, 6, 3}),
                                 box({1, 8, 2}, {2, 9, 3})};
  EXPECT_EQ(seeds_of(bodies), (std::vector<std::string>{"before patch 0: infinity", "before patch 1: infinity",
                                                        "before patch 2: before patch 1", "before patch 3: infinity"}));
}

using Corners = std::array<Vector, 2>;

bool are_apart(const Corners& p, const Corners& q) {
  for (std::size_t k = 0; k < 3; ++k)
    if (p[1][k] < q[0][k] || q[1][k] < p[0][k]) return true;
  return false;
}
bool is_within(const Corners& p, const Corners& q) {
  for (std::size_t k = 0; k < 3; ++k)
    if (p[0][k] <= q[0][k] || p[1][k] >= q[1][k]) return false;
  return true;
}

/// Boxes within boxes and beside each other, none touching.
std::vector<Corners> any_boxes(Random& random) {
  std::vector<Corners> boxes;
  for (int tries = 0; tries < 60; ++tries) {
    const Vector low = random.vector(-20, 20), size = random.vector(1, random.one_in(3) ? 20 : 4);
    const Corners next{low, low + size};
    if (std::all_of(boxes.begin(), boxes.end(),
                    [&](const Corners& b) { return are_apart(b, next) || is_within(b, next) || is_within(next, b); }))
      boxes.push_back(next);
  }
  return boxes;
}

/// What a ray from the low corner of a box towards -y, a little further in x and z, meets first.
SideId below(const std::vector<Corners>& boxes, std::size_t from, const std::vector<NodeId>& node_of_box) {
  const Vector start = boxes[from][0];
  SideId hit = none;
  std::int64_t highest = -100;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const auto& [low, high] = boxes[i];
    if (i == from || start[0] < low[0] || start[0] >= high[0] || start[2] < low[2] || start[2] >= high[2]) continue;
    for (const bool top : {true, false}) {
      const std::int64_t y = top ? high[1] : low[1];
      if (y >= start[1] || y < highest) continue;
      highest = y;
      hit = top ? front_of(node_of_box[i]) : back_of(node_of_box[i]);
    }
  }
  return hit;
}

// A box is seen from its low corner; what is next to it is known by comparing numbers. A union keeps the boxes that lie
// in no other.
TEST(Seeds, BoxesWithinBoxes) {
  for (std::uint64_t number = 0; number < case_count(40); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0x5EED, number);
    const std::vector<Corners> boxes = any_boxes(random);
    std::vector<Body> bodies;
    for (const Corners& b : boxes) bodies.push_back(box(b[0], b[1]));
    const Arrangement a = arranged(bodies);
    std::vector<NodeId> node_of_box;
    for (std::uint32_t o = 0; o < bodies.size(); ++o) node_of_box.push_back(a.patches().of[a.operands.face(o, 0)]);

    const auto seeds = all_seeds(a, components_of(a));
    ASSERT_EQ(seeds.size(), boxes.size());
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      EXPECT_EQ(seeds[i].outer, front_of(node_of_box[i]));
      EXPECT_EQ(seeds[i].beyond, below(boxes, i, node_of_box));
    }

    const Selection s =
        select(a, find_cells(a), Expression::flat(Rule::any, static_cast<std::uint32_t>(bodies.size())));
    for (std::uint32_t o = 0; o < bodies.size(); ++o) {
      const bool is_hidden =
          std::any_of(boxes.begin(), boxes.end(), [&](const Corners& b) { return is_within(boxes[o], b); });
      for (std::uint32_t f = 0; f < bodies[o].face_count(); ++f)
        EXPECT_EQ(int{s.kept[a.patches().of[a.operands.face(o, f)]]}, is_hidden ? 0 : 1);
    }
  }
}

using exact::Rational;

/// The facet or patch that a raw triangle is, which nothing cuts.
NodeId node_of_face(const Arrangement& a, FaceId f) {
  if (!a.touched.is_touched(f)) return a.patches().of[f];
  for (const NodeId n : Ids<NodeId>(a.sheets.facet_count()))
    for (const TouchedId t : a.sheets[a.sheets.sheet_of(n)].covers(a.sheets.facet_of(n)))
      if (t == a.touched.touched_of[f]) return n;
  return none;
}

/// The side that the ray from s towards -y meets first, by rationals; nothing of it is degenerate.
SideId first_hit(const Arrangement& a, const std::array<Rational, 3>& s) {
  SideId hit = none;
  Rational highest;
  for (const FaceId f : Ids<FaceId>(a.operands.face_count())) {
    const auto [operand, face] = a.operands.own(f);
    const Body& body = a.operands[operand];
    std::array<std::array<Rational, 3>, 3> p;  // corners, seen from s
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k) p[i][k] = body.grid_points[body.triangles[face][i]].c[k] - s[k];

    std::array<Rational, 3> weight;  // of each corner, as seen along y
    for (std::size_t i = 0; i < 3; ++i) {
      const auto &q = p[(i + 1) % 3], &r = p[(i + 2) % 3];
      weight[i] = q[2] * r[0] - q[0] * r[2];
    }
    const bool up = weight[0] > 0;  // its outward normal has y > 0
    if (weight[0] == 0 || (weight[1] > 0) != up || (weight[2] > 0) != up) continue;

    const Rational y =
        (weight[0] * p[0][1] + weight[1] * p[1][1] + weight[2] * p[2][1]) / (weight[0] + weight[1] + weight[2]);
    if (y >= 0 || (hit != none && y < highest)) continue;
    highest = y;
    const NodeId n = node_of_face(a, f);
    const bool turned = a.sheets.is_facet(n) && !exact::is_canonical(body.plane(face));
    hit = up != turned ? front_of(n) : back_of(n);
  }
  return hit;
}

// Tetrahedra with a common first corner, one above the other like a fan, perhaps in a box. From next to its lowest edge
// each one sees what a ray from s = t d - t^2 y - t^3 z + t^4 x meets for a small t.
TEST(Seeds, FanOfTetrahedraWithACommonCorner) {
  constexpr std::int64_t size = 12;
  std::size_t joined = 0;
  for (std::uint64_t number = 0; number < case_count(60); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0x5EEF, number);
    std::vector<Body> bodies;
    std::vector<Vector> lowest;  // the edge of each from the corner
    for (std::int64_t slope = -3; slope < 4; ++slope) {
      std::array<Vector, 4> p{};
      for (std::size_t i = 1; i < 4; ++i) {
        const std::int64_t x = random.between(2, size);
        p[i] = {x, slope * x + random.between(1, x - 1), random.between(-size, size)};
      }
      const auto body = tetrahedron(p);
      if (!body) continue;
      bodies.push_back(*body);
      lowest.push_back(*std::min_element(p.begin() + 1, p.end(), [](const Vector& d, const Vector& e) {
        if (d[1] * e[0] != e[1] * d[0]) return d[1] * e[0] < e[1] * d[0];
        return d[2] * e[0] < e[2] * d[0];
      }));
    }
    if (random.one_in(2)) bodies.push_back(box({-1, -99, -99}, {99, 99, 99}));

    const Arrangement a = arranged(bodies);
    const auto components = components_of(a);
    const auto seeds = all_seeds(a, components);
    for (std::uint32_t o = 0; o < lowest.size(); ++o) {
      const Rational t(1, 1'000'000'000);
      const std::array<Rational, 3> s{t * lowest[o][0] + t * t * t * t, t * lowest[o][1] - t * t,
                                      t * lowest[o][2] - t * t * t};
      const ComponentId c = components.of[node_of_face(a, a.operands.face(o, 0))];
      EXPECT_EQ(seeds[c].beyond, first_hit(a, s));
      EXPECT_EQ(locate(bodies[o], s), -1);
      joined += seeds[c].beyond != none;
    }
  }
  EXPECT_GT(joined, 3 * case_count(60));
}

bool have_common(const std::set<std::uint32_t>& x, const std::set<std::uint32_t>& y) {
  return std::any_of(x.begin(), x.end(), [&](std::uint32_t r) { return y.contains(r); });
}

/// The seeds of those that are not placed, in order.
void expect_some(const ById<ComponentId, Seed>& all, const std::vector<Seed>& some,
                 const ById<ComponentId, std::uint8_t>& is_placed) {
  std::size_t i = 0;
  for (const ComponentId c : Ids<ComponentId>(all.size())) {
    if (is_placed[c]) continue;
    ASSERT_LT(i, some.size());
    EXPECT_EQ(some[i].outer, all[c].outer);
    EXPECT_EQ(some[i++].beyond, all[c].beyond);
  }
  EXPECT_EQ(some.size(), i);
}

// Tetrahedra of one lattice, many of which share corners only: both sides of a seed see one region, which is the outer
// one where there is nothing beyond; following the seeds ends there. Those of some components are those of all.
TEST(Seeds, JoinComponentsOverTheRegionBetweenThem) {
  std::size_t joined = 0;
  for (std::uint64_t number = 0; number < case_count(60); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0x5EEE, number);
    std::vector<Filling> fillings(4 + random.below(10), Filling::single);
    if (random.one_in(2)) fillings[0] = Filling(random.below(4));
    const Vector size{random.between(1, 3), random.between(3, 6), random.between(1, 3)};
    const auto sets = lattice_sets(random, size, fillings);
    const std::vector<Body> bodies = boundaries(sets);
    const Arrangement a = arranged(bodies);
    const Components components = components_of(a);
    const auto seeds = all_seeds(a, components);

    LatticeRegions regions(sets, a);
    ById<ComponentId, ComponentId> next(components.count);
    ById<ComponentId, std::uint8_t> is_placed = empty_components(a, components);
    for (const ComponentId c : Ids<ComponentId>(components.count)) {
      if (is_placed[c]) continue;
      const Seed& s = seeds[c];
      ASSERT_NE(s.outer, SideId(none));
      ASSERT_EQ(components.of[node_of(s.outer)], c);
      if (s.beyond == none) {
        ASSERT_TRUE(regions.seen_by(s.outer).contains(regions.infinity()));
        continue;
      }
      ASSERT_TRUE(have_common(regions.seen_by(s.outer), regions.seen_by(s.beyond)));
      next[c] = components.of[node_of(s.beyond)];
      ++joined;
    }
    for (const ComponentId c : Ids<ComponentId>(components.count)) {
      std::uint32_t steps = 0;
      for (ComponentId at = c; at != none; at = next[at]) ASSERT_LT(steps++, components.count);
    }

    for (auto& placed : is_placed) placed = placed || random.one_in(2);
    expect_some(seeds, find_seeds(a, components, is_placed), is_placed);
  }
  EXPECT_GT(joined, case_count(60) / 4);
}

}  // namespace
}  // namespace quoin::booleans::testing
