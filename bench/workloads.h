/// \file
/// The workloads of docs/benchmarks.md: operands, the operation on them, and the grid that Quoin puts them on.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "quoin/quoin.h"

namespace quoin::bench {

enum class Operation {
  unite,              // all operands in one union
  intersect,          // all operands in one intersection
  subtract,           // the first without all others, in one operation
  unite_each,         // one union after the other, each result an operand of the next
  subtract_each,      // one difference after the other
  unite_differences,  // the union of each operand without the one after it
  subtract_nested,    // the first without (the second without (the third ..))
  unite_leaning,      // ((the first u the second) u the third) u .., in one operation
  alternate,          // ((the first u the second) without the third) u .., in one operation
  unite_remainders,   // the union of the first without each of the others
};

/// "union", "intersection", "difference", "unions", "differences", "parts", "nested", "leaning", "alternating",
/// "remainders".
const char* name(Operation operation);

struct Workload {
  std::string name;
  /// What the size counts.
  std::string unit;
  std::size_t default_size;
  Operation operation;
  /// The step of the grid, model units.
  std::string step;
  std::vector<Mesh> (*operands)(std::size_t size);
  /// Makes the result of a workload without operands; null for others.
  Solid (*made)(std::size_t size, const Grid& grid, const Options& run) = nullptr;
};

const std::vector<Workload>& workloads();

/// Null for an unknown name.
const Workload* find_workload(const std::string& name);

}  // namespace quoin::bench
