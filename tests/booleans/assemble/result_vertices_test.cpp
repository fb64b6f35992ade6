#include "booleans/assemble/result_vertices.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "tests/booleans/assemble/making.h"

namespace quoin::booleans::testing {
namespace {

TEST(ResultName, SaysWhichPointItIs) {
  EXPECT_TRUE(ResultName().is_none());
  for (const std::size_t i : {0u, 1u, 0x7FFFFF00u}) {
    const ResultName grid = ResultName::grid(i), derived = ResultName::derived(i);
    EXPECT_FALSE(grid.is_none() || derived.is_none());
    EXPECT_FALSE(grid.is_derived());
    EXPECT_TRUE(derived.is_derived());
    for (const ResultName name : {grid, derived}) {
      EXPECT_EQ(name.index(), i);
      const ResultName again = ResultName::of_corner(name.as_corner());
      EXPECT_EQ(again.as_corner(), name.as_corner());
      EXPECT_EQ(again.is_derived(), name.is_derived());
    }
    EXPECT_NE(grid.as_corner(), derived.as_corner());
  }
}

/// Names all vertices of the operands in some order, and checks each name against the vertex's point.
void name_all(Made& made, Random& random, PointNumbers& numbers, std::map<std::uint32_t, std::uint32_t>& corner_of) {
  std::vector<std::array<std::uint32_t, 2>> all;
  for (const OperandId o : made.a.operands.ids())
    for (std::uint32_t v = 0; v < made.a.operands[o].vertex_count(); ++v)
      if (made.a.operands[o].is_grid(v) || v >= made.a.operands[o].derived_base()) all.push_back({o.value, v});
  for (std::size_t i = all.size(); i > 1; --i) std::swap(all[i - 1], all[random.below(i)]);

  for (const auto& [o, v] : all) {
    const Body& body = made.a.operands[o];
    const ResultName name = made.m.vertices.named(o, v);
    const std::uint32_t number = numbers.of(body, v);
    EXPECT_EQ(numbers.of(made.m.body, name), number);
    EXPECT_EQ(name.is_derived(), !body.is_grid(v));
    EXPECT_EQ(corner_of.try_emplace(number, name.as_corner()).first->second, name.as_corner()) << "two names";
    EXPECT_EQ(made.m.vertices.named(o, v).as_corner(), name.as_corner()) << "asked again";
  }
}

// A point has one name, whichever operands have it, and the body holds it once.
TEST(ResultVertices, PointsHaveOneNameEach) {
  for_families(0x2E5, 20, [](Solids& solids, Random& random) {
    const std::vector<Body> bodies{packed(odd(solids.raw(), solids.raw())), solids.raw(), packed(solids.next())};
    Made made(bodies, Expression::flat(Rule::any, 3));
    PointNumbers numbers;
    std::map<std::uint32_t, std::uint32_t> corner_of;
    name_all(made, random, numbers, corner_of);
    EXPECT_EQ(made.m.body.grid_points.size() + made.m.body.points.size(), corner_of.size());
  });
}

// The host's vertices have the names that they have in its lists, and those of others that are there too take them.
TEST(ResultVertices, VerticesOfAHostKeepTheirNames) {
  for_families(0x2E6, 20, [](Solids& solids, Random& random) {
    const std::vector<Body> bodies{packed(odd(solids.raw(), solids.raw())), solids.raw()};
    const auto host = static_cast<std::uint32_t>(random.below(2));
    Made made(bodies, Expression::flat(Rule::any, 2), host);
    keep_host(made.m);

    PointNumbers numbers;
    std::map<std::uint32_t, std::uint32_t> corner_of;
    const Body& body = bodies[host];
    for (std::uint32_t v = 0; v < body.vertex_count(); ++v) {
      const ResultName name = made.m.vertices.named(host, v);
      EXPECT_EQ(name.index(), body.is_grid(v) ? v : v - body.derived_base());
      corner_of[numbers.of(body, v)] = name.as_corner();
    }
    const std::size_t before = made.m.body.grid_points.size() + made.m.body.points.size();
    EXPECT_EQ(before, body.vertex_count());
    name_all(made, random, numbers, corner_of);
    EXPECT_EQ(made.m.body.grid_points.size() + made.m.body.points.size(), corner_of.size());
  });
}

// A vertex waits in one place, whichever operand it is asked for by: under the name that it got before, under the one
// that it has in the host's lists, or without one.
TEST(ResultVertices, AVertexThatWaitsHasOnePlace) {
  for_families(0x2E7, 20, [](Solids& solids, Random& random) {
    const std::vector<Body> bodies{packed(odd(solids.raw(), solids.raw())), solids.raw()};
    const auto first = static_cast<std::uint32_t>(random.below(2));
    const OperandId host = random.one_in(2) ? OperandId(none) : OperandId(first);
    Made made(bodies, Expression::flat(Rule::any, 2), host);
    ResultVertices& vertices = made.m.vertices;
    if (host != none) made.m.body = bodies[first];

    PointNumbers numbers;
    std::map<std::uint32_t, std::uint32_t> corner_of;  // of vertices with names
    for (const std::uint32_t o : {first, 1 - first})
      for (std::uint32_t v = 0; v < bodies[o].vertex_count(); ++v)
        if (random.one_in(3)) corner_of[numbers.of(bodies[o], v)] = vertices.named(o, v).as_corner();
    if (host != none)
      for (std::uint32_t v = 0; v < bodies[first].vertex_count(); ++v) {
        const Body& b = bodies[first];
        const ResultName name = b.is_grid(v) ? ResultName::grid(v) : ResultName::derived(v - b.derived_base());
        corner_of.try_emplace(numbers.of(b, v), name.as_corner());
      }

    const std::size_t table = made.a.names.vertices.size();
    std::map<std::uint32_t, PlaceId> place_of;
    std::size_t outside = 0;
    for (const OperandId o : made.a.operands.ids())
      for (std::uint32_t v = 0; v < bodies[o.value].vertex_count(); ++v) {
        const std::uint32_t number = numbers.of(bodies[o.value], v);
        const PlaceId p = vertices.place(o, v);
        EXPECT_EQ(vertices.is_grid(p), bodies[o.value].is_grid(v));
        const auto [at, is_new] = place_of.try_emplace(number, p);
        EXPECT_EQ(at->second, p) << "two places";
        outside += is_new && p.value >= table;
        if (p.value < table) {
          EXPECT_EQ(numbers.of(made.a, VertexId(p.value)), number);
        }
      }
    EXPECT_EQ(vertices.place_count(), table + outside);

    for (const auto& [number, p] : place_of) {
      const std::size_t before = made.m.body.grid_points.size() + made.m.body.points.size();
      const ResultName name = vertices.named(p);
      const auto [at, is_new] = corner_of.try_emplace(number, name.as_corner());
      EXPECT_EQ(at->second, name.as_corner());
      EXPECT_EQ(numbers.of(made.m.body, name), number);
      EXPECT_EQ(made.m.body.grid_points.size() + made.m.body.points.size(), before + is_new);
      EXPECT_EQ(vertices.named(p).as_corner(), name.as_corner()) << "asked again";
    }
  });
}

// An edge ends where there are more than two neighbours; a vertex with a name stays on every edge.
TEST(ResultVertices, AVertexBetweenTwoNeighboursIsNotNeeded) {
  const std::vector<Body> bodies{box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3})};
  Made made(bodies, Expression::flat(Rule::any, 2));
  ResultVertices& vertices = made.m.vertices;
  const PlaceId a = 0, b = 1, c = 2, d = 3;
  EXPECT_FALSE(vertices.is_used(a));
  for (const auto& [before, next] : {std::array{b, c}, {c, b}, {b, c}}) {
    vertices.add_neighbours(a, before, next);
    EXPECT_TRUE(vertices.is_used(a));
    EXPECT_FALSE(vertices.is_needed(a));
  }
  vertices.add_neighbours(a, c, d);
  EXPECT_TRUE(vertices.is_needed(a));

  vertices.named(c);
  EXPECT_TRUE(vertices.is_used(c));
  EXPECT_FALSE(vertices.is_needed(c)) << "on no edge yet";
  vertices.add_neighbours(c, a, b);
  EXPECT_TRUE(vertices.is_needed(c));
}

}  // namespace
}  // namespace quoin::booleans::testing
