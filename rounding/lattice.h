/// \file
/// Short vectors of integer lattices.
///
/// Source: A. K. Lenstra, H. W. Lenstra, L. Lovasz, Factoring polynomials with rational coefficients (1982); in
/// integers alone as H. Cohen, A Course in Computational Algebraic Number Theory (1993), algorithm 2.6.7.
#pragma once

#include <vector>

#include "exact/rational.h"

namespace quoin::rounding {

using LatticeVector = std::vector<exact::Integer>;

/// Makes the basis of a lattice LLL-reduced (delta = 3/4): the same lattice, its vectors short and nearly orthogonal.
/// `companions`, one a vector, undergo the same combinations: they tell what a short vector stands for.
/// Precondition: the vectors are linearly independent.
void reduce_basis(std::vector<LatticeVector>& basis, std::vector<LatticeVector>& companions);

}  // namespace quoin::rounding
