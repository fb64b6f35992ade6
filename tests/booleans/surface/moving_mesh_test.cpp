#include "booleans/surface/moving_mesh.h"

#include <gtest/gtest.h>

#include "booleans/surface/rational_triangles.h"
#include "tests/booleans/lattice_sets.h"
#include "tests/booleans/support.h"

namespace quoin::booleans::testing {
namespace {

using exact::Rational;

/// Thirds, far from 0: nearly all floats are rounded.
grid::Lattice far_thirds(Random& random) {
  grid::Lattice lattice;
  lattice.step = Rational(1, 3);
  for (Rational& x : lattice.origin) x = Rational(random.between(-1 << 20, 1 << 20), 7);
  return lattice;
}

/// The corners of a triangle when it has gone `part` of its way.
RationalTriangle on_its_way(const Body& body, const Triangulated& mesh, const grid::Lattice& lattice,
                            const std::vector<double>& points, std::uint32_t t, const Rational& part) {
  RationalTriangle r;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t v = mesh.triangle(t)[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<int>(k);
      const std::uint32_t source = mesh.source[v];
      const Rational in_steps = body.is_grid(source) ? Rational(body.grid_points[source][axis])
                                                     : exact::coordinate(body.derived(source), axis);
      const Rational from = lattice.origin[k] + lattice.step * in_steps;
      r[i][k] = from + part * (exact::to_rational(points[3 * std::size_t{v} + k]) - from);
    }
  }
  return r;
}

/// Puts corners that are the same vertex first; returns how many they are.
std::size_t align_exactly(std::array<std::uint32_t, 3> c, std::array<std::uint32_t, 3> d, RationalTriangle& t,
                          RationalTriangle& u) {
  std::size_t shared = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = shared; j < 3; ++j) {
      if (c[i] != d[j]) continue;
      std::swap(c[i], c[shared]), std::swap(t[i], t[shared]);
      std::swap(d[j], d[shared]), std::swap(u[j], u[shared]);
      ++shared;
      break;
    }
  return shared;
}

// Triangles around a vertex that is marked meet as they should, all the way: every pair, at five places of it.
TEST(SteadyStars, StayEmbedded) {
  std::size_t steady = 0, others = 0;
  for (std::uint64_t number = 0; number < case_count(60); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0x57A2, number);
    Solids solids(random, families[random.below(6)]);
    const Body a = solids.next(), b = solids.next(), body = odd(a, b);
    const grid::Lattice lattice = far_thirds(random);
    const Triangulated mesh = triangulated(body);
    const auto points = rounded_points(body, mesh, lattice, Floats::float32);
    const Moves moved = moves(body, mesh, lattice, Floats::float32, points);
    if (moved.moved.empty()) continue;

    const Array<std::uint8_t> marks = steady_stars(MovingMesh(body, mesh, Floats::float32, lattice, points, moved));
    std::vector<std::vector<std::uint32_t>> around(mesh.vertex_count());
    for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t)
      for (const std::uint32_t v : mesh.triangle(t)) around[v].push_back(t);
    for (std::uint32_t v = 0; v < marks.size(); ++v) {
      ++(marks[v] ? steady : others);
      for (std::size_t i = 0; marks[v] && i < around[v].size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
          for (int quarter = 0; quarter <= 4; ++quarter) {
            const Rational part(quarter, 4);
            RationalTriangle t = on_its_way(body, mesh, lattice, points, around[v][i], part),
                             u = on_its_way(body, mesh, lattice, points, around[v][j], part);
            const std::size_t shared = align_exactly(mesh.triangle(around[v][i]), mesh.triangle(around[v][j]), t, u);
            ASSERT_FALSE(meet_out_of_place(t, u, shared)) << "vertex " << v;
          }
    }
  }
  EXPECT_GT(steady, 0u);
  EXPECT_GT(others, 0u);
}

}  // namespace
}  // namespace quoin::booleans::testing
