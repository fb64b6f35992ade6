/// \file
/// Counts of the arithmetic, for profiles and tests.
#pragma once

#include "quoin/export.h"

#include <cstdint>

namespace quoin {

/// How many signs each rung of the arithmetic decided since the process began.
struct Statistics {
  std::uint64_t symbolic = 0, filter = 0, fixed_width = 0, rational = 0;
};
QUOIN_API Statistics statistics();

}  // namespace quoin
