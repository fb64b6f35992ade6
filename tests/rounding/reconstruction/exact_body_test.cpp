#include "rounding/reconstruction/exact_body.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/rounding/reconstruction/placements.h"

namespace quoin::rounding::testing {
namespace {

TEST(ExactBodyTest, ExactMotions) {
  std::mt19937_64 random = generator(648);
  const Shape shapes[] = {
      shape(block({3, 2, 1})),
      shape(frustum(4, 6, 0, 9, Fit::inscribed)),
      shape(frustum(4, 0, 6, 9, Fit::inscribed)),
      shape(sphere(8, 4)),
      shape(torus(5, 2, 4, 4)),
      shape(wedge({4, 2, 5}, 2)),
      shape(convex_hull(std::vector<Vector>{{0, 0, 0}, {9, 0, 0}, {0, 9, 1}, {1, 2, 9}, {7, 7, 7}}))};
  for (const Shape& s : shapes) {
    const Body still = made(placed(s)).body;
    for (int i = 0; i < 12; ++i) {
      Motion motion;
      for (int k = 0; k < 3; ++k) {
        Vector axis{0, 0, 0};
        axis[below(random, 3)] = 1;
        motion = motion.then(Motion::rotation(axis, 90 * between(random, -1, 2)))
                     .then(Motion::translation({between(random, -99, 99), between(random, -99, 99), 7}));
        if (below(random, 4) == 0) motion = motion.then(Motion::mirror(axis));
      }
      const Placement placement = placed(s, realize(motion).map);
      const Reconstruction all = made(std::vector{placement});
      const Reconstructed& r = all.primitives[0];
      EXPECT_EQ(r.displacement, 0);
      EXPECT_TRUE(r.by_planes);
      EXPECT_EQ(all.exact_planes, all.planes);
      EXPECT_EQ(booleans::volume(r.body), volume(s.polyhedron));
      const Canonical form = booleans::canonical(r.body);
      std::set<Vector> points;
      for (const exact::Point& v : form.vertices) points.insert(vertex(v));
      const auto expected = carried(placement);
      EXPECT_EQ(points, std::set(expected.begin(), expected.end()));
      EXPECT_EQ(form.face_count(), s.polyhedron.face_count());
      expect_clean(r.body);
      // And back again it is what it was.
      const Shape there(polyhedron_of(form));
      EXPECT_TRUE(booleans::canonical(made(placed(there, inverse(placement.to_grid))).body) ==
                  booleans::canonical(still));
    }
  }
}

}  // namespace
}  // namespace quoin::rounding::testing
