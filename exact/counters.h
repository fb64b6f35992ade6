/// \file
/// How many signs each rung of the ladder decided.
#pragma once

#include <cstdint>

namespace quoin::exact {

/// One thread's counts. `fixed_width` includes signs that need no filter because they fit 128 bits.
struct Counters {
  std::uint64_t symbolic = 0, filter = 0, fixed_width = 0, rational = 0;
};

/// This thread's counters.
namespace detail {
Counters* registered();
inline constinit thread_local Counters* mine = nullptr;
}  // namespace detail
inline Counters& counters() {
  if (detail::mine == nullptr) [[unlikely]]
    detail::mine = detail::registered();
  return *detail::mine;
}
/// The sum over all threads that ever counted; exact while no other thread is counting.
Counters total_counters();

}  // namespace quoin::exact
