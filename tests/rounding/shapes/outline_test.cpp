#include "rounding/shapes/outline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "rounding/shapes/primitives.h"
#include "tests/rounding/shapes/soundness.h"

namespace quoin::rounding::testing {
namespace {

TEST(OutlineTest, ExtrusionsDropStraightCorners) {
  const Loop plain = square(0, 0, 2);
  const Loop more{{1, 0}, {Rational(3, 2), 0}, {2, 0}, {2, half()}, {2, 1}, {2, 2}, {0, 2}, {0, 1},
                  {0, 0}, {half(), 0}};
  for (const Loop& l : {more, reversed(more)}) {
    const Polyhedron p = sound(extrusion({{l}}, {0, 0, 1}));
    EXPECT_EQ(p.face_count(), 6u);
    EXPECT_EQ(p.points.size(), 8u);
    EXPECT_EQ(volume(p), 4);
  }
}

// A corner given twice in a row is no corner more, or a refusal; never another polygon.
TEST(OutlineTest, ExtrusionsWithRepeatedCorners) {
  for (std::size_t at = 0; at < 4; ++at)
    for (std::size_t times = 1; times <= 2; ++times) {
      Loop l = square(0, 0, 2);
      l.insert(l.begin() + static_cast<std::ptrdiff_t>(at), times, PlanePoint(l[at]));
      const auto p = extrusion({{l}}, {0, 0, 1});
      if (p) {
        EXPECT_EQ(volume(p.value()), 4) << at;
      } else {
        EXPECT_EQ(p.error().code, ErrorCode::bad_primitive);
      }
    }
  // The first corner again at the end.
  Loop closed = square(0, 0, 2);
  closed.push_back(closed.front());
  const auto p = extrusion({{closed}}, {0, 0, 1});
  if (p) {
    EXPECT_EQ(volume(p.value()), 4);
  }
}

TEST(OutlineTest, ExtrusionsRefuseWhatIsNoRegion) {
  const Vector up{0, 0, 1};
  const Loop big = square(0, 0, 10);
  expect_refusal(extrusion({{big}}, {1, 2, 0}));
  expect_refusal(extrusion({{big}}, {0, 0, 0}));
  expect_refusal(extrusion({{}}, up));
  expect_refusal(extrusion({{big}, {}}, up));
  expect_refusal(extrusion({{Loop{}}}, up));
  expect_refusal(extrusion({{{{0, 0}, {1, 1}}}}, up));
  expect_refusal(extrusion({{{{0, 0}, {1, 1}, {3, 3}}}}, up));
  expect_refusal(extrusion({{big, {{1, 1}, {2, 2}, {3, 3}, {2, 2}}}}, up));
  // A bow tie, with areas that cancel and with ones that do not.
  expect_refusal(extrusion({{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}}}, up));
  expect_refusal(extrusion({{{{0, 0}, {3, 3}, {3, 0}, {0, 2}}}}, up));
  // A corner on another side; a corner that is two.
  expect_refusal(extrusion({{{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}}}, up));
  expect_refusal(extrusion({{{{0, 0}, {4, 0}, {2, 2}, {4, 4}, {0, 4}, {2, 2}}}}, up));
  // Holes outside, around, crossing, touching, in one another, twice.
  expect_refusal(extrusion({{big, square(20, 0, 1)}}, up));
  expect_refusal(extrusion({{big, square(-1, -1, 12)}}, up));
  expect_refusal(extrusion({{big, square(8, 8, 4)}}, up));
  expect_refusal(extrusion({{big, square(8, 4, 2)}}, up));
  expect_refusal(extrusion({{big, square(9, 9, 1)}}, up));
  expect_refusal(extrusion({{big, {{5, 0}, {6, 3}, {4, 3}}}}, up));
  expect_refusal(extrusion({{big, big}}, up));
  expect_refusal(extrusion({{big, square(2, 2, 4), square(3, 3, 1)}}, up));
  expect_refusal(extrusion({{big, square(3, 3, 1), square(2, 2, 4)}}, up));
  expect_refusal(extrusion({{big, square(2, 2, 4), square(5, 5, 3)}}, up));
  expect_refusal(extrusion({{big, square(2, 2, 2), square(4, 2, 2)}}, up));
  expect_refusal(extrusion({{big, square(2, 2, 2), square(4, 4, 2)}}, up));
  // Polygons that overlap, touch, lie in one another.
  expect_refusal(extrusion({{big}, {square(5, 5, 10)}}, up));
  expect_refusal(extrusion({{big}, {square(10, 0, 10)}}, up));
  expect_refusal(extrusion({{big}, {square(10, 10, 10)}}, up));
  expect_refusal(extrusion({{big}, {square(5, 5, 1)}}, up));
  expect_refusal(extrusion({{square(5, 5, 1)}, {big}}, up));
  expect_refusal(extrusion({{big}, {big}}, up));
  expect_refusal(extrusion({{big, square(2, 2, 4)}, {square(2, 2, 4)}}, up));
  expect_refusal(extrusion({{big, square(2, 2, 4)}, {square(7, 7, 1)}}, up));
  // A side that runs out and back.
  expect_refusal(extrusion({{{{0, 0}, {4, 0}, {4, 6}, {4, 4}, {0, 4}}}}, up));
}

// An outline that begins at the height of another one's corners is inside or outside all the same.
TEST(OutlineTest, CornersAtOneHeight) {
  const Vector up{0, 0, 1};
  for (const int x : {-5, 5})
    for (const int y : {-2, 0, 2})
      EXPECT_EQ(volume(sound(extrusion({{square(0, 0, 2)}, {square(x, y, 2)}}, up), 4)), 8) << x << ' ' << y;
  const Loop diamond{{0, -4}, {4, 0}, {0, 4}, {-4, 0}};
  // Clockwise, as holes are: they begin with their left corner and with their right one.
  for (const Loop& hole : {Loop{{-1, 0}, {0, 1}, {1, 0}}, Loop{{1, 0}, {0, -1}, {-1, 0}}})
    EXPECT_EQ(volume(sound(extrusion({{diamond, hole}}, up), 0)), 31);
}

// Second way for crossings: all pairs of sides in all small pentagons.
TEST(OutlineTest, ExtrusionsRefuseAllCrossings) {
  std::mt19937_64 random = generator(609);
  const auto orient = [](const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
    return sign_of(Rational((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])));
  };
  const auto between_ends = [&](const PlanePoint& p, const PlanePoint& a, const PlanePoint& b) {
    return orient(a, b, p) == 0 && (p[0] - a[0]) * (p[0] - b[0]) + (p[1] - a[1]) * (p[1] - b[1]) <= 0;
  };
  int simple_ones = 0;
  for (int i = 0; i < 4000; ++i) {
    Loop l(4 + below(random, 3));
    for (PlanePoint& p : l) p = {between(random, 0, 4), between(random, 0, 4)};
    const std::size_t n = l.size();
    bool simple = true, straight = false;
    for (std::size_t a = 0; a < n; ++a) {
      straight = straight || orient(l[a], l[(a + 1) % n], l[(a + 2) % n]) == 0;
      for (std::size_t b = 0; b < n; ++b) {
        if (b != a && b != (a + 1) % n) simple = simple && !between_ends(l[b], l[a], l[(a + 1) % n]);
        const PlanePoint &p = l[a], &q = l[(a + 1) % n], &r = l[b], &s = l[(b + 1) % n];
        simple = simple && !(orient(p, q, r) * orient(p, q, s) < 0 && orient(r, s, p) * orient(r, s, q) < 0);
      }
    }
    // Straight corners have a test of their own.
    if (straight) continue;
    simple_ones += simple ? 1 : 0;
    const auto p = extrusion({{l}}, {0, 0, 1});
    ASSERT_EQ(p.has_value(), simple);
    if (p) {
      ASSERT_EQ(volume(sound(p)), magnitude(doubled_area(l)) / 2);
    }
  }
  EXPECT_GT(simple_ones, 200);
}

}  // namespace
}  // namespace quoin::rounding::testing
