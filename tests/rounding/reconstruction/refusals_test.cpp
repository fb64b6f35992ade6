#include "rounding/reconstruction/refusals.h"

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

/// The factor that an error names, and that it is what is needed.
void expect_factor(const std::vector<Placement>& placements, const std::string& where,
                   const ReconstructionOptions& options = {}) {
  const auto r = reconstruct(placements, options);
  ASSERT_FALSE(r.has_value());
  ASSERT_EQ(r.error().code, ErrorCode::out_of_range);
  EXPECT_EQ(r.error().where, where);
  const std::string lead = "a step ";
  const auto at = r.error().message.rfind(lead);
  ASSERT_NE(at, std::string::npos) << r.error().message;
  const std::string digits = r.error().message.substr(at + lead.size());
  const Integer factor(digits.substr(0, digits.find(' ')));
  ASSERT_GT(factor, 1);
  std::vector<Placement> coarser = placements;
  for (Placement& p : coarser) p.to_grid = scaled(p.to_grid, Rational(1, factor));
  const auto again = reconstruct(coarser, options);
  EXPECT_TRUE(again.has_value()) << factor << ": " << again.error().message;
  // Half of it would not do.
  for (Placement& p : coarser) p.to_grid = scaled(p.to_grid, 2);
  EXPECT_FALSE(reconstruct(coarser, options).has_value()) << factor;
}

TEST(RefusalsTest, OutOfRange) {
  std::mt19937_64 random = generator(652);
  const Shape box = shape(block({300, 200, 100})), ball = shape(sphere(600, 8));
  for (const Rational& far :
       {Rational(exact::world + 4'000'000), Rational(power_of_2(31) + 5), Rational(power_of_2(40) * 3)}) {
    for (int i = 0; i < 4; ++i) {
      AffineMap map = i == 0 ? AffineMap{} : random_motion(random);
      map.shift =
          map.shift + Vector{i % 2 == 0 ? far : Rational(0), i % 2 == 0 ? Rational(0) : Rational(-2 * far), far};
      expect_factor({placed(box, map)}, "primitive 0");
      expect_factor({placed(box, map)}, "primitive 0", {Method::best, true});
      expect_factor({placed(box), placed(ball, map)}, "primitive 1");
    }
  }
}

// By planes, exactly, and vertex by vertex.
TEST(RefusalsTest, TheEndOfTheWorldBelongsToIt) {
  const Shape box = shape(block({6, 6, 9})), roof = shape(frustum(4, 6, 0, 9, Fit::inscribed));
  const Vector last{exact::world - 6, exact::world - 6, exact::world - 9};
  for (const Shape* s : {&box, &roof})
    for (const bool by_vertices : {false, true}) {
      const ReconstructionOptions options{Method::best, by_vertices};
      const Reconstructed r = made(placed(*s, shift(last)), options);
      EXPECT_EQ(r.by_planes, !by_vertices);
      EXPECT_EQ(r.displacement, 0);
      EXPECT_EQ(booleans::volume(r.body), Rational(volume(s->polyhedron)));
      for (std::size_t k = 0; k < 3; ++k) {
        Vector beyond = last;
        beyond[k] += 1;
        const auto refused = reconstruct(std::vector{placed(*s, shift(beyond))}, options);
        ASSERT_FALSE(refused.has_value()) << k;
        EXPECT_EQ(refused.error().code, ErrorCode::out_of_range);
      }
    }
}

// Where vertices need different factors the largest is named.
TEST(RefusalsTest, OutOfRangeOfLongShapes) {
  const Shape beam = shape(block({Rational(power_of_2(32)), 8, 8}));
  // Its first vertex is just outside, its last far out.
  const AffineMap map = shift({exact::world + 10, 0, 0});
  expect_factor({placed(beam, map)}, "primitive 0");
  expect_factor({placed(beam, map)}, "primitive 0", {Method::best, true});
  // With long numbers, too.
  expect_factor({placed(beam, composed(shift({exact::world * 2, 0, 0}),
                                       {matrix(quaternion(3, 1, 0, 0)), {Rational(1, 3), 0, 0}}))},
                "primitive 0");
}

// So far away that no plane fits.
TEST(RefusalsTest, OutOfRangeOfPlanes) {
  std::mt19937_64 random = generator(653);
  const Shape box = shape(block({300, 200, 100}));
  for (const unsigned bits : {124u, 140u, 200u}) {
    AffineMap map = random_motion(random);
    map.shift = {power_of_2(bits), 0, 5};
    const auto r = reconstruct(std::vector{placed(box, map)});
    ASSERT_FALSE(r.has_value());
    EXPECT_EQ(r.error().code, ErrorCode::out_of_range);
    EXPECT_EQ(r.error().where, "primitive 0");
    const Placement half{nullptr, WidePlane{{1, 0, 0}, 0}, map};
    const auto h = reconstruct(std::vector{placed(box), half});
    if (h) continue;
    EXPECT_EQ(h.error().code, ErrorCode::out_of_range);
    EXPECT_EQ(h.error().where, "primitive 1");
  }
}

}  // namespace
}  // namespace quoin::rounding::testing
