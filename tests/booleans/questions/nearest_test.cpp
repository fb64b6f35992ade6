#include "booleans/questions/nearest.h"

#include <gtest/gtest.h>

#include "booleans/questions/along_line.h"
#include "tests/booleans/questions/places.h"

namespace quoin::booleans::testing {
namespace {

Rational squared_between(const RationalPlace& p, const RationalPlace& q) {
  Rational r = 0;
  for (std::size_t k = 0; k < 3; ++k) r += (p[k] - q[k]) * (p[k] - q[k]);
  return r;
}

/// The second way: of all faces of the canonical form the feet of perpendiculars that they hold, of all edges those
/// between their ends, and all vertices.
std::pair<Rational, RationalPlace> nearest_of_all(const Boundary& form, const RationalPlace& p) {
  std::optional<std::pair<Rational, RationalPlace>> best;
  const auto offer = [&](const RationalPlace& q) {
    const std::pair found(squared_between(p, q), q);
    if (!best || found < *best) best = found;
  };
  const auto vertex = [&](std::uint32_t v) {
    RationalPlace q;
    for (std::size_t k = 0; k < 3; ++k) q[k] = exact::coordinate(form.vertices[v], static_cast<int>(k));
    return q;
  };
  for (std::uint32_t v = 0; v < form.vertices.size(); ++v) offer(vertex(v));
  for (std::size_t f = 0; f < form.face_count(); ++f) {
    const exact::Plane& plane = form.planes[f];
    const RationalPlace n{plane.n[0], plane.n[1], plane.n[2]};
    const RationalPlace foot = point_along(p, n, -value_at(plane, p) / slope_along(plane, n));
    if (face_holds(form, f, foot)) offer(foot);
    form.faces.for_edges(f, [&](std::uint32_t from, std::uint32_t to) {
      const RationalPlace u = vertex(from), v = vertex(to);
      Rational along = 0;
      for (std::size_t k = 0; k < 3; ++k) along += (p[k] - u[k]) * (v[k] - u[k]);
      const Rational t = along / squared_between(u, v);
      const RationalPlace d{Rational(v[0] - u[0]), Rational(v[1] - u[1]), Rational(v[2] - u[2])};
      if (t > 0 && t < 1) offer(point_along(u, d, t));
    });
  }
  return *best;
}

TEST(Nearest, AgreesWithAllFacesEdgesAndVertices) {
  std::size_t on_boundary = 0, off = 0;
  for (const Family family : families)
    for (std::uint64_t number = 0; number < case_count(20); ++number) {
      SCOPED_TRACE(std::string(name_of(family)) + " " + case_name(number));
      Random random(0x4EA, number);
      Solids solids(random, family);
      Body body = solids.next();
      if (random.one_in(2)) body = odd(body, solids.next());
      if (random.one_in(4)) body = complement(body);
      body = packed(body);
      if (body.face_count() == 0) continue;
      const Index index(body);
      const Canonical form = canonical(body);
      for (int i = 0; i < 5; ++i) {
        RationalPlace p = any_place(random, body);
        if (random.one_in(3))
          for (std::size_t k = 0; k < 3; ++k) p[k] *= random.between(-40, 40);
        const auto found = nearest(index, QueryPoint(p));
        ASSERT_TRUE(found);
        const auto [squared, point] = nearest_of_all(form, p);
        ASSERT_EQ(found->squared_distance, squared);
        ASSERT_EQ(found->point, point);
        for (std::uint32_t f = 0; f < form.face_count(); ++f)
          ASSERT_EQ(std::binary_search(found->faces.begin(), found->faces.end(), f), face_holds(form, f, point));
        ASSERT_EQ(squared == 0, locate(index, QueryPoint(p)) == 0);
        ++(squared == 0 ? on_boundary : off);
      }
    }
  EXPECT_GT(on_boundary, 0u);
  EXPECT_GT(off, 0u);
}

// From the middle of a cube all faces are equally near: the first place counts.
TEST(Nearest, FromTheMiddleAndFromAfar) {
  const Index cube(box({0, 0, 0}, {2, 2, 2}));
  const auto middle = nearest(cube, QueryPoint(RationalPlace{1, 1, 1}));
  EXPECT_EQ(middle->squared_distance, 1);
  EXPECT_EQ(middle->point, (RationalPlace{0, 1, 1}));
  EXPECT_EQ(middle->faces, std::vector<std::uint32_t>{0});
  const Rational far(exact::Integer(exact::Integer(1) << 2000));
  EXPECT_EQ(nearest(cube, QueryPoint(RationalPlace{far, 1, far}))->point, (RationalPlace{2, 1, 2}));
  EXPECT_FALSE(nearest(Index(Body()), QueryPoint(RationalPlace{0, 0, 0})));
}

}  // namespace
}  // namespace quoin::booleans::testing
