/// \file
/// What labels and channels cost: the same operations on solids without them, with a label for each triangle (one of
/// eight), and with two channels as well, in turn: the table of docs/benchmarks.md.
///
/// usage: quoin-labels [TRIANGLES [ROUNDS]] (100000, 5)
/// Entries are CPU seconds of one thread, the least of all rounds, and those of the others over the plain ones.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "examples/models.h"
#include "quoin/quoin.h"

namespace {

using namespace quoin;

enum Way { plain, with_labels, with_channels, way_count };
enum Stage { import, boolean, export_, stage_count };
constexpr const char* stage_names[] = {"import", "Boolean", "export"};

struct Workload {
  const char* name;
  std::vector<Mesh> meshes;
  bool is_union;
  bool is_chain;
};

/// By way and stage.
struct Times {
  double seconds[way_count][stage_count] = {};
};

double now() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

Grid grid_of(const std::vector<Mesh>& meshes) {
  std::array<double, 3> low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
  for (const Mesh& m : meshes)
    for (std::size_t i = 0; i < m.points.size(); ++i) {
      low[i % 3] = std::min(low[i % 3], m.points[i]);
      high[i % 3] = std::max(high[i % 3], m.points[i]);
    }
  return Grid::fitting(low, high).value();
}

/// What is given with a mesh.
struct Given {
  std::vector<std::uint32_t> labels;
  std::vector<double> channels;
};

Given given(const Mesh& mesh, Way way) {
  Given g;
  for (std::size_t t = 0; way != plain && t < mesh.triangles.size() / 3; ++t)
    g.labels.push_back(static_cast<std::uint32_t>(t / 2 % 8));
  if (way == with_channels)
    for (const std::uint32_t v : mesh.triangles)
      for (std::size_t k = 0; k < 2; ++k) g.channels.push_back(mesh.points[3 * v + k]);
  return g;
}

std::vector<Solid> imported(const Workload& w, const Grid& grid, const std::vector<Given>& all) {
  std::vector<Solid> solids;
  for (std::size_t i = 0; i < w.meshes.size(); ++i) {
    ImportOptions options;
    options.grid = grid;
    options.run.threads = 1;
    options.labels = all[i].labels;
    options.channels = all[i].channels;
    if (!all[i].labels.empty()) options.id = static_cast<std::uint32_t>(i + 1);
    solids.push_back(Solid::from_triangles(w.meshes[i].points, w.meshes[i].triangles, options).value());
  }
  return solids;
}

Solid combined(const Workload& w, const std::vector<Solid>& solids) {
  if (w.is_union) return unite(solids, {.threads = 1}).value();
  if (!w.is_chain) return difference(solids[0], {solids.begin() + 1, solids.end()}, {.threads = 1}).value();
  Solid result = solids[0];
  for (std::size_t i = 1; i < solids.size(); ++i) result = difference(result, {solids[i]}, {.threads = 1}).value();
  return result;
}

void run(const Workload& w, const Grid& grid, Way way, double* seconds) {
  std::vector<Given> all;
  for (const Mesh& mesh : w.meshes) all.push_back(given(mesh, way));

  const double start = now();
  const std::vector<Solid> solids = imported(w, grid, all);
  const double began = now();
  const Solid result = combined(w, solids);
  const double made = now();
  ExportOptions options;
  options.run.threads = 1;
  if (way == plain)
    static_cast<void>(result.to_triangles(options).value());
  else
    static_cast<void>(to_labelled_triangles(result, options).value());
  const double end = now();

  const double taken[stage_count] = {began - start, made - began, end - made};
  for (int s = 0; s < stage_count; ++s) seconds[s] = seconds[s] == 0 ? taken[s] : std::min(seconds[s], taken[s]);
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t size = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 100000;
  const int rounds = argc > 2 ? std::atoi(argv[2]) : 5;
  std::vector<Workload> workloads;
  workloads.push_back(
      {"two spheres", {examples::sphere({0, 0, 0}, 1, size), examples::sphere({0.5, 0.3, 0.2}, 1, size)}, true, false});
  workloads.push_back(
      {"two bumpy spheres",
       {examples::bumpy_sphere({0, 0, 0}, 1, size, 1), examples::bumpy_sphere({.3, .2, .1}, 1, size, 2)},
       true,
       false});
  workloads.push_back({"1,728 cubes that overlap", examples::cube_grid(12, 0.9), true, false});
  std::vector<Mesh> plate{examples::box({-1, -1, 0}, {33, 9, 1})};
  for (const Mesh& drill : examples::drills(32, 8, 16)) plate.push_back(drill);
  workloads.push_back({"256 holes, one by one", std::move(plate), false, true});

  for (const Workload& w : workloads) {
    const Grid grid = grid_of(w.meshes);
    Times times;
    for (int round = 0; round < rounds; ++round)
      for (int way = 0; way < way_count; ++way) run(w, grid, static_cast<Way>(way), times.seconds[way]);
    for (int s = 0; s < stage_count; ++s)
      std::printf("| %s | %s | %.4f | %.2f | %.2f |\n", w.name, stage_names[s], times.seconds[plain][s],
                  times.seconds[with_labels][s] / times.seconds[plain][s],
                  times.seconds[with_channels][s] / times.seconds[plain][s]);
  }
}
