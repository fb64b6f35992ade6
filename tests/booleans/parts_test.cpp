#include "booleans/parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>

#include "tests/booleans/stages.h"

namespace quoin::booleans::testing {
namespace {

Rule random_rule(Random& random) { return std::array{Rule::any, Rule::all, Rule::odd}[random.below(3)]; }

/// Leaves under a root and two inner nodes, all rules and negations at random; some operands come twice.
Expression random_expression(Random& random, std::uint32_t operands) {
  Expression e;
  e.add({random_rule(random), random.one_in(2), 0, none});
  for (int i = 0; i < 2; ++i) e.add({random_rule(random), random.one_in(2), 0, 0});
  for (std::uint32_t i = 0; i < operands; ++i)
    for (int times = random.one_in(8) ? 2 : 1; times > 0; --times)
      e.add({Rule::operand, random.one_in(3), i, random.one_in(3) ? static_cast<std::uint32_t>(random.below(3)) : 0});
  return e;
}

/// Counts the rounds in which parts are evaluated.
booleans::Run counting_parts(std::size_t& rounds) {
  booleans::Run run;
  run.stage = [&rounds](const char* name) { rounds += std::string(name) == "parts"; };
  return run;
}

class PartsOfFamily : public ::testing::TestWithParam<Family> {};

TEST_P(PartsOfFamily, GiveTheSameSetAsOneArrangement) {
  const std::uint64_t count = case_count(GetParam() == Family::spheres ? 4 : 20);
  std::size_t combined = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    SCOPED_TRACE(case_name(i));
    Random random(700 + static_cast<std::uint64_t>(GetParam()), i);
    Solids solids(random, GetParam());
    std::vector<Body> operands;
    for (std::uint64_t n = 9 + random.below(20); n > 0; --n) operands.push_back(solids.next());
    const std::vector<const Body*> pointers = Drawn::pointers(operands);
    const Expression e = random_expression(random, static_cast<std::uint32_t>(operands.size()));
    const booleans::Run run = counting_parts(combined);
    const Body whole = sound(evaluate(pointers, e)), parts = sound(evaluate_in_parts(pointers, e, run));
    ASSERT_TRUE(same(whole, parts));
  }
  if (usual_thresholds()) {
    EXPECT_GT(combined, count / 4);
  }
}

INSTANTIATE_TEST_SUITE_P(Booleans, PartsOfFamily, ::testing::ValuesIn(families),
                         [](const auto& p) { return name_of(p.param); });

TEST(Parts, RepeatedLeavesCountOnceOrCancel) {
  const Body b = box({0, 0, 0}, {2, 2, 2});
  const std::vector<const Body*> one{&b};
  for (const Rule rule : {Rule::any, Rule::all, Rule::odd})
    for (const std::uint32_t copies : {9u, 10u}) {
      Expression e;
      e.add({rule, false, 0, none});
      for (std::uint32_t i = 0; i < copies; ++i) e.add({Rule::operand, false, 0, 0});
      const Body result = sound(evaluate_in_parts(one, e));
      EXPECT_TRUE(rule == Rule::odd && copies == 10 ? empty(result) : same(result, b));
    }
}

// A group of complements of an even number is none, of an odd number it is one.
TEST(Parts, ComplementsCountByParity) {
  std::vector<Body> boxes;
  for (std::int64_t i = 0; i < 8; ++i) boxes.push_back(box({i, 0, 0}, {i + 4, 4, 4}));
  for (const Rule rule : {Rule::any, Rule::all, Rule::odd})
    for (const std::uint32_t count : {7u, 8u}) {
      std::vector<const Body*> pointers;
      for (std::uint32_t i = 0; i < count; ++i) pointers.push_back(&boxes[i]);
      std::size_t combined = 0;
      const booleans::Run run = counting_parts(combined);
      const Expression e = Expression::flat(rule, count, 0);
      EXPECT_TRUE(same(sound(evaluate_in_parts(pointers, e, run)), sound(evaluate(pointers, e)))) << count;
      if (usual_thresholds()) {
        EXPECT_GT(combined, 0u);
      }
    }
}

/// A node of small subtrees, all rules and negations at random; some operands stand in several places.
Expression tree_of_parts(Random& random, std::uint32_t operands) {
  Expression e;
  e.add({random_rule(random), random.one_in(2), 0, none});
  for (std::uint32_t i = 0; i < operands;) {
    const std::uint32_t part = e.add({random_rule(random), random.one_in(2), 0, 0});
    for (std::uint64_t n = 1 + random.below(3); n > 0 && i < operands; --n, ++i)
      e.add({Rule::operand, random.one_in(2), random.one_in(12) ? 0 : i, part});
    if (random.one_in(3)) e.add({Rule::operand, random.one_in(2), static_cast<std::uint32_t>(random.below(i)), 0});
  }
  return e;
}

// Subtrees that share nothing with the rest are evaluated first, whatever they are at infinity.
TEST(Parts, SmallSubtreesAreEvaluatedFirst) {
  std::size_t combined = 0;
  for (std::uint64_t i = 0; i < case_count(20); ++i) {
    SCOPED_TRACE(case_name(i));
    Random random(0x5B7, i);
    Solids solids(random, Family::tiny);
    std::vector<Body> operands;
    for (int n = 0; n < 24; ++n) operands.push_back(random.one_in(4) ? complement(solids.next()) : solids.next());
    const std::vector<const Body*> pointers = Drawn::pointers(operands);
    const Expression e = tree_of_parts(random, static_cast<std::uint32_t>(operands.size()));
    const booleans::Run run = counting_parts(combined);
    ASSERT_TRUE(same(sound(evaluate(pointers, e)), sound(evaluate_in_parts(pointers, e, run))));
  }
  if (usual_thresholds()) {
    EXPECT_GT(combined, case_count(20) / 2);
  }
}

// A hundred boxes with a hole each are so many operations, and then one; a shared drill makes it one arrangement.
TEST(Parts, BoxesWithAHole) {
  for (const bool is_shared : {false, true}) {
    std::vector<Body> bodies;
    Expression e;
    e.add({Rule::any, false, 0, none});
    if (is_shared) bodies.push_back(box({-9, 1, 1}, {999, 2, 2}));
    for (std::int64_t i = 0; i < 100; ++i) {
      const std::uint32_t part = e.add({Rule::all, false, 0, 0});
      bodies.push_back(box({4 * i, 0, 0}, {4 * i + 3, 3, 3}));
      e.add({Rule::operand, false, static_cast<std::uint32_t>(bodies.size() - 1), part});
      if (!is_shared) bodies.push_back(box({4 * i - 1, 1, 1}, {4 * i + 4, 2, 2}));
      e.add({Rule::operand, true, is_shared ? 0 : static_cast<std::uint32_t>(bodies.size() - 1), part});
    }
    const std::vector<const Body*> pointers = Drawn::pointers(bodies);
    std::size_t combined = 0;
    const booleans::Run run = counting_parts(combined);
    const Body result = sound(evaluate_in_parts(pointers, e, run));
    EXPECT_EQ(body_of(canonical(result)).face_count(), 1000u);
    if (usual_thresholds()) {
      EXPECT_EQ(combined, is_shared ? 0u : 1u);
    }
  }
}

TEST(Parts, OperandsThatStandApartAreOneArrangement) {
  std::vector<Body> boxes;
  for (std::int64_t i = 0; i < 100; ++i) boxes.push_back(box({3 * i, 0, 0}, {3 * i + 2, 2, 2}));
  const std::vector<const Body*> pointers = Drawn::pointers(boxes);
  booleans::Run run;
  run.stage = [](const char* name) { EXPECT_STRNE(name, "parts"); };
  EXPECT_EQ(sound(evaluate_in_parts(pointers, Expression::flat(Rule::any, 100), run)).face_count(), 1200u);
}

TEST(Parts, ProgressNeverGoesBackAndCancellingEndsIt) {
  std::vector<Body> boxes;
  for (std::int64_t i = 0; i < 64; ++i)
    boxes.push_back(box({i % 4, i / 4 % 4, i / 16}, {i % 4 + 2, i / 4 % 4 + 2, i / 16 + 2}));
  const std::vector<const Body*> pointers = Drawn::pointers(boxes);
  std::vector<double> seen;
  std::atomic<bool> cancel = false;
  booleans::Run run;
  run.cancel = &cancel;
  run.progress = [&](double fraction) { seen.push_back(fraction); };
  const Expression e = Expression::flat(Rule::any, 64);
  EXPECT_TRUE(same(sound(evaluate_in_parts(pointers, e, run)), box({0, 0, 0}, {5, 5, 5})));
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
  EXPECT_EQ(seen.back(), 1.0);
  cancel = true;
  const auto result = evaluate_in_parts(pointers, e, run);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::cancelled);
}

}  // namespace
}  // namespace quoin::booleans::testing
