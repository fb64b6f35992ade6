/// \file
/// Short vectors of integer lattices.
///
/// Source: A. K. Lenstra, H. W. Lenstra, L. Lovasz, Factoring polynomials with rational coefficients (1982); in
/// integers alone as H. Cohen, A Course in Computational Algebraic Number Theory (1993), algorithm 2.6.7.
#pragma once

#include <algorithm>
#include <vector>

#include "exact/rational.h"

namespace quoin::rounding {

using LatticeVector = std::vector<exact::Integer>;

/// Makes the basis of a lattice LLL-reduced (delta = 3/4): the same lattice, its vectors short and nearly orthogonal.
/// `companions`, one a vector, undergo the same combinations: they tell what a short vector stands for.
/// Precondition: the vectors are linearly independent.
void reduce_basis(std::vector<LatticeVector>& basis, std::vector<LatticeVector>& companions);

/// visit(v) for all combinations v of the vectors with coefficients -1, 0 and 1 of which the first non-zero one is 1:
/// of a reduced basis these are short. Precondition: there is a vector.
template <class Visit>
void for_small_combinations(const std::vector<LatticeVector>& vectors, Visit&& visit) {
  std::vector<int> c(vectors.size(), -1);
  for (;;) {
    const auto first = std::find_if(c.begin(), c.end(), [](int v) { return v != 0; });
    if (first != c.end() && *first == 1) {
      LatticeVector sum(vectors.front().size());
      for (std::size_t i = 0; i < c.size(); ++i)
        for (std::size_t j = 0; j < sum.size() && c[i] != 0; ++j) sum[j] += c[i] * vectors[i][j];
      visit(sum);
    }

    std::size_t i = 0;
    while (i < c.size() && c[i] == 1) c[i++] = -1;
    if (i == c.size()) return;
    ++c[i];
  }
}

}  // namespace quoin::rounding
