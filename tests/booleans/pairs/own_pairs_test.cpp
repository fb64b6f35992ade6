#include "booleans/pairs/own_pairs.h"

#include <gtest/gtest.h>

#include "tests/booleans/pairs/fans.h"

namespace quoin::booleans::testing {
namespace {

// Fans as a whole, boxes and slabs against all pairs.
TEST(ImproperPairs, AreThoseThatMeetImproperly) {
  std::size_t meshes = 0, improper = 0;
  for (std::uint64_t number = 0; number < case_count(400); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0x1A9, number);
    const auto mesh = with_fans(random);
    if (!mesh) continue;
    ++meshes;
    const std::set<FacePair> expected = improper_by_pairs(*mesh);
    const auto found = improper_pairs(*mesh, stars(*mesh));
    EXPECT_EQ(std::set<FacePair>(found.begin(), found.end()), expected);
    EXPECT_EQ(found.size(), expected.size());
    improper += expected.size();
  }
  EXPECT_GT(meshes, case_count(400) / 2);
  EXPECT_GT(improper, case_count(400));
}

// The edge that faces the common corner, of the first or of the second one, may meet the other triangle; mirrored they
// come in the other order.
TEST(ImproperPairs, TrianglesOfOneCorner) {
  const auto pairs = [](std::int32_t reach, std::int32_t way) {
    Body mesh;
    mesh.grid_points = {
        {{0, 0, 0}}, {{way * 10, -10, 0}}, {{way * 10, 10, 0}}, {{way * reach, 0, -3}}, {{way * reach, 0, 3}}};
    mesh.triangles.push_back({0, 1, 2});
    mesh.triangles.push_back({0, 3, 4});
    return improper_pairs(mesh, Array<Star>(5, Star::other)).size();
  };
  for (const std::int32_t way : {1, -1}) {
    EXPECT_EQ(pairs(4, way), 1u);
    EXPECT_EQ(pairs(20, way), 1u);
    EXPECT_EQ(pairs(-4, way), 0u);
  }
}

}  // namespace
}  // namespace quoin::booleans::testing
