/// \file
/// Parallel work that depends on no number of threads.
#pragma once

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>

namespace quoin::grid {

/// visit(stretch, begin, end) for 0 .. count - 1 in stretches of a fixed length, side by side: the stretches, and with
/// them what is kept by stretch, are the same for any number of threads.
template <class Visit>
void in_stretches(std::size_t count, std::size_t length, Visit&& visit) {
  const std::size_t stretches = (count + length - 1) / length;
  if (stretches == 1) return visit(std::size_t{0}, std::size_t{0}, count);
  tbb::parallel_for(std::size_t{0}, stretches,
                    [&](std::size_t s) { visit(s, s * length, std::min(count, (s + 1) * length)); });
}

}  // namespace quoin::grid
