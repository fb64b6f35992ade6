/// \file
/// How a long operation runs: progress, cancelling, threads.
#pragma once

#include "quoin/export.h"

#include <atomic>
#include <functional>

#include "quoin/report.h"

namespace quoin {

/// Called with a fraction in [0, 1] from the thread that called the operation. It never decreases; of an operation that
/// succeeds, however little there was to do, it ends with exactly 1.
using Progress = std::function<void(double)>;
/// Set to true, from any thread or signal handler, to make the operation return the error "cancelled".
using Cancel = std::atomic<bool>;

struct Options {
  Progress progress = {};
  const Cancel* cancel = nullptr;
  /// Called in the calling thread with the name of each stage as it begins; for profiles.
  std::function<void(const char*)> stage = {};
  /// Worker threads; 0 takes what the machine has. Results are the same bytes for any number.
  unsigned threads = 0;
  /// What happens to operands that are not exact on their common grid.
  GridRule grid_rule = GridRule::common;
};

}  // namespace quoin
