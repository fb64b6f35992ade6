/// \file
/// Shapes on which work tends to grow faster than what comes out of it: everything meets in one point or along one
/// edge, all boxes overlap, all surfaces coincide, expressions are deep or have a solid in all terms, planes surround a
/// sphere. The output of each is linear in its size.
#pragma once

#include <cstddef>
#include <vector>

#include "quoin/quoin.h"

namespace quoin::bench {

/// n thin pyramids that meet in their common apex only.
std::vector<Mesh> pyramids_with_one_apex(std::size_t n);

/// Two cones of n sides that cross; they have one apex, or one is moved sideways.
std::vector<Mesh> cones_with_one_apex(std::size_t n);
std::vector<Mesh> crossing_cones(std::size_t n);

/// n wedges that meet along their common edge only.
std::vector<Mesh> wedges_at_one_edge(std::size_t n);

/// Two layers, each of n thin tetrahedra side by side in one mesh; the boxes of nearly all pairs meet, their tetrahedra
/// do not.
std::vector<Mesh> slivers(std::size_t n);

/// Two prisms of n sides whose caps, fans from one corner of the rim, lie in the same planes.
std::vector<Mesh> prism_caps(std::size_t n);

/// n solids of 80 triangles in one place.
std::vector<Mesh> stacked_duplicates(std::size_t n);

/// Two prisms over stars of n tips, each tip of one between two of the other.
std::vector<Mesh> star_polygons(std::size_t n);

/// n boxes, each inside the one before it.
std::vector<Mesh> nested_boxes(std::size_t n);

/// n boxes, each of which overlaps its neighbours only.
std::vector<Mesh> boxes_in_a_row(std::size_t n);

/// A sphere of 1,280 triangles, then n of 20 on its surface, apart.
std::vector<Mesh> sphere_and_spheres(std::size_t n);

/// Meshes of many shells: a tetrahedron n times in one place; n needles through one point; n bars across n others,
/// which meet in n^2 places.
Solid mesh_of_duplicates(std::size_t n, const Grid& grid, const Options& run);
Solid mesh_of_needles(std::size_t n, const Grid& grid, const Options& run);
Solid mesh_of_bars(std::size_t n, const Grid& grid, const Options& run);

/// A model: a star of n corners, swept along z.
Solid swept_star(std::size_t n, const Grid& grid, const Options& run);

/// ((A - B) u A) - B ..: n terms that name two boxes.
Solid two_solids_in_turn(std::size_t n, const Grid& grid, const Options& run);

/// What n half-spaces whose planes touch a sphere have in common: n faces, 2 n - 4 vertices. Precondition: n is large
/// enough for it to be within twice the sphere.
Solid common_of_half_spaces(std::size_t n, const Grid& grid, const Options& run);

/// The convex hull of n points of a sphere.
Solid hull_of_points(std::size_t n, const Grid& grid, const Options& run);

}  // namespace quoin::bench
