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
    for (const Floats floats : {Floats::float32, Floats::float64})
      for (const int coarser : {0, 1, 7}) {
        const grid::Lattice lattice = lattice_of_numbers(low, high, floats, coarser);
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

TEST(LatticeOfNumbers, TheCoarsestHasOnePoint) {
  for (std::uint64_t number = 0; number < case_count(500); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0x1A78, number);
    const auto [low, high] = random_box(random);
    for (const Floats floats : {Floats::float32, Floats::float64}) {
      const grid::Lattice lattice = lattice_of_numbers(low, high, floats, 60);
      for (std::size_t k = 0; k < 3; ++k) {
        ASSERT_EQ(lattice.origin[k], 0);
        ASSERT_LT(2 * std::max(std::fabs(low[k]), std::fabs(high[k])), exact::to_double(lattice.step));
      }
    }
  }
}

}  // namespace
}  // namespace quoin::booleans::testing
