/// \file
/// What is counted of a triangulated boundary.
#pragma once

#include "booleans/surface/triangulated.h"
#include "quoin/quoin.h"

namespace quoin {

/// Of the boundary of a body; touching parts are separated first.
SurfaceCounts surface_counts(const booleans::Body& body, booleans::Triangulated mesh);
/// Of a mesh that is separated already, and had so many vertices before.
SurfaceCounts surface_counts(const booleans::Triangulated& separated_mesh, std::size_t vertices_before);

}  // namespace quoin
