#include "booleans/surface/rational_triangles.h"

#include <gtest/gtest.h>

#include "booleans/pairs/triangle_pair.h"
#include "tests/booleans/support.h"

namespace quoin::booleans::testing {
namespace {

using exact::Rational;

/// A mesh of two triangles that may share corners, each of some area.
Body two_triangles(Random& random, std::uint32_t shared) {
  Body mesh;
  for (int i = 0; i < 6; ++i) {
    const Vector v = random.vector(0, 3);
    mesh.grid_points.push_back(exact::GridPoint{
        {static_cast<std::int32_t>(v[0]), static_cast<std::int32_t>(v[1]), static_cast<std::int32_t>(v[2])}});
  }
  mesh.triangles.push_back({0, 1, 2});
  std::array<std::uint32_t, 3> second{3, 4, 5};
  for (std::uint32_t i = 0; i < shared; ++i) second[i] = i;
  mesh.triangles.push_back(second);
  return mesh;
}

RationalTriangle rational_triangle(const Body& mesh, std::uint32_t t) {
  RationalTriangle r;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) r[i][k] = Rational(mesh.grid_points[mesh.triangles[t][i]].c[k]);
  return r;
}

// The same question in 128 bits, between grid points, by other determinants.
TEST(MeetOutOfPlace, AgreesWithIntegers) {
  std::array<std::array<std::size_t, 2>, 3> count{};
  for (std::uint64_t number = 0; number < case_count(20000); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0x2A7A, number);
    const auto shared = static_cast<std::uint32_t>(random.below(3));
    const Body mesh = two_triangles(random, shared);
    const RationalTriangle t = rational_triangle(mesh, 0), u = rational_triangle(mesh, 1);
    const RationalPoint zero{0, 0, 0};
    if (normal(t) == zero || normal(u) == zero) continue;
    // Corners that coincide, but are not shared, are two vertices of the mesh at one place.
    const bool meets = meet_out_of_place(t, u, shared);
    ASSERT_EQ(meets, meet_out_of_place(mesh, 0, 1));
    ++count[shared][meets];
  }
  for (const auto& each : count) {
    EXPECT_GT(each[0], 0u);
    EXPECT_GT(each[1], 0u);
  }
}

}  // namespace
}  // namespace quoin::booleans::testing
