#include "rounding/numbers/approximation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "tests/rounding/support.h"

namespace quoin::rounding::testing {
namespace {

using exact::to_rational;

std::vector<Integer> quotients(const Rational& w) {
  std::vector<Integer> r;
  for (ContinuedFraction c(w); c.next();) r.push_back(c.quotient());
  return r;
}
std::vector<Rational> convergents(const Rational& w) {
  std::vector<Rational> r;
  for (ContinuedFraction c(w); c.next();) r.emplace_back(c.p(), c.q());
  return r;
}
/// The denominator of the last convergent within Q, taken from the whole expansion.
Integer last_denominator(const Rational& w, const Integer& Q) {
  Integer q = 0;
  for (ContinuedFraction c(w); c.next();)
    if (c.q() <= Q) q = c.q();
  return q;
}
Rational error(const Rational& w, const Rational& approximation) { return magnitude(w - approximation); }

TEST(ApproximationTest, NearestIntegerTakesHalvesToEven) {
  const std::pair<Rational, int> cases[] = {
      {0, 0},
      {Rational(1, 2), 0},
      {Rational(3, 2), 2},
      {Rational(5, 2), 2},
      {Rational(-1, 2), 0},
      {Rational(-3, 2), -2},
      {Rational(-5, 2), -2},
      {Rational(7, 3), 2},
      {Rational(8, 3), 3},
      {Rational(-8, 3), -3},
      {-7, -7},
  };
  for (const auto& [v, nearest] : cases) EXPECT_EQ(nearest_integer(v), nearest) << v;
  std::mt19937_64 random = generator(300);
  for (int i = 0; i < 5000; ++i) {
    const Rational v = random_rational(random), half(1, 2);
    const Integer n = nearest_integer(v), f = floor_of(v);
    ASSERT_LE(f, v);
    ASSERT_GT(f + 1, v);
    ASSERT_LE(error(v, n), half) << v;
    if (error(v, n) == half) {
      ASSERT_EQ(n % 2, 0) << v;
    }
    ASSERT_EQ(nearest_integer(-v), -n) << v;
    ASSERT_EQ(magnitude(-v), magnitude(v));
    ASSERT_GE(magnitude(v), 0);
  }
}

// The worked example of 4.3.4: 0.123 by Euclid's algorithm on the exact fraction.
TEST(ApproximationTest, ExpandsTheDecimal0123) {
  const Rational w(123, 1000);
  EXPECT_EQ(quotients(w), (std::vector<Integer>{0, 8, 7, 1, 2, 5}));
  EXPECT_EQ(convergents(w), (std::vector<Rational>{0, Rational(1, 8), Rational(7, 57), Rational(8, 65),
                                                   Rational(23, 187), Rational(123, 1000)}));
  ContinuedFraction c(w);
  ASSERT_TRUE(c.next());
  EXPECT_EQ(c.previous_p(), 1);
  EXPECT_EQ(c.previous_q(), 0);
  ASSERT_TRUE(c.next() && c.next());
  EXPECT_EQ(Rational(c.previous_p(), c.previous_q()), Rational(1, 8));
}

// The double nearest to 0.123 follows the decimal for six quotients, the float for five alone: the book's printed table
// (0, 8, 7, 1, 2, 4, 1, 293) is that of the float, although it says double precision (S01).
TEST(ApproximationTest, ExpandsTheFloatsNearestTo0123) {
  EXPECT_EQ(quotients(to_rational(0.123)), (std::vector<Integer>{0, 8, 7, 1, 2, 5, Integer("562949953421"), 8}));
  const auto single = quotients(to_rational(0.123f));
  EXPECT_EQ(single, (std::vector<Integer>{0, 8, 7, 1, 2, 4, 1, 293, 1, 1, 9, 1, 6, 3}));
  // The printed rests, up to the garbled digits: r - k of each step, in six digits.
  const char* rests[] = {"0.130081", "0.687513", "0.454517", "0.200135", "0.996604", "0.003406", "0.524122"};
  Rational r = to_rational(0.123f);
  for (const char* rest : rests) {
    r = 1 / (r - floor_of(r));
    EXPECT_EQ(floor_of((r - floor_of(r)) * 1000000), floor_of(*exact::parse_rational(rest) * 1000000)) << rest;
  }
}

TEST(ApproximationTest, ExpandsAnyRational) {
  EXPECT_EQ(quotients(0), std::vector<Integer>{0});
  EXPECT_EQ(quotients(-7), std::vector<Integer>{-7});
  EXPECT_EQ(quotients(Rational(-1, 3)), (std::vector<Integer>{-1, 1, 2}));
  std::mt19937_64 random = generator(301);
  for (int i = 0; i < 1000; ++i) {
    const Rational w = random_rational(random);
    const auto k = quotients(w);
    const auto u = convergents(w);
    ASSERT_EQ(u.back(), w);
    // Second way: the fraction folded from its end.
    Rational folded = k.back();
    for (std::size_t j = k.size() - 1; j-- > 0;) folded = k[j] + 1 / folded;
    ASSERT_EQ(folded, w);
    // The shorter form.
    ASSERT_TRUE(k.size() == 1 || k.back() > 1);
    for (std::size_t j = 1; j < k.size(); ++j) ASSERT_GT(k[j], 0);
    for (const Rational& x : u) ASSERT_LE(error(w, x), 1 / Rational(denominator(x) * denominator(x))) << w;
  }
}

TEST(ApproximationTest, NaiveIsTheNearestOfItsDenominator) {
  EXPECT_EQ(naive_approximation(Rational(123, 1000), 100), Rational(3, 25));
  EXPECT_EQ(error(Rational(123, 1000), Rational(3, 25)), Rational(3, 1000));
  std::mt19937_64 random = generator(302);
  for (int i = 0; i < 2000; ++i) {
    const Rational w = random_rational(random);
    const Integer Q = abs(biased_integer(random, 70)) + 1;
    const Rational u = naive_approximation(w, Q);
    ASSERT_EQ(denominator(Rational(u * Q)), 1);
    ASSERT_LE(error(w, u), Rational(1, 2 * Q)) << w << ' ' << Q;
    ASSERT_EQ(naive_approximation(-w, Q), -u);
  }
}

TEST(ApproximationTest, BestOf0123) {
  const Rational w(123, 1000);
  struct Row {
    int first, last;
    Rational best;
  };
  const Row rows[] = {{1, 4, 0},
                      {10, 10, Rational(1, 8)},
                      {50, 50, Rational(6, 49)},
                      {57, 64, Rational(7, 57)},
                      {65, 121, Rational(8, 65)},
                      {122, 130, Rational(15, 122)},
                      {187, 188, Rational(23, 187)},
                      {500, 500, Rational(23, 187)},
                      {999, 999, Rational(100, 813)},
                      {1000, 1001, w}};
  for (const Row& row : rows)
    for (int Q = row.first; Q <= row.last; ++Q) EXPECT_EQ(best_approximation(w, Q), row.best) << Q;
  EXPECT_EQ(error(w, Rational(8, 65)), Rational(1, 13000));
}

TEST(ApproximationTest, BestOfPi) {
  const Rational pi = *exact::parse_rational("3.14159265358979");
  struct Row {
    int first, last;
    Rational best;
  };
  const Row rows[] = {{1, 3, 3},
                      {6, 6, Rational(19, 6)},
                      {7, 56, Rational(22, 7)},
                      {57, 57, Rational(179, 57)},
                      {64, 64, Rational(201, 64)},
                      {100, 100, Rational(311, 99)},
                      {106, 112, Rational(333, 106)},
                      {113, 200, Rational(355, 113)}};
  for (const Row& row : rows)
    for (int Q = row.first; Q <= row.last; ++Q) EXPECT_EQ(best_approximation(pi, Q), row.best) << Q;
}

// The book's bound 1 / (q Q) holds for convergents only (S03); the bounds of the header hold.
TEST(ApproximationTest, TheBookBoundIsFalse) {
  struct Case {
    Rational w;
    int Q;
    Rational best;
  };
  for (const Case& c : {Case{Rational(123, 1000), 50, Rational(6, 49)}, Case{Rational(1, 5), 3, Rational(1, 3)}}) {
    const Rational u = best_approximation(c.w, c.Q);
    EXPECT_EQ(u, c.best);
    EXPECT_GT(error(c.w, u), Rational(1, denominator(u) * c.Q));
    EXPECT_LE(error(c.w, u), Rational(1, last_denominator(c.w, c.Q) * (c.Q + 1)));
  }
}

// All quotients 1: the slowest expansion there is.
TEST(ApproximationTest, GoldenRatioTakesTheMostSteps) {
  Integer f = 1, next = 1;
  for (int i = 0; i < 300; ++i) f = std::exchange(next, Integer(f + next));
  const Rational golden(f, next);
  const std::pair<Integer, int> cases[] = {{1000, 15}, {1000000, 29}, {power_of_2(48), 69}, {power_of_2(64), 92}};
  for (const auto& [Q, steps] : cases) {
    int count = -1;  // the quotient 0 before the point is no step
    ContinuedFraction c(golden);
    for (; c.next() && c.q() <= Q; ++count) EXPECT_EQ(c.quotient(), count < 0 ? 0 : 1);
    EXPECT_EQ(count, steps);
    const Rational u = best_approximation(golden, Q);
    EXPECT_EQ(u, Rational(c.previous_p(), c.previous_q()));
  }
}

/// Of all fractions within Q: the closest, then of the smallest denominator, then the closest to 0.
Rational searched(const Rational& w, int Q) {
  Rational best = floor_of(w);
  const auto better = [&](const Rational& u) {
    const Rational e = error(w, u), least = error(w, best);
    if (e != least) return e < least;
    if (denominator(u) != denominator(best)) return denominator(u) < denominator(best);
    return magnitude(u) < magnitude(best);
  };
  for (int q = 1; q <= Q; ++q)
    for (const Integer& p : {floor_of(w * q), Integer(floor_of(w * q) + 1)})
      if (better(Rational(p, q))) best = Rational(p, q);
  return best;
}

TEST(ApproximationTest, BestEqualsTheSearch) {
  // The search for Q continues the search for Q - 1, since the closest of more fractions is the best of both.
  const auto check = [](const Rational& w, int most) {
    Rational best = floor_of(w);
    for (int Q = 1; Q <= most; ++Q) {
      for (const Integer& p : {floor_of(w * Q), Integer(floor_of(w * Q) + 1)}) {
        const Rational u(p, Q), e = error(w, u), least = error(w, best);
        if (e < least || (e == least && denominator(u) == denominator(best) && magnitude(u) < magnitude(best)))
          best = u;
      }
      const Rational found = best_approximation(w, Q);
      ASSERT_EQ(found, best) << w << ' ' << Q;
      ASSERT_LE(error(w, found), Rational(1, 2 * Q)) << w << ' ' << Q;
      ASSERT_LE(error(w, found), Rational(1, last_denominator(w, Q) * (Q + 1))) << w << ' ' << Q;
    }
  };
  for (int q = 1; q <= 60; ++q)
    for (int p = 0; p < q; ++p)
      if (std::gcd(p, q) == 1) check(Rational(p, q), 60);
  std::mt19937_64 random = generator(303);
  for (int i = 0; i < 60; ++i) {
    const Rational w = random_rational(random, 20);
    check(w, 40);
    const int Q = static_cast<int>(between(random, 1, 300));
    ASSERT_EQ(best_approximation(w, Q), searched(w, Q)) << w << ' ' << Q;
    // Not in lowest terms.
    const Integer k = 1 + below(random, 1000);
    ASSERT_EQ(best_approximation(numerator(w) * k, denominator(w) * k, Q), searched(w, Q)) << w << ' ' << Q;
  }
}

TEST(ApproximationTest, TiesGoToTheSmallerDenominatorThenTowardsZero) {
  EXPECT_EQ(best_approximation(Rational(1, 2), 1), 0);
  EXPECT_EQ(best_approximation(Rational(-1, 2), 1), 0);
  EXPECT_EQ(best_approximation(Rational(5, 2), 1), 2);
  EXPECT_EQ(best_approximation(Rational(-5, 2), 1), -2);
  EXPECT_EQ(best_approximation(Rational(1, 4), 2), 0);                // not 1/2
  EXPECT_EQ(best_approximation(Rational(3, 4), 2), 1);                // not 1/2
  EXPECT_EQ(best_approximation(Rational(5, 12), 3), Rational(1, 2));  // not 1/3
}

TEST(ApproximationTest, BestIsBoundedOddAndMonotone) {
  std::mt19937_64 random = generator(304);
  for (int i = 0; i < 100; ++i) {
    const Integer Q = abs(biased_integer(random, below(random, 2) == 0 ? 6 : 64)) + 1;
    std::vector<Rational> w;
    for (int j = 0; j < 30; ++j) w.push_back(random_rational(random));
    // Close together, and fractions within Q with their middles.
    for (int j = 0; j < 10; ++j) w.push_back(w[0] + Rational(j, power_of_2(90)));
    for (int j = 0; j < 10; ++j) w.push_back((best_approximation(w[0], Q) + best_approximation(w[1], Q + j)) / 2);
    std::sort(w.begin(), w.end());
    Rational before = best_approximation(w[0], Q);
    for (const Rational& x : w) {
      const Rational u = best_approximation(x, Q);
      ASSERT_LE(denominator(u), Q);
      ASSERT_LE(before, u) << x << ' ' << Q;
      ASSERT_LE(error(x, u), Rational(1, 2 * Q)) << x << ' ' << Q;
      ASSERT_LE(error(x, u), Rational(1, last_denominator(x, Q) * (Q + 1))) << x << ' ' << Q;
      ASSERT_LE(error(x, u), error(x, naive_approximation(x, Q)));
      ASSERT_EQ(best_approximation(-x, Q), -u);
      if (denominator(x) <= Q) {
        ASSERT_EQ(u, x);
      }
      before = u;
    }
  }
}

}  // namespace
}  // namespace quoin::rounding::testing
