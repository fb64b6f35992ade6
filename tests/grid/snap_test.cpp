#include "grid/snap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/grid/random.h"

namespace quoin::grid {
namespace {

using exact::GridPoint;
using exact::Integer;
using exact::Rational;

/// Nearest integer, ties to even.
Integer nearest(const Rational& v) {
  Integer q, r;
  divide_qr(numerator(v), denominator(v), q, r);
  const Rational rest = v - q;  // in (-1, 1)
  if (abs(rest) > Rational(1, 2) || (abs(rest) == Rational(1, 2) && q % 2 != 0)) q += rest < 0 ? -1 : 1;
  return q;
}

/// Compares every coordinate and the largest move with rationals.
void check(const Array<double>& points, const Lattice& l) {
  const auto snapped = snap(points, l);
  ASSERT_TRUE(snapped.has_value()) << snapped.error().message;
  Rational worst = 0;
  for (std::size_t i = 0; i < points.size() / 3; ++i) {
    Rational squared = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Rational v = exact::to_rational(points[3 * i + k]);
      const std::int32_t c = snapped.value().points[i].c[k];
      EXPECT_EQ(Integer(c), nearest((v - l.origin[k]) / l.step)) << points[3 * i + k];
      const Rational move = v - model_coordinate(l, c, static_cast<int>(k));
      squared += move * move;
    }
    worst = std::max(worst, squared);
  }
  const double bound = snapped.value().max_snap;
  EXPECT_EQ(bound == 0, worst == 0);
  EXPECT_GE(exact::to_rational(bound) * exact::to_rational(bound), worst);
  // Tight up to the guard of the double path, 2^-20 steps.
  const Rational slack = l.step / (1 << 19);
  if (bound > 0x1p-500 && exact::to_rational(bound) > slack) {
    const Rational low = exact::to_rational(bound) - slack;
    EXPECT_LE(low * low, worst * 2);
  }
}

const Array<Lattice>& lattices() {
  static const Array<Lattice> all{
      {1, {0, 0, 0}},
      {Rational(1, 1 << 20), {0, 0, 0}},
      {Rational(1024), {0, 0, 0}},
      {Rational(1, 1000), {0, 0, 0}},
      {Rational(1, 1000), {Rational(1, 3), -7, Rational(10001, 100)}},
      {Rational(1, 1 << 20), {Rational(1 << 25), 0, Rational(1, 1 << 20)}},
      {Rational(2, 7), {Rational(Integer("1000000000000000000001"), Integer("999999999999999999999999")), 0, 0}},
      {Rational(5, 3), {1000000, 0, 0}},
      {49, {0, 0, 0}},  // 49 times the rounded 1 / 49 is less than 1
      {Rational(2, 7), {Rational(std::int64_t{1} << 45) + Rational(1, 3), -(std::int64_t{1} << 45), 0}}};
  return all;
}

TEST(Snap, agrees_with_rationals) {
  auto random = seeded_generator();
  for (const Lattice& l : lattices()) {
    const double step = exact::to_double(l.step);
    Array<double> points;
    for (int i = 0; i < 900; ++i) {
      const double origin = exact::to_double(l.origin[static_cast<std::size_t>(i % 3)]);
      const int bits = static_cast<int>(random() % 30);
      const double cell = static_cast<double>(static_cast<std::int64_t>(random() % (2U << bits)) - (1 << bits)) / 2;
      double v = origin + cell * step / 1.01;
      if (i % 4 == 0) v = origin + (cell + static_cast<double>(random() >> 11) * 0x1p-53) * step / 1.01;
      if (i % 4 == 1) v = origin + cell * step;  // on or next to a tie or a grid coordinate
      if (i % 8 == 1) v = std::nextafter(v, random() % 2 == 0 ? 1e300 : -1e300);
      points.push_back(v);
    }
    check(points, l);
  }
}

TEST(Snap, ties_go_to_even) {
  const Array<double> points{0.5, 1.5, 2.5, -0.5, -1.5, -2.5};
  const Array<GridPoint> expected{{{0, 2, 2}}, {{0, -2, -2}}};
  EXPECT_EQ(snap(points, Lattice{}).value().points, expected);
  // The general path: 1/2, 3/2, 5/2 steps of 3/4 beyond the origin 1.
  const Lattice l{Rational(3, 4), {1, 1, 1}};
  Array<double> moved;
  for (double p : points) moved.push_back(1 + 0.75 * p);
  EXPECT_EQ(snap(moved, l).value().points, expected);
}

TEST(Snap, exact_input_has_no_move) {
  EXPECT_EQ(snap(Array<double>{0.5, -3, 7.25}, {Rational(1, 4), {0, 0, 0}}).value().max_snap, 0);
  EXPECT_EQ(snap(Array<double>{0.5, -3, 7.25}, {Rational(1, 1000), {0, 0, 0}}).value().max_snap, 0);
  EXPECT_GT(snap(Array<double>{0.1, 0, 0}, {Rational(1, 1000), {0, 0, 0}}).value().max_snap, 0);
  EXPECT_GT(snap(Array<double>{1e-320, 0, 0}, {Rational(1024), {0, 0, 0}}).value().max_snap, 0);
  EXPECT_EQ(snap(Array<double>{-0.0, 0, 0}, {Rational(1, 3), {0, 0, 0}}).value().max_snap, 0);
}

// Far from 0 the filter's error is large, here 2^-12 steps and 2^-5: it alone cannot tell that nothing moved.
TEST(Snap, exact_input_far_from_zero_has_no_move) {
  const double far = 0x1p40;
  const Rational origin = exact::to_rational(far);
  const Lattice short_numbers{1, {origin, origin, origin}};
  EXPECT_EQ(snap(Array<double>{far + 5, far, far - 7}, short_numbers).value().max_snap, 0);
  EXPECT_GT(snap(Array<double>{far + 5, far, far - 7 + 0x1p-12}, short_numbers).value().max_snap, 0);
  // Numbers too long for machine integers.
  const Rational step = 1 + exact::to_rational(0x1p-54), start = origin - 5 * step;
  const Lattice long_numbers{step, {start, start, start}};
  EXPECT_EQ(snap(Array<double>{far, far, far}, long_numbers).value().max_snap, 0);
  EXPECT_GT(snap(Array<double>{far, far + 0x1p-12, far}, long_numbers).value().max_snap, 0);

  const auto fitting = fitting_lattice({1e6, 1e6, 1e6}, {1e6 + 1, 1e6 + 1, 1e6 + 1});
  EXPECT_EQ(snap(Array<double>{1e6, 1e6 + 1, 1e6, 1e6 + 1, 1e6, 1e6}, fitting.value()).value().max_snap, 0);
}

TEST(Snap, the_edge_of_the_world) {
  const double edge = exact::world;
  for (const double scale : {1.0, 0.125}) {
    const Lattice l{exact::to_rational(scale), {0, 0, 0}};
    const Array<double> in{edge * scale, (edge + 0.5) * scale, -(edge + 0.5) * scale};
    const GridPoint corner{{exact::world, exact::world, -exact::world}};
    EXPECT_EQ(snap(in, l).value().points.at(0), corner);
    const Array<double> out{0, 0, 0, 0, std::nextafter((edge + 0.5) * scale, 1e30), 0};
    const auto refused = snap(out, l);
    ASSERT_FALSE(refused.has_value());
    EXPECT_EQ(refused.error().code, ErrorCode::out_of_range);
    EXPECT_EQ(refused.error().where.substr(0, 9), "vertex 1 ");
  }
}

TEST(Snap, refusals_name_vertex_and_step) {
  const Lattice milli{Rational(1, 1000), {0, 0, 0}};
  const auto far = snap(Array<double>{0, 0, 0, 1e6, 0, -3e6}, milli);
  ASSERT_FALSE(far.has_value());
  EXPECT_EQ(far.error().code, ErrorCode::out_of_range);
  EXPECT_EQ(far.error().where, "vertex 1 (1e+06, 0, -3e+06)");
  EXPECT_NE(far.error().message.find("a step of 1/125 would do"), std::string::npos) << far.error().message;
  EXPECT_TRUE(snap(Array<double>{0, 0, 0, 1e6, 0, -3e6}, {Rational(1, 125), {0, 0, 0}}).has_value());
  for (const Lattice& l : lattices())
    for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
      const auto refused = snap(Array<double>{0, 0, 0, 1e30, 0, 0, 0, bad, 0}, l);
      ASSERT_FALSE(refused.has_value());
      EXPECT_EQ(refused.error().code, ErrorCode::non_finite);
      EXPECT_EQ(refused.error().where.substr(0, 9), "vertex 2 ");
    }
  for (const Lattice& l : lattices())
    EXPECT_EQ(snap(Array<double>{1e308, -1e308, 5}, l).error().code, ErrorCode::out_of_range);
}

TEST(Snap, extreme_steps) {
  const double least = std::numeric_limits<double>::denorm_min();
  check({least, -3 * least, 0}, {exact::to_rational(least), {0, 0, 0}});
  check({0x1p1000, -0x1.8p999, 1}, {exact::to_rational(0x1p990), {0, 0, 0}});
  check({0x1p-300, 5, 0x1p-900}, {Rational(1, 3), {exact::to_rational(0x1p-950), 0, 0}});
  // Moves of which a rounded length may be below the true one.
  check({least, least, 0}, {exact::to_rational(0x1p-600), {0, 0, 0}});
  check({least, least, 0}, {exact::to_rational(0x1p-1073), {0, 0, 0}});
  check({2000 * least, 999 * least, least}, {exact::to_rational(0x1p-1060) / 3, {0, 0, 0}});
}

}  // namespace
}  // namespace quoin::grid
