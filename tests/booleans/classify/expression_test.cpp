#include "booleans/classify/expression.h"

#include <gtest/gtest.h>

#include "tests/booleans/support.h"

namespace quoin::booleans::testing {
namespace {

/// The values for all ways in which three operands may be inside, operand 0 fastest: "01010101" for operand 0.
std::string table(const Expression& expression) {
  std::string values;
  for (std::uint32_t inside = 0; inside < 8; ++inside) {
    Evaluator evaluator(expression, 3);
    for (std::uint32_t o = 0; o < 3; ++o)
      if (inside >> o & 1) evaluator.add(o, 1);
    values += evaluator.value() ? '1' : '0';
  }
  return values;
}

TEST(Evaluator, TablesOfFlatExpressions) {
  EXPECT_EQ(table(Expression::itself()), "01010101");
  EXPECT_EQ(table(Expression::flat(Rule::any, 3)), "01111111");
  EXPECT_EQ(table(Expression::flat(Rule::all, 3)), "00000001");
  EXPECT_EQ(table(Expression::flat(Rule::odd, 3)), "01101001");
  EXPECT_EQ(table(Expression::flat(Rule::all, 3, 1)), "01000000");
  EXPECT_EQ(table(Expression::flat(Rule::any, 3, 2)), "11110111");
  EXPECT_EQ(table(Expression::flat(Rule::odd, 3, 2)), "10010110");
  EXPECT_EQ(table(Expression::flat(Rule::any, 0)), "00000000");
  EXPECT_EQ(table(Expression::flat(Rule::all, 0)), "11111111");
}

// The complement of (0 and not 1), or 2 twice, which cancels in a symmetric difference.
TEST(Evaluator, TablesOfTrees) {
  Expression e;
  const std::uint32_t root = e.add({Rule::odd, false, 0, none});
  const std::uint32_t difference = e.add({Rule::all, true, 0, root});
  e.add({Rule::operand, false, 0, difference});
  e.add({Rule::operand, true, 1, difference});
  e.add({Rule::operand, false, 2, root});
  EXPECT_EQ(table(e), "10110100");
  e.add({Rule::operand, false, 2, root});
  EXPECT_EQ(table(e), "10111011");
}

// Winding numbers count: inside is where they are > 0, whatever they were before.
TEST(Evaluator, InsideIsAPositiveWindingNumber) {
  const Expression expression = Expression::itself();
  Evaluator evaluator(expression, 1);
  EXPECT_FALSE(evaluator.value());
  std::string values;
  for (const int by : {1, 1, -1, -1, -1, -1, 1, 1, 1, -3, 5}) {
    evaluator.add(0, by);
    values += evaluator.value() ? '1' : '0';
  }
  EXPECT_EQ(values, "11100000101");
}

// Random trees whose leaves repeat, winding numbers that walk up and down, against the tree evaluated anew.
TEST(Evaluator, FollowsChangesOfWindingNumbers) {
  std::size_t changes = 0;
  for (std::uint64_t number = 0; number < case_count(200); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0xE9A1, number);
    const std::uint64_t operands = 1 + random.below(5);
    const Expression expression = random_expression(random, operands, 1 + static_cast<int>(random.below(4)));
    Evaluator evaluator(expression, static_cast<std::uint32_t>(operands));
    std::vector<int> winding(operands);
    bool before = evaluator.value();
    for (int step = 0; step < 60; ++step) {
      ASSERT_EQ(evaluator.value(), holds(expression, [&](std::uint32_t o) { return winding[o] > 0; }));
      changes += evaluator.value() != before;
      before = evaluator.value();
      const std::uint64_t o = random.below(operands);
      const int by = static_cast<int>(random.between(-2, 2));
      winding[o] += by;
      evaluator.add(static_cast<std::uint32_t>(o), by);
    }
  }
  EXPECT_GT(changes, case_count(200));
}

// Deep trees of any rules, with a few nodes on each level: as above.
TEST(Evaluator, FollowsChangesInDeepTrees) {
  std::size_t changes = 0;
  for (std::uint64_t number = 0; number < case_count(60); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0xE9A2, number);
    Expression expression;
    const auto rule = [&] { return random.one_in(2) ? Rule::odd : random.one_in(2) ? Rule::any : Rule::all; };
    const std::uint32_t depth = 1 + static_cast<std::uint32_t>(random.below(40)), operands = 2 * depth;
    std::uint32_t parent = expression.add({rule(), random.one_in(2), 0, none});
    for (std::uint32_t level = 0; level < depth; ++level) {
      std::uint32_t next = parent;
      for (std::uint64_t left = random.below(4); left > 0; --left)
        expression.add({Rule::operand, random.one_in(2), static_cast<std::uint32_t>(random.below(operands)), parent});
      for (std::uint64_t left = 1 + random.below(2); left > 0; --left)
        next = expression.add({rule(), random.one_in(2), 0, parent});
      parent = next;
    }
    Evaluator evaluator(expression, operands);
    std::vector<int> winding(operands);
    bool before = evaluator.value();
    for (int step = 0; step < 200; ++step) {
      const auto o = static_cast<std::uint32_t>(random.below(operands));
      const int by = static_cast<int>(random.between(-1, 1));
      winding[o] += by;
      evaluator.add(o, by);
      ASSERT_EQ(evaluator.value(), holds(expression, [&](std::uint32_t i) { return winding[i] > 0; }));
      changes += evaluator.value() != before;
      before = evaluator.value();
    }
  }
  EXPECT_GT(changes, 2 * case_count(60));
}

}  // namespace
}  // namespace quoin::booleans::testing
