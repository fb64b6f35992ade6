#include "booleans/surface/separated.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "booleans/resolve.h"
#include "booleans/surface/shells.h"
#include "grid/lists/partition.h"
#include "tests/booleans/lattice_sets.h"
#include "tests/booleans/support.h"
#include "tests/booleans/surface/position.h"

namespace quoin::booleans::testing {
namespace {

using exact::Rational;

/// What an index mesh says by itself.
struct IndexTopology {
  std::size_t most_on_one_edge = 0;  // triangles that name one pair of vertices
  bool closed = true;                // every directed edge has its reverse
  std::int64_t characteristic = 0;   // V - E + F
  std::uint64_t parts = 0;
};
IndexTopology index_topology(const Triangulated& mesh) {
  std::map<std::array<std::uint32_t, 2>, int> balance;
  std::map<std::array<std::uint32_t, 2>, std::size_t> uses;
  std::set<std::uint32_t> vertices;
  grid::Partition parts(mesh.vertex_count());
  for (std::size_t n = 0; n < mesh.triangle_count(); ++n) {
    const auto t = mesh.triangle(n);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t u = t[k], v = t[(k + 1) % 3];
      vertices.insert(u);
      parts.unite(u, v);
      ++uses[{std::min(u, v), std::max(u, v)}];
      balance[{std::min(u, v), std::max(u, v)}] += u < v ? 1 : -1;
    }
  }

  IndexTopology r;
  for (const auto& [edge, count] : uses) r.most_on_one_edge = std::max(r.most_on_one_edge, count);
  for (const auto& [edge, sum] : balance) r.closed = r.closed && sum == 0;
  for (const std::uint32_t v : vertices) r.parts += parts.find(v) == v;
  r.characteristic = static_cast<std::int64_t>(vertices.size()) - static_cast<std::int64_t>(uses.size()) +
                     static_cast<std::int64_t>(mesh.triangle_count());
  return r;
}

/// The mesh's exact volume, through its own triangles.
Rational mesh_volume(const Body& body, const Triangulated& mesh) {
  Rational six = 0;
  for (std::size_t n = 0; n < mesh.triangle_count(); ++n) {
    std::array<RationalPoint, 3> p;
    for (std::size_t i = 0; i < 3; ++i) p[i] = position(body, mesh, mesh.triangle(n)[i]);
    const auto minor = [&](std::size_t i, std::size_t j) { return p[1][i] * p[2][j] - p[1][j] * p[2][i]; };
    six += p[0][0] * minor(1, 2) + p[0][1] * minor(2, 0) + p[0][2] * minor(0, 1);
  }
  return six / 6;
}

/// The laws of separated.h for one body; its shells.
Shells separated_shells(const Body& body, std::size_t* split_edges = nullptr) {
  const Triangulated whole = triangulated(body), apart = separated(body, whole);
  const Shells ours = shells(apart);
  const IndexTopology before = index_topology(whole), after = index_topology(apart);

  EXPECT_TRUE(after.closed);
  EXPECT_EQ(after.most_on_one_edge, whole.triangle_count() > 0 ? 2u : 0u);
  EXPECT_EQ(after.parts, ours.count);
  EXPECT_EQ(after.characteristic, 2 * (static_cast<std::int64_t>(ours.count) - ours.genus));
  EXPECT_EQ(mesh_volume(body, apart), mesh_volume(body, whole));

  if (apart.vertex_count() == whole.vertex_count()) {
    EXPECT_LE(before.most_on_one_edge, 2u);
    EXPECT_EQ(apart.corners, whole.corners);
    EXPECT_EQ(apart.source, whole.source);
  }
  EXPECT_GE(apart.added.size(), 2 * apart.split_edges);
  EXPECT_EQ(apart.triangle_count(), whole.triangle_count() + 2 * apart.added.size());
  if (split_edges != nullptr) *split_edges = apart.split_edges;
  return ours;
}

/// All full tetrahedra as one mesh, resolved.
Body united(const std::vector<Body>& tetrahedra) {
  std::uint64_t crossings = 0;
  return sound(resolve(merged(tetrahedra), crossings));
}

// One point set as raw triangles, as what a Boolean makes of its pieces, and in canonical form, against counting.
TEST(Separated, LatticeSetsHaveTheTopologyThatCountingGives) {
  std::uint64_t split = 0;
  const std::uint64_t cases = case_count(3000);
  for (std::uint64_t number = 0; number < cases; ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0x5E7, number);
    const LatticeSet set = lattice_set([&](std::uint64_t n) { return random.below(n); });
    const auto scale = static_cast<std::int64_t>(1 + random.below(3));
    const Body body = boundary(set, scale);
    if (body.triangles.empty()) continue;
    const SeparatedTopology expected = separated_topology(set);

    std::size_t split_edges = 0;
    const Shells raw = separated_shells(body, &split_edges), form = separated_shells(body_of(canonical(body)));
    ASSERT_EQ(raw.count, expected.shells);
    ASSERT_EQ(raw.genus, expected.genus);
    ASSERT_EQ(form.count, expected.shells);
    ASSERT_EQ(form.genus, expected.genus);
    split += split_edges > 0;

    if (number % 8 == 0) {
      const Body whole = united(solids(set, scale));
      const Shells resolved = separated_shells(whole);
      ASSERT_TRUE(same(whole, body));
      ASSERT_EQ(resolved.count, expected.shells);
      ASSERT_EQ(resolved.genus, expected.genus);
    }
    if (HasFailure()) break;
  }
  // The cases that are hard are among them.
  if (cases >= 1000) {
    EXPECT_GT(split, 0u);
  }
}

// Booleans of solids that touch and coincide, with derived points, and their complements.
TEST(Separated, BooleansOfTouchingSolids) {
  for (std::uint64_t number = 0; number < case_count(300); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0x5E8, number);
    Solids solids(random, families[random.below(4)]);
    const Body a = solids.next(), b = solids.next(), c = solids.next();
    const Body body = random.one_in(2) ? odd(odd(a, b), c) : minus(any(a, b), c);
    const Shells ours = separated_shells(body), form = separated_shells(body_of(canonical(body)));
    ASSERT_EQ(ours.count, form.count);
    ASSERT_EQ(ours.genus, form.genus);
    separated_shells(complement(body));
    if (HasFailure()) break;
  }
}

Body cubes(const std::vector<Vector>& cells) {
  std::vector<Body> all;
  for (const Vector& c : cells) all.push_back(box(c, c + Vector{1, 1, 1}));
  return united(all);
}

// Eight cubes: two L around the edge from (1, 1, 1) to (1, 1, 2), between them two cubes that touch in it.
TEST(Separated, TwoCubesThatTouchInAnEdgeBetweenTwoLs) {
  const Body body = cubes({{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 1, 1}, {1, 0, 1}, {0, 0, 2}, {0, 1, 2}, {1, 0, 2}});
  std::size_t split_edges = 0;
  const Shells ring = separated_shells(body, &split_edges);
  EXPECT_EQ(ring.count, 1u);
  EXPECT_EQ(ring.genus, 1);
  EXPECT_EQ(split_edges, 1u);
}

// An edge of six triangles and one of four in one solid.
TEST(Separated, ThirteenTetrahedraAroundTheEdgesOfALattice) {
  const std::vector<Tetrahedron> all{
      {{{0, 0, 0}, {2, 2, 0}, {2, 0, 2}, {0, 2, 2}}}, {{{0, 0, 2}, {2, 0, 2}, {0, 2, 2}, {0, 0, 0}}},
      {{{0, 2, 0}, {0, 0, 0}, {0, 2, 2}, {2, 2, 0}}}, {{{2, 2, 4}, {0, 2, 2}, {0, 0, 4}, {2, 0, 2}}},
      {{{0, 0, 2}, {0, 0, 4}, {0, 2, 2}, {2, 0, 2}}}, {{{2, 2, 2}, {2, 0, 2}, {0, 2, 2}, {2, 2, 4}}},
      {{{2, 4, 2}, {0, 4, 0}, {0, 2, 2}, {2, 2, 0}}}, {{{0, 2, 0}, {0, 2, 2}, {0, 4, 0}, {2, 2, 0}}},
      {{{2, 2, 2}, {2, 2, 0}, {2, 4, 2}, {0, 2, 2}}}, {{{2, 0, 0}, {2, 0, 2}, {2, 2, 0}, {4, 0, 0}}},
      {{{2, 2, 2}, {2, 0, 2}, {4, 2, 2}, {2, 2, 0}}}, {{{2, 2, 2}, {2, 0, 2}, {2, 2, 4}, {4, 2, 2}}},
      {{{2, 2, 2}, {4, 2, 2}, {2, 4, 2}, {2, 2, 0}}}};
  std::vector<Body> bodies;
  for (const Tetrahedron& t : all) bodies.push_back(*tetrahedron(t));
  std::size_t split_edges = 0;
  separated_shells(united(bodies), &split_edges);
  EXPECT_GT(split_edges, 0u);
}

// A box with two cubic voids that share an edge: its interior hangs together around both ends, the voids do not.
TEST(Separated, VoidsThatShareAnEdge) {
  const Body box_of_4 = box({0, 0, 0}, {4, 4, 4});
  const Body voids = any(box({1, 1, 1}, {2, 2, 2}), box({2, 2, 1}, {3, 3, 2})), body = minus(box_of_4, voids);
  std::size_t split_edges = 0;
  const Shells ours = separated_shells(body, &split_edges);
  EXPECT_EQ(ours.count, 2u);
  EXPECT_EQ(ours.genus, 0);
  EXPECT_EQ(split_edges, 1u);

  // Where the vertex goes from the edge's lower end, or from the other one: the edge of one step has no grid point
  // inside, that of (5, 1, 1) neither; those of six and three steps have.
  const auto expect_added = [&](const std::array<Vector, 3>& columns, const RationalPoint& low,
                                const RationalPoint& high) {
    const auto part = [&](const Vector& from, const Vector& to) { return *mapped(box(from, to), {0, 0, 0}, columns); };
    const Body hollow = minus(part({0, 0, 0}, {4, 4, 4}), any(part({1, 1, 1}, {2, 2, 2}), part({2, 2, 1}, {3, 3, 2})));
    const auto added = separated(hollow, triangulated(hollow)).added;
    ASSERT_EQ(added.size(), 2u);
    EXPECT_EQ(added[0], added[1]);
    EXPECT_TRUE(added[0] == low || added[0] == high) << added[0][0] << ' ' << added[0][1] << ' ' << added[0][2];
  };
  expect_added({{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {2, 2, Rational(5, 4)}, {2, 2, Rational(7, 4)});
  expect_added({{{1, 0, 0}, {0, 1, 0}, {5, 1, 1}}}, {Rational(117, 16), Rational(49, 16), Rational(17, 16)},
               {Rational(187, 16), Rational(63, 16), Rational(31, 16)});
  expect_added({{{6, 0, 0}, {0, 6, 0}, {0, 0, 6}}}, {12, 12, 9}, {12, 12, 9});
  expect_added({{{3, 0, 0}, {0, 3, 0}, {0, 0, 3}}}, {6, 6, 4}, {6, 6, 5});
}

// A block of 4 x 4 x 4 cells with two voids of two cells each that share an edge. Raw, it has a vertex inside the edge:
// nothing is to be split, and the topology is the same.
TEST(Separated, VoidsThatShareAnEdgeWithAVertexInside) {
  LatticeSet set;
  for (std::int64_t i = 0; i < 64; ++i) {
    const Vector cell{i % 4, i / 4 % 4, i / 16};
    const bool in_middle = cell[2] == 1 || cell[2] == 2, is_void = cell[0] == cell[1] && (cell[0] == 1 || cell[0] == 2);
    if (in_middle && is_void) continue;
    for (Tetrahedron t : six_tetrahedra(cell)) {
      if (determinant(t[1] - t[0], t[2] - t[0], t[3] - t[0]) < 0) std::swap(t[0], t[1]);
      set.tetrahedra.push_back(t);
      set.full.push_back(1);
    }
  }

  const Body raw = boundary(set, 1), form = body_of(canonical(raw));
  std::size_t raw_split = 0, form_split = 0;
  const Shells of_raw = separated_shells(raw, &raw_split), of_form = separated_shells(form, &form_split);
  EXPECT_EQ(raw_split, 0u);
  EXPECT_EQ(form_split, 1u);
  EXPECT_EQ(of_raw.count, 2u);
  EXPECT_EQ(of_form.count, 2u);
  EXPECT_EQ(of_raw.genus, 0);
  EXPECT_EQ(of_form.genus, 0);
}

TEST(Separated, CubesThatShareAnEdgeOrACornerComeApart) {
  for (const Vector& other : {Vector{1, 1, 0}, Vector{1, 1, 1}}) {
    std::size_t split_edges = 0;
    const Body body = cubes({{0, 0, 0}, other});
    const Shells ours = separated_shells(body, &split_edges);
    EXPECT_EQ(ours.count, 2u);
    EXPECT_EQ(ours.genus, 0);
    EXPECT_EQ(split_edges, 0u);
    EXPECT_EQ(separated(body, triangulated(body)).vertex_count(), 16u);
  }
}

}  // namespace
}  // namespace quoin::booleans::testing
