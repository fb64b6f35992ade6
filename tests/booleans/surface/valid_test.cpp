#include "booleans/surface/valid.h"

#include <gtest/gtest.h>

#include <map>

#include "booleans/surface/separated.h"
#include "tests/api/exact_mesh.h"
#include "tests/booleans/lattice_sets.h"
#include "tests/booleans/support.h"

namespace quoin::booleans::testing {
namespace {

using exact::Rational;

/// Far origins and odd steps: numbers of so few bits that rounding often spoils something.
grid::Lattice random_lattice(Random& random) {
  grid::Lattice lattice;
  lattice.step = std::array<Rational, 3>{1, Rational(1, 3), Rational(1, 1000)}[random.below(3)];
  const std::int64_t reach = std::int64_t{1} << random.between(1, 30);
  for (Rational& x : lattice.origin)
    if (random.one_in(2)) x = Rational(random.between(-reach, reach), 3);
  return lattice;
}

/// Do different vertices of the body coincide?
bool coincide(const Triangulated& mesh, const std::vector<double>& points) {
  std::map<std::array<double, 3>, std::uint32_t> sources;
  for (std::size_t v = 0; v < mesh.source.size(); ++v)
    if (sources.try_emplace({points[3 * v], points[3 * v + 1], points[3 * v + 2]}, mesh.source[v]).first->second !=
        mesh.source[v])
      return true;
  return false;
}

TEST(IsValid, AgreesWithBruteForce) {
  std::size_t valid = 0, invalid = 0;
  for (std::uint64_t number = 0; number < case_count(150); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0x7A11D, number);
    Solids solids(random, families[random.below(4)]);
    const Body a = solids.next(), b = solids.next(), body = odd(a, b);
    const grid::Lattice lattice = random_lattice(random);
    const Triangulated mesh = triangulated(body);
    for (const Floats floats : {Floats::float32, Floats::float64}) {
      const auto points = rounded_points(body, mesh, lattice, floats);
      const auto effects = rounding_effects(body, mesh, lattice, floats, points);
      const bool expected =
          effects == RoundingEffects{} && !coincide(mesh, points) && exact_mesh::fault({points, mesh.corners}).empty();
      ASSERT_EQ(is_valid(body, mesh, floats, lattice, points, moves(body, mesh, lattice, floats, points)), expected);
      ++(expected ? valid : invalid);
    }
  }
  EXPECT_GT(valid, 0u);
  EXPECT_GT(invalid, 0u);
}

/// Is the body valid when its points are rounded?
bool is_rounded_validly(const Body& body, const grid::Lattice& lattice, Floats floats) {
  const Triangulated mesh = triangulated(body);
  const auto points = rounded_points(body, mesh, lattice, floats);
  return is_valid(body, mesh, floats, lattice, points, moves(body, mesh, lattice, floats, points));
}

/// Tenths, about a point where floats are 2 apart.
grid::Lattice tenths_where_floats_are_even() {
  grid::Lattice lattice;
  lattice.step = Rational(1, 10);
  for (Rational& x : lattice.origin) x = 1 << 24;
  return lattice;
}

// A wall through even points stays. A small shell outside moves by 0.9 along each axis, through the wall: no triangles
// meet, before or after, but then it is inside.
TEST(IsValid, AShellThatPassesThroughAWall) {
  const auto even = [](std::int64_t x, std::int64_t y, std::int64_t z, std::int64_t tenths) {
    return Vector{20 * x + tenths, 20 * y + tenths, 20 * z + tenths};
  };
  const Body wall = *tetrahedron({even(0, 0, 0, 0), even(20, 0, 0, 0), even(0, 15, 0, 0), even(0, 0, 12, 0)});
  const auto shell = [&](std::int64_t tenths) {
    return *tetrahedron({even(4, 6, 4, tenths), even(7, 4, 4, tenths), even(5, 3, 6, tenths), even(6, 5, 4, tenths)});
  };
  const Body apart = any(wall, shell(9));
  ASSERT_EQ(apart.face_count(), 8u);
  EXPECT_FALSE(is_rounded_validly(apart, tenths_where_floats_are_even(), Floats::float32));
  EXPECT_TRUE(is_rounded_validly(apart, tenths_where_floats_are_even(), Floats::float64));

  // A void that stays inside is one.
  EXPECT_TRUE(is_rounded_validly(minus(wall, shell(0)), tenths_where_floats_are_even(), Floats::float32));
}

// A pyramid rounds flat. Its base covers the other faces, each across an edge; none is flipped or has no area.
TEST(IsValid, APyramidThatRoundsFlat) {
  const Body flat = *tetrahedron({Vector{0, 0, 0}, Vector{200, 0, 0}, Vector{0, 0, 200}, Vector{60, 9, 60}});
  EXPECT_FALSE(is_rounded_validly(flat, tenths_where_floats_are_even(), Floats::float32));
  const Body high = *tetrahedron({Vector{0, 0, 0}, Vector{200, 0, 0}, Vector{0, 0, 200}, Vector{60, 11, 60}});
  EXPECT_TRUE(is_rounded_validly(high, tenths_where_floats_are_even(), Floats::float32));
}

}  // namespace
}  // namespace quoin::booleans::testing
