/// \file
/// Public options as the engine takes them.
#pragma once

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <utility>

#include "booleans/boolean.h"
#include "grid/lists/stretches.h"
#include "quoin/quoin.h"

namespace quoin {

inline booleans::Run run_of(const Options& options) { return {options.progress, options.cancel, options.stage}; }

/// Of a run in several steps the one from `from` to `to`, as fractions of the whole. It ends at exactly `to`, and never
/// passes it before: the sum may round upwards.
inline Options step_of(const Options& run, double from, double to) {
  Options step = run;
  if (run.progress)
    step.progress = [&run, from, to](double done) {
      run.progress(done < 1 ? std::min(from + done * (to - from), to) : to);
    };
  return step;
}

/// The value of work(run), an operation that a caller may start. If it succeeds it says 1 last and once, however it
/// came to its end: what `work` says of that itself is not passed on.
template <class Work>
auto run_to_end(const Options& run, Work&& work) {
  if (!run.progress) return work(run);
  Options inner = run;
  inner.progress = [&run](double done) {
    if (done < 1) run.progress(done);
  };

  auto result = work(std::as_const(inner));
  if (result) run.progress(1);
  return result;
}

/// Runs `work` in the calling thread with so many workers, 0 for all, and returns its value.
/// TBB says on stderr when it is asked for more than it has.
template <class Work>
auto with_threads(unsigned threads, Work&& work) {
  if (threads == 0) return work();
  if (threads == 1) {
    const grid::Serially serially;
    return work();
  }
  const std::size_t most = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  tbb::task_arena arena(static_cast<int>(std::min<std::size_t>(threads, most)));
  return arena.execute(std::forward<Work>(work));
}

}  // namespace quoin
