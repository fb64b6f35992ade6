#include "booleans/body/fault.h"

#include <gtest/gtest.h>

#include "tests/booleans/support.h"

namespace quoin::booleans::testing {
namespace {

Body half(const exact::Plane& plane) { return half_space_body(plane, {{0, 0, 0}}, {{4, 4, 4}}); }

TEST(Fault, NamesTheFirst) {
  EXPECT_EQ(fault(box({0, 0, 0}, {4, 4, 4})), std::nullopt);

  Body open = box({0, 0, 0}, {4, 4, 4});
  std::swap(open.triangles.edit()[0][1], open.triangles.edit()[0][2]);
  EXPECT_EQ(fault(open), "the edge from vertex 0 to vertex 4 is not balanced by its reverse");

  Body outside = box({0, 0, 0}, {exact::world, 1, 1});
  for (auto& p : outside.grid_points.edit()) p.c[0] += 1;
  EXPECT_NE(fault(outside).value_or("").find("outside the world"), std::string::npos);
  EXPECT_EQ(fault(outside, exact::world + 1), std::nullopt);

  Body flat = box({0, 0, 0}, {4, 4, 4});
  for (auto& p : flat.grid_points.edit()) p.c[2] = 0;
  EXPECT_NE(fault(flat).value_or("").find("no area"), std::string::npos);

  Body missing = box({0, 0, 0}, {4, 4, 4});
  missing.triangles.edit()[0][1] = 8;
  EXPECT_NE(fault(missing).value_or("").find("does not exist"), std::string::npos);
}

TEST(Fault, OfPolygons) {
  const exact::Plane cut{{1, 2, 3}, -exact::int128{11}};
  EXPECT_EQ(fault(half(cut)), std::nullopt);

  Body off = half(cut);
  off.planes.edit()[0].d += 1;
  EXPECT_NE(fault(off).value_or("").find("off its plane"), std::string::npos);

  Body twice = half(cut);
  auto& p = twice.planes.edit().back();
  for (auto& n : p.n) n *= 2;
  p.d *= 2;
  EXPECT_NE(fault(twice).value_or("").find("not reduced"), std::string::npos);
}

}  // namespace
}  // namespace quoin::booleans::testing
