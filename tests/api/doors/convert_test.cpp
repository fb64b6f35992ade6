#include <gtest/gtest.h>

#include <cmath>

#include "tests/api/solids.h"

namespace quoin::api_test {
namespace {

TEST(Convert, ToAFinerGridAndBack) {
  auto random = random_engine();
  for (int round = 0; round < 10; ++round) {
    const Solid a = random_tetrahedron(random, 6) - random_tetrahedron(random, 6);
    for (const char* step : {"1/2", "1/3", "2/3", "3", "1/1000", "7/5"}) {
      const auto moved = a.on_grid(grid_of(step));
      ASSERT_TRUE(moved) << moved.error().message;
      EXPECT_EQ(moved.value().grid().step(), step);
      EXPECT_TRUE(moved.value() == a) << step;
      EXPECT_EQ(moved.value().volume(), a.volume());
      EXPECT_EQ(moved.value().on_grid(Grid()).value().to_quoin(), a.to_quoin());
    }
  }
}

// What an operation remembers of a solid for the next one must not outlive a change of grid.
TEST(Convert, OperationsAfterAChangeOfGrid) {
  const Solid b = box({0, 0, 0}, {1, 1, 1}) & box({0, 0, 0}, {2, 2, 1});
  for (const char* step : {"1/2", "1/3", "1/1024"}) {
    const Grid fine = grid_of(step);
    const Solid there = b.on_grid(fine).value(),
                cut = tetrahedron({Corner{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, fine);
    EXPECT_EQ(volume(there - cut), "5/6") << step;
    EXPECT_EQ(volume(cut - there), "0") << step;
  }
  auto random = random_engine();
  for (int round = 0; round < 20; ++round) {
    const Solid p = random_tetrahedron(random, 6) - random_tetrahedron(random, 6);
    const Solid q = random_tetrahedron(random, 6), r = random_tetrahedron(random, 6);
    const Grid fine = grid_of(round % 2 == 0 ? "1/2" : "1/7");
    const auto carried = [&](const Solid& solid) { return solid.on_grid(fine).value(); };
    const Solid expected = (p + q) & r, result = (carried(p) + carried(q)) & carried(r);
    EXPECT_TRUE(result == expected) << round;
    EXPECT_TRUE((carried(p + q) & carried(r)) == expected) << round;
  }
}

TEST(Convert, GridPointsMayBecomeDerivedPoints) {
  const Solid a = box({0, 0, 0}, {.5, .5, .5}, grid_of("1/2"));
  const auto third = a.on_grid(grid_of("1/3"));
  ASSERT_TRUE(third) << third.error().message;
  EXPECT_EQ(volume(third.value()), "1/8");
  const Solid b = box({0, 0, 0}, {1, 1, 1}, grid_of("1/3"));
  EXPECT_EQ(volume(b - third.value()), "7/8");
  EXPECT_EQ(volume(unite({a, b}).value()), "1");
  EXPECT_TRUE(third.value() == a);
  EXPECT_EQ((b - third.value()).classify({.5, .5, .5}), Location::boundary);
}

TEST(Convert, Origins) {
  const Grid shifted = Grid::with_step_and_origin("1/4", {"1/2", "-100", "1000000"}).value();
  EXPECT_EQ(shifted.origin(), (std::array<std::string, 3>{"1/2", "-100", "1000000"}));
  const Solid a = box({1, 2, 3}, {4, 5, 6});
  const auto moved = a.on_grid(shifted);
  ASSERT_TRUE(moved);
  EXPECT_TRUE(moved.value() == a);
  EXPECT_FALSE(moved.value() == box({1, 2, 3}, {4, 5, 7}));
  EXPECT_EQ(volume(moved.value()), "27");
  EXPECT_EQ(moved.value().info().box->at(1), (Corner{4, 5, 6}));
  EXPECT_EQ(moved.value().on_grid(Grid()).value().to_quoin(), a.to_quoin());
}

// Derived points on grids of other origins.
TEST(Convert, ToOtherOriginsAndBack) {
  auto random = random_engine();
  for (const char* step : {"1/4", "3/7", "2"}) {
    const Grid shifted = Grid::with_step_and_origin(step, {"1/2", "-100", "7/3"}).value();
    for (int round = 0; round < 5; ++round) {
      const Solid a = random_tetrahedron(random, 6) - random_tetrahedron(random, 6);
      const auto moved = a.on_grid(shifted);
      ASSERT_TRUE(moved) << moved.error().message;
      EXPECT_TRUE(moved.value() == a) << step;
      EXPECT_EQ(moved.value().volume(), a.volume());
      EXPECT_EQ(moved.value().on_grid(Grid()).value().to_quoin(), a.to_quoin());
    }
  }
}

TEST(Convert, ComplementsEmptyAndFull) {
  const Solid a = box({0, 0, 0}, {1, 1, 1});
  const Grid fine = grid_of("1/7");
  EXPECT_TRUE((~a).on_grid(fine).value() == ~a);
  EXPECT_TRUE(Solid::full(fine) == Solid::full(Grid()));
  EXPECT_TRUE(Solid().on_grid(fine).value().is_empty());
  EXPECT_TRUE(Solid::full(Grid()).on_grid(grid_of("1e300")).value() == Solid::full(fine));
}

/// A tetrahedron whose planes have normals near 2^60, which few grids can hold, but that of its own.
Solid unwieldy(const Grid& grid = {}) {
  return tetrahedron({Corner{-536870911, 1, 2}, Corner{536870909, -536870912, 7}, Corner{12345, 536870911, -536870912},
                      Corner{3, 5, 536870911}},
                     grid);
}

TEST(Convert, Refusals) {
  const Solid a = box({0, 0, 0}, {1, 1, 1});
  const auto far = a.on_grid(grid_of("1e-9"));
  ASSERT_FALSE(far);
  EXPECT_EQ(far.error().code, ErrorCode::out_of_range);
  EXPECT_NE(far.error().message.find("step 1 "), std::string::npos) << far.error().message;

  const auto inexact = unwieldy().on_grid(Grid::with_step_and_origin("1000", {"1", "2", "3"}).value());
  ASSERT_FALSE(inexact);
  EXPECT_EQ(inexact.error().code, ErrorCode::inexact_grid);
  EXPECT_NE(inexact.error().message.find("the step "), std::string::npos);
}

// The second way: where the coordinates or the planes leave their bounds, by hand.
TEST(Convert, RefusalsNameThePlace) {
  const auto where = [](const Solid& solid, const Grid& grid) {
    const auto there = solid.on_grid(grid);
    return there ? "it is there" : there.error().where;
  };
  // Corners in their canonical order, and in that of the mesh where grid points stay grid points.
  EXPECT_EQ(where(box({0, 0, 0}, {1, 1, 1}), grid_of("1e-9")), "vertex (1, 0, 0)");
  EXPECT_EQ(
      where(box({0, 0, 0}, {1, 2, 3}, grid_of("1/2")), Grid::with_step_and_origin("1/2", {"0", "0", "5e8"}).value()),
      "vertex (0, 0, 0)");
  const Solid cut = box({0, 0, 0}, {6, 6, 6}) - tetrahedron({Corner{1, 1, 1}, {9, 2, 1}, {1, 9, 2}, {2, 1, 9}});
  EXPECT_EQ(where(cut, grid_of("1e-8")).substr(0, 8), "vertex (");

  const Grid coarse = Grid::with_step_and_origin("1000", {"1", "2", "3"}).value();
  EXPECT_EQ(where(unwieldy(), coarse), "face at (-536870911, 1, 2)");
  EXPECT_EQ(where(~unwieldy(), coarse), "face at (-536870911, 1, 2)");
}

TEST(Grid, Doors) {
  EXPECT_EQ(grid_of("0.001").step(), "1/1000");
  EXPECT_EQ(grid_of("1e-3").step(), "1/1000");
  EXPECT_EQ(grid_of("1e-3"), grid_of("1/1000"));
  for (const char* text : {"", "0", "-1", "x", "1/0", "nan", "1e999"})
    EXPECT_EQ(Grid::with_step(text).error().code, ErrorCode::bad_number) << text;
  EXPECT_EQ(Grid::with_step_and_origin("1", {"0", "zero", "0"}).error().code, ErrorCode::bad_number);
  EXPECT_EQ(Grid::with_step_and_origin("1", {"0", "zero", "0"}).error().where, "origin, y");
  EXPECT_EQ(Grid::with_step("-1").error().where, "step");
  EXPECT_EQ(Grid::fitting({0, 0, 0}, {1, HUGE_VAL, 1}).error().code, ErrorCode::non_finite);
  EXPECT_EQ(Grid::fitting({0, 0, 0}, {1, 1e308, 1}).error().code, ErrorCode::out_of_range);
  EXPECT_EQ(Grid::fitting({-1, 0, 0}, {1, 1, 1}).value().step(), "1/67108864");
  EXPECT_EQ(Grid::fitting({1, 1, 1}, {-1, 0, 0}).value().step(), "1/67108864");
}

}  // namespace
}  // namespace quoin::api_test
