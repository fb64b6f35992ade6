#include "booleans/body/body.h"

#include <gtest/gtest.h>

#include "booleans/body/canonical.h"
#include "tests/booleans/support.h"

namespace quoin::booleans::testing {
namespace {

// A small edit of a large solid is a patched body: the same solid packed has the same faces.
TEST(Body, PackedIsTheSameSolid) {
  const auto ball = sphere({0, 0, 0}, 24, 48, [](std::uint32_t, std::uint32_t) { return 10000.0; });
  ASSERT_TRUE(ball);
  std::size_t patched = 0;
  Body body = *ball;
  for (std::uint64_t number = 0; number < 12; ++number) {
    Random random(0xB0D1, number);
    const Vector at = random.vector(-9000, 9000);
    const Body cube = box(at, at + Vector{900, 900, 900});
    Body next = evaluated(std::vector{body, cube}, Expression::flat(Rule::all, 2, 1));
    patched += next.is_packed ? 0 : 1;
    const Body whole = packed(next);
    EXPECT_TRUE(whole.is_packed);
    EXPECT_EQ(whole.face_count() > 0, next.face_count() > 0);
    EXPECT_EQ(volume(whole), volume(next));
    EXPECT_TRUE(same(whole, next));
    EXPECT_EQ(exact::Rational(volume(next) + volume(all(body, cube))), volume(body));
    body = std::move(next);
  }
  if (usual_thresholds()) {
    EXPECT_GT(patched, 0u);
  }
}

TEST(Body, TwoComplementsAreNone) {
  for (std::uint64_t number = 0; number < case_count(60); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0xB0D2, number);
    Solids solids(random, families[number % families.size()]);
    const Body body = solids.next(), other = complement(body);
    EXPECT_NE(other.full_at_infinity, body.full_at_infinity);
    EXPECT_EQ(fault(other).value_or(""), "");
    EXPECT_TRUE(same(complement(other), body));
    EXPECT_TRUE(empty(all(body, other)));
  }
}

// A box cut by a plane: both halves make the box, and each is its box without the other.
TEST(Body, HalfSpacesOfABox) {
  const exact::GridPoint low{{-3, -4, -5}}, high{{6, 5, 4}};
  const Body whole = box_body(low, high);
  for (std::uint64_t number = 0; number < case_count(200); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0xB0D3, number);
    Vector n = random.vector(-3, 3);
    if (n == Vector{0, 0, 0}) n = {0, 1, 0};
    const exact::Plane plane = exact::reduced_plane(n, random.between(-20, 20));
    const Body below = half_space_body(plane, low, high), above = half_space_body(plane.opposite(), low, high);
    EXPECT_EQ(fault(below).value_or(""), "");
    EXPECT_EQ(exact::Rational(volume(below) + volume(above)), volume(whole));
    EXPECT_TRUE(same(minus(whole, below), above));
  }
}

// Chunks hold all faces in order, and their boxes hold their faces.
TEST(Body, Chunks) {
  for (std::uint64_t number = 0; number < case_count(60); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0xB0D4, number);
    Solids solids(random, families[number % families.size()]);
    const Body body = packed(odd(solids.next(), solids.next()));
    Array<Chunk> chunks;
    add_chunks(body, 0, static_cast<std::uint32_t>(body.face_count()), chunks);
    std::uint32_t next = 0;
    for (const Chunk& c : chunks) {
      EXPECT_EQ(c.begin, next);
      next = c.end;
      Box all = c.box;
      for (std::uint32_t f = c.begin; f < c.end; ++f) all.add(face_box(body, f));
      EXPECT_EQ(all.low, c.box.low);
      EXPECT_EQ(all.high, c.box.high);
    }
    EXPECT_EQ(next, body.face_count());
  }
}

}  // namespace
}  // namespace quoin::booleans::testing
