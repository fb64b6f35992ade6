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
  for (std::uint64_t number = 0; number < case_count(600); ++number) {
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
          const Relation relation = subtrees.relation(level, x, y, random.one_in(2));
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
  EXPECT_GT(said[Relation::apart], case_count(600) / 10);
  EXPECT_GT(said[Relation::in_parts], 20 * case_count(600));
  EXPECT_GT(said[Relation::unknown], 50 * case_count(600));
}

/// n thin tetrahedra from the origin to the unit square of (1, x, y), in two bodies in turn: they meet in one corner.
std::array<Body, 2> tetrahedra_at_one_corner(std::uint32_t n) {
  std::array<Body, 2> two;
  for (std::uint32_t i = 0; i < n * n; ++i) {
    const auto at = [&](std::int32_t dx, std::int32_t dy) {
      const auto x = static_cast<std::int32_t>(1000 * (i % n)), y = static_cast<std::int32_t>(1000 * (i / n));
      return GridPoint{{1000000, x + dx, y + dy}};
    };
    Body& body = two[i % 2];
    const auto first = static_cast<std::uint32_t>(body.grid_points.size());
    for (const GridPoint& p : {GridPoint{}, at(0, 0), at(500, 0), at(0, 500)}) body.grid_points.push_back(p);
    for (const Triangle& t : {Triangle{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}})
      body.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  return two;
}

/// All faces at the corner have a pair. How many pairs there are.
std::size_t count_pairs_at_one_corner(std::uint32_t n) {
  const auto [a, b] = tetrahedra_at_one_corner(n);
  const Operands operands({&a, &b});
  const FacePairs pairs = foreign_pairs(operands);

  std::set<std::uint32_t> named;
  for (const FacePair& p : pairs) named.insert({p[0].value, p[1].value});
  std::size_t at_corner = 0;
  for (std::uint32_t f = 0; f < operands.face_count(); ++f) {
    const OwnFace own = operands.own(FaceId(f));
    const GridTriangle t = triangle(operands[own.operand], own.face);
    if (std::none_of(t.begin(), t.end(), [](const GridPoint& p) { return p == GridPoint{}; })) continue;
    ++at_corner;
    EXPECT_TRUE(named.contains(f));
  }
  EXPECT_EQ(at_corner, 3u * n * n);
  return pairs.size();
}

// Each face meets each in the corner; the number of pairs grows as that of faces does, not as its square.
TEST(Subtrees, FacesAtOneCornerAreFewPairs) {
  const WithThresholds set(grid::Thresholds{});
  const std::size_t few = count_pairs_at_one_corner(16), more = count_pairs_at_one_corner(48);
  EXPECT_LT(more, 18 * few);  // of 9 times as many faces
}

/// A prism under z = 0 over a polygon of n corners, its caps fans from their middle; one in `holes` of the triangles of
/// the upper one reaches down to a point of its own.
Body fan_prism(Random& random, std::uint32_t n, std::uint64_t holes, const std::vector<Vector>& rim) {
  std::vector<Vector> points{{0, 0, 0}, {0, 0, -1000}};
  std::vector<Triangle> triangles;
  for (const Vector& p : rim)
    for (const std::int64_t z : {0, -1000}) points.push_back({p[0], p[1], z});
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n, a = 2 + 2 * i, b = 2 + 2 * j;
    for (const Triangle& t : {Triangle{1, b + 1, a + 1}, {a, a + 1, b + 1}, {a, b + 1, b}}) triangles.push_back(t);
    if (!random.one_in(holes)) {
      triangles.push_back({0, a, b});
      continue;
    }
    const auto deep = static_cast<std::uint32_t>(points.size());
    points.push_back({(rim[i][0] + rim[j][0]) / 4, (rim[i][1] + rim[j][1]) / 4, -300});
    for (const Triangle& t : {Triangle{0, a, deep}, {a, b, deep}, {b, 0, deep}}) triangles.push_back(t);
  }
  return *mesh(points, triangles);
}

/// Tetrahedra over z = 0 from the origin, along edges of the fan or into its triangles, in some number of meshes.
std::vector<Body> tetrahedra_on(Random& random, const std::vector<Vector>& rim) {
  std::vector<std::vector<Vector>> points(1 + random.below(3));
  std::vector<std::vector<Triangle>> triangles(points.size());
  for (std::size_t i = 0; i < rim.size(); ++i) {
    if (random.one_in(3)) continue;
    const std::size_t k = random.below(points.size());
    const Vector &p = rim[i], &next = rim[(i + 1) % rim.size()];
    const Vector aside{(3 * p[0] + next[0]) / 5, (3 * p[1] + next[1]) / 5, 0};
    const Vector end = random.one_in(3) ? Vector{p[0], p[1], 400} : random.one_in(2) ? aside : p;
    const Vector left{p[0], p[1], 500}, right{aside[0] / 2, aside[1] / 2, 700};
    const auto first = static_cast<std::uint32_t>(points[k].size());
    for (const Vector& q : {Vector{0, 0, 0}, end, left, right}) points[k].push_back(q);
    const bool turned = determinant(end, left, right) > 0;
    for (const Triangle& t : {Triangle{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}})
      triangles[k].push_back({first + t[0], first + t[turned ? 2 : 1], first + t[turned ? 1 : 2]});
  }
  std::vector<Body> bodies;
  for (std::size_t k = 0; k < points.size(); ++k)
    if (auto body = mesh(points[k], triangles[k])) bodies.push_back(*body);
  return bodies;
}

/// A cone from the origin over half a disk at x = 64000: its upper side is a flat fan of n triangles, its lower side a
/// fan of m.
Body half_cone(std::uint32_t n, std::uint32_t m, const std::vector<Vector>& rim) {
  std::vector<Vector> points = rim;
  for (std::uint32_t j = 1; j < m; ++j) {
    const double turn = std::numbers::pi * j / m;
    points.push_back({64000, std::llround(32000 * std::cos(turn)), -std::llround(32000 * std::sin(turn))});
  }
  const auto sides = static_cast<std::uint32_t>(points.size()), apex = sides, low = n + 1 + m / 2;
  points.push_back({0, 0, 0});
  std::vector<Triangle> triangles;
  for (std::uint32_t i = 0; i < sides; ++i) {
    const std::uint32_t j = (i + 1) % sides;
    triangles.push_back({apex, i, j});
    if (i != low && j != low) triangles.push_back({low, j, i});
  }
  return *mesh(points, triangles);
}

// Thin tetrahedra that stand on the inner edges of a flat fan: some pairs that tell so are passed over with those of
// the fan below, others with faces that have the hub alone.
TEST(Subtrees, WhatStandsOnTheEdgesOfAFlatFan) {
  for (std::uint64_t number = 0; number < case_count(40); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0xFAE, number);
    const auto n = static_cast<std::uint32_t>(9 + random.below(40)),
               m = static_cast<std::uint32_t>(8 + random.below(60));
    std::vector<Vector> rim;
    for (std::uint32_t i = 0; i <= n; ++i) rim.push_back({64000, -32000 + std::int64_t{64000} * i / n, 0});
    std::vector<Vector> points{{0, 0, 0}};
    std::vector<Triangle> triangles;
    const std::uint32_t on = 1 + static_cast<std::uint32_t>(random.below(n - 1));
    const std::int64_t up = random.one_in(2) ? 200 : 20000;
    for (std::uint32_t k = 0; k < 3; ++k) {
      const auto first = static_cast<std::uint32_t>(points.size());
      const Vector& p = rim[on];
      points.insert(points.end(), {p, {60000, p[1] - 30 + 20 * k, up}, {60000, p[1] - 20 + 20 * k, up}});
      for (const Triangle& t : {Triangle{0, first + 1, first + 2},
                                {0, first, first + 1},
                                {first + 2, first, 0},
                                {first, first + 2, first + 1}})
        triangles.push_back({t[0], t[2], t[1]});
    }
    const auto standing = mesh(points, triangles);
    ASSERT_TRUE(standing);
    const std::vector<Body> solids{half_cone(n, m, rim), *standing};
    const auto result = [&](int crowded) {
      grid::Thresholds t = grid::thresholds();
      t.crowded_nodes = t.crowded_blocks = crowded;
      const WithThresholds set(t);
      return evaluated(solids, Expression::flat(Rule::any, 2));
    };
    EXPECT_TRUE(same(result(0), result(64)));
  }
}

/// The triangles of a closed polygon's edges with two points, each of which may be one of its corners.
Body double_cone(const std::vector<Vector>& rim, const Vector& hub, const Vector& apex) {
  std::vector<Vector> points = rim;
  const auto n = static_cast<std::uint32_t>(rim.size());
  points.insert(points.end(), {hub, apex});
  std::vector<Triangle> triangles;
  exact::int128 volume = 0;
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    triangles.insert(triangles.end(), {{n, j, i}, {n + 1, i, j}});
    volume += determinant(rim[i] - hub, rim[j] - hub, apex - hub);
  }
  const Body body = *mesh(points, triangles);
  return volume > 0 ? body : inside_out(body);
}

Vector on_circle(std::int64_t radius, double turn) {
  const auto r = static_cast<double>(radius);
  return {std::llround(r * std::cos(turn)), std::llround(r * std::sin(turn)), 0};
}
std::vector<Vector> circle(const Vector& centre, std::int64_t radius, int n) {
  std::vector<Vector> points;
  for (int i = 0; i < n; ++i) points.push_back(centre + on_circle(radius, 2 * std::numbers::pi * i / n));
  return points;
}

/// The union with all passed over that can be equals the union with nothing passed over.
///
/// Of four solids, by the places that their faces have in the tree: of the first, eight triangles lie on the plane of a
/// flat region of the last one, so that all faces there have a pair. The second and the third touch the region from the
/// other side, where they touch each other, and are passed over with each other first: so they have pairs, too. Then no
/// pair is made of a face of the region and one of those that touch it.
void expect_nothing_lost(const std::vector<Body>& solids) {
  const auto result = [&](int crowded) {
    grid::Thresholds t;
    t.crowded_nodes = t.crowded_blocks = crowded;
    const WithThresholds set(t);
    return evaluated(solids, Expression::flat(Rule::any, static_cast<std::uint32_t>(solids.size())));
  };
  EXPECT_TRUE(same(result(0), result(64)));
}

constexpr std::int64_t reach = 1 << 16, height = 1 << 19;  // nodes of eight faces are sectors of what lies on z = 0

// Two tips on the inner vertex of a flat fan: no pair tells the fan of it, but it is a hub.
TEST(Subtrees, TipsOnTheMiddleOfAFlatFan) {
  const Vector middle{0, 0, 0}, left{-40000, 0, -200000}, right{40000, 0, -200000}, aside{-15000, -15000, 0};
  const std::vector<Vector> rim{{15000, -20000, 0},  {-20000, 15000, 0},  {-26000, 5000, 0},  {-30000, -5000, 0},
                                {-30000, -20000, 0}, {-20000, -30000, 0}, {-5000, -30000, 0}, {5000, -26000, 0}};
  expect_nothing_lost({double_cone(rim, aside, aside + Vector{0, 0, 300000}),
                       double_cone(circle(right, 20000, 8), right, middle),
                       double_cone(circle(left, 20000, 8), left, middle),
                       double_cone(circle(middle, reach, 32), middle, {0, 0, height})});
}

// Two blades on a diagonal of a flat polygon, whose triangles are a fan from one of its ends: would faces be passed
// over that have an edge in common, no pair would tell the polygon of the diagonal.
TEST(Subtrees, BladesOnADiagonalOfAFlatPolygon) {
  std::vector<Vector> polygon;
  for (const int degrees : {200, 220, 235, 250, 270, 285, 300, 330, 0, 15, 40, 60, 75, 90, 105, 120, 140, 180})
    polygon.push_back(on_circle(reach, degrees * std::numbers::pi / 180));
  const Vector from = polygon[0], to = polygon[9];

  const auto blade = [&](int side) {
    std::vector<Vector> rim;
    for (const std::int64_t k : {3, 4, 5, 6}) rim.push_back({side * k * -3000, side * k * 9500, -270000 + 10000 * k});
    rim.push_back(to);
    return double_cone(rim, from, to);
  };
  const std::vector<Vector> rim{{-30000, -15000, 0}, {-30000, -20000, 0}, {-20000, -30000, 0}, {-10000, -35000, 0},
                                {0, -35000, 0},      {10000, -30000, 0},  {20000, -20000, 0},  {20000, 0, 0}};
  expect_nothing_lost({double_cone(rim, {0, -15000, 0}, {0, -15000, 300000}), blade(1), blade(-1),
                       double_cone(polygon, from, {0, 0, height})});
}

// Solids that stand on a flat fan, on its hub and its inner edges: with what is passed over as without.
TEST(Subtrees, WhatStandsOnFlatFans) {
  for (std::uint64_t number = 0; number < case_count(40); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0xFA9, number);
    const auto n = static_cast<std::uint32_t>(8 + random.below(60));
    std::vector<Vector> rim;
    for (std::uint32_t i = 0; i < n; ++i)
      rim.push_back({std::llround(100000 * std::cos(2 * std::numbers::pi * i / n)),
                     std::llround(100000 * std::sin(2 * std::numbers::pi * i / n)), 0});
    std::vector<Body> solids = tetrahedra_on(random, rim);
    solids.insert(solids.begin(), fan_prism(random, n, random.one_in(2) ? 1000000 : 3, rim));

    const auto result = [&](int crowded) {
      grid::Thresholds t = grid::thresholds();
      t.crowded_nodes = t.crowded_blocks = crowded;
      const WithThresholds set(t);
      const Expression any = Expression::flat(Rule::any, static_cast<std::uint32_t>(solids.size()));
      return evaluated(solids, any);
    };
    EXPECT_TRUE(same(result(0), result(64)));
  }
}

}  // namespace
}  // namespace quoin::booleans::testing
