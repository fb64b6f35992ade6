#include "booleans/surface/rounded.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "booleans/surface/separated.h"
#include "tests/booleans/lattice_sets.h"
#include "tests/booleans/support.h"
#include "tests/booleans/surface/position.h"

namespace quoin::booleans::testing {
namespace {

using exact::Rational;

/// Whether r, whose neighbours are `below` and `above`, is the nearest number to x, the even one if two are.
template <class Float>
bool is_nearest(Float r, const Rational& x) {
  const Float infinity = std::numeric_limits<Float>::infinity();
  const Rational value = exact::to_rational(double(r)), error = abs(value - x);
  for (const Float other : {std::nextafter(r, -infinity), std::nextafter(r, infinity)}) {
    const Rational others = abs(exact::to_rational(double(other)) - x);
    if (others < error) return false;
    const bool even =
        std::fmod(std::ldexp(r, std::numeric_limits<Float>::digits - 1 - std::ilogb(r == 0 ? 1 : r)), Float(2)) == 0;
    if (others == error && !even) return false;
  }
  return true;
}

/// Near and far origins, binary and other steps.
grid::Lattice random_lattice(Random& random) {
  static const std::array<Rational, 5> steps{1, Rational(1, 3), Rational(1, 1000), Rational(1, 32), Rational(7)};
  grid::Lattice lattice;
  lattice.step = steps[random.below(steps.size())];
  for (Rational& x : lattice.origin)
    if (random.one_in(2)) x = Rational(random.between(-1000000000, 1000000000), random.between(1, 3));
  return lattice;
}

/// Bodies with derived points, and some with split edges.
Body random_body(Random& random) {
  if (random.one_in(3)) {
    const LatticeSet set = lattice_set([&](std::uint64_t n) { return random.below(n); });
    return body_of(canonical(boundary(set, 1)));
  }
  Solids solids(random, families[random.below(4)]);
  const Body a = solids.next(), b = solids.next();
  return odd(a, b);
}

/// A box with two voids that share an edge: this is split.
Body with_a_split_edge() {
  return minus(box({0, 0, 0}, {4, 4, 4}), any(box({1, 1, 1}, {2, 2, 2}), box({2, 2, 1}, {3, 3, 2})));
}

TEST(RoundedPoints, AreTheNearestOnes) {
  std::size_t added = 0;
  for (std::uint64_t number = 0; number < case_count(200); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0x20D, number);
    const Body body = number == 0 ? with_a_split_edge() : random_body(random);
    const grid::Lattice lattice = random_lattice(random);
    const Triangulated mesh = separated(body, triangulated(body));
    const auto doubles = rounded_points(body, mesh, lattice, Floats::float64);
    const auto floats = rounded_points(body, mesh, lattice, Floats::float32);
    added += mesh.added.size();

    ASSERT_EQ(doubles.size(), 3 * mesh.vertex_count());
    ASSERT_EQ(floats.size(), 3 * mesh.vertex_count());
    for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
      const RationalPoint p = position(body, mesh, v);
      for (std::size_t k = 0; k < 3; ++k) {
        const Rational x = lattice.origin[k] + lattice.step * p[k];
        ASSERT_TRUE(is_nearest(doubles[3 * v + k], x)) << x;
        ASSERT_EQ(static_cast<float>(floats[3 * v + k]), floats[3 * v + k]);
        ASSERT_TRUE(is_nearest(static_cast<float>(floats[3 * v + k]), x)) << x;
        ASSERT_FALSE(std::signbit(doubles[3 * v + k]) && doubles[3 * v + k] == 0);
      }
    }
  }
  EXPECT_GT(added, 0u);
}

/// Through the corners' exact places and the rounded ones, all rational.
RoundingEffects effects_by_rationals(const Body& body, const Triangulated& mesh, const std::vector<double>& points) {
  using Corners = std::array<RationalPoint, 3>;
  const auto normal = [](const Corners& p) {
    RationalPoint n;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      n[k] = (p[1][i] - p[0][i]) * (p[2][j] - p[0][j]) - (p[1][j] - p[0][j]) * (p[2][i] - p[0][i]);
    }
    return n;
  };

  RoundingEffects effects;
  for (std::size_t n = 0; n < mesh.triangle_count(); ++n) {
    Corners exact_corners, rounded;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t v = mesh.triangle(n)[i];
      exact_corners[i] = position(body, mesh, v);
      for (std::size_t k = 0; k < 3; ++k) rounded[i][k] = exact::to_rational(points[3 * v + k]);
    }
    const RationalPoint a = normal(exact_corners), b = normal(rounded);
    const Rational dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    if (b == RationalPoint{})
      ++effects.collapsed;
    else
      effects.flipped += dot < 0;
  }
  return effects;
}

TEST(RoundingEffects, AgreeWithRationals) {
  RoundingEffects sum;
  for (std::uint64_t number = 0; number < case_count(300); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0x20E, number);
    const Body body = random_body(random);
    const grid::Lattice lattice = random_lattice(random);
    const Triangulated mesh = separated(body, triangulated(body));
    for (const Floats floats : {Floats::float32, Floats::float64}) {
      const auto points = rounded_points(body, mesh, lattice, floats);
      const RoundingEffects found = rounding_effects(body, mesh, lattice, floats, points);
      ASSERT_EQ(found, effects_by_rationals(body, mesh, points));
      sum.flipped += found.flipped;
      sum.collapsed += found.collapsed;
    }
  }
  if (case_count(300) >= 300) {
    EXPECT_GT(sum.flipped, 0u);
    EXPECT_GT(sum.collapsed, 0u);
  }
}

}  // namespace
}  // namespace quoin::booleans::testing
