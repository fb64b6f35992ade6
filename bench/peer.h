/// \file
/// What all programs that bench/compare runs have in common: they read the operands of a workload from a folder, go
/// from arrays to arrays, and print what it took as one line of JSON.
///
/// usage: PROGRAM FOLDER THREADS [ROUNDS]
/// FOLDER holds `operation` (the word of bench::name(Operation)), `step` and 0.off, 1.off, ..
#pragma once

#include <sys/resource.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "examples/mesh_file.h"

namespace quoin::bench {

struct Task {
  std::string operation, step;
  std::vector<Mesh> operands;
  unsigned threads = 1;
};

inline Task read_task(const std::string& folder, const char* threads) {
  Task task;
  task.threads = static_cast<unsigned>(std::strtoul(threads, nullptr, 10));
  std::ifstream(folder + "/operation") >> task.operation;
  std::ifstream(folder + "/step") >> task.step;
  for (std::size_t i = 0;; ++i) {
    const std::string path = folder + "/" + std::to_string(i) + ".off";
    if (!std::filesystem::exists(path)) return task;
    Result<Mesh> mesh = examples::read_mesh_file(path);
    if (!mesh) {
      std::fprintf(stderr, "%s: %s\n", path.c_str(), mesh.error().message.c_str());
      std::exit(1);
    }
    task.operands.push_back(std::move(mesh).value());
  }
}

inline double cpu_seconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

inline double wall_seconds() {
  timespec t{};
  clock_gettime(CLOCK_MONOTONIC, &t);
  return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

/// Six times the volume is summed in long double, from the first corner.
inline double volume(const Mesh& m) {
  long double sum = 0;
  const auto p = [&](std::size_t t, std::size_t i, std::size_t k) -> long double {
    return m.points[3 * std::size_t{m.triangles[t + i]} + k] - m.points[k];
  };
  for (std::size_t t = 0; t < m.triangles.size(); t += 3)
    for (std::size_t k = 0; k < 3; ++k)
      sum += p(t, 0, k) * (p(t, 1, (k + 1) % 3) * p(t, 2, (k + 2) % 3) - p(t, 1, (k + 2) % 3) * p(t, 2, (k + 1) % 3));
  return static_cast<double>(sum / 6);
}

/// A field of /proc/self/status, bytes.
inline long memory(const std::string& field) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (word == field + ":") {
      long kb = 0;
      status >> kb;
      return kb * 1024;
    }
  return 0;
}

/// For engines that combine two operands at a time: op(a, b, 'u' | 'i' | 'd') gives the result. Operations on many are
/// done in a balanced tree, which is what suits such engines best.
template <class Solid, class Op>
Solid combine_pairwise(const Task& task, std::vector<Solid>& solids, Op op) {
  const auto tree = [&](std::vector<Solid> level, char operation) {
    while (level.size() > 1) {
      std::vector<Solid> next;
      for (std::size_t i = 0; i + 1 < level.size(); i += 2) next.push_back(op(level[i], level[i + 1], operation));
      if (level.size() % 2 == 1) next.push_back(std::move(level.back()));
      level = std::move(next);
    }
    return std::move(level[0]);
  };
  if (task.operation == "union") return tree(std::move(solids), 'u');
  if (task.operation == "intersection") return tree(std::move(solids), 'i');
  if (task.operation == "difference") {
    Solid first = std::move(solids[0]);
    solids.erase(solids.begin());
    Solid rest = tree(std::move(solids), 'u');
    return op(first, rest, 'd');
  }
  if (task.operation == "parts") {
    std::vector<Solid> parts;
    for (std::size_t i = 0; i + 1 < solids.size(); i += 2) parts.push_back(op(solids[i], solids[i + 1], 'd'));
    return tree(std::move(parts), 'u');
  }
  if (task.operation == "nested") {
    Solid nested = std::move(solids.back());
    for (std::size_t i = solids.size() - 1; i-- > 0;) nested = op(solids[i], nested, 'd');
    return nested;
  }
  if (task.operation == "remainders") {
    std::vector<Solid> remainders;
    for (std::size_t i = 1; i < solids.size(); ++i) remainders.push_back(op(solids[0], solids[i], 'd'));
    return tree(std::move(remainders), 'u');
  }
  const bool unites = task.operation == "unions" || task.operation == "leaning";
  const bool alternates = task.operation == "alternating";
  Solid result = std::move(solids[0]);
  for (std::size_t i = 1; i < solids.size(); ++i)
    result = op(result, solids[i], unites || (alternates && i % 2 == 1) ? 'u' : 'd');
  return result;
}

/// CPU seconds of import, operation and export, summed over the rounds.
struct Spent {
  double import = 0, boolean = 0, output = 0;
};

/// One round, from arrays to arrays.
template <class Import, class Combine, class ToMesh>
Mesh run_round(const Task& task, Import& import, Combine& combine, ToMesh& to_mesh, Spent& spent) {
  const double t0 = cpu_seconds();
  auto solids = import(task);
  const double t1 = cpu_seconds();
  auto result = combine(task, solids);
  const double t2 = cpu_seconds();
  Mesh mesh = to_mesh(result);
  const double t3 = cpu_seconds();

  spent.import += t1 - t0;
  spent.boolean += t2 - t1;
  spent.output += t3 - t2;
  return mesh;
}

/// Solids solids = import(task); Solid result = combine(task, solids); Mesh mesh = to_mesh(result).
/// Prints seconds a round; a warm-up is not counted where there is more than one round.
template <class Import, class Combine, class ToMesh>
int run_peer(int argc, char** argv, Import import, Combine combine, ToMesh to_mesh) {
  if (argc != 3 && argc != 4) {
    std::fprintf(stderr, "usage: %s FOLDER THREADS [ROUNDS]\n", argv[0]);
    return 2;
  }
  const Task task = read_task(argv[1], argv[2]);
  const unsigned long rounds = argc == 4 ? std::strtoul(argv[3], nullptr, 10) : 1;
  std::ofstream("/proc/self/clear_refs") << 5;  // the peak begins here
  const long before = memory("VmRSS");
  const double wall = wall_seconds();

  Spent spent;
  Mesh mesh = run_round(task, import, combine, to_mesh, spent);
  if (rounds > 1) spent = {};
  for (unsigned long i = 1; i < rounds; ++i) mesh = run_round(task, import, combine, to_mesh, spent);

  const double counted = rounds > 1 ? double(rounds - 1) : 1, wall_end = wall_seconds();
  const double total = spent.import + spent.boolean + spent.output;
  const auto output = static_cast<long>(8 * mesh.points.size() + 4 * mesh.triangles.size());
  std::printf(
      "{\"import\": %.9f, \"boolean\": %.9f, \"export\": %.9f, \"total\": %.9f, \"wall\": %.6f, \"extra_bytes\": %ld, "
      "\"vertices\": %zu, \"triangles\": %zu, \"volume\": %.12g}\n",
      spent.import / counted, spent.boolean / counted, spent.output / counted, total / counted,
      (wall_end - wall) / double(rounds), memory("VmHWM") - before - output, mesh.points.size() / 3,
      mesh.triangles.size() / 3, volume(mesh));
  return 0;
}

}  // namespace quoin::bench
