/// Runs CGAL's Nef polyhedra on a workload's folder; see bench/peer.h.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/boost/graph/convert_nef_polyhedron_to_polygon_mesh.h>

#include "bench/cgal_surface.h"
#include "bench/peer.h"

namespace {

using namespace quoin;
using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Nef = CGAL::Nef_polyhedron_3<Kernel>;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

}  // namespace

int main(int argc, char** argv) {
  return bench::run_peer(
      argc, argv,
      [](const bench::Task& task) {
        std::vector<Nef> all;
        for (const Mesh& m : task.operands) {
          auto surface = bench::surface<Kernel>(m);
          all.emplace_back(surface);
        }
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
        return bench::mesh_of(s);
      });
}
