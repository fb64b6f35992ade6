#include <gtest/gtest.h>

#include <algorithm>

#include "tests/api/solids.h"
#include "tests/grid/with_thresholds.h"

namespace quoin::api_test {
namespace {

Expression half(const std::string& a, const std::string& b, const std::string& c, const std::string& d) {
  return HalfSpace{{a, b, c, d}};
}

/// low <= x, y, z <= high as six half-spaces.
Expression cube_of_half_spaces(const std::string& low, const std::string& high) {
  std::vector<Expression> terms;
  for (std::size_t k = 0; k < 3; ++k) {
    HalfSpace below{{"0", "0", "0", "-" + high}}, above{{"0", "0", "0", low}};
    below.plane[k] = "1";
    above.plane[k] = "-1";
    terms.emplace_back(below);
    terms.emplace_back(above);
  }
  return Expression::intersect(terms);
}

std::string code(const Expression& expression) {
  const auto result = evaluate(expression);
  return result ? "" : to_string(result.error().code);
}

TEST(Expression, NestedIsOneOperation) {
  const Solid a = box({0, 0, 0}, {4, 4, 4}), b = box({1, 1, 1}, {5, 5, 5}), c = box({2, 0, 0}, {3, 4, 9});
  const Expression e = ((Expression(a) + b) - c) ^ ~(Expression(b) & c);
  const Solid expected = ((a + b) - c) ^ ~(b & c);
  const auto result = evaluate(e);
  ASSERT_TRUE(result);
  EXPECT_TRUE(result.value() == expected);
  EXPECT_EQ(result.value().to_quoin(), expected.to_quoin());
}

// A graph of few terms may have a tree of 3^40 leaves.
TEST(Expression, SharedTermsAreNotWrittenOut) {
  const Solid a = box({0, 0, 0}, {4, 4, 4}), b = box({1, 1, 1}, {5, 5, 5});
  Expression e = Expression(a) + b, f = e, g = e;
  for (int i = 0; i < 40; ++i) {
    e = e - (e - e);
    f = Expression::symmetric_difference({f, f, f});
    // Alternately the symmetric difference with b and that union again.
    g = (g + a) ^ (g & b);
  }
  EXPECT_TRUE(evaluate(e).value() == a + b);
  EXPECT_TRUE(evaluate(f).value() == a + b);
  Solid expected = a + b;
  for (int i = 0; i < 40; ++i) expected = (expected + a) ^ (expected & b);
  EXPECT_TRUE(evaluate(g).value() == expected);
  EXPECT_TRUE(evaluate(~g & g).value().is_empty());

  // Half-spaces are unbounded, and have no solid of their own.
  Expression h = half("1", "0", "0", "-2");
  for (int i = 0; i < 5; ++i) h = h - (h - h);
  EXPECT_EQ(volume(evaluate(Expression(a) & h).value()), "32");
  for (int i = 0; i < 40; ++i) h = h - (h - h);
  EXPECT_EQ(code(Expression(a) & h), "too-many-terms");
}

// As one operation, and every term that stands in several places by itself.
TEST(Expression, RandomTreesAgreeWithOperators) {
  auto random = random_engine();
  for (int round = 0; round < 10; ++round) {
    std::vector<Solid> solids;
    std::vector<Expression> trees;
    for (int i = 0; i < 4; ++i) {
      solids.push_back(random_tetrahedron(random, 4));
      trees.emplace_back(solids.back());
    }
    for (int step = 0; step < 8; ++step) {
      const std::size_t i = random() % 4, j = random() % 4;
      switch (random() % 5) {
        case 0:
          solids[i] = solids[i] + solids[j], trees[i] = trees[i] + trees[j];
          break;
        case 1:
          solids[i] = solids[i] - solids[j], trees[i] = trees[i] - trees[j];
          break;
        case 2:
          solids[i] = solids[i] & solids[j], trees[i] = trees[i] & trees[j];
          break;
        case 3:
          solids[i] = solids[i] ^ solids[j], trees[i] = trees[i] ^ trees[j];
          break;
        default:
          solids[i] = ~solids[i], trees[i] = ~trees[i];
      }
    }
    for (std::size_t i = 0; i < 4; ++i) {
      for (const std::size_t leaves : {grid::thresholds().few_leaves, std::size_t{0}}) {
        const grid::testing::WithThresholds few(grid::testing::with(&grid::Thresholds::few_leaves, leaves));
        const auto result = evaluate(trees[i]);
        ASSERT_TRUE(result);
        EXPECT_EQ(result.value().to_quoin(), solids[i].to_quoin());
      }
    }
  }
}

TEST(Expression, OneSolidSeveralTimes) {
  const Solid a = box({0, 0, 0}, {1, 1, 1});
  EXPECT_TRUE(evaluate(Expression(a) ^ a).value().is_empty());
  EXPECT_TRUE(evaluate(Expression(a) + a).value() == a);
  EXPECT_TRUE(evaluate(Expression(a) & ~Expression(a)).value().is_empty());
  EXPECT_TRUE(evaluate(Expression(a) + ~Expression(a)).value() == Solid::full(Grid()));
  EXPECT_TRUE(evaluate(~~Expression(a)).value() == a);
}

TEST(Expression, WithoutTerms) {
  const Solid a = box({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(code(Expression::unite({})), "no-operand");
  EXPECT_EQ(code(half("1", "0", "0", "0")), "no-operand");
  EXPECT_EQ(unite({}).error().code, ErrorCode::no_operand);
  EXPECT_TRUE(evaluate(a + Expression::unite({})).value() == a);
  EXPECT_TRUE(evaluate(a & Expression::intersect({})).value() == a);
  EXPECT_TRUE(evaluate(a & Expression::unite({})).value().is_empty());
}

TEST(Expression, LongChainsAreNoProblem) {
  const Solid a = box({0, 0, 0}, {1, 1, 1}), b = box({0, 0, 0}, {2, 1, 1});
  Expression chain = a;
  for (int i = 0; i < 200000; ++i) chain = chain + (i % 2 == 0 ? a : b);
  EXPECT_TRUE(evaluate(chain).value() == b);
  Expression alternating = a;
  for (int i = 0; i < 2000; ++i) alternating = ~(alternating & b);
  const auto result = evaluate(alternating);
  ASSERT_TRUE(result);
  EXPECT_TRUE(result.value() == a + ~b);
}

TEST(Expression, HalfSpacesCut) {
  const Solid a = box({0, 0, 0}, {4, 4, 4});
  EXPECT_TRUE(evaluate(a & half("1", "0", "0", "-1")).value() == box({0, 0, 0}, {1, 4, 4}));
  EXPECT_TRUE(evaluate(a - half("1", "0", "0", "-1")).value() == box({1, 0, 0}, {4, 4, 4}));
  EXPECT_TRUE(evaluate(a & half("-2", "0", "0", "2")).value() == box({1, 0, 0}, {4, 4, 4}));
  EXPECT_EQ(volume(evaluate(a & half("1", "1", "1", "-1/2")).value()), "1/48");
  EXPECT_TRUE(evaluate(~Expression(a) + half("1", "0", "0", "-1")).value() == ~box({1, 0, 0}, {4, 4, 4}));
  // A plane along a face, from both sides.
  EXPECT_TRUE(evaluate(a & half("0", "1", "0", "0")).value().is_empty());
  EXPECT_TRUE(evaluate(a & half("0", "-1", "0", "0")).value() == a);
}

TEST(Expression, HalfSpacesMakeSolids) {
  const Solid a = box({0, 0, 0}, {1, 1, 1});
  EXPECT_TRUE(evaluate(a + cube_of_half_spaces("100", "102")).value() == a + box({100, 100, 100}, {102, 102, 102}));
  EXPECT_TRUE(evaluate(a ^ cube_of_half_spaces("0", "2")).value() == box({0, 0, 0}, {2, 2, 2}) - a);
  EXPECT_TRUE(evaluate(a + ~cube_of_half_spaces("0", "2")).value() == ~(box({0, 0, 0}, {2, 2, 2}) - a));
  EXPECT_TRUE(evaluate(Solid() + cube_of_half_spaces("0", "2")).value() == box({0, 0, 0}, {2, 2, 2}));
  // Up to the world's boundary, and beyond.
  EXPECT_EQ(volume(evaluate(Solid() + cube_of_half_spaces("0", "536870912")).value()), "154742504910672534362390528");
  EXPECT_EQ(code(Solid() + cube_of_half_spaces("0", "536870913")), "unbounded");
  EXPECT_EQ(code(Solid() + cube_of_half_spaces("1000000000", "1000000001")), "unbounded");
}

TEST(Expression, HalfSpacesWithoutFiniteSurfaceAreRefused) {
  const Solid a = box({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(code(a + half("1", "0", "0", "-1")), "unbounded");
  EXPECT_EQ(code(a + half("1", "0", "0", "-1000000000")), "unbounded");
  EXPECT_EQ(code(~Expression(a) & half("1", "0", "0", "-1")), "unbounded");
  // A slab, an infinite prism, an octant, and a wedge far out, most of its planes near the origin.
  EXPECT_EQ(code(a + (half("1", "0", "0", "-2") & half("-1", "0", "0", "0"))), "unbounded");
  EXPECT_EQ(code(a + (half("1", "0", "0", "-2") & half("-1", "0", "0", "0") & half("0", "1", "0", "-2") &
                      half("0", "-1", "0", "0"))),
            "unbounded");
  EXPECT_EQ(code(a + (half("1", "0", "0", "0") & half("0", "1", "0", "0") & half("0", "0", "1", "0"))), "unbounded");
  EXPECT_EQ(code(a + (half("1", "-1000000000", "0", "-5") & half("-1", "1000000001", "0", "0") &
                      half("0", "0", "1", "-9") & half("0", "0", "-1", "-9") & half("-1", "0", "0", "1000000000"))),
            "unbounded");
}

TEST(Expression, HalfSpacesThatCancelAtInfinity) {
  const Solid a = box({0, 0, 0}, {4, 4, 4});
  const Expression h = half("1", "0", "0", "-2"), opposite = half("-3", "0", "0", "6");
  EXPECT_TRUE(evaluate(a + (h & opposite)).value() == a);
  EXPECT_TRUE(evaluate(a & (h + opposite)).value() == a);
  EXPECT_TRUE(evaluate(~Expression(a) & (h + opposite)).value() == ~a);
  EXPECT_TRUE(evaluate(~Expression(a) & (half("1", "0", "0", "-2") + half("-1", "0", "0", "1"))).value() == ~a);
  EXPECT_TRUE(evaluate(a ^ h ^ h).value() == a);
  EXPECT_TRUE(evaluate((a & h) + (a - h)).value() == a);
}

TEST(Expression, GridsGoToTheFinest) {
  const Solid a = box({0, 0, 0}, {1, 1, 1}, grid_of("1/2")), b = box({0, 0, 0}, {2, 1, 1}, grid_of("1/10"));
  const auto both = evaluate(Expression(a) + b);
  ASSERT_TRUE(both);
  EXPECT_EQ(both.value().grid().step(), "1/10");
  EXPECT_EQ(volume(both.value()), "2");
}

// A tetrahedron with long normals, and boxes so far away that no grid holds all of them exactly.
TEST(Expression, ErrorsNameTheOperand) {
  const Grid far = Grid::with_step_and_origin("1024", {"0", "0", "1e11"}).value();
  const Solid a = box({0, 0, 0}, {1, 1, 1}), b = box({2, 0, 0}, {3, 1, 1}),
              wide = box({0, 0, 1e11}, {1024, 1024, 1e11 + 2048}, far),
              fine = tetrahedron({Corner{-536870911, 1, 2}, Corner{536870909, -536870912, 7},
                                  Corner{12345, 536870911, -536870912}, Corner{3, 5, 536870911}});
  const auto place = [](const Result<Solid>& result) { return result ? "none" : result.error().where; };
  const Options exact{.grid_rule = GridRule::exact};
  // The first that does not fit, by its place among all; a solid that stands in several by the first of them.
  EXPECT_EQ(place(unite({wide, wide, a, fine}, exact)), "operand 3");
  EXPECT_EQ(place(unite({wide, fine, a}, exact)), "operand 1");
  EXPECT_EQ(place(difference(fine, {wide}, exact)), "operand 0");
  EXPECT_EQ(place(evaluate((Expression(wide) + half("1", "0", "0", "0")) & ~(Expression(fine) ^ a), exact)),
            "operand 2");
  EXPECT_EQ(unite({wide, fine}, exact).error().code, ErrorCode::inexact_grid);
  EXPECT_EQ(place(unite({wide, fine, a})), "none");

  EXPECT_EQ(place(evaluate(Expression(a) & half("1", "0", "0", "0") & half("1", "x", "0", "0"))), "operand 2");
  EXPECT_EQ(place(evaluate(Expression(a) - half("0", "0", "0", "1"))), "operand 1");
  // Of a split there is one plane.
  const auto parts = split(a, HalfSpace{{"0", "0", "0", "1"}});
  ASSERT_FALSE(parts);
  EXPECT_EQ(parts.error().code, ErrorCode::bad_plane);
  EXPECT_EQ(parts.error().where, "");

  // What is evaluated in parts has no numbers: the place in the operand remains.
  Expression large = a;
  for (int i = 0; i < 300; ++i) large = large + box({0, 0, 0}, {i + 1.0, 1, 1}) + fine;
  EXPECT_EQ(place(evaluate((large + wide) & (large - b), exact)), "");
  EXPECT_EQ(evaluate((large + wide) & (large - b), exact).error().code, ErrorCode::inexact_grid);
}

}  // namespace
}  // namespace quoin::api_test
