/// Runs Quoin on a workload's folder; see bench/peer.h. QUOIN_TRUST=1 skips the proof that operands do not cross
/// themselves, which the peers do not make either.
#include <cstdlib>

#include "bench/combine.h"
#include "bench/peer.h"

using namespace quoin;
using bench::must;

int main(int argc, char** argv) {
  ExportOptions output;
  return bench::run_peer(
      argc, argv,
      [&](const bench::Task& task) {
        output.run.threads = task.threads;
        ImportOptions options;
        options.grid = must(Grid::with_step(task.step));
        options.run.threads = task.threads;
        if (std::getenv("QUOIN_TRUST")) options.trust = Trust::embedded;
        std::vector<Solid> solids;
        for (const Mesh& m : task.operands)
          solids.push_back(must(Solid::from_triangles(m.points, m.triangles, options)));
        return solids;
      },
      [](const bench::Task& task, const std::vector<Solid>& solids) {
        Options options;
        options.threads = task.threads;
        return bench::combine(task.operation, solids, [&](const Expression& e) { return must(evaluate(e, options)); });
      },
      [&](const Solid& solid) { return must(solid.to_triangles(output)); });
}
