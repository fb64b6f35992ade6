#include "rounding/numbers/lattice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "tests/rounding/support.h"

namespace quoin::rounding::testing {
namespace {

using Rows = std::vector<LatticeVector>;
using RationalRow = std::vector<Rational>;

Rows identity(std::size_t n) {
  Rows r(n, LatticeVector(n));
  for (std::size_t i = 0; i < n; ++i) r[i][i] = 1;
  return r;
}

Rows product(const Rows& a, const Rows& b) {
  Rows r(a.size(), LatticeVector(b[0].size()));
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b[0].size(); ++j)
      for (std::size_t k = 0; k < b.size(); ++k) r[i][j] += a[i][k] * b[k][j];
  return r;
}

/// By elimination.
Rational determinant_of(const Rows& m) {
  std::vector<RationalRow> a;
  for (const LatticeVector& row : m) a.emplace_back(row.begin(), row.end());
  Rational d = 1;
  for (std::size_t k = 0; k < a.size(); ++k) {
    std::size_t p = k;
    while (p < a.size() && a[p][k] == 0) ++p;
    if (p == a.size()) return 0;
    if (p != k) {
      std::swap(a[p], a[k]);
      d = -d;
    }
    d *= a[k][k];
    for (std::size_t i = k + 1; i < a.size(); ++i) {
      const Rational f = a[i][k] / a[k][k];
      for (std::size_t j = k; j < a.size(); ++j) a[i][j] -= f * a[k][j];
    }
  }
  return d;
}

Rational dot_of(const RationalRow& a, const RationalRow& b) {
  Rational sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

Integer squared_length(const LatticeVector& v) {
  Integer sum = 0;
  for (const Integer& x : v) sum += x * x;
  return sum;
}

/// Size reduction and Lovasz' condition, by Gram and Schmidt in rationals. Independence on the way.
void expect_reduced(const Rows& basis) {
  std::vector<RationalRow> star;
  Rational last_mu = 0;
  for (std::size_t i = 0; i < basis.size(); ++i) {
    const RationalRow b(basis[i].begin(), basis[i].end());
    RationalRow v = b;
    for (std::size_t j = 0; j < i; ++j) {
      const Rational mu = dot_of(b, star[j]) / dot_of(star[j], star[j]);
      ASSERT_LE(magnitude(mu), Rational(1, 2)) << i << ' ' << j;
      for (std::size_t k = 0; k < v.size(); ++k) v[k] -= mu * star[j][k];
      last_mu = mu;
    }
    const Rational length = dot_of(v, v);
    ASSERT_GT(length, 0);
    if (i > 0) {
      ASSERT_GE(length, (Rational(3, 4) - last_mu * last_mu) * dot_of(star[i - 1], star[i - 1])) << i;
    }
    star.push_back(std::move(v));
  }
}

/// Reduces and checks everything that the header says. The reduced basis.
Rows checked_reduction(const Rows& basis) {
  Rows reduced = basis, combinations = identity(basis.size());
  reduce_basis(reduced, combinations);
  expect_reduced(reduced);
  EXPECT_EQ(product(combinations, basis), reduced);
  EXPECT_EQ(magnitude(determinant_of(combinations)), 1);
  return reduced;
}

TEST(LatticeTest, KnownCases) {
  // A textbook case; (-1, 0, 2) would do for the last vector as well, its mu being 1/2 of the other sign.
  EXPECT_EQ(checked_reduction({{1, 1, 1}, {-1, 0, 2}, {3, 5, 6}}), (Rows{{0, 1, 0}, {1, 0, 1}, {-2, 0, 1}}));
  // Gauss in the plane: the lattice of all integers, badly given.
  const Rows plane = checked_reduction({{1, 1000}, {0, 1}});
  EXPECT_EQ(squared_length(plane[0]), 1);
  EXPECT_EQ(squared_length(plane[1]), 1);
  // Reduced ones stay.
  EXPECT_EQ(checked_reduction(identity(4)), identity(4));
  EXPECT_EQ(checked_reduction({{5}}), (Rows{{5}}));
  Rows nothing, none;
  reduce_basis(nothing, none);
  EXPECT_TRUE(nothing.empty());
}

// mu = 1/2 and |v|^2 = (3/4 - mu^2) |u|^2, both just so: no exchange. Which half mu is does not matter.
TEST(LatticeTest, KeepsWhatIsJustReduced) {
  const Rows r = checked_reduction({{2, 0, 0}, {-1, 1, 1}});
  EXPECT_EQ(r[0], (LatticeVector{2, 0, 0}));
  EXPECT_EQ(squared_length(r[1]), 3);
}

TEST(LatticeTest, ReducesRandomBases) {
  std::mt19937_64 random = generator(320);
  for (int i = 0; i < 300; ++i) {
    const std::size_t n = 2 + below(random, 4);
    const unsigned magnitude = static_cast<unsigned>(between(random, 2, 120));
    Rows basis(n, LatticeVector(n));
    for (LatticeVector& v : basis)
      for (Integer& x : v) x = biased_integer(random, magnitude);
    if (determinant_of(basis) == 0) continue;
    const Rows reduced = checked_reduction(basis);
    ASSERT_EQ(rounding::magnitude(determinant_of(reduced)), rounding::magnitude(determinant_of(basis)));
  }
}

// Fewer vectors than coordinates, and the lattices that plane rounding makes: two near-parallel huge vectors.
TEST(LatticeTest, ReducesFlatAndSkewBases) {
  std::mt19937_64 random = generator(321);
  for (int i = 0; i < 100; ++i) {
    const Integer one = power_of_2(120);
    const Rows approximations{{power_of_2(static_cast<unsigned>(between(random, 10, 110))), biased_integer(random, 120),
                               biased_integer(random, 120)},
                              {0, one, 0},
                              {0, 0, one}};
    checked_reduction(approximations);
    Rows flat{{1, biased_integer(random, 90), biased_integer(random, 90), 0}, {0, 1, 0, biased_integer(random, 90)}};
    checked_reduction(flat);
  }
}

TEST(LatticeTest, CompanionsUndergoTheSame) {
  std::mt19937_64 random = generator(322);
  for (int i = 0; i < 50; ++i) {
    Rows basis(3, LatticeVector(3)), companions(3, LatticeVector(5)), combinations = identity(3);
    for (LatticeVector& v : basis)
      for (Integer& x : v) x = biased_integer(random, 50);
    for (LatticeVector& v : companions)
      for (Integer& x : v) x = biased_integer(random, 50);
    if (determinant_of(basis) == 0) continue;
    const Rows before = companions;
    Rows copy = basis;
    reduce_basis(basis, companions);
    reduce_basis(copy, combinations);
    ASSERT_EQ(copy, basis);
    ASSERT_EQ(companions, product(combinations, before));
  }
}

// In three dimensions the first vector is at most twice as long as the shortest.
TEST(LatticeTest, FirstVectorIsShort) {
  std::mt19937_64 random = generator(323);
  int not_shortest = 0;
  for (int i = 0; i < 150; ++i) {
    Rows basis(3, LatticeVector(3));
    for (LatticeVector& v : basis)
      for (Integer& x : v) x = between(random, -9, 9);
    const Rational d = determinant_of(basis);
    if (d == 0) continue;
    const Integer first = squared_length(checked_reduction(basis)[0]);
    // x is in the lattice if x times the inverse is whole: Cramer's rule, row by row.
    const auto contains = [&](const LatticeVector& x) {
      for (std::size_t k = 0; k < 3; ++k) {
        Rows replaced = basis;
        replaced[k] = x;
        if (denominator(Rational(determinant_of(replaced) / d)) != 1) return false;
      }
      return true;
    };
    const int reach = static_cast<int>(sqrt(first));
    Integer shortest = first;
    for (int x = 0; x <= reach; ++x)
      for (int y = -reach; y <= reach; ++y)
        for (int z = -reach; z <= reach; ++z) {
          const LatticeVector v{x, y, z};
          const Integer length = squared_length(v);
          if (length > 0 && length < shortest && contains(v)) shortest = length;
        }
    ASSERT_LE(first, 4 * shortest);
    not_shortest += first > shortest ? 1 : 0;
  }
  // Mostly it is the shortest itself.
  EXPECT_LT(not_shortest, 50);
}

// All combinations of three vectors with small coefficients, one of each pair of opposite ones: (27 - 1) / 2.
TEST(LatticeTest, SmallCombinations) {
  const std::vector<LatticeVector> unit{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  std::set<LatticeVector> seen;
  for_small_combinations(unit, [&](const LatticeVector& v) {
    EXPECT_TRUE(seen.insert(v).second);
    const auto first = std::find_if(v.begin(), v.end(), [](const Integer& x) { return x != 0; });
    ASSERT_NE(first, v.end());
    EXPECT_EQ(*first, 1);
    for (const Integer& x : v) EXPECT_LE(abs(x), 1);
  });
  EXPECT_EQ(seen.size(), 13u);

  std::vector<LatticeVector> sums;
  for_small_combinations({{5, 7}, {100, -3}}, [&](const LatticeVector& v) { sums.push_back(v); });
  std::sort(sums.begin(), sums.end());
  EXPECT_EQ(sums, (std::vector<LatticeVector>{{-95, 10}, {5, 7}, {100, -3}, {105, 4}}));
}

}  // namespace
}  // namespace quoin::rounding::testing
