// The algebra of sets, with == and for every solid.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "tests/booleans/support.h"
#include "tests/grid/with_thresholds.h"

namespace quoin::booleans::testing {
namespace {

using exact::Rational;
using grid::testing::WithThresholds;

class Laws : public ::testing::TestWithParam<Family> {
 protected:
  /// check(solids, random) for as many cases as the family's cost allows.
  template <class Check>
  void for_cases(std::uint64_t salt, std::uint64_t count, Check&& check) const {
    const Family family = GetParam();
    if (family == Family::spheres) count = (count + 7) / 8;
    for (std::uint64_t i = 0; i < count; ++i) {
      SCOPED_TRACE(case_name(i));
      Random random(salt * families.size() + static_cast<std::uint64_t>(family), i);
      Solids solids(random, family);
      check(solids, random);
      if (HasFatalFailure() || HasNonfatalFailure()) return;
    }
  }
};

/// Up to orientation.
std::set<std::array<exact::int128, 4>> planes_of(const Body& body) {
  std::set<std::array<exact::int128, 4>> planes;
  for (std::uint32_t f = 0; f < body.face_count(); ++f) {
    const exact::Plane p = body.plane(f), c = exact::is_canonical(p) ? p : p.opposite();
    planes.insert({c.n[0], c.n[1], c.n[2], c.d});
  }
  return planes;
}

/// A prism along z over a polygon that sees its hub; the caps are fans about it.
Body fan_prism(const std::vector<Vector>& rim, const Vector& hub, std::int64_t low, std::int64_t high) {
  std::vector<Vector> points;
  for (const std::int64_t z : {low, high})
    for (const Vector& p : rim) points.push_back({p[0], p[1], z});
  const auto n = static_cast<std::uint32_t>(rim.size()), bottom = 2 * n, top = bottom + 1;
  points.insert(points.end(), {{hub[0], hub[1], low}, {hub[0], hub[1], high}});

  std::vector<Triangle> triangles;
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    triangles.insert(triangles.end(), {{i, j, n + j}, {i, n + j, n + i}, {bottom, j, i}, {top, n + i, n + j}});
  }
  return *mesh(points, triangles);
}
Vector on_circle(double radius, double turn) {
  return {std::llround(radius * std::cos(turn)), std::llround(radius * std::sin(turn)), 0};
}
/// A star of many tips, or a wedge at the axis; heights and directions are few, so that solids share planes and edges.
Body star_or_wedge(Random& random) {
  constexpr double turn = 2 * std::numbers::pi;
  constexpr double size = 1 << 20;
  const std::int64_t low = random.between(0, 2), high = low + random.between(1, 2);
  std::vector<Vector> rim;
  if (random.one_in(2)) {
    const double at = turn * static_cast<double>(random.below(48)) / 48, width = turn / 96;
    rim = {{0, 0, 0}, on_circle(size, at), on_circle(size, at + width)};
    return fan_prism(rim, {0, 0, 0}, low, high);
  }

  const std::uint64_t corners = 2 * (12 + random.below(40));
  const double first = turn * static_cast<double>(random.below(8)) / 8 / static_cast<double>(corners);
  for (std::uint64_t i = 0; i < corners; ++i)
    rim.push_back(
        on_circle(i % 2 == 0 ? size : size / 2, first + turn * static_cast<double>(i) / static_cast<double>(corners)));
  return fan_prism(rim, {0, 0, 0}, low, high);
}

// Edges that overlap in all their boxes, and faces that meet in one edge: with trees, strips and hubs as one by one.
TEST(StarsAndWedges, AllWaysHaveOneResult) {
  for (std::uint64_t number = 0; number < case_count(25); ++number) {
    SCOPED_TRACE(case_name(number));
    Random random(0x57A2, number);
    std::vector<Body> solids;
    for (std::uint64_t left = 3 + random.below(3); left > 0; --left) solids.push_back(star_or_wedge(random));
    const Rule rule = std::array{Rule::any, Rule::all, Rule::odd}[random.below(3)];
    const auto result = [&](const grid::Thresholds& t) {
      const WithThresholds set(t);
      return evaluated(solids, Expression::flat(rule, static_cast<std::uint32_t>(solids.size())));
    };

    const Body usual = result({});
    ASSERT_TRUE(same(usual, result(grid::Thresholds::smallest())));
    ASSERT_TRUE(same(usual, result(grid::Thresholds::largest())));
    ASSERT_TRUE(same(usual, result(grid::Thresholds::patched())));
  }
}

TEST_P(Laws, OperandOrderDoesNotMatter) {
  for_cases(1, 60, [](Solids& solids, Random&) {
    const Body a = solids.next(), b = solids.next(), c = solids.next();
    for (const Rule rule : {Rule::any, Rule::all, Rule::odd}) {
      EXPECT_TRUE(same(combined(rule, {&a, &b}), combined(rule, {&b, &a})));
      const Body abc = combined(rule, {&a, &b, &c});
      for (const auto& order : {std::array{&b, &c, &a}, std::array{&c, &b, &a}})
        EXPECT_TRUE(same(combined(rule, {order[0], order[1], order[2]}), abc));
    }
  });
}

TEST_P(Laws, GroupingDoesNotMatter) {
  for_cases(2, 60, [](Solids& solids, Random&) {
    const Body a = solids.next(), b = solids.next(), c = solids.next();
    for (const Rule rule : {Rule::any, Rule::all, Rule::odd}) {
      const Body ab = combined(rule, {&a, &b}), bc = combined(rule, {&b, &c});
      const Body at_once = combined(rule, {&a, &b, &c});
      EXPECT_TRUE(same(combined(rule, {&ab, &c}), at_once));
      EXPECT_TRUE(same(combined(rule, {&a, &bc}), at_once));
    }
  });
}

TEST_P(Laws, IdempotenceAbsorptionAndTheEmptySet) {
  for_cases(3, 60, [](Solids& solids, Random&) {
    const Body a = solids.next(), b = solids.next(), nothing;
    EXPECT_TRUE(same(any(a, a), a));
    EXPECT_TRUE(same(all(a, a), a));
    EXPECT_TRUE(same(any(a, all(a, b)), a));
    EXPECT_TRUE(same(all(a, any(a, b)), a));
    EXPECT_TRUE(same(any(a, nothing), a));
    EXPECT_TRUE(same(minus(a, nothing), a));
    EXPECT_TRUE(empty(all(a, nothing)));
    EXPECT_TRUE(empty(minus(a, a)));
    EXPECT_TRUE(empty(odd(a, a)));
    const Body everything = any(a, complement(a));
    EXPECT_EQ(everything.face_count(), 0u);
    EXPECT_TRUE(everything.full_at_infinity);
    EXPECT_TRUE(empty(all(a, complement(a))));
  });
}

TEST_P(Laws, Distributivity) {
  for_cases(4, 60, [](Solids& solids, Random&) {
    const Body a = solids.next(), b = solids.next(), c = solids.next();
    EXPECT_TRUE(same(all(a, any(b, c)), any(all(a, b), all(a, c))));
    EXPECT_TRUE(same(any(a, all(b, c)), all(any(a, b), any(a, c))));
    EXPECT_TRUE(same(all(a, odd(b, c)), odd(all(a, b), all(a, c))));
  });
}

TEST_P(Laws, DeMorgan) {
  for_cases(5, 60, [](Solids& solids, Random&) {
    const Body a = solids.next(), b = solids.next(), not_a = complement(a), not_b = complement(b);
    EXPECT_TRUE(same(complement(any(a, b)), all(not_a, not_b)));
    EXPECT_TRUE(same(complement(all(a, b)), any(not_a, not_b)));
    EXPECT_TRUE(same(minus(a, b), all(a, not_b)));
    EXPECT_TRUE(same(odd(not_a, b), complement(odd(a, b))));
    EXPECT_TRUE(same(odd(not_a, not_b), odd(a, b)));
  });
}

TEST_P(Laws, PartsMakeTheWhole) {
  for_cases(6, 80, [](Solids& solids, Random&) {
    const Body a = solids.next(), b = solids.next();
    const Body both = all(a, b), only_a = minus(a, b), only_b = minus(b, a), one = odd(a, b);
    EXPECT_TRUE(same(any(only_a, both), a));
    EXPECT_TRUE(same(any(only_a, only_b), one));
    EXPECT_TRUE(same(minus(any(a, b), both), one));
    EXPECT_TRUE(same(any(one, both), any(a, b)));
    EXPECT_TRUE(same(odd(one, b), a));
    EXPECT_TRUE(same(combined(Rule::any, {&only_a, &both, &only_b}), any(a, b)));
    EXPECT_TRUE(empty(minus(minus(a, both), only_a)));
  });
}

TEST_P(Laws, VolumesByInclusionAndExclusion) {
  for_cases(7, 60, [](Solids& solids, Random&) {
    const Body a = solids.next(), b = solids.next(), c = solids.next();
    const Rational va = volume(a), vb = volume(b), vc = volume(c), ab = volume(all(a, b)), bc = volume(all(b, c)),
                   ca = volume(all(c, a)), abc = volume(combined(Rule::all, {&a, &b, &c}));
    EXPECT_EQ(volume(any(a, b)), Rational(va + vb - ab));
    EXPECT_EQ(volume(minus(a, b)), Rational(va - ab));
    EXPECT_EQ(volume(combined(Rule::any, {&a, &b, &c})), Rational(va + vb + vc - ab - bc - ca + abc));
    EXPECT_EQ(volume(combined(Rule::odd, {&a, &b, &c})), Rational(va + vb + vc - 2 * (ab + bc + ca) + 4 * abc));
    EXPECT_EQ(volume(complement(a)), Rational(-va));
    EXPECT_GE(ab, 0);
    EXPECT_EQ(ab == 0, all(a, b).face_count() == 0);
  });
}

TEST_P(Laws, ResultPlanesAreOperandPlanes) {
  for_cases(8, 60, [](Solids& solids, Random& random) {
    const std::vector<Body> operands{solids.next(), solids.next(), solids.next()};
    std::set<std::array<exact::int128, 4>> given;
    for (const Body& b : operands) given.merge(planes_of(b));
    const Body result = evaluated(operands, random_expression(random, operands.size(), 3));
    for (const Body& body : {result, body_of(canonical(result))})
      for (const auto& p : planes_of(body)) EXPECT_TRUE(given.contains(p));
  });
}

TEST_P(Laws, ExpressionsAtOnceAndOneByOne) {
  for_cases(9, 60, [](Solids& solids, Random& random) {
    std::vector<Body> operands;
    for (std::uint64_t n = 2 + random.below(4); n > 0; --n) operands.push_back(solids.next());
    const Expression e = random_expression(random, operands.size(), 3);
    EXPECT_TRUE(same(evaluated(operands, e), pairwise(e, operands)));
  });
}

TEST_P(Laws, CanonicalForms) {
  for_cases(10, 80, [](Solids& solids, Random&) {
    const Body a = solids.next(), b = solids.next();
    for (const Body& body : {a, odd(a, b), minus(a, b), complement(any(a, b))}) {
      const Canonical form = canonical(body);
      const Body again = body_of(form);
      EXPECT_EQ(fault(again), std::nullopt);
      EXPECT_TRUE(canonical(again) == form);
      EXPECT_EQ(volume(again), volume(body));
      EXPECT_TRUE(canonical(complement(complement(body))) == form);
      EXPECT_EQ(canonical(complement(body)).face_count(), form.face_count());
      EXPECT_FALSE(canonical(complement(body)) == form);
      EXPECT_TRUE(empty(odd(body, again)));
    }
  });
}

TEST_P(Laws, ChainsOfFiftyOperations) {
  for_cases(11, 2, [](Solids& solids, Random& random) {
    std::vector<Body> operands{solids.raw()};
    Expression e;
    Body chain = operands[0];
    constexpr std::uint32_t length = 50;
    std::vector<Rule> rules;
    std::vector<bool> negated;
    for (std::uint32_t i = 0; i < length; ++i) {
      static constexpr std::array<Rule, 4> choice{Rule::any, Rule::any, Rule::all, Rule::odd};
      rules.push_back(choice[random.below(4)]);
      negated.push_back(rules.back() == Rule::all);
      operands.push_back(solids.raw());
      chain = combined(rules.back(), {&chain, &operands.back()}, negated.back() ? 1 : none);
    }
    // The same as one left-deep tree, its last operation at the root.
    std::uint32_t parent = none;
    for (std::uint32_t i = length; i-- > 0;) {
      const std::uint32_t self = e.add({rules[i], false, 0, parent});
      e.add({Rule::operand, negated[i], i + 1, self});
      parent = self;
    }
    e.add({Rule::operand, false, 0, parent});
    EXPECT_TRUE(same(evaluated(operands, e), chain));
    // Every operand taken off again leaves nothing.
    Body rest = chain;
    for (const Body& b : operands) rest = minus(rest, b);
    EXPECT_TRUE(empty(rest));
  });
}

INSTANTIATE_TEST_SUITE_P(Booleans, Laws, ::testing::ValuesIn(families),
                         [](const auto& one) { return std::string(name_of(one.param)); });

TEST(BigLaws, DentedSpheresOfThousandsOfFaces) {
  for (std::uint64_t i = 0; i < 3; ++i) {
    SCOPED_TRACE(case_name(i));
    Random random(20, i);
    const auto ball = [&](const Vector& centre) {
      for (;;) {
        const auto body = sphere(centre, 24, 40, [&](std::uint32_t, std::uint32_t) {
          return 1e8 * (1 - static_cast<double>(random.below(1000)) / 2e4);
        });
        if (body) return *body;
      }
    };
    const Body a = ball({0, 0, 0}), b = ball(random.vector(-30'000'000, 30'000'000));
    const Body either = any(a, b), both = all(a, b), one = odd(a, b);
    EXPECT_EQ(Rational(volume(a) + volume(b)), Rational(volume(either) + volume(both)));
    EXPECT_TRUE(same(any(minus(a, b), both), a));
    EXPECT_TRUE(same(any(one, both), either));
    EXPECT_TRUE(same(complement(all(complement(a), complement(b))), either));
  }
}

}  // namespace
}  // namespace quoin::booleans::testing
