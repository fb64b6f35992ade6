/// Runs CGAL's corefinement on a workload's folder; see bench/peer.h. KERNEL is one of CGAL's: inexact or exact
/// constructions, both with exact predicates.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>

#include "bench/peer.h"

namespace {

using namespace quoin;
using Kernel = CGAL::KERNEL;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
namespace pmp = CGAL::Polygon_mesh_processing;

Surface surface(const Mesh& mesh) {
  Surface s;
  std::vector<Surface::Vertex_index> v;
  for (std::size_t i = 0; i < mesh.points.size(); i += 3)
    v.push_back(s.add_vertex(Kernel::Point_3(mesh.points[i], mesh.points[i + 1], mesh.points[i + 2])));
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3)
    s.add_face(v[mesh.triangles[t]], v[mesh.triangles[t + 1]], v[mesh.triangles[t + 2]]);
  return s;
}

Surface combined(Surface& a, Surface& b, char operation) {
  Surface out;
  const bool valid = operation == 'u'   ? pmp::corefine_and_compute_union(a, b, out)
                     : operation == 'i' ? pmp::corefine_and_compute_intersection(a, b, out)
                                        : pmp::corefine_and_compute_difference(a, b, out);
  if (!valid) {
    std::fprintf(stderr, "the result is not manifold\n");
    std::exit(1);
  }
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_peer(
      argc, argv,
      [](const bench::Task& task) {
        std::vector<Surface> all;
        for (const Mesh& m : task.operands) all.push_back(surface(m));
        return all;
      },
      [](const bench::Task& task, std::vector<Surface>& all) { return bench::combine_pairwise(task, all, combined); },
      [](Surface& s) {
        s.collect_garbage();
        Mesh mesh;
        for (const auto v : s.vertices())
          for (int k = 0; k < 3; ++k) mesh.points.push_back(CGAL::to_double(s.point(v)[k]));
        for (const auto f : s.faces())
          for (const auto v : s.vertices_around_face(s.halfedge(f))) mesh.triangles.push_back(v);
        return mesh;
      });
}
