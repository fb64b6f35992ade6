/// \file
/// Touching parts taken apart.
#pragma once

#include "booleans/surface/triangulated.h"

namespace quoin::booleans {

/// A triangulated boundary with touching parts separated combinatorially, as if the interior shrank a little from the
/// edges where it touches itself: at an edge of 2k triangles those that bound one wedge of the solid are glued in
/// pairs, and a vertex is split into the fans of triangles that hang together over glued edges. No point moves.
///
/// Law 1: two output vertices name one edge, of two triangles (the mesh of a clean body).
/// Law 2: components and their genera are those of the point set, however it is stored and triangulated.
/// Law 3: where nothing touches, the mesh stays as it is; else there are more vertices than before.
///
/// Glued edges may have the same two vertices: the solid touches itself along an edge and its interior hangs together
/// around both ends. Law 2 leaves no choice of these vertices, so indices alone cannot name such edges apart. Each edge
/// of the body where that happens is split, for all its triangles: it gets a vertex inside, one copy a pair (`added`,
/// `split_edges`), exactly on it. Between grid points this is one of them if the edge meets any inside, else so near to
/// an end that this is the nearest one: what has grid points only is the same solid when it is read back on its grid.
///
/// That suffices. Output edges with the same vertices lie over one edge of the unseparated mesh, as all points of a
/// body differ. Halves of split edges end in different copies. A new edge from a copy to the third corner of a triangle
/// lies in that triangle, and the two triangles of a pair have different third corners.
///
/// SharedEdges::kept: such edges stay as they are, and are counted (`shared_edges`): law 1 does not hold at them. For
/// numbers so coarse that the vertex inside does not fit.
enum class SharedEdges { split, kept };
Triangulated separated(const Body& body, Triangulated mesh, SharedEdges shared = SharedEdges::split);

}  // namespace quoin::booleans
