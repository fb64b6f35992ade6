#include "booleans/half_spaces.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/booleans/support.h"

namespace quoin::booleans::testing {
namespace {

/// The value of an expression over these solids and, behind them, half-spaces; nothing where its surface is infinite.
std::optional<Body> value_of(Expression e, const std::vector<Body>& solids, const std::vector<exact::Plane>& planes) {
  std::vector<const Body*> operands;
  for (const Body& body : solids) operands.push_back(&body);
  std::vector<Body> storage;
  const auto clipped = clip_half_spaces(e, planes, operands, storage, nullptr);
  if (!clipped) {
    EXPECT_EQ(clipped.error().code, ErrorCode::unbounded);
    return std::nullopt;
  }
  return sound(evaluate(operands, e));
}

// Far from all solids six half-spaces are a cube, five of them are infinite; so are their complements.
TEST(HalfSpaces, MakeACube) {
  const std::vector<Body> solids{box({0, 0, 0}, {1, 1, 1})};
  std::vector<exact::Plane> planes;
  Expression e;
  e.add({Rule::any, false, 0, none});
  e.add({Rule::operand, false, 0, 0});
  e.add({Rule::all, false, 0, 0});
  for (std::size_t k = 0; k < 3; ++k)
    for (const int at : {102, 100}) {
      exact::Plane plane{};
      plane.n[k] = 1;
      plane.d = -at;
      planes.push_back(plane);
      e.add({Rule::operand, at == 100, static_cast<std::uint32_t>(planes.size()), 2});
    }

  const Body expected = any(solids[0], box({100, 100, 100}, {102, 102, 102}));
  for (const bool negated : {false, true}) {
    e.nodes[0].negated = negated;
    const auto found = value_of(e, solids, planes);
    ASSERT_TRUE(found);
    EXPECT_TRUE(same(*found, negated ? complement(expected) : expected));
    Expression open = e;
    open.nodes.pop_back();
    EXPECT_FALSE(value_of(open, solids, planes));
  }
}

TEST(HalfSpaces, CutASolid) {
  const std::vector<Body> solids{box({0, 0, 0}, {4, 4, 4})};
  const exact::Plane plane{{1, 2, 3}, -exact::int128{11}};
  const Body below = half_space_body(plane, {{0, 0, 0}}, {{4, 4, 4}});
  EXPECT_TRUE(same(*value_of(Expression::flat(Rule::all, 2), solids, {plane}), below));
  EXPECT_TRUE(same(*value_of(Expression::flat(Rule::all, 2, 1), solids, {plane}), minus(solids[0], below)));
  EXPECT_FALSE(value_of(Expression::flat(Rule::any, 2), solids, {plane}));
}

// Beyond all meetings of the planes everything is as at infinity: between two large boxes.
TEST(HalfSpaces, AreFiniteWhereAShellOfSpaceSaysSo) {
  const exact::GridPoint low{{-64, -64, -64}}, high{{64, 64, 64}};
  // Three planes of these numbers meet within 18 steps of the origin.
  const Body inner = box({-32, -32, -32}, {32, 32, 32}), shell = minus(box_body(low, high), inner);
  std::size_t finite = 0, infinite = 0;
  for (std::uint64_t number = 0; number < case_count(200); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0x4A1F, number);
    const std::vector<Body> solids{box(random.vector(-3, 0), random.vector(1, 4))};
    std::vector<exact::Plane> planes;
    for (std::uint64_t n = 1 + random.below(5); n > 0; --n) {
      Vector normal = random.vector(-1, 1);
      if (normal == Vector{0, 0, 0}) normal = {0, 0, 1};
      exact::Plane plane = exact::reduced_plane(normal, random.between(-3, 3));
      if (!exact::is_canonical(plane)) plane = plane.opposite();
      if (std::find(planes.begin(), planes.end(), plane) == planes.end()) planes.push_back(plane);
    }

    const Expression e = random_expression(random, 1 + planes.size(), 2);
    std::vector<Body> bodies = solids;
    for (const exact::Plane& plane : planes) bodies.push_back(half_space_body(plane, low, high));
    const Body whole = evaluated(bodies, e), outside = all(shell, whole);
    const bool is_empty = empty(outside), is_finite = is_empty || same(outside, shell);
    const auto found = value_of(e, solids, planes);
    ASSERT_EQ(found.has_value(), is_finite);
    ++(is_finite ? finite : infinite);
    if (!found) continue;
    EXPECT_EQ(found->full_at_infinity, !is_empty);
    EXPECT_TRUE(same(all(inner, *found), all(inner, whole)));
    EXPECT_TRUE(same(all(shell, *found), outside));
  }
  EXPECT_GT(finite, 0u);
  EXPECT_GT(infinite, 0u);
}

}  // namespace
}  // namespace quoin::booleans::testing
