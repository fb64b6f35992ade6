#include "api/doors/surface.h"

#include "booleans/surface/separated.h"
#include "booleans/surface/shells.h"

namespace quoin {

SurfaceCounts surface_counts(const booleans::Body& body, booleans::Triangulated mesh) {
  const std::size_t vertices = mesh.vertex_count();
  return surface_counts(booleans::separated(body, std::move(mesh)), vertices);
}

SurfaceCounts surface_counts(const booleans::Triangulated& separated_mesh, std::size_t vertices_before) {
  const booleans::Shells shells = booleans::shells(separated_mesh);
  return {.triangles = separated_mesh.triangle_count(),
          .shells = shells.count,
          .genus = shells.genus,
          .manifold = separated_mesh.vertex_count() == vertices_before};
}

}  // namespace quoin
