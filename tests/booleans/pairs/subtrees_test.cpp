#include "booleans/pairs/subtrees.h"

#include <gtest/gtest.h>

#include <map>

#include "booleans/pairs/foreign_pairs.h"
#include "tests/booleans/pairs/in_parts.h"
#include "tests/grid/with_thresholds.h"

namespace quoin::booleans::testing {
namespace {

using exact::GridPoint;
using grid::testing::WithThresholds;

/// Triangles whose boxes overlap everywhere, of one kind or of all: with a corner, or an edge, in one place; on one
/// plane; long, thin and nearly parallel; any.
Body overlapping(Random& random, std::int64_t size, std::size_t count) {
  const auto point = [&](std::int64_t reach) {
    GridPoint p{};
    for (auto& x : p.c) x = static_cast<std::int32_t>(random.between(-reach, reach));
    return p;
  };
  const auto near = [&](GridPoint p, std::int64_t reach) {
    const GridPoint d = point(reach);
    for (std::size_t k = 0; k < 3; ++k)
      p.c[k] = static_cast<std::int32_t>(std::clamp<std::int64_t>(std::int64_t{p.c[k]} + d.c[k], -size, size));
    return p;
  };

  const GridPoint hub = point(size), end = point(size), from = point(size), to = point(size), side = point(size);
  const std::int64_t step = std::max<std::int64_t>(1, size / 50), kind = random.between(0, 5);
  Body body;
  while (body.triangles.size() < count) {
    const GridPoint p = point(size), q = near(p, step), r = near(p, step);
    GridTriangle t{hub, p, q};
    const std::int64_t this_kind = kind == 5 ? random.between(0, 4) : kind;
    if (this_kind == 1) t = {hub, end, p};
    if (this_kind == 2) t = {p, q, r};
    if (this_kind == 3) {  // side by side
      const auto beside = [&, at = random.between(0, 100)](const GridPoint& c, std::int64_t more) {
        GridPoint moved = c;
        for (std::size_t k = 0; k < 3; ++k)
          moved.c[k] = static_cast<std::int32_t>(c.c[k] / 2 + (std::int64_t{side.c[k]} * (at + more)) / 300);
        return moved;
      };
      t = {beside(from, 0), beside(to, 0), beside(to, 1)};
    }
    if (this_kind == 4) t = {p, point(size), point(size)};
    if (this_kind == 2)  // x = 2 z
      for (GridPoint& c : t) c = {{2 * (c[0] / 2), c[1], c[0] / 2}};
    if (!exact::plane_through(t[0], t[1], t[2])) continue;

    const auto first = static_cast<std::uint32_t>(body.grid_points.size());
    for (const GridPoint& c : t) body.grid_points.push_back(c);
    body.triangles.push_back({first, first + 1, first + 2});
  }
  return body;
}

// What is said of two nodes holds for every pair of faces below them.
TEST(Subtrees, RelationsHoldForAllPairs) {
  std::map<Relation, std::size_t> said;
  for (std::uint64_t number = 0; number < case_count(60); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0x5B7E, number);
    const std::int64_t size = random.one_in(3) ? 20 : random.one_in(2) ? 100000 : exact::world;
    const Body body = overlapping(random, size, 40 + random.below(200));
    Array<BoxTree::Item> items(body.triangles.size());
    for (std::uint32_t t = 0; t < items.size(); ++t) items[t] = {face_box(body, t), t, t};
    const BoxTree tree(items);
    Array<SearchedFace> faces;
    for (const std::uint32_t f : tree.ids()) faces.push_back({&body, f});

    const bool are_foreign = random.one_in(2);
    Subtrees subtrees(faces, tree, are_foreign);
    const auto at = [&](std::uint32_t i) { return triangle(body, faces[i].face); };
    for (std::size_t level = 1; faces.size() >> (3 * level) > 0; ++level)
      for (std::uint32_t x = 0; subtrees.begin(level, x) < faces.size(); ++x)
        for (std::uint32_t y = x + 1; subtrees.begin(level, y) < faces.size(); ++y) {
          const Relation relation = subtrees.relation(level, x, y);
          ++said[relation];
          if (relation == Relation::unknown) continue;
          for (std::uint32_t i = subtrees.begin(level, x); i < subtrees.end(level, x); ++i)
            for (std::uint32_t j = subtrees.begin(level, y); j < subtrees.end(level, y); ++j) {
              if (relation == Relation::apart)
                EXPECT_FALSE(meet(at(i), at(j)));
              else
                EXPECT_TRUE((are_foreign && on_one_plane(at(i), at(j))) || meet_in_common_parts(at(i), at(j)));
            }
        }
  }
  EXPECT_GT(said[Relation::apart], case_count(60) / 5);
  EXPECT_GT(said[Relation::in_parts], 20 * case_count(60));
  EXPECT_GT(said[Relation::unknown], 50 * case_count(60));
}

/// n thin wedges around the z axis between them, in two bodies in turn: they meet in one edge.
std::array<Body, 2> wedges(std::uint32_t n) {
  std::array<Body, 2> two;
  for (std::uint32_t i = 0; i < n; ++i) {
    const auto on_circle = [&](std::uint32_t half_step, std::int32_t z) {
      const double angle = std::numbers::pi * half_step / n;
      return GridPoint{{static_cast<std::int32_t>(std::lround(1e6 * std::cos(angle))),
                        static_cast<std::int32_t>(std::lround(1e6 * std::sin(angle))), z}};
    };
    Body& body = two[i % 2];
    const auto first = static_cast<std::uint32_t>(body.grid_points.size());
    for (const std::int32_t z : {0, 1000000})
      for (const GridPoint& p : {GridPoint{{0, 0, z}}, on_circle(2 * i, z), on_circle(2 * i + 1, z)})
        body.grid_points.push_back(p);
    for (const Triangle& t :
         {Triangle{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}})
      body.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  return two;
}

/// All faces at the edge have a pair. How many pairs there are.
std::size_t count_pairs_at_one_edge(std::uint32_t n) {
  const auto [a, b] = wedges(n);
  const Operands operands({&a, &b});
  const FacePairs pairs = foreign_pairs(operands);

  std::set<std::uint32_t> named;
  for (const FacePair& p : pairs) named.insert({p[0].value, p[1].value});
  std::size_t at_edge = 0;
  for (std::uint32_t f = 0; f < operands.face_count(); ++f) {
    const OwnFace own = operands.own(FaceId(f));
    const GridTriangle t = triangle(operands[own.operand], own.face);
    if (std::none_of(t.begin(), t.end(), [](const GridPoint& p) { return p[0] == 0 && p[1] == 0; })) continue;
    ++at_edge;
    EXPECT_TRUE(named.contains(f));
  }
  EXPECT_EQ(at_edge, 6u * n);
  return pairs.size();
}

// Each face meets each at the edge; the number of pairs grows as that of faces does, not as its square.
TEST(Subtrees, FacesAtOneEdgeAreFewPairs) {
  const WithThresholds set(grid::Thresholds{});
  const std::size_t few = count_pairs_at_one_edge(512), more = count_pairs_at_one_edge(4096);
  EXPECT_LT(more, 16 * few);
}

}  // namespace
}  // namespace quoin::booleans::testing
