/// \file
/// Public options as the engine takes them.
#pragma once

#include <tbb/task_arena.h>

#include <algorithm>
#include <utility>

#include "booleans/boolean.h"
#include "quoin/quoin.h"

namespace quoin {

inline booleans::Run run_of(const Options& options) { return {options.progress, options.cancel}; }

/// Runs `work` in the calling thread with so many workers, 0 for all, and returns its value.
template <class Work>
auto with_threads(unsigned threads, Work&& work) {
  if (threads == 0) return work();
  constexpr unsigned most = 4096;
  tbb::task_arena arena(static_cast<int>(std::min(threads, most)));
  return arena.execute(std::forward<Work>(work));
}

}  // namespace quoin
