#include "rounding/planes/plane_rounding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "tests/rounding/planes/planes.h"

namespace quoin::rounding::testing {
namespace {

/// Three or more points of a plane, with the plane; of about `size` bits.
struct Face {
  WidePlane plane;
  std::vector<Vector> points;
};
Face random_face(std::mt19937_64& random, unsigned size) {
  for (;;) {
    const auto point = [&] {
      return Vector{biased_integer(random, size), biased_integer(random, size), biased_integer(random, size)};
    };
    const AffineMap map{matrix(random_quaternion(random, 30)),
                        {Rational(biased_integer(random, size), 1000), biased_integer(random, size), 0}};
    const Vector a = point(), e = point() - a, f = point() - a;
    const Vector n{e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]};
    if (n == Vector{0, 0, 0}) continue;
    Face face{moved(wide_plane(n, -dot(n, a)), inverse(map)), {a, a + e, a + f, a + e + f}};
    for (Vector& p : face.points) p = map(p);
    return face;
  }
}

TEST(FaceLocalTest, FaceLocalIsNeverFartherThanBest) {
  std::mt19937_64 random = generator(358);
  int nearer = 0, count = 0;
  for (const unsigned bits : {3u, 5u, 8u, 16u, 32u, 48u, 62u}) {
    const PlaneRounder r = rounder(bits);
    for (int i = 0; i < 12; ++i) {
      const Face face = random_face(random, std::clamp(bits / 2, 2u, 20u));
      const auto best = r.round(face.plane, Method::best), near = r.round_near(face.plane, face.points);
      ASSERT_TRUE(near.has_value() || !best.has_value());
      if (!near) continue;
      ASSERT_TRUE(r.fits(wide(*near)));
      const auto opposite = r.round_near(face.plane.opposite(), face.points);
      ASSERT_TRUE(opposite.has_value());
      ASSERT_EQ(opposite->opposite(), *near);
      if (!best) continue;
      const Rational there = squared_displacement(*near, face.points), here = squared_displacement(*best, face.points);
      ASSERT_LE(there, here) << bits;
      ASSERT_GE(dot_of(normal(*near), face.plane.n), 0);
      if (r.fits(face.plane)) continue;
      ++count;
      nearer += there < here ? 1 : 0;
    }
  }
  // It is worth its while.
  EXPECT_GE(4 * nearer, count);
}

}  // namespace
}  // namespace quoin::rounding::testing
