#include "booleans/mended.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/booleans/support.h"

namespace quoin::booleans::testing {
namespace {

using exact::Rational;

/// Boxes of any size and place.
std::array<std::array<double, 3>, 2> random_box(Random& random) {
  const int size = static_cast<int>(random.between(-100, 90)), far = static_cast<int>(random.between(-100, 100));
  std::array<std::array<double, 3>, 2> box{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double at = std::ldexp(static_cast<double>(random.between(-1000, 1000)), far);
    box[0][k] = at - std::ldexp(static_cast<double>(random.between(0, 1000)), size);
    box[1][k] = at + std::ldexp(static_cast<double>(random.between(1, 1000)), size);
  }
  return box;
}

TEST(LatticeOfNumbers, HoldsNumbersOfTheFormat) {
  for (std::uint64_t number = 0; number < case_count(2000); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0x1A77, number);
    const auto [low, high] = random_box(random);
    for (const Floats floats : {Floats::float32, Floats::float64}) {
      const grid::Lattice lattice = lattice_of_numbers(low, high, floats);
      for (std::size_t k = 0; k < 3; ++k)
        for (const double end : {low[k], high[k]}) {
          const Rational steps = (exact::to_rational(end) - lattice.origin[k]) / lattice.step;
          ASSERT_LE(abs(steps), (1 << 28) + 1);
          const Rational nearest =
              lattice.origin[k] + lattice.step * exact::to_rational(std::nearbyint(exact::to_double(steps)));
          const double number = floats == Floats::float64 ? exact::to_double(nearest) : exact::to_float(nearest);
          ASSERT_EQ(exact::to_rational(number), nearest);
        }
    }
  }
}

/// Tetrahedra in a row along x, with legs of 3, one every 64.
struct Row {
  std::vector<double> points;
  std::vector<std::uint32_t> triangles;

  explicit Row(std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; ++i) {
      const double x = 64.0 * i;
      points.insert(points.end(), {x, 0, 0, x + 3, 0, 0, x, 3, 0, x, 0, 3});
      for (const auto& corners : {std::array{0u, 2u, 1u}, {0u, 1u, 3u}, {0u, 3u, 2u}, {1u, 2u, 3u}})
        for (const std::uint32_t v : corners) triangles.push_back(4 * i + v);
    }
  }
};

// Near the troubled point tetrahedra shrink to nothing; the others keep all their points.
TEST(Mended, IsCoarserNearTroubleOnly) {
  // The largest coordinate is below 2^12, so the step is 2^-12.
  const Row row(64);
  constexpr std::uint32_t troubled_one = 20;
  std::vector<std::uint8_t> troubled(row.points.size() / 3);
  troubled[4 * troubled_one] = 1;
  for (const int exponent : {-12, 0, 5, 6, 8, 10}) {
    SCOPED_TRACE(exponent);
    const auto result = mended(row.points, row.triangles, {}, Floats::float32, {troubled, exponent + 12});
    ASSERT_TRUE(result) << result.error().message;

    const double cell = std::ldexp(1, exponent), trouble = std::floor(64 * troubled_one / cell);
    std::size_t expected = 0;
    for (int i = 0; i < 64; ++i) {
      const bool is_near = std::fabs(std::floor(64 * i / cell) - trouble) <= 1;
      expected += is_near && cell > 3 ? 0 : 1;
    }
    EXPECT_EQ(result.value().body.face_count(), 4 * expected);
    EXPECT_EQ(result.value().merged_points > 0, expected < 64);
    EXPECT_LE(result.value().most, cell);
    EXPECT_EQ(result.value().most > 0, exponent > -12);
  }
}

// What is coarser than everything has one point.
TEST(Mended, EndsWithNothing) {
  const Row row(5);
  std::vector<std::uint8_t> troubled(row.points.size() / 3);
  troubled[7] = 1;
  for (const Floats floats : {Floats::float32, Floats::float64})
    for (const double far : {0.0, 1e9}) {
      std::vector<double> points = row.points;
      for (double& x : points) x += far;
      const auto result = mended(points, row.triangles, {}, floats, {troubled, 30});
      ASSERT_TRUE(result) << result.error().message;
      EXPECT_EQ(result.value().body.face_count(), 0u);
    }
}

}  // namespace
}  // namespace quoin::booleans::testing
