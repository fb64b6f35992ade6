#include "rounding/numbers/lattice.h"

#include <cassert>
#include <utility>

namespace quoin::rounding {

using exact::Integer;

namespace {

Integer inner_product(const LatticeVector& a, const LatticeVector& b) {
  Integer sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

/// n / d rounded to an integer, halves upward. Precondition: d > 0.
Integer rounded(const Integer& n, const Integer& d) {
  Integer q;
  const Integer twice_d = d * 2, shifted = n * 2 + d;
  mpz_fdiv_q(q.backend().data(), shifted.backend().data(), twice_d.backend().data());
  return q;
}

/// d[i] are the Gram determinants of the first i vectors, lambda[i][j] = d[j + 1] mu[i][j]: all integers.
class Reducer {
 public:
  Reducer(std::vector<LatticeVector>& basis, std::vector<LatticeVector>& companions)
      : b_(basis), companions_(companions), d_(basis.size() + 1), lambda_(basis.size(), LatticeVector(basis.size())) {}

  void run() {
    const std::size_t n = b_.size();
    d_[0] = 1;
    for (std::size_t k = 0; k < n; ++k) orthogonalize(k);

    for (std::size_t k = 1; k < n;) {
      reduce(k, k - 1);
      // Lovasz: d[k+1] d[k-1] < 3/4 d[k]^2 - lambda^2
      if (4 * (d_[k + 1] * d_[k - 1] + lambda_[k][k - 1] * lambda_[k][k - 1]) < 3 * d_[k] * d_[k]) {
        exchange(k);
        if (k > 1) --k;
      } else {
        for (std::size_t l = k - 1; l-- > 0;) reduce(k, l);
        ++k;
      }
    }
  }

 private:
  void orthogonalize(std::size_t k) {
    for (std::size_t j = 0; j <= k; ++j) {
      Integer u = inner_product(b_[k], b_[j]);
      for (std::size_t i = 0; i < j; ++i) u = (d_[i + 1] * u - lambda_[k][i] * lambda_[j][i]) / d_[i];
      if (j < k)
        lambda_[k][j] = u;
      else
        d_[k + 1] = u;
    }
    assert(d_[k + 1] > 0);
  }

  void reduce(std::size_t k, std::size_t l) {
    const Integer q = rounded(lambda_[k][l], d_[l + 1]);
    if (q == 0) return;
    for (auto* rows : {&b_, &companions_})
      for (std::size_t i = 0; i < (*rows)[k].size(); ++i) (*rows)[k][i] -= q * (*rows)[l][i];
    lambda_[k][l] -= q * d_[l + 1];
    for (std::size_t i = 0; i < l; ++i) lambda_[k][i] -= q * lambda_[l][i];
  }

  void exchange(std::size_t k) {
    std::swap(b_[k], b_[k - 1]);
    std::swap(companions_[k], companions_[k - 1]);
    for (std::size_t j = 0; j + 1 < k; ++j) std::swap(lambda_[k][j], lambda_[k - 1][j]);

    const Integer l = lambda_[k][k - 1];
    const Integer next = (d_[k - 1] * d_[k + 1] + l * l) / d_[k];
    for (std::size_t i = k + 1; i < b_.size(); ++i) {
      const Integer t = lambda_[i][k];
      lambda_[i][k] = (d_[k + 1] * lambda_[i][k - 1] - l * t) / d_[k];
      lambda_[i][k - 1] = (next * t + l * lambda_[i][k]) / d_[k + 1];
    }
    d_[k] = next;
  }

  std::vector<LatticeVector>&b_, &companions_;
  LatticeVector d_;
  std::vector<LatticeVector> lambda_;
};

}  // namespace

void reduce_basis(std::vector<LatticeVector>& basis, std::vector<LatticeVector>& companions) {
  assert(companions.size() == basis.size());
  if (!basis.empty()) Reducer(basis, companions).run();
}

}  // namespace quoin::rounding
