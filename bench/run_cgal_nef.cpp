/// Runs CGAL's Nef polyhedra on a workload's folder; see bench/peer.h.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/convert_nef_polyhedron_to_polygon_mesh.h>

#include "bench/peer.h"

namespace {

using namespace quoin;
using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Nef = CGAL::Nef_polyhedron_3<Kernel>;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

Nef nef(const Mesh& mesh) {
  Surface s;
  std::vector<Surface::Vertex_index> v;
  for (std::size_t i = 0; i < mesh.points.size(); i += 3)
    v.push_back(s.add_vertex(Kernel::Point_3(mesh.points[i], mesh.points[i + 1], mesh.points[i + 2])));
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3)
    s.add_face(v[mesh.triangles[t]], v[mesh.triangles[t + 1]], v[mesh.triangles[t + 2]]);
  return Nef(s);
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_peer(
      argc, argv,
      [](const bench::Task& task) {
        std::vector<Nef> all;
        for (const Mesh& m : task.operands) all.push_back(nef(m));
        return all;
      },
      [](const bench::Task& task, std::vector<Nef>& all) {
        return bench::combine_pairwise(task, all, [](Nef& a, Nef& b, char operation) {
          return operation == 'u' ? a + b : operation == 'i' ? a * b : a - b;
        });
      },
      [](const Nef& n) {
        Surface s;
        CGAL::convert_nef_polyhedron_to_polygon_mesh(n, s, true);
        Mesh mesh;
        for (const auto v : s.vertices())
          for (int k = 0; k < 3; ++k) mesh.points.push_back(CGAL::to_double(s.point(v)[k]));
        for (const auto f : s.faces())
          for (const auto v : s.vertices_around_face(s.halfedge(f))) mesh.triangles.push_back(v);
        return mesh;
      });
}
