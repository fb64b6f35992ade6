/// \file
/// Proof that rounded triangles bound what the exact ones do.
#pragma once

#include <vector>

#include "booleans/surface/rounded.h"

namespace quoin::booleans {

/// Whether a triangulated clean body, its points rounded and read as exact numbers, is a valid boundary: triangles meet
/// in common corners and edges only, none is flipped or has no area, and the winding number is 1 just inside each and 0
/// just outside. Exact: false exactly where something is wrong, or where vertices of different places coincide or
/// touch. `points` and `moves`: what rounding made of it (rounded.h). What did not move is taken to be as clean as the
/// body.
///
/// Method: let all vertices move straight to their rounded places. Two triangles that never meet out of place on the
/// way are as good after it as before. For those of one star that is mostly seen at once (`steady_stars`), for most
/// others by a plane that parts them all the time: signs of determinants that have no zero while each coordinate is
/// within its rounding error. The few other pairs are examined where they ended, in rationals; and since they may have
/// passed through each other, a ray from each component that one of them belongs to finds the winding number outside
/// it. Components are joined by edges of two triangles: where nothing crosses, the number is the same all along one.
bool is_valid(const Body& body, const Triangulated& mesh, Floats floats, const grid::Lattice& lattice,
              const std::vector<double>& points, const Moves& moves);

}  // namespace quoin::booleans
