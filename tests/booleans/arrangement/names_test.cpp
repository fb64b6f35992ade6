#include "booleans/arrangement/names.h"

#include <gtest/gtest.h>

#include <map>

#include "exact/rational.h"
#include "tests/booleans/support.h"

namespace quoin::booleans::testing {
namespace {

using exact::Rational;
using RationalPoint = std::array<Rational, 3>;

RationalPoint exactly(const exact::Point& p) {
  return {exact::coordinate(p, 0), exact::coordinate(p, 1), exact::coordinate(p, 2)};
}
int sign(const Rational& v) { return v > 0 ? 1 : v < 0 ? -1 : 0; }

/// The plane where the k-th coordinate is p / q.
exact::Plane upright(std::size_t k, std::int64_t p, std::int64_t q) {
  std::array<std::int64_t, 3> n{};
  n[k] = q;
  return exact::reduced_plane(n, -exact::int128(p));
}
exact::Plane any_plane(Random& random, std::int64_t reach) {
  for (;;)
    if (const Vector n = random.vector(-reach, reach); n != Vector{})
      return exact::reduced_plane(n, random.between(-4 * reach, 4 * reach));
}

// A plane and its opposite are one; ids count up as planes come, and stay what they are while the table grows.
TEST(Names, PlanesAreEqualWhateverTheirOrientation) {
  Random random(0x9A3E5, 0);
  PlaneTable table;
  std::map<std::pair<Vector, std::int64_t>, PlaneId> ids;
  for (int i = 0; i < 2000; ++i) {
    const exact::Plane p = any_plane(random, 3);
    // The orientation whose first component that is not 0 is positive.
    std::pair<Vector, std::int64_t> key{p.n, static_cast<std::int64_t>(p.d)};
    if (key.first < Vector{}) key = {-1 * key.first, -key.second};

    const PlaneId next = static_cast<std::uint32_t>(ids.size()), id = table.id(random.one_in(2) ? p : p.opposite());
    ASSERT_EQ(id, ids.try_emplace(key, next).first->second);
    ASSERT_EQ(table.size(), ids.size());
  }
  for (const auto& [key, id] : ids) {
    EXPECT_EQ(table[id].n, key.first);
    EXPECT_EQ(table[id].d, exact::int128(key.second));
    EXPECT_EQ(table.approximation(id).d, static_cast<double>(key.second));
  }
  EXPECT_GT(ids.size(), 500u);
}

// Points that many triples of planes share, grid points among them, against rationals: ids, order and sides.
TEST(Names, PointsAreEqualWhateverTheirPlanes) {
  Random random(0x9A3E5, 1);
  Names names;
  std::map<RationalPoint, VertexId> ids;
  const auto add = [&](const RationalPoint& p, VertexId id) {
    const VertexId next = static_cast<std::uint32_t>(ids.size());
    ASSERT_EQ(id, ids.try_emplace(p, next).first->second);
    ASSERT_EQ(names.vertices.size(), ids.size());
  };
  for (int i = 0; i < 1500; ++i) {
    const Vector v = random.vector(-3, 3);
    const exact::GridPoint p{
        {static_cast<std::int32_t>(v[0]), static_cast<std::int32_t>(v[1]), static_cast<std::int32_t>(v[2])}};
    ASSERT_NO_FATAL_FAILURE(add({v[0], v[1], v[2]}, names.vertices.id(p)));
    const exact::Plane x = any_plane(random, 1), y = any_plane(random, 1), z = any_plane(random, 2);
    const auto m = exact::meet(x, y, z);
    if (m) {
      ASSERT_NO_FATAL_FAILURE(add(exactly(*m), names.vertices.id(*m)));
    }
  }

  std::size_t on_planes = 0;
  for (const auto& [p, u] : ids) {
    EXPECT_EQ(exactly(names.vertices.point(u)), p);
    EXPECT_EQ(names.vertices.is_grid(u), exact::are_whole(p));
    const auto& [q, v] = *std::next(ids.begin(), static_cast<std::ptrdiff_t>(random.below(ids.size())));
    EXPECT_EQ(names.vertices.compare_lexicographic(u, v), p < q ? -1 : p > q ? 1 : 0);
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_EQ(names.vertices.compare_along(static_cast<int>(k), u, v), sign(p[k] - q[k]));

    const PlaneId plane = names.planes.id(any_plane(random, 1));
    const exact::Plane& n = names.planes[plane];
    const Rational value = n.n[0] * p[0] + n.n[1] * p[1] + n.n[2] * p[2] + Rational(exact::to_integer(n.d));
    EXPECT_EQ(names.side(u, plane), sign(value));
    on_planes += value == 0;
  }
  EXPECT_GT(ids.size(), 500u);
  EXPECT_GT(on_planes, 10u);
}

// m / (2 m + 1) for four large m: one double, four points, in their order. m / (m + 1) rounds to the grid point 1 and
// is none.
TEST(Names, PointsWithinOneRoundingDiffer) {
  constexpr std::int64_t large = std::int64_t{1} << 60;
  const auto at = [](std::int64_t p, std::int64_t q) {
    return *exact::meet(upright(0, p, q), upright(1, 0, 1), upright(2, -5, 1));
  };
  VertexTable table;
  Array<VertexId> halves;
  for (std::int64_t i = 0; i < 4; ++i) halves.push_back(table.id(at(large + i, 2 * (large + i) + 1)));
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(halves[i], VertexId(static_cast<std::uint32_t>(i)));
    EXPECT_EQ(table.approximation(halves[i])[0], 0.5);
    EXPECT_EQ(table.id(at(large + std::int64_t(i), 2 * (large + std::int64_t(i)) + 1)), halves[i]);
    if (i > 0) {
      EXPECT_EQ(table.compare_along(0, halves[i - 1], halves[i]), -1);
      EXPECT_EQ(table.compare_along(1, halves[i - 1], halves[i]), 0);
      EXPECT_EQ(table.compare_lexicographic(halves[i], halves[i - 1]), 1);
    }
  }

  const VertexId one = table.id(exact::GridPoint{{1, 0, -5}}), nearly = table.id(at(large, large + 1));
  EXPECT_EQ(table.approximation(nearly), table.approximation(one));
  EXPECT_NE(nearly, one);
  EXPECT_TRUE(table.is_grid(one));
  EXPECT_FALSE(table.is_grid(nearly));
  EXPECT_EQ(table.compare_along(0, nearly, one), -1);
  EXPECT_EQ(table.id(at(3, 3)), one);
  EXPECT_EQ(table.id(at(large, large + 1)), nearly);
}

// Operands name the vertices that are asked for, each once, and a point that two of them have once for both.
TEST(Names, OperandsShareTheNamesOfTheirPoints) {
  const Body a = box({0, 0, 0}, {1, 1, 1}), b = box({1, 0, 0}, {2, 1, 1});
  Names names;
  names.operands.resize(2);
  EXPECT_EQ(names.operands[0].of(3), VertexId(none));
  for (const std::uint32_t v : {5u, 1u, 5u, 0u}) names.name(a, 0, v);
  for (const std::uint32_t v : {4u, 3u}) names.name(b, 1, v);

  EXPECT_EQ(names.operands[0].listed, (Array<std::uint32_t>{5, 1, 0}));
  EXPECT_EQ(names.operands[1].listed, (Array<std::uint32_t>{4, 3}));
  EXPECT_EQ(names.vertices.size(), 4u);  // (1, 0, 1) is vertex 5 of one and 4 of the other
  EXPECT_EQ(names.operands[0].of(5), names.operands[1].of(4));
  EXPECT_EQ(names.operands[0].of(7), VertexId(none));
  EXPECT_EQ(names.vertices.grid_point(names.operands[1].of(3)), (exact::GridPoint{{2, 1, 0}}));
}

// A worker's point of some index is not the vertex of that id.
TEST(Names, OwnPointsAreNoVertices) {
  const NewVertex own = NewVertex::own(7), named = VertexId(7);
  EXPECT_TRUE(own.is_own());
  EXPECT_FALSE(named.is_own());
  EXPECT_EQ(own.index(), 7u);
  EXPECT_EQ(named.named(), VertexId(7));
  EXPECT_NE(own, named);
}

}  // namespace
}  // namespace quoin::booleans::testing
