/// Runs Quoin on a workload's folder; see bench/peer.h. QUOIN_TRUST=1 skips the proof that operands do not cross
/// themselves, which the peers do not make either.
#include <cstdlib>

#include "bench/peer.h"

namespace {

using namespace quoin;

template <class T>
T must(Result<T> result) {
  if (result) return std::move(result).value();
  std::fprintf(stderr, "%s: %s\n", result.error().code.c_str(), result.error().message.c_str());
  std::exit(1);
}

Solid combine(const bench::Task& task, const std::vector<Solid>& s) {
  Options options;
  options.threads = task.threads;
  const std::vector<Expression> all(s.begin(), s.end()), rest(s.begin() + 1, s.end());
  if (task.operation == "union") return must(evaluate(Expression::union_of(all), options));
  if (task.operation == "intersection") return must(evaluate(Expression::intersection_of(all), options));
  if (task.operation == "difference") return must(evaluate(all[0] - Expression::union_of(rest), options));
  Solid result = s[0];
  for (const Expression& next : rest)
    result = must(evaluate(task.operation == "unions" ? result + next : result - next, options));
  return result;
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_peer(
      argc, argv,
      [](const bench::Task& task) {
        ImportOptions options;
        options.grid = must(Grid::with_step(task.step));
        options.run.threads = task.threads;
        if (std::getenv("QUOIN_TRUST")) options.trust = Trust::embedded;
        std::vector<Solid> solids;
        for (const Mesh& m : task.operands)
          solids.push_back(must(Solid::from_triangles(m.points, m.triangles, options)));
        return solids;
      },
      combine, [](const Solid& solid) { return must(solid.to_triangles({})); });
}
