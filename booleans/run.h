/// \file
/// Progress and cancellation of long work.
#pragma once

#include <atomic>
#include <functional>

#include "quoin/result.h"

namespace quoin::booleans {

/// As the public Options.
struct Run {
  std::function<void(double)> progress = {};
  const std::atomic<bool>* cancel = nullptr;
  std::function<void(const char*)> stage = {};

  /// Announces a stage. False when the run was cancelled.
  bool begin(const char* name, double fraction) const {
    if (stage) stage(name);
    if (progress) progress(fraction);
    return !cancel || !cancel->load(std::memory_order_relaxed);
  }
  void end() const {
    if (progress) progress(1);
  }
};

inline Error cancelled() { return {ErrorCode::cancelled, "the operation was cancelled"}; }

}  // namespace quoin::booleans
