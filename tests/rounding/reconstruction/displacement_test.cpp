#include "rounding/reconstruction/displacement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "tests/rounding/reconstruction/placements.h"

namespace quoin::rounding::testing {
namespace {

// The true points lie anywhere within half a unit of the rounded ones.
TEST(DisplacementTest, DistancesAreBoundedFromAbove) {
  std::mt19937_64 random = generator(656);
  for (int i = 0; i < 200; ++i) {
    const auto bits = 1 + static_cast<unsigned>(below(random, 200));
    std::array<Integer, 3> a, b;
    Vector p, q;
    for (std::size_t k = 0; k < 3; ++k) {
      a[k] = biased_integer(random, bits);
      b[k] = below(random, 3) == 0 ? a[k] : biased_integer(random, bits);
      const auto near = [&](const Integer& x) -> Rational {
        return (Rational(x) + Rational(between(random, -50, 50), 100)) / Rational(power_of_2(unit_bits));
      };
      p[k] = near(a[k]);
      q[k] = near(b[k]);
    }
    const Rational bound = distance_above(a, b), unit(1, power_of_2(unit_bits));
    ASSERT_GE(bound * bound, dot(p - q, p - q));
    ASSERT_LE(bound, true_root(dot(p - q, p - q), MPFR_RNDU) + 6 * unit);
  }
}

TEST(DisplacementTest, TheFarthestVertexDecides) {
  std::mt19937_64 random = generator(657);
  const Shape box = shape(block({300, 200, 100}));
  for (int i = 0; i < 10; ++i) {
    const Placement placement = placed(box, random_motion(random));
    const auto& points = box.polyhedron.points;
    // Vertices that are all where they should be, to a step, but one.
    booleans::Boundary boundary;
    Rational most = 0;
    for (std::size_t v = 0; v < points.size(); ++v) {
      const Vector p = placement.to_grid(points[v]);
      exact::GridPoint g{};
      for (std::size_t k = 0; k < 3; ++k) g.c[k] = static_cast<std::int32_t>(nearest_integer(p[k]));
      if (v == static_cast<std::size_t>(i) % points.size()) g.c[0] += 1000;
      boundary.vertices.push_back(exact::point(g));
      const Vector e = p - vertex(boundary.vertices.back());
      most = std::max(most, Rational(dot(e, e)));
    }
    const Rational bound = displacement_above(points, IntegerMap(placement.to_grid), boundary);
    EXPECT_GT(bound, 998);
    EXPECT_GE(bound * bound, most);
    EXPECT_LE(bound * bound, most * (1 + Rational(1, power_of_2(150))));
  }
}

}  // namespace
}  // namespace quoin::rounding::testing
