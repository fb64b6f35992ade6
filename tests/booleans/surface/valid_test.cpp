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

}  // namespace
}  // namespace quoin::booleans::testing
