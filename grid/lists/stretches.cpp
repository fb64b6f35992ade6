#include "grid/lists/stretches.h"

#include <atomic>
#include <exception>
#include <thread>

namespace quoin::grid {
namespace {

/// All of them at once: one after the other they would stay within any bound.
bool start_threads(std::size_t count) {
  std::atomic<bool> all_started = false;
  std::vector<std::thread> threads;
  bool good = true;
  try {
    threads.reserve(count);
    while (threads.size() < count) threads.emplace_back([&] { all_started.wait(false); });
  } catch (const std::exception&) {
    good = false;
  }

  all_started = true;
  all_started.notify_all();
  for (std::thread& thread : threads) thread.join();
  return good;
}

}  // namespace

bool threads_can_start() {
  static const bool can_start = start_threads(static_cast<std::size_t>(tbb::this_task_arena::max_concurrency()) - 1);
  return can_start;
}

}  // namespace quoin::grid
