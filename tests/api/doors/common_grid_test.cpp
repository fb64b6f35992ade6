#include "api/doors/common_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "api/place.h"
#include "booleans/body/canonical.h"
#include "tests/api/solids.h"

namespace quoin::api_test {
namespace {

using exact::Rational;

/// What a random solid is: of a simplex three planes meet in every corner, of a ball five. Blocks and needles bend when
/// they are turned in floating point.
enum class Kind { simplex, block, needle, ball };

Mesh mesh_of(Kind kind) {
  if (kind == Kind::simplex)
    return {{-.5, -.4, -.3, .5, -.3, -.2, 0, .5, -.4, .1, .2, .5}, {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3}};
  if (kind == Kind::block) return box_mesh({-.5, -.5, -.5}, {.5, .5, .5});
  if (kind == Kind::needle) return box_mesh({-.5, -.0005, -.0004}, {.5, .0005, .0006});
  const double g = (1 + std::sqrt(5.0)) / 2;
  Mesh ball;
  ball.points = {-1, g,  0,  1, g, 0,  -1, -g, 0,  1, -g, 0, 0,  -1, g,  0,  1, g,
                 0,  -1, -g, 0, 1, -g, g,  0,  -1, g, 0,  1, -g, 0,  -1, -g, 0, 1};
  for (double& x : ball.points) x /= 2 * g;
  ball.triangles = {0, 11, 5, 0, 5, 1, 0, 1, 7, 0, 7, 10, 0, 10, 11, 1, 5, 9, 5, 11, 4,  11, 10, 2,  10, 7, 6, 7, 1, 8,
                    3, 9,  4, 3, 4, 2, 3, 2, 6, 3, 6, 8,  3, 8,  9,  4, 9, 5, 2, 4,  11, 6,  2,  10, 8,  6, 7, 9, 8, 1};
  return ball;
}

/// Turned by the same skew rotation each, scaled, moved; imported with defaults.
Solid imported(Kind kind, double size, const Corner& at) {
  Mesh mesh = mesh_of(kind);
  const double c = std::cos(0.7), s = std::sin(0.7), d = std::cos(1.1), t = std::sin(1.1);
  for (std::size_t i = 0; i < mesh.points.size(); i += 3) {
    double* p = &mesh.points[i];
    const double x = c * p[0] - s * p[1], y = s * p[0] + c * p[1], z = p[2];
    p[0] = size * x + at[0];
    p[1] = size * (d * y - t * z) + at[1];
    p[2] = size * (t * y + d * z) + at[2];
  }
  return Solid::from_triangles(mesh.points, mesh.triangles).value();
}

Rational volume_of(const Solid& solid) { return *exact::parse_rational(*solid.volume()); }

/// The second way to see how far a solid was moved: every corner's distance from the nearest one of the other, squared.
Rational squared_movement(const Solid& before, const Solid& after) {
  const auto corners = [](const Solid& solid) {
    std::vector<std::array<Rational, 3>> r;
    for (const exact::Point& p : booleans::canonical(Access::body(solid)).vertices)
      r.push_back({grid::model_coordinate(Access::lattice(solid), p, 0),
                   grid::model_coordinate(Access::lattice(solid), p, 1),
                   grid::model_coordinate(Access::lattice(solid), p, 2)});
    return r;
  };
  const auto from = corners(before), to = corners(after);
  Rational most = 0;
  for (const auto& p : from) {
    Rational least = -1;
    for (const auto& q : to) {
      Rational sum = 0;
      for (std::size_t k = 0; k < 3; ++k) sum += (p[k] - q[k]) * (p[k] - q[k]);
      if (least < 0 || sum < least) least = sum;
    }
    most = std::max(most, least);
  }
  return most;
}

struct Pair {
  Solid a, b;
  Rational size() const {
    grid::ModelBox box = model_box(a);
    box.add(model_box(b));
    return box.size();
  }
};

/// Both as they are carried to their common grid.
Pair carried(const Pair& pair) {
  const std::vector<Solid> solids{pair.a, pair.b};
  const CommonGrid common = common_grid(solids);
  const auto there = [&](std::size_t i) {
    return common.exact[i] ? *common.exact[i] : rounded_to(solids[i], common.grid, nullptr).value().solid;
  };
  return {there(0), there(1)};
}

Pair random_pair(std::mt19937_64& random) {
  const auto exponent = [&](int most) { return std::pow(10.0, static_cast<double>(random() % 1000) / 1000 * most); };
  const auto kind = [&] { return static_cast<Kind>(random() % 4); };
  const double ratio = exponent(6), offset = random() % 3 == 0 ? 0 : exponent(7);
  const double size = std::ldexp(1 + static_cast<double>(random() % 1000) / 1000, static_cast<int>(random() % 40) - 20);
  return {
      imported(kind(), size, {0.1 * size, -0.2 * size, 0.05 * size}),
      imported(kind(), size / ratio, {offset * size / ratio * 0.7, size / 3 / ratio, -offset * size / ratio * 0.3})};
}

TEST(CommonGrid, LawsOfRandomPairs) {
  auto random = random_engine();
  for (int round = 0; round < 60; ++round) {
    const Pair pair = random_pair(random), there = carried(pair);
    OperationReport report, other;
    const auto both = unite({pair.a, pair.b}, {}, &report), turned = unite({pair.b, pair.a}, {}, &other);
    ASSERT_TRUE(both && turned) << round << ": " << (both ? turned : both).error().message;

    // Any order, through any door, and what the operands were carried to.
    EXPECT_EQ(both.value().to_quoin(), turned.value().to_quoin()) << round;
    EXPECT_EQ((pair.b + pair.a).to_quoin(), both.value().to_quoin()) << round;
    EXPECT_EQ((there.a + there.b).to_quoin(), both.value().to_quoin()) << round;
    EXPECT_EQ(report.max_snap_bound, other.max_snap_bound);
    EXPECT_EQ(volume_of(there.a) + volume_of(there.b), volume_of(both.value()) + volume_of(there.a & there.b)) << round;
    EXPECT_EQ((pair.a - pair.b).to_quoin(), (there.a - there.b).to_quoin()) << round;
    EXPECT_TRUE((there.a - there.b) + (there.a & there.b) == there.a) << round;

    // Exactly what the report says.
    const int rounded = !(there.a == pair.a) + !(there.b == pair.b);
    EXPECT_LE(static_cast<std::uint64_t>(rounded), report.rounded_operands) << round;
    const Rational bound = *exact::parse_rational(report.max_snap_bound);
    EXPECT_LT(bound * (1 << 28), pair.size()) << round;
    EXPECT_EQ(report.max_snap, exact::to_double(bound));
    if (report.vanished_operands == 0) {
      EXPECT_LE(squared_movement(pair.a, there.a), bound * bound) << round;
      EXPECT_LE(squared_movement(pair.b, there.b), bound * bound) << round;
    }

    const auto refused = unite({pair.a, pair.b}, {.grid_rule = GridRule::exact});
    EXPECT_EQ(bool(refused), report.rounded_operands == 0) << round;
    if (!refused) {
      EXPECT_EQ(refused.error().code, ErrorCode::inexact_grid);
    }
  }
}

// The second way to see that a grid is there: all steps of 2^k times the finer one, about two origins.
TEST(CommonGrid, WherePairsAreRoundedNoPowerOfTwoHoldsThem) {
  auto random = random_engine();
  int rounded = 0;
  for (int round = 0; round < 200; ++round) {
    const Pair pair = random_pair(random);
    const std::vector<Solid> solids{pair.a, pair.b};
    const CommonGrid common = common_grid(solids);
    const bool is_exact = common.exact[0] && common.exact[1];
    rounded += !is_exact;

    bool is_found = false;
    const grid::Lattice &a = Access::lattice(pair.a), &b = Access::lattice(pair.b);
    const Rational size = pair.size();
    grid::ModelBox box = model_box(pair.a);
    box.add(model_box(pair.b));
    for (grid::Lattice at{std::min(a.step, b.step)}; at.step < size; at.step *= 2) {
      at.origin = a.step < b.step ? b.origin : a.origin;
      const auto holds = [&] {
        const Grid grid = Access::grid(at);
        return exactly_on(pair.a, grid).has_value() && exactly_on(pair.b, grid).has_value();
      };
      is_found = is_found || holds();
      for (std::size_t k = 0; k < 3; ++k) {
        const Rational steps = ((box.low[k] + box.high[k]) / 2 - at.origin[k]) / at.step;
        at.origin[k] += at.step * Rational(exact::Integer(numerator(steps) / denominator(steps)));
      }
      is_found = is_found || holds();
    }
    EXPECT_TRUE(is_exact || !is_found) << round;
  }
  EXPECT_GT(rounded, 20);
  EXPECT_LT(rounded, 180);
}

TEST(CommonGrid, AnyOrderOfManyOperands) {
  auto random = random_engine();
  for (int round = 0; round < 5; ++round) {
    std::vector<Solid> solids{Solid::empty(grid_of("1/7")), Solid()};
    for (int i = 0; i < 2; ++i) {
      const Pair pair = random_pair(random);
      solids.push_back(pair.a);
      solids.push_back(~pair.b);
    }
    const std::string expected = symmetric_difference(solids).value().to_quoin();
    for (int order = 0; order < 4; ++order) {
      std::shuffle(solids.begin(), solids.end(), random);
      EXPECT_EQ(symmetric_difference(solids).value().to_quoin(), expected) << round;
    }
  }
}

// A 1 mm hole and a 20 mm plate, each with the grid that fits it.
TEST(CommonGrid, AHoleInAPlate) {
  const Mesh plate_mesh = box_mesh({0, 0, 0}, {20, 20, 2}), hole_mesh = box_mesh({9.5, 9.5, -1}, {10.5, 10.5, 3}),
             tip_mesh = box_mesh({0, 0, 0}, {1, 1, 1});
  const Solid plate = Solid::from_triangles(plate_mesh.points, plate_mesh.triangles).value(),
              hole = Solid::from_triangles(hole_mesh.points, hole_mesh.triangles).value(),
              tip = Solid::from_triangles(tip_mesh.points, tip_mesh.triangles).value();
  EXPECT_FALSE(tip.grid() == plate.grid());
  OperationReport report;
  const auto drilled = difference(plate, {hole, tip}, {}, &report);
  ASSERT_TRUE(drilled) << drilled.error().message;
  EXPECT_EQ(volume(drilled.value()), "797");
  EXPECT_EQ(report.rounded_operands, 0u);
  EXPECT_EQ(report.max_snap_bound, "0");
  EXPECT_EQ(volume(plate - hole), "798");
  EXPECT_EQ(volume(plate - tip), "799");
  EXPECT_EQ(volume((plate - tip) + tip), "800");
}

/// A wedge within a block of 2^26 steps, between two planes whose normals of 62 bits differ in their last bit: on
/// another grid their offsets are rounded by up to 1/2, and where they meet moves by as many steps as these differ.
Solid thin_wedge(std::mt19937_64& random) {
  using exact::Integer;
  const auto coefficient = [&] { return Integer((std::uint64_t{1} << 61) + (random() >> 4)); };
  const Integer a = coefficient(), b = coefficient(), c = coefficient();
  const Integer d = -(a * (random() % 1000) + b * (random() % 1000) + c * (random() % 1000));
  const HalfSpace below{{a.str(), b.str(), c.str(), d.str()}},
      above{{Integer(-a - 1).str(), Integer(-b).str(), Integer(-c).str(), Integer(random() % 1000 - d).str()}};
  const Solid block = box({-0x1p26, -0x1p26, -0x1p26}, {0x1p26, 0x1p26, 0x1p26});
  return evaluate(Expression(block) & below & above, {.grid_rule = GridRule::exact}).value();
}

// The second way to see whether planes may be kept: they are asked how far they move what meets in them.
TEST(CommonGrid, PlanesThatMoveAVertexFarAreNotKept) {
  auto random = random_engine();
  int kept = 0, dropped = 0;
  for (int round = 0; round < 200; ++round) {
    const Solid solid = thin_wedge(random);
    const Grid coarse = grid_of(std::to_string((1 << (2 + random() % 20)) + 1) + "/3");
    const Rounded rounded = rounded_to(solid, coarse, nullptr).value();
    const Rational step = Access::lattice(coarse).step;
    EXPECT_LE(rounded.displacement * 8, step * 7) << round;

    const auto shape = shape_of(solid);
    const rounding::RealizedMotion identity;
    const auto by_planes = place({{shape.get(), {}, &identity}}, Access::lattice(coarse), Rounding::best, {});
    const bool is_near =
        by_planes && by_planes.value().primitives[0].by_planes && by_planes.value().primitives[0].displacement * 8 <= 7;
    EXPECT_EQ(rounded.by_planes, is_near) << round;
    ++(is_near ? kept : dropped);
    if (is_near) {
      EXPECT_EQ(rounded.displacement, by_planes.value().primitives[0].displacement * step);
    } else if (!rounded.vanished && rounded.resolved_crossings == 0) {
      // By vertices: each is a point of the grid then.
      for (const exact::Point& p : booleans::canonical(Access::body(rounded.solid)).vertices) EXPECT_TRUE(is_grid(p));
    }
  }
  EXPECT_GT(kept, 10);
  EXPECT_GT(dropped, 10);
}

// Steps that are no powers of two of each other, and a mesh of long normals between them.
TEST(CommonGrid, DecimalsAndPowersOfTwo) {
  const Solid decimal = box({0, 0, 0}, {20, 1, 1}, grid_of("1/1000")), ball = imported(Kind::ball, 20, {1, 1, 1});
  OperationReport report;
  const auto both = unite({decimal, ball}, {}, &report);
  ASSERT_TRUE(both) << both.error().message;
  EXPECT_EQ(report.rounded_operands, 0u);
  EXPECT_TRUE((both.value() & ball) == ball);
  EXPECT_TRUE((both.value() & decimal) == decimal);
}

// Of nothing is left more than a corner of the grid.
TEST(CommonGrid, WhatVanishesIsReported) {
  const Solid large = imported(Kind::ball, 1e6, {0, 0, 0}), speck = imported(Kind::ball, 1e-6, {0.3, 0.2, 0.1});
  OperationReport report;
  const auto both = unite({large, speck}, {}, &report);
  ASSERT_TRUE(both) << both.error().message;
  EXPECT_TRUE(both.value() == large);
  EXPECT_EQ(report.rounded_operands, 1u);
  EXPECT_EQ(report.by_vertices, 1u);
  EXPECT_EQ(report.vanished_operands, 1u);
  EXPECT_EQ(report.vanished_where, "operand 1");
  EXPECT_EQ(unite({speck, large}, {.grid_rule = GridRule::exact}).error().where, "operand 0");
}

// Terms that are evaluated by themselves do not round their operands again.
TEST(CommonGrid, SharedTermsAreRoundedOnce) {
  const Solid large = imported(Kind::ball, 1000, {0, 0, 0}), small = imported(Kind::ball, 0.01, {499.9, 1, 1});
  Expression term = Expression(large) + small, twice = term;
  for (int i = 0; i < 300; ++i) term = term + imported(Kind::ball, 0.01 + i * 1e-4, {0, 0, 0});
  OperationReport once, shared;
  const Solid expected = evaluate(term, {}, &once).value(), same = evaluate(term & (term + large), {}, &shared).value();
  EXPECT_EQ(same.to_quoin(), expected.to_quoin());
  EXPECT_GT(once.rounded_operands, 0u);
  EXPECT_EQ(shared.rounded_operands, once.rounded_operands);
  EXPECT_EQ(shared.max_snap_bound, once.max_snap_bound);
}

TEST(CommonGrid, PlanesOfFloatingPoint) {
  const Solid cube = box({0, 0, 0}, {1, 1, 1});
  const HalfSpace noisy{{"6.123233995736766e-17", "0", "1", "-0.5"}};
  OperationReport report;
  const auto parts = split(cube, noisy, {}, &report);
  ASSERT_TRUE(parts) << parts.error().message;
  for (const Solid& part : parts.value()) EXPECT_EQ(volume(part), "1/2");
  EXPECT_EQ(report.rounded_planes, 1u);
  EXPECT_GT(report.max_snap, 6.1e-17);
  EXPECT_LT(report.max_snap, 3e-16);
  EXPECT_EQ(split(cube, noisy, {.grid_rule = GridRule::exact}).error().code, ErrorCode::bad_plane);

  // Both sides, by opposite coefficients, have one plane.
  const HalfSpace turned{{"-6.123233995736766e-17", "0", "-1", "0.5"}};
  EXPECT_EQ(evaluate((Expression(cube) & noisy) + (Expression(cube) & turned)).value().to_quoin(), cube.to_quoin());
}

/// "exact", or an upper bound of how far the pair is rounded in parts of its size, and whether both are.
std::string entry(Kind kind, double ratio, double offset) {
  const Pair pair{imported(kind, 1, {0, 0, 0}), imported(kind, 1 / ratio, {offset, offset / 3, 0})};
  OperationReport report;
  if (!unite({pair.a, pair.b}, {}, &report)) return "refused";
  if (report.rounded_operands == 0) return "exact";
  const double part = report.max_snap / exact::to_double(pair.size());
  char text[64];
  std::snprintf(text, sizeof text, "2^%.0f%s%s", std::ceil(std::log2(part)),
                report.rounded_operands == 2 ? ", both" : "", report.vanished_operands > 0 ? ", vanishes" : "");
  return text;
}

// QUOIN_TABLE=1 prints the tables of docs/doors.md.
TEST(CommonGrid, TableOfPairs) {
  const bool is_printed = std::getenv("QUOIN_TABLE") != nullptr;
  for (const Kind kind : {Kind::simplex, Kind::ball}) {
    if (is_printed) std::printf("%s\n", kind == Kind::simplex ? "simplices" : "balls");
    for (int r = 0; r <= 6; ++r) {
      std::string line = "| 10^" + std::to_string(r);
      for (const int o : {-1, 0, 1, 2, 3, 4, 5, 6, 7}) {
        const std::string text = entry(kind, std::pow(10, r), o < 0 ? 0 : std::pow(10, o));
        EXPECT_NE(text, "refused");
        const int most = kind == Kind::simplex ? -90 : -28;
        EXPECT_TRUE(text == "exact" || std::atoi(text.c_str() + 2) <= most) << r << ", " << o;
        line += " | " + text;
      }
      if (is_printed) std::printf("%s |\n", line.c_str());
    }
  }
}

}  // namespace
}  // namespace quoin::api_test
