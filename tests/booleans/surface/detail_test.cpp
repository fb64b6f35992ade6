#include "booleans/surface/detail.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/booleans/support.h"

namespace quoin::booleans::testing {
namespace {

double distance(const std::array<double, 3>& p, const std::array<double, 3>& q) {
  const double x = p[0] - q[0], y = p[1] - q[1], z = p[2] - q[2];
  return std::sqrt(x * x + y * y + z * z);
}

/// The same by all edges and all pairs of vertices, in grid steps.
double by_all_pairs(const Body& body, const Triangulated& mesh, double reach) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto at = [&](std::uint32_t v) { return body.approximation(mesh.source[v]); };
  double edge = infinity, gap = infinity;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t)
    for (std::size_t i = 0; i < 3; ++i)
      edge = std::min(edge, distance(at(mesh.triangle(t)[i]), at(mesh.triangle(t)[(i + 1) % 3])));
  for (std::uint32_t v = 0; v < mesh.source.size(); ++v)
    for (std::uint32_t u = 0; u < v; ++u)
      if (const double d = distance(at(u), at(v)); d > 0 && d < reach) gap = std::min(gap, d);
  const double least = edge > reach ? std::min(edge, gap) : edge;
  return std::isfinite(least) ? least : 0;
}

TEST(LeastDetail, AgreesWithAllPairs) {
  std::size_t near = 0;
  for (std::uint64_t number = 0; number < case_count(150); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0xDE7A, number);
    Solids solids(random, families[random.below(6)]);
    const Body a = solids.next(), b = solids.next(), body = odd(a, b);
    const Triangulated mesh = triangulated(body);
    grid::Lattice lattice;
    for (int exponent = -30; exponent <= 26; exponent += 4) {
      const double reach = std::ldexp(1.3, exponent);
      const double expected = by_all_pairs(body, mesh, reach);
      ASSERT_EQ(least_detail(body, mesh, lattice, reach), expected) << reach;
      near += expected > 0 && expected < reach;
    }
  }
  EXPECT_GT(near, 0u);
}

}  // namespace
}  // namespace quoin::booleans::testing
