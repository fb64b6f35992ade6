#include "booleans/body/simple.h"

#include <gtest/gtest.h>

#include "grid/lists/thresholds.h"
#include "tests/booleans/support.h"

namespace quoin::booleans::testing {
namespace {

using Corner = std::array<int, 2>;
using Loop = std::vector<Corner>;

int cross(const Corner& a, const Corner& b, const Corner& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}
bool is_between(const Corner& a, const Corner& p, const Corner& b) {
  return cross(a, b, p) == 0 && (p[0] - a[0]) * (p[0] - b[0]) + (p[1] - a[1]) * (p[1] - b[1]) <= 0;
}
bool have_common_point(const Corner& a, const Corner& b, const Corner& c, const Corner& d) {
  const auto sign = [](int x) { return (x > 0) - (x < 0); };
  const bool cross_each_other = sign(cross(a, b, c)) * sign(cross(a, b, d)) < 0 &&  //
                                sign(cross(c, d, a)) * sign(cross(c, d, b)) < 0;
  return cross_each_other || is_between(a, c, b) || is_between(a, d, b) || is_between(c, a, d) || is_between(c, b, d);
}

/// By definition, with the area by the sum of all triangles from the first corner.
bool is_simple(const Loop& loop) {
  const std::size_t n = loop.size();
  const auto at = [&](std::size_t i) { return loop[i % n]; };
  int area = 0;
  for (std::size_t i = 0; i < n; ++i) {
    area += cross(at(0), at(i), at(i + 1));
    if (cross(at(i), at(i + 1), at(i + 2)) == 0) return false;
    for (std::size_t j = i + 2; j < n; ++j)
      if (j + 1 - i != n && have_common_point(at(i), at(i + 1), at(j), at(j + 1))) return false;
  }
  return area > 0;
}

/// A polygon on one of three planes, seen from outside as it is.
Body body_of(const Loop& loop, int plane) {
  Body body;
  for (const auto& [u, v] : loop) {
    const exact::GridPoint p = plane == 0   ? exact::GridPoint{{u, v, 5}}
                               : plane == 1 ? exact::GridPoint{{7, v, u}}
                                            : exact::GridPoint{{u, v, u + 2 * v}};
    body.polygons.corners.push_back(static_cast<std::uint32_t>(body.grid_points.size()));
    body.grid_points.push_back(p);
  }
  body.polygons.end_loop();
  body.polygons.end_face();
  body.planes.push_back(plane == 0   ? exact::Plane{{0, 0, 1}, -5}
                        : plane == 1 ? exact::Plane{{-1, 0, 0}, 7}
                                     : exact::Plane{{-1, -2, 1}, 0});
  return body;
}

TEST(ProvedSimple, ExactlyWhereItIsByDefinition) {
  std::size_t simple = 0, others = 0;
  for (std::uint64_t number = 0; number < case_count(20000); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0x51, number);
    Loop loop(static_cast<std::size_t>(random.between(4, 8)));
    const int reach = static_cast<int>(random.between(3, 12));
    for (Corner& c : loop) c = {static_cast<int>(random.between(0, reach)), static_cast<int>(random.between(0, reach))};
    const bool expected = is_simple(loop);
    for (int plane = 0; plane < 3; ++plane)
      EXPECT_EQ(proved_simple(body_of(loop, plane), 0), expected && loop.size() <= grid::thresholds().small_face);
    ++(expected ? simple : others);
  }
  EXPECT_GT(simple, case_count(20000) / 100);
  EXPECT_GT(others, case_count(20000) / 2);
}

TEST(ProvedSimple, OnlyOfOneLoop) {
  Body body = body_of({{0, 0}, {9, 0}, {9, 9}, {0, 9}}, 0);
  EXPECT_EQ(proved_simple(body, 0), grid::thresholds().small_face >= 4);
  body.polygons = {};
  body.polygons.corners = {0, 1, 2, 3, 1};
  body.polygons.loop_start = {0, 4, 5};
  body.polygons.face_start = {0, 2};
  EXPECT_FALSE(proved_simple(body, 0));
}

}  // namespace
}  // namespace quoin::booleans::testing
