#include "rounding/reconstruction/conditions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/rounding/reconstruction/placements.h"

namespace quoin::rounding::testing {
namespace {

// Of plates ever thinner those that a rounding keeps come out, the others are refused.
TEST(ConditionsTest, PlatesAreKeptOrRefused) {
  std::mt19937_64 random = generator(641);
  int kept = 0, refused = 0, mended = 0;
  for (int i = 0; i < 70; ++i) {
    const unsigned thinness = 35 + static_cast<unsigned>(below(random, 70));
    const Rational size = power_of_2(4 + static_cast<unsigned>(below(random, 17)));
    const Shape plate = shape(block({size, size, 1}));
    // Flattened by to_grid itself, then turned.
    const AffineMap flat{{Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, Rational(1, power_of_2(thinness))}},
                         {0, 0, 0}};
    const Placement placement = placed(plate, composed(flat, random_motion(random)));
    std::array<WidePlane, 6> before, after;
    for (std::size_t f = 0; f < 6; ++f) {
      // Opposite pairs: bottom and top come first, then the sides around.
      const std::size_t at = std::array{0, 1, 2, 4, 3, 5}[f];
      before[f] = moved(plate.polyhedron.planes[at], inverse(placement.to_grid));
      after[f] = wide(*PlaneRounder().round(before[f], Method::best));
    }
    const auto r = reconstruct(std::vector{placement});
    if (r) {
      ++kept;
      const Canonical form = booleans::canonical(r.value().primitives[0].body);
      ASSERT_EQ(form.face_count(), 6u);
      ASSERT_EQ(conditions(form).all, 24u);
      ASSERT_EQ(conditions(form).hold, 24u) << thinness;
      ASSERT_GE(r.value().primitives[0].displacement * r.value().primitives[0].displacement,
                squared_movement(placement, form));
      // Planes rounded a second time are those that had to be.
      ASSERT_EQ(r.value().face_local_planes == 0, is_block(after, before)) << thinness;
      mended += r.value().face_local_planes > 0 ? 1 : 0;
      continue;
    }
    ++refused;
    ASSERT_EQ(r.error().code, ErrorCode::inconsistent_motion);
    ASSERT_FALSE(is_block(after, before));
    for (const char* part : {"primitive 0", "vertex ", "face "})
      ASSERT_NE(r.error().where.find(part), std::string::npos) << r.error().where;
  }
  EXPECT_GT(kept, 15);
  EXPECT_GT(refused, 10);
  EXPECT_GT(mended, 0);
  std::printf("kept %d (face_local %d), refused %d\n", kept, mended, refused);
}

TEST(ConditionsTest, TheVertexAndTheFaceOfARefusal) {
  const Shape plate = shape(block({1024, 1024, Rational(1, power_of_2(200))}));
  const Shape other = shape(block({1, 1, 1}));
  std::mt19937_64 random = generator(642);
  const AffineMap map = random_motion(random);
  const auto r = reconstruct(std::vector{placed(other), placed(plate, map)});
  ASSERT_FALSE(r.has_value());
  EXPECT_EQ(r.error().code, ErrorCode::inconsistent_motion);
  EXPECT_EQ(r.error().where.find("primitive 1, vertex "), 0u) << r.error().where;
  EXPECT_NE(r.error().where.find(", face "), std::string::npos) << r.error().where;
}

TEST(ConditionsTest, ConditionsOfSimpleConvexShapes) {
  std::mt19937_64 random = generator(643);
  const std::vector<Shape> shapes = convex_ones(power_of_2(20));
  for (int i = 0; i < 28; ++i) {
    const Shape& s = shapes[static_cast<std::size_t>(i) % shapes.size()];
    const Placement placement = placed(s, random_motion(random));
    const Reconstructed r = made(placement);
    const std::size_t F = s.polyhedron.face_count();
    const Canonical form = booleans::canonical(r.body);
    // Incidences are kept.
    ASSERT_EQ(form.face_count(), F);
    ASSERT_EQ(form.vertices.size(), s.polyhedron.points.size());
    ASSERT_EQ(booleans::edge_count(form), s.polyhedron.faces.corners.size() / 2);
    const Conditions c = conditions(form);
    ASSERT_EQ(c.all, 2 * (F - 2) * (F - 3));
    ASSERT_EQ(c.hold, c.all);
    ASSERT_TRUE(r.by_planes);
    // The certificate.
    const Rational squared = squared_movement(placement, form);
    ASSERT_GE(r.displacement * r.displacement, squared);
    ASSERT_LE(r.displacement * r.displacement, squared * (1 + Rational(1, power_of_2(50))));
    ASSERT_LT(r.displacement, Rational(1, power_of_2(40)));
    ASSERT_GT(r.displacement, 0);
    expect_clean(r.body);
  }
  std::vector<std::size_t> counts;
  for (const Shape& s : shapes) {
    const auto form = booleans::canonical(made(placed(s)).body);
    counts.push_back(conditions(form).all);
  }
  EXPECT_EQ(counts, (std::vector<std::size_t>{4, 12, 12, 24, 112, 112, 2 * 17 * 16}));
}

/// A C of 100 steps, 30 high, whose mouth is open by `width`.
Shape mouth(const Rational& width) {
  const Rational top = 50 + width;
  return shape(extrusion({{{{0, 0},
                            {100, 0},
                            {100, 50},
                            {80, 50},
                            {80, 20},
                            {20, 20},
                            {20, 80},
                            {80, 80},
                            {80, top},
                            {100, top},
                            {100, 100},
                            {0, 100}}}},
                         {0, 0, 30}));
}

/// Second way: whether the two faces that the mouth lies between are strictly apart: all corners of each above the
/// plane of the other. They are the quadrangles at y = 50 and above whose normals turn to and fro along y.
bool is_open(const Canonical& form, const AffineMap& map) {
  const auto direction = [&](const Rational& y) { return map({0, y, 0}) - map({0, 0, 0}); };
  const Vector middle = map({90, 50, 15});
  std::vector<std::uint32_t> lips;
  for (std::uint32_t f = 0; f < form.face_count(); ++f) {
    const WidePlane p = wide(form.planes[f]);
    const Vector n{p.n[0], p.n[1], p.n[2]};
    const Rational along = dot(n, direction(1)), off = value(p, middle);
    const bool is_parallel = along * along > dot(n, n) * (1 - Rational(1, power_of_2(60)));
    if (is_parallel && off * off < dot(n, n) / 4) lips.push_back(f);
  }
  EXPECT_EQ(lips.size(), 2u);
  if (lips.size() != 2) return false;

  bool open = true;
  for (const auto& [f, g] : {std::pair(lips[0], lips[1]), std::pair(lips[1], lips[0])})
    for (const std::uint32_t v : form.faces.corners_of(f))
      open = open && value(wide(form.planes[g]), vertex(form.vertices[v])) > 0;
  return open;
}

// C3: at every vertex and along every edge all is well when the two faces of a narrow mouth come to touch or to cross.
TEST(ConditionsTest, ANarrowMouthStaysOpenOrIsRefused) {
  std::mt19937_64 random = generator(655);
  int kept = 0, refused = 0, mended = 0;
  for (int digits = 14; digits <= 40; ++digits) {
    const Shape c = mouth(Rational(Integer(1), Integer(pow(Integer(10), static_cast<unsigned>(digits)))));
    for (int i = 0; i < 3; ++i) {
      const Rational degrees = i == 0 ? Rational(37) : Rational(1 + below(random, 359'000), 1000);
      const AffineMap map = composed(realize(Motion::rotation({1, 2, 3}, degrees)).map, shift({Rational(1, 3), 7, -5}));
      const auto r = reconstruct(std::vector{placed(c, map)});
      if (r) {
        ++kept;
        const Canonical form = booleans::canonical(r.value().primitives[0].body);
        ASSERT_EQ(form.face_count(), 14u);
        ASSERT_EQ(form.vertices.size(), 24u);
        ASSERT_TRUE(is_open(form, map)) << digits << ' ' << degrees;
        expect_clean(r.value().primitives[0].body);
        mended += r.value().face_local_planes > 0 ? 1 : 0;
        continue;
      }
      // No vertex and no face is to blame.
      ++refused;
      ASSERT_EQ(r.error().code, ErrorCode::inconsistent_motion);
      ASSERT_EQ(r.error().where, "primitive 0") << digits << ' ' << degrees;
    }
  }
  EXPECT_GT(kept, 10);
  EXPECT_GT(refused, 20);
  std::printf("kept %d (face_local %d), refused %d\n", kept, mended, refused);
}

}  // namespace
}  // namespace quoin::rounding::testing
