#include "api/doors/placed.h"

#include <gtest/gtest.h>

#include <bit>

#include "exact/rational.h"
#include "tests/io/io_support.h"

namespace quoin {
namespace {

using exact::Rational;
using exact::to_rational;

/// The map of a matrix, by rationals.
double image_by_rationals(const std::array<double, 12>& rows, std::size_t k, const std::array<double, 3>& p) {
  Rational sum = to_rational(rows[4 * k + 3]);
  for (std::size_t j = 0; j < 3; ++j) sum += to_rational(rows[4 * k + j]) * to_rational(p[j]);
  return exact::to_double(sum);
}

/// Doubles of few bits, of all, nearly cancelling, tiny and huge ones.
double awkward(std::mt19937_64& random) {
  switch (random() % 6) {
    case 0:
      return 0;
    case 1:
      return static_cast<double>(static_cast<std::int64_t>(random() % 17)) - 8;
    case 2:
      return std::ldexp(static_cast<double>(random() >> 11), static_cast<int>(random() % 40) - 60);
    case 3:
      return 1 + std::ldexp(static_cast<double>(static_cast<std::int64_t>(random() % 5)) - 2, -52);
    case 4:
      return -std::ldexp(1 + static_cast<double>(random() % 3) * 0x1p-53, static_cast<int>(random() % 200) - 100);
    default:
      return io::test::any_finite(random);
  }
}

TEST(Placed, ImagesAreCorrectlyRounded) {
  std::mt19937_64 random(io::test::seed());
  for (int round = 0; round < 20000; ++round) {
    io::MatrixStep step;
    for (double& entry : step.rows) entry = awkward(random);
    const std::array<double, 3> p = {awkward(random), awkward(random), awkward(random)};
    const RoundedMap map(map_of({step}).value());
    const auto image = map(p);
    for (std::size_t k = 0; k < 3; ++k) {
      const double expected = image_by_rationals(step.rows, k, p);
      EXPECT_EQ(std::bit_cast<std::uint64_t>(image[k]), std::bit_cast<std::uint64_t>(expected)) << "round " << round;
    }
  }
}

// Sums that lie in the middle of two doubles, or 2^-120 beside it.
TEST(Placed, MiddlesOfTwoDoubles) {
  for (const double beside : {0.0, 0x1p-120, -0x1p-120})
    for (const double odd : {0.0, 0x1p-52}) {
      io::MatrixStep step = io::identity_step;
      step.rows = {1, 1, 1, 0, 0, 1, 0, 0, 0, 0, 1, 0};
      const std::array<double, 3> p = {1 + odd, 0x1p-53, beside};
      const RoundedMap map(map_of({step}).value());
      EXPECT_EQ(map(p)[0], image_by_rationals(step.rows, 0, p));
    }
}

// Ten maps by thirds of degrees and back: composed exactly, so that every coordinate comes back to the bit.
TEST(Placed, StepsComposeExactly) {
  const io::MatrixStep shear = {{1, 0.1, 0, 0.3, 0, 1, 0, 0, 0, 0, 1, 1e-9}};
  const io::MatrixStep back = {{1, -0.1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}};
  const io::MatrixStep home = {{1, 0, 0, -0.3, 0, 1, 0, 0, 0, 0, 1, -1e-9}};
  EXPECT_EQ(map_of({shear, home, back}).value(), rounding::AffineMap{});
  io::Placing turns;
  for (int i = 0; i < 4; ++i) turns.emplace_back(io::AngleStep{2, 90});
  EXPECT_EQ(map_of(turns).value(), rounding::AffineMap{});
  // A quaternion in doubles that means 90 degrees is 90 degrees.
  const io::Placing quarter = {io::QuaternionStep{{0, 0, 0.7071067811865476, 0.7071067811865476}}};
  EXPECT_EQ(map_of(quarter).value(), map_of({io::AngleStep{2, 90}}).value());
  EXPECT_EQ(map_of({io::QuaternionStep{{0, 0, 0, 0}}}).error().code, ErrorCode::non_finite);
}

// A quotient of integers, moved, is rounded once: integers of 16 bits over what stands for 1 among them.
TEST(Placed, QuotientsAreRoundedOnce) {
  std::mt19937_64 random(io::test::seed());
  for (const int divisor : {127, 255, 32767, 65535}) {
    const io::MatrixStep step = {{0.1, 0, 0, 1e-3, 0, 3, 0, 0, 0, 0, -1.0 / 3, 7}};
    const RoundedMap plain(map_of({io::DivisionStep{static_cast<double>(divisor)}}).value());
    const RoundedMap moved(map_of({io::DivisionStep{static_cast<double>(divisor)}, step}).value());
    for (int round = 0; round < 2000; ++round) {
      std::array<double, 3> p;
      for (double& v : p) v = static_cast<double>(random() % static_cast<unsigned>(divisor + 1)) - divisor / 2;
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(plain(p)[k], p[k] / divisor);  // IEEE 754 rounds it once
        const Rational image =
            to_rational(step.rows[5 * k]) * to_rational(p[k]) / divisor + to_rational(step.rows[4 * k + 3]);
        EXPECT_EQ(moved(p)[k], exact::to_double(image));
      }
    }
  }
}

TEST(Placed, MirroredFacesAreTurnedRound) {
  const io::PolygonMesh mesh{{0.1, 0, -0.0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, {0, 3, 7}, {0, 1, 2, 0, 1, 3, 2}};
  const auto mirrored = placed_mesh(mesh, map_of({io::MatrixStep{{-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}}}).value());
  ASSERT_TRUE(mirrored);
  EXPECT_EQ(mirrored.value().corners, (std::vector<std::uint32_t>{2, 1, 0, 2, 3, 1, 0}));
  EXPECT_EQ(mirrored.value().points[0], -0.1);

  const auto same = placed_mesh(mesh, {});
  EXPECT_EQ(io::test::bits(same.value().points), io::test::bits(mesh.points));
  EXPECT_EQ(placed_mesh(mesh, map_of({io::MatrixStep{}}).value()).error().code, ErrorCode::bad_syntax);
  const io::MatrixStep huge = {{1e308, 1e308, 0, 1e308, 0, 1, 0, 0, 0, 0, 1, 0}};
  EXPECT_EQ(placed_mesh(mesh, map_of({huge}).value()).error().code, ErrorCode::non_finite);
}

TEST(Placed, UnitsAreExact) {
  EXPECT_EQ(millimeters(Unit::inch), Rational(127, 5));
  EXPECT_EQ(millimeters(Unit::foot), 12 * millimeters(Unit::inch));
  EXPECT_EQ(millimeters(Unit::meter), 1000 * millimeters(Unit::millimeter));
  EXPECT_EQ(millimeters(Unit::centimeter), 10000 * millimeters(Unit::micron));
}

}  // namespace
}  // namespace quoin
