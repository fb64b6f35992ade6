// Which shells of a mesh nothing is left of.
#include "booleans/dropped_shells.h"

#include <gtest/gtest.h>

#include "booleans/resolve.h"
#include "tests/booleans/support.h"

namespace quoin::booleans::testing {
namespace {

Body cube(std::int64_t low, std::int64_t high) { return box({low, low, low}, {high, high, high}); }

DroppedShells dropped(const std::vector<Body>& parts) {
  const Body mesh = merged(parts);
  std::uint64_t crossings = 0;
  return dropped_shells(mesh, sound(resolve(mesh, crossings)));
}

TEST(DroppedShells, OneOfTwoCubesIsInsideOut) {
  const DroppedShells d = dropped({cube(0, 2), inside_out(cube(4, 6)), inside_out(cube(8, 9))});
  EXPECT_EQ(d.count, 2u);
  EXPECT_EQ(d.lowest_corner, (exact::GridPoint{{4, 4, 4}}));
}

TEST(DroppedShells, VoidsAndNotchesBoundTheResult) {
  EXPECT_EQ(dropped({cube(0, 9), inside_out(cube(1, 8))}).count, 0u);
  EXPECT_EQ(dropped({cube(0, 9), inside_out(cube(1, 8)), cube(2, 7), inside_out(cube(3, 4))}).count, 0u);
  EXPECT_EQ(dropped({cube(0, 9), inside_out(cube(5, 12))}).count, 0u);
  EXPECT_EQ(dropped({cube(0, 9), inside_out(box({1, 1, 5}, {2, 2, 9}))}).count, 0u);
  // Two surfaces, of which one void takes too little away, and two take enough.
  EXPECT_EQ(dropped({cube(0, 9), cube(0, 9), inside_out(cube(1, 8))}).count, 1u);
  EXPECT_EQ(dropped({cube(0, 9), cube(0, 9), inside_out(cube(1, 8)), inside_out(cube(1, 8))}).count, 0u);
}

TEST(DroppedShells, WhatUnionSwallowsIsNotDropped) {
  EXPECT_EQ(dropped({cube(0, 2), cube(0, 2)}).count, 0u);
  EXPECT_EQ(dropped({cube(0, 9), cube(1, 2), cube(5, 12)}).count, 0u);
}

TEST(DroppedShells, InsideOutBodiesThatTouchAnother) {
  const Body a = cube(0, 2);
  EXPECT_EQ(dropped({a, inside_out(cube(2, 4))}).count, 1u);                   // in a corner
  EXPECT_EQ(dropped({a, inside_out(box({2, 2, 0}, {4, 4, 2}))}).count, 1u);    // along an edge
  EXPECT_EQ(dropped({a, inside_out(box({2, 0, 0}, {4, 2, 2}))}).count, 1u);    // in a whole face
  EXPECT_EQ(dropped({a, inside_out(box({2, -1, -1}, {4, 5, 5}))}).count, 1u);  // in a part of its face
  EXPECT_EQ(dropped({a, inside_out(box({1, -1, -1}, {4, 5, 5}))}).count, 0u);  // it cuts
}

// The second way: winding numbers of unit cells, and every unit square of a shell.
TEST(DroppedShells, AgreeWithUnitCells) {
  constexpr std::int64_t size = 5;
  struct Part {
    Vector low, high;
    int sign;
    bool holds(const Vector& cell) const {
      for (std::size_t k = 0; k < 3; ++k)
        if (cell[k] < low[k] || cell[k] >= high[k]) return false;
      return true;
    }
  };
  std::uint64_t seen = 0;
  const std::uint64_t cases = case_count(400);
  for (std::uint64_t number = 0; number < cases; ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0xD20, number);
    std::vector<Part> parts;
    for (std::uint64_t n = 2 + random.below(4); n > 0; --n) {
      Part part{random.vector(0, size - 1), {}, random.one_in(2) ? 1 : -1};
      for (std::size_t k = 0; k < 3; ++k) part.high[k] = random.between(part.low[k] + 1, size);
      parts.push_back(part);
    }

    const auto winding = [&](const Vector& cell) {
      int sum = 0;
      for (const Part& p : parts) sum += p.holds(cell) ? p.sign : 0;
      return sum;
    };
    const auto bounds = [&](const Part& shell, const Vector& in, const Vector& out) {
      if (!shell.holds(in) || shell.holds(out) || winding(in) > 0 || winding(out) <= 0) return false;
      return std::none_of(parts.begin(), parts.end(),
                          [&](const Part& p) { return p.sign > 0 && p.holds(out) && !p.holds(in); });
    };
    std::uint64_t expected = 0;
    for (const Part& shell : parts) {
      if (shell.sign > 0) continue;
      bool found = false;
      for (std::int64_t x = 0; x < size; ++x)
        for (std::int64_t y = 0; y < size; ++y)
          for (std::int64_t z = 0; z < size; ++z)
            for (std::size_t k = 0; k < 3; ++k)
              for (const std::int64_t step : {-1, 1}) {
                Vector out{x, y, z};
                out[k] += step;
                found = found || bounds(shell, {x, y, z}, out);
              }
      expected += found ? 0 : 1;
    }

    std::vector<Body> bodies;
    for (const Part& p : parts) bodies.push_back(p.sign > 0 ? box(p.low, p.high) : inside_out(box(p.low, p.high)));
    ASSERT_EQ(dropped(bodies).count, expected);
    seen += expected;
  }
  EXPECT_GT(seen, cases / 4);
}

}  // namespace
}  // namespace quoin::booleans::testing
