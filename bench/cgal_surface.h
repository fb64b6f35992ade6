/// \file
/// Triangle meshes as CGAL's surfaces, and back.
#pragma once

#include <CGAL/Surface_mesh.h>

#include <vector>

#include "quoin/quoin.h"

namespace quoin::bench {

template <class Kernel>
CGAL::Surface_mesh<typename Kernel::Point_3> surface(const Mesh& mesh) {
  using Surface = CGAL::Surface_mesh<typename Kernel::Point_3>;
  Surface s;
  std::vector<typename Surface::Vertex_index> v;
  for (std::size_t i = 0; i < mesh.points.size(); i += 3)
    v.push_back(s.add_vertex(typename Kernel::Point_3(mesh.points[i], mesh.points[i + 1], mesh.points[i + 2])));
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3)
    s.add_face(v[mesh.triangles[t]], v[mesh.triangles[t + 1]], v[mesh.triangles[t + 2]]);
  return s;
}

/// Preconditions: all faces are triangles, and nothing that was removed is left in the lists.
template <class Surface>
Mesh mesh_of(const Surface& s) {
  Mesh mesh;
  for (const auto v : s.vertices())
    for (int k = 0; k < 3; ++k) mesh.points.push_back(CGAL::to_double(s.point(v)[k]));
  for (const auto f : s.faces())
    for (const auto v : s.vertices_around_face(s.halfedge(f))) mesh.triangles.push_back(v);
  return mesh;
}

}  // namespace quoin::bench
