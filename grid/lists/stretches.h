/// \file
/// Parallel work that depends on no number of threads.
#pragma once

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

#include "grid/lists/array.h"
#include "grid/lists/thresholds.h"

namespace quoin::grid {

/// The length of stretches whose results are put together: `length`, less only where tests ask for it.
inline std::size_t stretch(std::size_t length) { return std::min(length, thresholds().stretch); }

/// The same for lists that each stretch keeps: at least `least`, longer where that would make many short lists.
inline std::size_t long_stretch(std::size_t count, std::size_t least) {
  constexpr std::size_t most_stretches = 64;
  return stretch(std::max(least, count / most_stretches + 1));
}

/// Whether the system starts as many threads as TBB may ask for; asked once. TBB throws where it cannot start one.
bool threads_can_start();

/// While one lives, work of its thread is not handed to others.
class Serially {
 public:
  Serially() : before_(here()) { here() = true; }
  Serially(const Serially&) = delete;
  Serially& operator=(const Serially&) = delete;
  ~Serially() { here() = before_; }

  static bool& here() {
    static thread_local bool serial = false;
    return serial;
  }

 private:
  const bool before_;
};

/// Whether the caller does all of the work.
inline bool is_serial() { return Serially::here() || !threads_can_start(); }

/// visit(stretch, begin, end) for 0 .. count - 1 in stretches of a fixed length, side by side: the stretches, and with
/// them what is kept by stretch, are the same for any number of threads. A thread that waits for others does nothing
/// else meanwhile, so what a visit keeps by thread stays its own while it waits for inner stretches.
template <class Visit>
void in_stretches(std::size_t count, std::size_t length, Visit&& visit) {
  if (count == 0) return;
  const std::size_t stretches = (count + length - 1) / length;
  if (stretches == 1) return visit(std::size_t{0}, std::size_t{0}, count);
  const auto one = [&](std::size_t s) { visit(s, s * length, std::min(count, (s + 1) * length)); };
  if (is_serial())
    for (std::size_t s = 0; s < stretches; ++s) one(s);
  else
    tbb::this_task_arena::isolate([&] { tbb::parallel_for(std::size_t{0}, stretches, one); });
}

/// visit(i) for 0 .. count - 1, side by side where that pays: `work` elements in all.
template <class Visit>
void in_tasks(std::size_t count, std::size_t work, Visit&& visit) {
  in_stretches(count, work < thresholds().small_work ? count : 1, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) visit(i);
  });
}

/// visit(begin, end) for one range of 0 .. count - 1 a thread, side by side. For work that all ranges begin by looking
/// at the same data, of which each takes its own; the result must not depend on how many there are.
template <class Visit>
void in_shares(std::size_t count, Visit&& visit) {
  const bool is_shared = count >= thresholds().small_work && !is_serial();
  const auto threads = is_shared ? static_cast<std::size_t>(tbb::this_task_arena::max_concurrency()) : 1;
  const std::size_t shares = std::min<std::size_t>(threads, 8);
  in_stretches(count, count / shares + 1, [&](std::size_t, std::size_t begin, std::size_t end) { visit(begin, end); });
}

/// Sorts items of which no two are equal.
template <class Iterator, class Less = std::less<>>
void sort_side_by_side(Iterator begin, Iterator end, Less less = {}) {
  if (is_serial())
    std::sort(begin, end, less);
  else
    tbb::parallel_sort(begin, end, less);
}

/// The lists one after the other, as what was kept by stretch is put together.
template <class T>
Array<T> joined(const Array<Array<T>>& lists) {
  std::size_t total = 0;
  for (const auto& list : lists) total += list.size();

  Array<T> all;
  all.reserve(total);
  for (const auto& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

}  // namespace quoin::grid
