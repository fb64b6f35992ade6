/// \file
/// How small the smallest detail of a mesh is.
#pragma once

#include "booleans/surface/triangulated.h"
#include "grid/grid.h"

namespace quoin::booleans {

/// The shortest edge or, where all are longer than `reach`, the least distance of two vertices at different places that
/// are nearer to each other than that; 0 without triangles. Model units, `reach` too; computed in doubles.
/// O(n) where few vertices are as near to each other as 8 times `reach`, else O(n log n) and what is within it.
double least_detail(const Body& body, const Triangulated& mesh, const grid::Lattice& lattice, double reach);

}  // namespace quoin::booleans
