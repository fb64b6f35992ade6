#include "booleans/pairs/operands.h"

#include <gtest/gtest.h>

#include "tests/booleans/support.h"
#include "tests/grid/with_thresholds.h"

namespace quoin::booleans::testing {
namespace {

using grid::testing::WithThresholds;

Operands operands_of(const std::vector<Body>& bodies) {
  std::vector<const Body*> list;
  for (const Body& b : bodies) list.push_back(&b);
  return Operands(list);
}

/// Some solids, results among them, and sometimes the empty set.
std::vector<Body> random_bodies(Solids& solids, Random& random) {
  std::vector<Body> bodies;
  for (std::uint64_t n = 1 + random.below(random.one_in(4) ? 12 : 3); n > 0; --n)
    bodies.push_back(random.one_in(6) ? Body{} : random.one_in(3) ? odd(solids.raw(), solids.raw()) : solids.next());
  return bodies;
}

/// check(bodies, operands, random) for random bodies of all families.
template <class Check>
void for_operands(std::uint64_t salt, Check&& check) {
  for (std::uint64_t number = 0; number < case_count(120); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(salt, number);
    Solids solids(random, families[number % families.size()]);
    const std::vector<Body> bodies = random_bodies(solids, random);
    check(bodies, operands_of(bodies), random);
  }
}

TEST(Operands, FacesAreNumberedThrough) {
  for_operands(0x09E1, [](const std::vector<Body>& bodies, const Operands& operands, Random&) {
    std::uint32_t next = 0;
    for (std::uint32_t o = 0; o < bodies.size(); ++o)
      for (std::uint32_t f = 0; f < bodies[o].face_count(); ++f, ++next) {
        EXPECT_EQ(operands.face(o, f), FaceId(next));
        EXPECT_EQ(operands.own(OperandId(o), FaceId(next)), f);
        const OwnFace own = operands.own(FaceId(next));
        EXPECT_EQ(own.operand, OperandId(o));
        EXPECT_EQ(own.face, f);
      }
    EXPECT_EQ(operands.face_count(), next);
  });
}

// Of a packed body all faces are in chunks, of a patched one those that are there.
TEST(Operands, ChunksHoldTheFacesOfEachOperand) {
  for_operands(0x09E2, [](const std::vector<Body>& bodies, const Operands& operands, Random&) {
    for (const OperandId o : operands.ids()) {
      const Body& body = bodies[o.value];
      std::vector<std::uint32_t> found, expected;
      body.for_runs([&](std::uint32_t begin, std::uint32_t end) {
        for (std::uint32_t f = begin; f < end; ++f) expected.push_back(f);
      });
      for (const OperandChunk& c : operands.chunks_of(o)) {
        EXPECT_EQ(c.operand, o);
        Box all = c.box;
        for (const FaceId f : Ids<FaceId>(c.begin, c.end)) {
          found.push_back(operands.own(o, f));
          all.add(face_box(body, found.back()));
        }
        EXPECT_EQ(all.low, c.box.low);
        EXPECT_EQ(all.high, c.box.high);
        all.add(operands.bounds[o]);
        EXPECT_EQ(all.low, operands.bounds[o].low);
        EXPECT_EQ(all.high, operands.bounds[o].high);
      }
      EXPECT_EQ(found, expected);
    }
  });
}

// Few operands are compared one by one; of many nothing is known to be far.
TEST(Operands, FarChunksMeetTheBoundsOfNoOther) {
  std::size_t far = 0;
  for (const std::size_t few : {std::size_t{0}, std::size_t{64}}) {
    const WithThresholds t(grid::testing::with(&grid::Thresholds::few_operands, few));
    for_operands(0x09E3, [&](const std::vector<Body>& bodies, const Operands& operands, Random&) {
      for (const OperandChunk& c : operands.chunks) {
        bool near = false;
        for (const OperandId o : operands.ids()) near = near || (o != c.operand && c.box.meets(operands.bounds[o]));
        if (bodies.size() > grid::thresholds().few_operands) near = true;
        EXPECT_EQ(c.far, !near);
        EXPECT_EQ(operands.may_be_near(c.operand, c.box), near);
        far += c.far;
      }
    });
  }
  EXPECT_GT(far, case_count(120) / 4);
}

TEST(Operands, ChunksThatMeetABoxHoldTheFacesThatDo) {
  for_operands(0x09E4, [](const std::vector<Body>& bodies, const Operands& operands, Random& random) {
    for (const OperandId o : operands.ids()) {
      if (bodies[o.value].face_count() == 0) continue;
      const std::uint32_t first = operands.chunks_of(o)[0].begin.value - operands.base[o].value;
      const std::array asked{operands.bounds[random.below(bodies.size())],
                             random.one_in(2) ? face_box(bodies[o.value], first) : Box{}};
      std::vector<std::array<std::uint32_t, 2>> found, expected;
      for (const Chunk& c : operands.chunks_meeting(o, asked)) found.push_back({c.begin, c.end});
      for (const OperandChunk& c : operands.chunks_of(o))
        if (c.box.meets(asked[0]) || c.box.meets(asked[1]))
          expected.push_back({operands.own(o, c.begin), operands.own(o, c.end)});
      EXPECT_EQ(found, expected);
    }
  });
}

// Two boxes that touch, the empty set between them, and one apart from all.
TEST(Operands, BoxesAndTheEmptySet) {
  const std::vector<Body> bodies{box({0, 0, 0}, {2, 2, 2}), Body{}, box({2, 0, 0}, {4, 2, 2}),
                                 box({9, 9, 9}, {10, 10, 10})};
  const Operands operands = operands_of(bodies);
  EXPECT_EQ(operands.base, (ById<OperandId, FaceId>{0, 12, 12, 24, 36}));
  EXPECT_EQ(operands.own(FaceId(11)).operand, OperandId(0));
  EXPECT_EQ(operands.own(FaceId(12)).operand, OperandId(2));
  EXPECT_EQ(operands.own(FaceId(12)).face, 0u);
  EXPECT_EQ(operands.chunks_of(1).size(), 0u);

  const WithThresholds t(grid::testing::with(&grid::Thresholds::few_operands, std::size_t{8}));
  EXPECT_TRUE(operands.may_be_near(0, operands.bounds[0]));
  EXPECT_TRUE(operands.may_be_near(2, operands.bounds[2]));
  EXPECT_FALSE(operands.may_be_near(3, operands.bounds[3]));
  EXPECT_FALSE(operands.may_be_near(0, Box{{0, 0, 0}, {1, 2, 2}})) << "the side away from the other";
}

// What was trusted to be clean is not proved, and so is what is made of it.
TEST(Operands, AreProvedWhenAllAre) {
  const Body proved = box({0, 0, 0}, {2, 2, 2});
  Body trusted = proved;
  trusted.is_proved = false;
  EXPECT_TRUE(operands_of({proved, proved}).are_proved);
  EXPECT_FALSE(operands_of({proved, trusted}).are_proved);
  EXPECT_FALSE(operands_of({trusted, proved}).are_proved);
}

}  // namespace
}  // namespace quoin::booleans::testing
