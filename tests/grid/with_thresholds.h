/// \file
/// Other thresholds for a while, where builds let tests set them.
#pragma once

#include "grid/lists/thresholds.h"

namespace quoin::grid::testing {

/// While it lives the thresholds are these. Without QUOIN_CHECKED they stay what they are.
class WithThresholds {
 public:
#ifdef QUOIN_CHECKED
  explicit WithThresholds(const Thresholds& thresholds) { settable_thresholds() = thresholds; }
  ~WithThresholds() { settable_thresholds() = before_; }
#else
  explicit WithThresholds(const Thresholds&) {}
#endif
  WithThresholds(const WithThresholds&) = delete;
  WithThresholds& operator=(const WithThresholds&) = delete;

 private:
#ifdef QUOIN_CHECKED
  const Thresholds before_ = thresholds();
#endif
};

/// The thresholds of now, one of them changed.
template <class T>
Thresholds with(T Thresholds::*member, T value) {
  Thresholds changed = thresholds();
  changed.*member = value;
  return changed;
}

}  // namespace quoin::grid::testing
