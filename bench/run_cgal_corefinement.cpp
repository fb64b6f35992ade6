/// Runs CGAL's corefinement on a workload's folder; see bench/peer.h. KERNEL is one of CGAL's: inexact or exact
/// constructions, both with exact predicates.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>

#include "bench/cgal_surface.h"
#include "bench/peer.h"

namespace {

using namespace quoin;
using Kernel = CGAL::KERNEL;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
namespace pmp = CGAL::Polygon_mesh_processing;

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
        for (const Mesh& m : task.operands) all.push_back(bench::surface<Kernel>(m));
        return all;
      },
      [](const bench::Task& task, std::vector<Surface>& all) { return bench::combine_pairwise(task, all, combined); },
      [](Surface& s) {
        s.collect_garbage();
        return bench::mesh_of(s);
      });
}
