#include "grid/grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/grid/random.h"

namespace quoin::grid {
namespace {

using exact::Integer;
using exact::Rational;

constexpr double infinity = std::numeric_limits<double>::infinity();

Lattice lattice_of(Rational step, Rational x = 0, Rational y = 0, Rational z = 0) {
  return {std::move(step), {std::move(x), std::move(y), std::move(z)}};
}

Rational power(int e) { return exact::to_rational(std::ldexp(1.0, e)); }

bool fits(const Lattice& l, const std::array<double, 3>& low, const std::array<double, 3>& high) {
  for (std::size_t k = 0; k < 3; ++k)
    if (abs(Rational(exact::to_rational(low[k]) - l.origin[k])) > l.step * fitting_bound ||
        abs(Rational(exact::to_rational(high[k]) - l.origin[k])) > l.step * fitting_bound)
      return false;
  return true;
}

TEST(FittingLattice, smallest_power_of_two) {
  EXPECT_EQ(fitting_lattice({0, 0, 0}, {1, 1, 1}).value(), lattice_of(power(-26)));
  EXPECT_EQ(fitting_lattice({0, 0, 0}, {1, 1, std::nextafter(1.0, 2.0)}).value(), lattice_of(power(-25)));
  EXPECT_EQ(fitting_lattice({-1.5, 0, 0}, {1, 1, 1}).value(), lattice_of(power(-25)));
  EXPECT_EQ(fitting_lattice({0, 0, 0}, {0x1p26, 1, 1}).value(), lattice_of(1));
  EXPECT_EQ(fitting_lattice({0, 0, 0}, {0, 0, 0}).value(), Lattice{});
  EXPECT_EQ(fitting_lattice({7, 7, 7}, {7, 7, 7}).value(), lattice_of(power(-23)));
}

TEST(FittingLattice, extremes) {
  const double least = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(fitting_lattice({0, 0, 0}, {least, 0, 0}).value().step, exact::to_rational(least));
  EXPECT_EQ(fitting_lattice({0, 0, 0}, {0x1p1020, 0, 0}).value().step, power(994));
  EXPECT_EQ(fitting_lattice({0, 0, 0}, {0x1.8p1020, 0, 0}).error().code, ErrorCode::out_of_range);
  EXPECT_EQ(fitting_lattice({0, 0, 0}, {infinity, 0, 0}).error().code, ErrorCode::non_finite);
  EXPECT_EQ(fitting_lattice({0, std::nan(""), 0}, {1, 1, 1}).error().code, ErrorCode::non_finite);
}

TEST(FittingLattice, origin_moves_only_for_far_boxes) {
  // A box of size 2 centred at c needs the step 2^-26; at distance 1024 the step is exactly 2^10 times that.
  const Lattice near = fitting_lattice({1022, 0, 0}, {1024, 2, 2}).value();
  EXPECT_EQ(near, lattice_of(power(-16)));
  const Lattice far = fitting_lattice({1024, 0, 0}, {1026, 2, 2}).value();
  EXPECT_EQ(far, lattice_of(power(-26), 1025, 1, 1));
  // The centre is no multiple of the step that the size alone needs: one more bit.
  const double u = 0x1p-40;
  const Lattice odd = fitting_lattice({0x1p10, 0, 0}, {0x1p10 + 2, u, u}).value();
  EXPECT_TRUE(fits(odd, {0x1p10, 0, 0}, {0x1p10 + 2, u, u}));
}

TEST(FittingLattice, random_boxes_fit_and_are_tight) {
  auto random = seeded_generator();
  for (int round = 0; round < 2000; ++round) {
    std::array<double, 3> low{}, high{};
    const int scale = static_cast<int>(random() % 200) - 100, distance = scale + static_cast<int>(random() % 30);
    const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    double farthest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::ldexp(unit() - 0.5, distance);
      high[k] = low[k] + std::ldexp(unit(), scale);
      farthest = std::max({farthest, std::fabs(low[k]), std::fabs(high[k])});
    }
    const Lattice l = fitting_lattice(low, high).value();
    EXPECT_TRUE(fits(l, low, high));
    if (l.origin == Lattice{}.origin) {
      EXPECT_GT(exact::to_rational(farthest), l.step / 2 * fitting_bound);
    } else {
      for (const Rational& o : l.origin) EXPECT_EQ(denominator(Rational(o / l.step)), 1);
      EXPECT_GT(exact::to_rational(farthest), l.step * 256 * fitting_bound);
    }
  }
}

exact::Point random_point(std::mt19937_64& random, int bits) {
  for (;;) {
    std::array<exact::Plane, 3> p{};
    for (exact::Plane& plane : p) {
      std::array<std::int64_t, 3> n{};
      for (auto& c : n) c = static_cast<std::int64_t>(random()) >> (64 - bits);
      if (n == std::array<std::int64_t, 3>{}) n[0] = 1;
      plane = exact::reduced_plane(n, exact::int128(static_cast<std::int64_t>(random()) >> (64 - bits)) * 1000);
    }
    if (const auto u = exact::meet(p[0], p[1], p[2])) return *u;
  }
}

TEST(Rounder, agrees_with_rationals) {
  auto random = seeded_generator();
  const Rational third(1, 3), tiny = power(-800), decimal(1, 1000);
  const std::vector<Lattice> lattices{
      Lattice{},
      lattice_of(power(-20)),
      lattice_of(power(30)),
      lattice_of(decimal),
      lattice_of(third, 1, Rational(1, 7), -5),
      lattice_of(power(-30), 1024, Rational(-12345), 0),
      lattice_of(tiny),
      lattice_of(Rational(3) * power(-10), power(-300), 0, 0),
      lattice_of(power(-140)),
      lattice_of(decimal, Rational(Integer("123456789012345678901234567890"), Integer("987654321098765432109")), 0, 0)};
  for (const Lattice& l : lattices) {
    const Rounder rounder(l);
    for (int round = 0; round < 300; ++round) {
      const int k = static_cast<int>(random() % 3);
      const auto i = static_cast<std::int32_t>(random() % (2U << 29)) - exact::world;
      EXPECT_EQ(rounder.to_double(i, k), exact::to_double(model_coordinate(l, i, k)));
      EXPECT_EQ(rounder.to_float(i, k), exact::to_float(model_coordinate(l, i, k)));
      const exact::Point u = random_point(random, round % 2 == 0 ? 10 : 62);
      EXPECT_EQ(rounder.to_double(u, k), exact::to_double(model_coordinate(l, u, k)));
      EXPECT_EQ(rounder.to_float(u, k), exact::to_float(model_coordinate(l, u, k)));
    }
    EXPECT_EQ(std::signbit(rounder.to_double(0, 2)), l.origin[2] < 0);
  }
}

TEST(Rounder, float_is_not_rounded_twice) {
  // 2^29 + 32 + 2^-40: the double nearest to it lies halfway between two floats.
  const exact::Plane x{{std::int64_t{1} << 40, 0, 0}, -((exact::int128(1) << 69) + (exact::int128(32) << 40) + 1)};
  const exact::Plane y{{0, 1, 0}, 0}, z{{0, 0, 1}, 0};
  const exact::Point u = *exact::meet(x, y, z);
  EXPECT_EQ(u.approximation[0], 0x1p29 + 32);
  EXPECT_EQ(static_cast<float>(u.approximation[0]), 0x1p29F);
  const Lattice lattice;
  EXPECT_EQ(Rounder(lattice).to_float(u, 0), 0x1p29F + 64);
}

TEST(Rounder, beyond_float_is_infinite) {
  const Lattice lattice = lattice_of(power(120));
  const Rounder rounder(lattice);
  EXPECT_EQ(rounder.to_float(1 << 8, 0), std::numeric_limits<float>::infinity());
  EXPECT_EQ(rounder.to_float(255, 0), 255 * 0x1p120F);
}

TEST(Rounder, decimal_steps_give_the_nearest_decimals) {
  const Lattice lattice = lattice_of(Rational(1, 1000));
  const Rounder rounder(lattice);
  EXPECT_EQ(rounder.to_double(1, 0), 0.001);
  EXPECT_EQ(rounder.to_double(-123456789, 1), -123456.789);
  EXPECT_EQ(rounder.to_float(100, 2), 0.1F);
}

TEST(GridPlane, scales_and_shifts) {
  // 2 x - 1/2 = 0 with step 1/1000 and origin 1/10: x = 1/4 is grid coordinate 150.
  const auto p = grid_plane(lattice_of(Rational(1, 1000), Rational(1, 10)), {2, 0, 0, Rational(-1, 2)});
  ASSERT_TRUE(p.has_value());
  EXPECT_EQ(*p, (exact::Plane{{1, 0, 0}, -150}));
  const auto q = grid_plane(Lattice{}, {-6, Rational(-9, 2), 3, 12});
  EXPECT_EQ(*q, (exact::Plane{{-4, -3, 2}, 8}));
}

TEST(GridPlane, bounds) {
  EXPECT_FALSE(grid_plane(Lattice{}, {0, 0, 0, 1}).has_value());
  const Rational limit = exact::coefficient_limit;
  EXPECT_EQ(grid_plane(Lattice{}, {limit, 1, 0, 0})->n[0], exact::coefficient_limit);
  EXPECT_FALSE(grid_plane(Lattice{}, {limit + 1, 1, 0, 0}).has_value());
  EXPECT_EQ(grid_plane(Lattice{}, {1, 0, 0, -limit * limit})->d, -exact::offset_limit);
  EXPECT_FALSE(grid_plane(Lattice{}, {1, 0, 0, limit * limit + 1}).has_value());
}

TEST(GridPlane, random_planes_vanish_where_the_model_plane_does) {
  auto random = seeded_generator();
  const auto number = [&] { return Rational(static_cast<std::int64_t>(random() % 2001) - 1000, random() % 50 + 1); };
  for (int round = 0; round < 300; ++round) {
    const Lattice l = lattice_of(Rational(random() % 20 + 1, random() % 50 + 1), number(), number(), number());
    const std::array<Rational, 4> m{number(), number(), number(), number()};
    const auto p = grid_plane(l, m);
    if (!p) continue;
    Rational factor = 0;  // grid value / model value, the same positive number everywhere
    for (int i = 0; i < 4; ++i) {
      const exact::GridPoint g{{static_cast<std::int32_t>(random() % 100), static_cast<std::int32_t>(random() % 100),
                                static_cast<std::int32_t>(random() % 100)}};
      Rational model = m[3];
      for (int k = 0; k < 3; ++k) model += m[static_cast<std::size_t>(k)] * model_coordinate(l, g[k], k);
      const Rational grid = exact::to_integer(exact::value(*p, g));
      if (model == 0) {
        EXPECT_EQ(grid, 0);
        continue;
      }
      if (factor == 0) factor = grid / model;
      EXPECT_GT(factor, 0);
      EXPECT_EQ(grid, factor * model);
    }
  }
}

}  // namespace
}  // namespace quoin::grid
