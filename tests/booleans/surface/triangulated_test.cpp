#include "booleans/surface/triangulated.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "tests/booleans/support.h"
#include "tests/booleans/surface/position.h"

namespace quoin::booleans::testing {
namespace {

using exact::Rational;

RationalPoint difference(const RationalPoint& a, const RationalPoint& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
RationalPoint cross(const RationalPoint& u, const RationalPoint& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}
RationalPoint place(const Body& body, std::uint32_t v) {
  const exact::Point p = body.point(v);
  return {exact::coordinate(p, 0), exact::coordinate(p, 1), exact::coordinate(p, 2)};
}
void add(RationalPoint& sum, const RationalPoint& v) {
  for (std::size_t k = 0; k < 3; ++k) sum[k] += v[k];
}

/// Twice the area vector of a face, through its loops.
RationalPoint area_by_loops(const Body& body, std::uint32_t face) {
  RationalPoint sum{};
  body.for_edges(face, [&](std::uint32_t u, std::uint32_t v) { add(sum, cross(place(body, u), place(body, v))); });
  return sum;
}

/// Closed, each face covered by proper triangles on it, each vertex in use once.
void expect_triangulation(const Body& body) {
  const Triangulated mesh = triangulated(body);
  ASSERT_TRUE(mesh.added.empty());
  ASSERT_EQ(mesh.corners.size(), 3 * mesh.triangle_count());
  std::map<std::array<std::uint32_t, 2>, int> balance;
  std::map<std::uint32_t, RationalPoint> area;  // by face
  for (std::size_t n = 0; n < mesh.triangle_count(); ++n) {
    const auto t = mesh.triangle(n);
    std::array<RationalPoint, 3> p;
    for (std::size_t i = 0; i < 3; ++i) {
      ASSERT_LT(t[i], mesh.vertex_count());
      p[i] = position(body, mesh, t[i]);
      ASSERT_EQ(p[i], place(body, mesh.source[t[i]]));
      const std::uint32_t u = t[i], v = t[(i + 1) % 3];
      balance[{std::min(u, v), std::max(u, v)}] += u < v ? 1 : -1;
    }

    const RationalPoint twice = cross(difference(p[1], p[0]), difference(p[2], p[0]));
    const exact::Plane plane = body.plane(mesh.face[n]);
    Rational dot = 0;
    for (std::size_t k = 0; k < 3; ++k) dot += twice[k] * plane.n[k];
    ASSERT_GT(dot, 0);
    add(area[mesh.face[n]], twice);
  }

  for (const auto& [edge, sum] : balance) ASSERT_EQ(sum, 0);
  std::set<std::uint32_t> used;
  body.for_runs([&](std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t face = begin; face < end; ++face) {
      body.for_corners(face, [&](std::uint32_t v) { used.insert(v); });
      ASSERT_EQ(area[face], area_by_loops(body, face));
    }
  });
  EXPECT_EQ(mesh.source, Array<std::uint32_t>(used.begin(), used.end()));
  EXPECT_TRUE(std::is_sorted(mesh.face.begin(), mesh.face.end()) || !body.is_packed);
}

TEST(Triangulated, RandomBooleans) {
  for (std::uint64_t number = 0; number < case_count(300); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0x7A1, number);
    Solids solids(random, families[random.below(families.size())]);
    const Body a = solids.next(), b = solids.next();
    for (const Body& body : {any(a, b), all(a, b), minus(a, b), complement(odd(a, b))}) expect_triangulation(body);
    if (HasFatalFailure()) break;
  }
}

// Four corners: two triangles, whichever corner the loop begins with.
TEST(Triangulated, QuadrilateralsDoNotDependOnWhereTheyBegin) {
  const Body cube = body_of(canonical(box({0, 0, 0}, {3, 4, 5})));
  const auto pieces_of = [](const Body& body) {
    const Triangulated mesh = triangulated(body);
    std::set<std::set<std::uint32_t>> pieces;
    for (std::size_t n = 0; n < mesh.triangle_count(); ++n) {
      const auto t = mesh.triangle(n);
      pieces.insert({mesh.source[t[0]], mesh.source[t[1]], mesh.source[t[2]]});
    }
    return pieces;
  };

  Body turned = cube;
  const auto corners = turned.polygons.corners.edit();
  for (std::size_t i = 0; i < corners.size(); i += 4)
    std::rotate(corners.begin() + static_cast<std::ptrdiff_t>(i), corners.begin() + static_cast<std::ptrdiff_t>(i + 1),
                corners.begin() + static_cast<std::ptrdiff_t>(i + 4));
  EXPECT_EQ(pieces_of(cube).size(), 12u);
  EXPECT_EQ(pieces_of(cube), pieces_of(turned));
}

}  // namespace
}  // namespace quoin::booleans::testing
