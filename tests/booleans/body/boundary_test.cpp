#include "booleans/body/boundary.h"

#include <gtest/gtest.h>

#include "booleans/body/canonical.h"
#include "tests/booleans/support.h"

namespace quoin::booleans::testing {
namespace {

// A body of a boundary has its faces, planes and points, the triangles between grid points without planes of their own.
TEST(Boundary, ABodyHasItsFaces) {
  std::size_t raw = 0, polygons = 0;
  for (std::uint64_t number = 0; number < case_count(100); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0xB0D, number);
    Solids solids(random, families[number % families.size()]);
    const Canonical form = canonical(odd(solids.next(), solids.next()));
    const Body body = body_of(form);
    ASSERT_EQ(body.face_count(), form.face_count());
    EXPECT_EQ(body.vertex_count(), form.vertices.size());
    EXPECT_EQ(body.full_at_infinity, form.full_at_infinity);

    const auto order = faces_in_order_of_body(form);
    std::uint32_t triangle = 0, polygon = static_cast<std::uint32_t>(body.triangles.size());
    for (std::size_t f = 0; f < form.face_count(); ++f) {
      const std::uint32_t face = is_raw(form, f) ? triangle++ : polygon++;
      EXPECT_EQ(order[face], f);
      EXPECT_TRUE(body.plane(face) == form.planes[f]);
      const auto own = body.corners_of(face), given = form.faces.corners_of(f);
      ASSERT_EQ(own.size(), given.size());
      for (std::size_t i = 0; i < own.size(); ++i)
        EXPECT_EQ(exact::compare_lexicographic(body.point(own[i]), form.vertices[given[i]]), 0);
    }
    raw += body.triangles.size();
    polygons += body.polygon_count();
  }
  EXPECT_GT(raw, 0u);
  EXPECT_GT(polygons, 0u);
}

}  // namespace
}  // namespace quoin::booleans::testing
