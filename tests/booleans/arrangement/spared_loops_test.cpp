#include "booleans/arrangement/spared_loops.h"

#include <gtest/gtest.h>

#include "tests/booleans/stages.h"

namespace quoin::booleans::testing {
namespace {

/// The usual ones, but that every face has a chunk of its own, and every face with holes is large.
grid::Thresholds eager() {
  grid::Thresholds t;
  t.large_face = 4;
  t.chunk = 1;
  return t;
}

Body hole(std::int64_t x, std::int64_t y) { return box({x, y, -1}, {x + 1, y + 1, 2}); }

/// A plate with holes of side 1 at 1, 4 and 7, but for the one in the middle.
Body plate_with_eight_holes() {
  Body plate = box({0, 0, 0}, {10, 10, 1});
  for (const std::int64_t x : {1, 4, 7})
    for (const std::int64_t y : {1, 4, 7})
      if (x != 4 || y != 4) plate = minus(plate, hole(x, y));
  return plate;
}

/// How many loops of the first body's two large faces are spared, when the second one comes.
std::size_t spared(const Body& plate, const Body& other) {
  const std::vector<Body> bodies{plate, other};
  return Drawn(bodies).touched.spared.size();
}

#ifdef QUOIN_CHECKED

// Holes are spared, on both sides of the plate, where the other body's bounds do not touch them.
TEST(SparedLoops, HolesOfAPlateFarFromTheNextOne) {
  const WithThresholds thresholds(eager());
  const Body plate = plate_with_eight_holes();
  EXPECT_EQ(spared(plate, hole(4, 4)), 16u);
  EXPECT_EQ(spared(plate, box({2, 4, -1}, {3, 5, 2})), 14u);  // touches the walls of one
  EXPECT_EQ(spared(plate, box({2, 4, 0}, {3, 5, 2})), 14u);   // ends on the bottom's plane
  EXPECT_EQ(spared(plate, box({4, 4, 1}, {5, 5, 2})), 8u);    // stands on the top, whose holes are spared
  EXPECT_EQ(spared(plate, box({9, 4, -1}, {10, 5, 2})), 0u);  // reaches the rim
  EXPECT_EQ(spared(plate, box({3, 3, -1}, {11, 6, 2})), 0u);  // crosses it
}

// The box of what is near a hole in the shape of a U holds the hole between its arms.
TEST(SparedLoops, AHoleBetweenTheArmsOfAnother) {
  const WithThresholds thresholds(eager());
  Body plate = box({0, 0, 0}, {20, 20, 1});
  for (const Body& part : {box({2, 2, -1}, {12, 3, 2}), box({2, 3, -1}, {3, 12, 2}), box({11, 3, -1}, {12, 12, 2}),
                           hole(6, 6), hole(15, 15)})
    plate = minus(plate, part);
  EXPECT_EQ(spared(plate, box({3, 4, -1}, {4, 5, 2})), 2u);
}

// Holes that touch in a corner are drawn or spared together.
TEST(SparedLoops, HolesThatTouchInACorner) {
  const WithThresholds thresholds(eager());
  Body plate = box({0, 0, 0}, {20, 20, 1});
  for (const Body& part : {hole(4, 4), hole(5, 5), hole(15, 15)}) plate = minus(plate, part);
  EXPECT_EQ(spared(plate, box({2, 2, -1}, {4, 5, 2})), 2u);
  EXPECT_EQ(spared(plate, hole(10, 10)), spared(plate, hole(12, 10)));
}

#endif

// A ray from a body in a pocket leaves through the mouth of the pocket, which is a spared loop of the bottom.
TEST(SparedLoops, ABodyInAPocket) {
  const WithThresholds thresholds(eager());
  Body block = box({0, 0, 0}, {20, 10, 20});
  for (const std::int64_t x : {2, 8, 14})
    for (const std::int64_t z : {2, 14}) block = minus(block, box({x, -1, z}, {x + 3, 6, z + 3}));
  const Body drill = box({9, -1, 9}, {10, 4, 10}), inside = box({3, 3, 3}, {4, 4, 4});

  const Body result =
      sound(evaluate(std::vector<const Body*>{&block, &drill, &inside}, Expression::flat(Rule::odd, 3)));
  EXPECT_TRUE(same(result, odd(odd(block, inside), drill)));
  EXPECT_EQ(volume(result), volume(block) - 4 + 1 + 1);
}

/// A lattice whose axes point anywhere, right-handed.
struct Axes {
  std::array<Vector, 3> axis{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

  explicit Axes(Random& random) {
    if (random.one_in(3)) return;
    do
      for (Vector& v : axis) v = random.vector(-9, 9);
    while (determinant(axis[0], axis[1], axis[2]) <= 0);
  }
  Body block(const Vector& low, const Vector& high) const { return *mapped(box(low, high), {0, 0, 0}, axis); }
};

/// A random plate with pockets and holes that touch or overlap each other, and blocks on it.
Body worked(Random& random, int steps) {
  const Axes axes(random);
  Body body = axes.block({0, 0, 0}, {16, 16, 3});
  if (random.one_in(4)) body = complement(body);
  for (int i = 0; i < steps; ++i) {
    const std::int64_t x = random.between(0, 14), y = random.between(0, 14);
    const Vector low{x, y, random.between(-1, 2)},
        high{x + random.between(1, 3), y + random.between(1, 3), random.between(3, 5)};
    const Body tool = axes.block(low, high);
    body = random.one_in(4) ? any(body, tool) : random.one_in(6) ? odd(body, tool) : minus(body, tool);
  }
  return body;
}

// Sparing changes nothing, whatever lies where.
TEST(SparedLoops, WorkIsTheSameWithoutThem) {
  for (std::uint64_t number = 0; number < case_count(60); ++number) {
    SCOPED_TRACE(case_name(number));
    const auto with = [&](std::uint32_t large, std::uint32_t chunk) {
      grid::Thresholds t = grid::thresholds();
      t.large_face = large;
      t.chunk = chunk;
      const WithThresholds thresholds(t);
      Random random(0x5FA3ED, number);
      return worked(random, static_cast<int>(random.between(3, 25)));
    };
    const Body plain = with(1u << 30, 32);
    ASSERT_TRUE(same(with(0, 1), plain));
    ASSERT_TRUE(same(with(0, 3), plain));
  }
}

}  // namespace
}  // namespace quoin::booleans::testing
