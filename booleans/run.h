/// \file
/// Progress and cancellation of long work.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>

#include "quoin/result.h"

namespace quoin::booleans {

/// As the public Options, and what is counted.
struct Run {
  std::function<void(double)> progress = {};
  const std::atomic<bool>* cancel = nullptr;
  std::function<void(const char*)> stage = {};
  std::atomic<std::uint64_t>* pairs = nullptr;  // grows by the pairs of faces that operations find

  /// Announces a stage. False when the run was cancelled.
  bool begin(const char* name, double fraction) const {
    if (stage) stage(name);
    if (progress) progress(fraction);
    return !cancel || !cancel->load(std::memory_order_relaxed);
  }
  void end() const {
    if (progress) progress(1);
  }
  /// For one of several operations side by side, which announce nothing.
  Run of_part() const { return {{}, cancel, {}, pairs}; }
};

inline Error cancelled() { return {ErrorCode::cancelled, "the operation was cancelled"}; }

}  // namespace quoin::booleans
