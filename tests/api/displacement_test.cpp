// The bounds of a motion's report against what the motion states, to some 580 bits: no point of a surface is farther
// from where it should be, and no angle is off by more.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "api/access.h"
#include "booleans/body/canonical.h"
#include "tests/api/solids.h"
#include "tests/rounding/motions/stated.h"

namespace quoin {
namespace {

using api_test::box;
using api_test::grid_of;
using api_test::random_engine;
using rounding::AffineMap;
using rounding::dot;
using rounding::Integer;
using rounding::Rational;
using rounding::Vector;
using rounding::operator-;
using Points = std::vector<Vector>;

/// The corners of the surface; model units.
Points corners(const Solid& solid) {
  const grid::Lattice& lattice = Access::lattice(solid);
  Points points;
  for (const exact::Point& p : booleans::canonical(Access::body(solid)).vertices) {
    Vector& v = points.emplace_back();
    for (std::size_t k = 0; k < 3; ++k)
      v[k] = lattice.origin[k] + lattice.step * exact::coordinate(p, static_cast<int>(k));
  }
  return points;
}

AffineMap stated(const Motion& motion) { return rounding::testing::stated_map(Access::motion(motion)); }

/// A lower bound of the squared distance of a stated point to the nearest of these. Doubles choose those near.
Rational squared_distance(const Vector& p, const Points& points) {
  std::vector<double> approximate;
  for (const Vector& q : points) approximate.push_back(exact::to_double(dot(q - p, q - p)));
  const double least = *std::min_element(approximate.begin(), approximate.end());
  std::optional<Rational> nearest;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (approximate[i] > least * 1.001 + 1e-300) continue;
    const Rational d = dot(points[i] - p, points[i] - p);
    if (!nearest || d < *nearest) nearest = d;
  }
  return *nearest;
}

/// What 600 bits leave over of numbers up to 2^100.
const Rational slack(Integer(1), Integer(1) << 400);

/// Every stated corner is within the bound of a corner of the result. Returns the square of how much of the bound the
/// farthest one uses up; 0 where the bound is.
Rational expect_within(const MotionReport& report, const Points& stated_corners, const Solid& result,
                       const std::string& what) {
  const auto bound = exact::parse_rational(report.displacement_bound);
  EXPECT_TRUE(bound.has_value()) << what;
  if (!bound) return 0;
  EXPECT_GE(exact::to_rational(report.displacement), *bound) << what;

  const Points points = corners(result);
  Rational farthest = 0;
  for (const Vector& p : stated_corners) farthest = std::max(farthest, squared_distance(p, points));
  const Rational most = *bound + slack;
  EXPECT_LE(farthest, most * most) << what << ": bound " << report.displacement_bound << ", true "
                                   << std::sqrt(exact::to_double(farthest));
  return *bound == 0 ? Rational(0) : Rational(farthest / (*bound * *bound));
}

Points carried(const Points& points, const AffineMap& map) {
  Points r;
  for (const Vector& p : points) r.push_back(map(p));
  return r;
}

std::uint64_t below(std::mt19937_64& random, std::uint64_t n) { return random() % n; }

/// Between 1e-30 and 360 degrees, all sizes alike, either way.
std::string random_degrees(std::mt19937_64& random) {
  const auto digits = 1 + below(random, 999'999);
  const auto exponent = static_cast<int>(below(random, 33)) - 36;
  std::string text = (below(random, 2) == 0 ? "-" : "") + std::to_string(digits) + "e" + std::to_string(exponent);
  if (below(random, 3) == 0) text = std::to_string(below(random, 360'000'000)) + "e-6";
  return text;
}

std::string negated(const std::string& number) { return number[0] == '-' ? number.substr(1) : "-" + number; }

Text3 random_axis(std::mt19937_64& random) {
  for (;;) {
    Text3 axis;
    for (std::string& x : axis) x = std::to_string(static_cast<int>(below(random, 7)) - 3);
    if (axis != Text3{"0", "0", "0"}) return axis;
  }
}

/// One step: mostly a rotation.
Motion random_step(std::mt19937_64& random) {
  switch (below(random, 8)) {
    case 0:
      return Motion::translation({std::to_string(below(random, 9)) + "e-3", "-1/3", "0.1"}).value();
    case 1:
      return Motion::mirror(random_axis(random)).value();
    case 2:
      return Motion::scaling({"2", "3/2", "1"}).value();
    default:
      return Motion::rotation(random_axis(random), random_degrees(random)).value();
  }
}

/// Words in which errors add (the same tiny angle about axes in turn) or cancel (there and back around another step).
Motion random_motion(std::mt19937_64& random) {
  Motion motion;
  switch (below(random, 3)) {
    case 0: {
      const std::string degrees = random_degrees(random);
      for (int i = 0; i < 6; ++i)
        motion = motion.then(Motion::rotation({"0", i % 2 == 0 ? "1" : "0", i % 2 == 0 ? "0" : "1"}, degrees).value());
      return motion;
    }
    case 1: {
      const Motion there = Motion::rotation(random_axis(random), random_degrees(random)).value();
      return there.then(random_step(random)).then(there.inverse());
    }
    default:
      for (auto n = 1 + below(random, 4); n > 0; --n) motion = motion.then(random_step(random));
      return motion;
  }
}

/// A box, a tetrahedron, and a solid with corners of many planes, which is rounded vertex by vertex.
std::vector<Solid> solids() {
  const Grid fine = grid_of("1/1048576");
  const Solid tetrahedron = api_test::tetrahedron({{{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {0, 0, 10}}}, fine);
  const Solid roof = evaluate(Model::frustum("5", "0", "7", "6"), {.grid = fine}).value();
  return {box({-3, 1, 2}, {4, 5, 3}, fine), tetrahedron, roof};
}

TEST(Displacement, OfSolidsUnderRandomMotions) {
  std::mt19937_64 random = random_engine();
  const std::vector<Solid> all = solids();
  Rational tightest = 0;
  int still = 0;
  for (int i = 0; i < 240; ++i) {
    const Solid& solid = all[static_cast<std::size_t>(i) % all.size()];
    const Motion motion = random_motion(random);
    MotionReport report;
    const MoveOptions options{.rounding = i % 7 == 0 ? Rounding::vertices : Rounding::best};
    const auto result = moved(solid, motion, options, &report);
    ASSERT_TRUE(result) << result.error().message;
    const Points expected = carried(corners(solid), stated(motion));
    tightest = std::max(tightest, expect_within(report, expected, result.value(), std::to_string(i)));
    still += result.value() == solid ? 1 : 0;

    // The surface of an unbounded solid is that of its complement.
    MotionReport outside;
    const auto complement = moved(~solid, motion, options, &outside);
    ASSERT_TRUE(complement);
    EXPECT_EQ(complement.value(), ~result.value());
    EXPECT_EQ(outside.displacement_bound, report.displacement_bound);
    EXPECT_EQ(outside.angle_error, report.angle_error);
  }
  // Some move nowhere, and no bound is idle.
  EXPECT_GT(still, 10);
  EXPECT_GT(tightest, Rational(1, 16));
}

// Where the angle is exact the rounding of planes is all there is: the bound is that, rounded upwards.
TEST(Displacement, OfExactTurns) {
  std::mt19937_64 random = random_engine();
  const Solid solid = box({-3, 1, 2}, {4, 5, 3}, grid_of("1/1048576"));
  for (int i = 0; i < 40; ++i) {
    std::array<std::string, 4> wxyz;
    for (std::string& x : wxyz) x = std::to_string(1 + below(random, 1'000'000'000'000));
    const Motion turn = Motion::quaternion(wxyz).value();
    MotionReport report;
    const auto result = moved(solid, turn, {}, &report);
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(report.angle_error, 0);
    const Points expected = carried(corners(solid), stated(turn));
    EXPECT_GT(expect_within(report, expected, result.value(), std::to_string(i)), Rational(99, 100));
  }
}

// An angle that is too small for any rational rotation: nothing moves, although it should.
TEST(Displacement, OfATetrahedronByATinyAngle) {
  const Solid tetrahedron = api_test::tetrahedron({{{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {0, 0, 10}}});
  for (const Solid& solid : {tetrahedron, ~tetrahedron}) {
    MotionReport report;
    const Motion motion = Motion::rotation({"0", "0", "1"}, "1e-26").value();
    const auto result = moved(solid, motion, {}, &report);
    ASSERT_TRUE(result);
    EXPECT_EQ(result.value().to_quoin(), solid.to_quoin());
    EXPECT_GE(*exact::parse_rational(report.displacement_bound), *exact::parse_rational("1.7e-27"));
    EXPECT_LE(report.displacement, 2e-27);
    EXPECT_GE(exact::to_rational(report.angle_error), *exact::parse_rational("1e-26"));
    EXPECT_EQ(report.primitives, 1U);
    EXPECT_EQ(report.by_planes, 1U);
  }
}

// What is stated to be nothing, and what is nothing, is off by nothing.
TEST(Displacement, IsNoneWhereAllIsExact) {
  const Motion tiny = Motion::rotation({"0", "0", "1"}, "1e-26").value();
  const Solid solid = box({0, 0, 0}, {3, 2, 1});
  const Motion quarter = Motion::rotation({"0", "0", "1"}, "90").value();
  for (const Motion& motion : {Motion(), tiny.then(tiny.inverse()), quarter.then(quarter).then(quarter).then(quarter),
                               Motion::quaternion({"2", "0", "0", "1"}).value()}) {
    MotionReport report{.displacement_bound = "7", .displacement = 7, .angle_error = 7};
    ASSERT_TRUE(moved(solid, motion, {}, &report));
    EXPECT_EQ(report.displacement_bound, "0");
    EXPECT_EQ(report.displacement, 0);
    EXPECT_EQ(report.angle_error, 0);
  }
  // No point of them is anywhere else.
  for (const Solid& none : {Solid(), Solid::full(Grid())}) {
    MotionReport report{.displacement_bound = "7", .displacement = 7, .angle_error = 7};
    ASSERT_TRUE(moved(none, tiny, {}, &report));
    EXPECT_EQ(report.displacement_bound, "0");
    EXPECT_GT(report.angle_error, 0);
  }
}

/// A box' corners.
Points box_corners(const Vector& size) {
  Points points;
  for (unsigned corner = 0; corner < 8; ++corner) {
    Vector& v = points.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) v[k] = (corner >> k & 1u) != 0 ? size[k] : Rational(0);
  }
  return points;
}

// Two blocks far apart, each under motions of its own and a common one.
TEST(Displacement, OfModelsUnderRandomMotions) {
  std::mt19937_64 random = random_engine();
  const Points first = box_corners({3, 2, 1}), second = box_corners({1, 5, Rational(1, 3)});
  Rational tightest = 0;
  for (int i = 0; i < 60; ++i) {
    const Text3 axis = random_axis(random), other = random_axis(random);
    const std::string degrees = random_degrees(random), more = random_degrees(random), common = random_degrees(random);
    const auto turn = [](const Text3& about, const std::string& by) { return Motion::rotation(about, by).value(); };
    const Motion apart = Motion::translation({"100", "0", "0"}).value();
    const Motion of_first = turn(axis, degrees).then(turn(other, common));
    const Motion of_second = turn(other, more).then(turn(axis, negated(common))).then(apart).then(turn(other, common));

    const Model model = (Model::block({"3", "2", "1"}).rotated(axis, degrees) + Model::block({"1", "5", "1/3"})
                                                                                    .rotated(other, more)
                                                                                    .rotated(axis, negated(common))
                                                                                    .translated({"100", "0", "0"}))
                            .rotated(other, common);
    MotionReport report;
    const auto result = evaluate(model, {.grid = grid_of("1/3000")}, &report);
    ASSERT_TRUE(result) << result.error().message;
    Points expected = carried(first, stated(of_first));
    for (const Vector& p : carried(second, stated(of_second))) expected.push_back(p);
    tightest = std::max(tightest, expect_within(report, expected, result.value(), std::to_string(i)));
  }
  EXPECT_GT(tightest, Rational(1, 256));
}

/// The angle by which a one-step rotation is off, at least; degrees.
Rational angle_off(const MotionInfo& info, const Text3& axis, const Rational& degrees) {
  const std::array<std::string, 4>& q = *info.quaternion;
  Rational norm = 0, along = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational a = Integer(axis[k]), x = Integer(q[k + 1]);
    norm += a * a;
    along += a * x;
  }
  // The angle is 2 atan(along / (w |axis|)), 180 for w = 0.
  const Rational w = Integer(q[0]);
  if (w == 0) return rounding::magnitude(180 - rounding::magnitude(degrees));
  const Rational tangent = rounding::magnitude(along / w) / rounding::testing::true_root(norm, MPFR_RNDN);
  const Rational realized =
      tangent == 0 ? Rational(0) : Rational(2 * rounding::testing::true_arctangent_degrees(tangent, MPFR_RNDN));
  return rounding::magnitude(realized - rounding::magnitude(degrees));
}

TEST(Displacement, AngleErrors) {
  std::mt19937_64 random = random_engine();
  const Solid solid = box({0, 0, 0}, {3, 2, 1}, grid_of("1/1048576"));
  for (int i = 0; i < 200; ++i) {
    const Text3 axis = random_axis(random);
    const std::string text = random_degrees(random);
    Rational degrees = *exact::parse_rational(text);
    if (degrees > 180) degrees -= 360;
    const Motion motion = Motion::rotation(axis, text).value();
    const Rational off = angle_off(motion.info(), axis, degrees);
    EXPECT_GE(exact::to_rational(motion.info().angle_error) + slack, off) << text;
    MotionReport report;
    ASSERT_TRUE(moved(solid, motion, {}, &report));
    EXPECT_GE(exact::to_rational(report.angle_error) + slack, off) << text;
    ASSERT_TRUE(evaluate(Model::block({"3", "2", "1"}).rotated(axis, text), {.grid = solid.grid()}, &report));
    EXPECT_GE(exact::to_rational(report.angle_error) + slack, off) << text;
  }
}

}  // namespace
}  // namespace quoin
