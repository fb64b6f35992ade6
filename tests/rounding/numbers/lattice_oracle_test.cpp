// Lattice reduction against FLINT: its Hermite normal form tells lattices apart, its own judge of reduced bases, and
// its own reduction. Apart from lattice_test.cpp, since FLINT's headers define short macros.
#include <flint/fmpz_lll.h>
#include <flint/fmpz_mat.h>
#include <gtest/gtest.h>

#include <vector>

#include "rounding/numbers/lattice.h"
#include "tests/rounding/support.h"

namespace quoin::rounding::testing {
namespace {

using Rows = std::vector<LatticeVector>;

class FlintMatrix {
 public:
  explicit FlintMatrix(const Rows& rows) {
    fmpz_mat_init(m_, static_cast<slong>(rows.size()), static_cast<slong>(rows[0].size()));
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (std::size_t j = 0; j < rows[i].size(); ++j)
        fmpz_set_mpz(fmpz_mat_entry(m_, static_cast<slong>(i), static_cast<slong>(j)), rows[i][j].backend().data());
  }
  ~FlintMatrix() { fmpz_mat_clear(m_); }
  FlintMatrix(const FlintMatrix&) = delete;
  FlintMatrix& operator=(const FlintMatrix&) = delete;
  fmpz_mat_struct* get() { return m_; }

  Integer squared_length(std::size_t row) const {
    Integer sum = 0;
    for (slong j = 0; j < fmpz_mat_ncols(m_); ++j) {
      Integer x;
      fmpz_get_mpz(x.backend().data(), fmpz_mat_entry(m_, static_cast<slong>(row), j));
      sum += x * x;
    }
    return sum;
  }

 private:
  fmpz_mat_t m_;
};

bool same_lattice(const Rows& a, const Rows& b) {
  FlintMatrix p(a), q(b), hp(a), hq(b);
  fmpz_mat_hnf(hp.get(), p.get());
  fmpz_mat_hnf(hq.get(), q.get());
  return fmpz_mat_equal(hp.get(), hq.get()) != 0;
}

/// Reduces by both; the bases with which plane rounding comes, and others.
void compare(const Rows& basis) {
  FlintMatrix given(basis);
  if (fmpz_mat_rank(given.get()) < static_cast<slong>(basis.size())) return;
  Rows reduced = basis, companions(basis.size(), LatticeVector(1));
  reduce_basis(reduced, companions);
  EXPECT_TRUE(same_lattice(basis, reduced));
  FlintMatrix ours(reduced);
  EXPECT_NE(fmpz_mat_is_reduced(ours.get(), 0.75, 0.5), 0);
  // Both are reduced, so that each first vector is at most 2^((n - 1) / 2) times the shortest, thus the other.
  fmpz_lll_t context;
  fmpz_lll_context_init(context, 0.99, 0.51, Z_BASIS, EXACT);
  fmpz_lll(given.get(), nullptr, context);
  const Integer a = ours.squared_length(0), b = given.squared_length(0);
  const Integer factor = power_of_2(static_cast<unsigned>(basis.size()) - 1);
  EXPECT_LE(a, factor * b);
  EXPECT_LE(b, factor * a);
}

TEST(LatticeOracleTest, Judges) {
  EXPECT_TRUE(same_lattice({{1, 0}, {0, 1}}, {{1, 1000}, {0, 1}}));
  EXPECT_FALSE(same_lattice({{1, 0}, {0, 1}}, {{2, 0}, {0, 1}}));
  FlintMatrix skew({{1, 1000}, {0, 1}});
  EXPECT_EQ(fmpz_mat_is_reduced(skew.get(), 0.75, 0.5), 0);
}

TEST(LatticeOracleTest, RandomBases) {
  std::mt19937_64 random = generator(330);
  for (int i = 0; i < 500; ++i) {
    const std::size_t n = 2 + below(random, 5), columns = n + below(random, 3);
    const auto bits = static_cast<unsigned>(between(random, 2, 200));
    Rows basis(n, LatticeVector(columns));
    for (LatticeVector& v : basis)
      for (Integer& x : v) x = biased_integer(random, bits);
    compare(basis);
  }
}

// As for directions (three dimensions) and for faces (four), with numbers of rounding to 2^62.
TEST(LatticeOracleTest, BasesOfPlaneRounding) {
  std::mt19937_64 random = generator(331);
  for (int i = 0; i < 300; ++i) {
    const Integer one = power_of_2(140);
    const auto number = [&] { return biased_integer(random, 140); };
    compare(
        {{power_of_2(static_cast<unsigned>(between(random, 20, 120))), number(), number()}, {0, one, 0}, {0, 0, one}});
    const Integer far = power_of_2(250), weight = power_of_2(static_cast<unsigned>(between(random, 100, 200)));
    const auto coordinate = [&] { return Integer(biased_integer(random, 28) * far); };
    Rows planes;
    for (int k = 0; k < 3; ++k)
      planes.push_back({coordinate(), coordinate(), coordinate(), weight * biased_integer(random, 60)});
    planes.push_back({far, far, far, 0});
    compare(planes);
  }
}

}  // namespace
}  // namespace quoin::rounding::testing
