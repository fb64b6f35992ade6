#include "grid/lists/stretches.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <fstream>
#include <numeric>
#include <thread>
#include <vector>

namespace quoin::grid {
namespace {

TEST(Stretches, CoverEachPlaceOnce) {
  for (const std::size_t count : {0u, 1u, 7u, 100u, 1001u}) {
    std::vector<std::atomic<int>> seen(count);
    in_stretches(count, 10, [&](std::size_t s, std::size_t begin, std::size_t end) {
      EXPECT_EQ(begin, s * 10);
      EXPECT_LE(end - begin, 10u);
      for (std::size_t i = begin; i < end; ++i) ++seen[i];
    });
    for (const auto& n : seen) EXPECT_EQ(n, 1);
  }
}

/// The caller's own count, in a process that has no room for the stack of another thread.
[[noreturn]] void count_without_threads() {
  std::ifstream pages("/proc/self/statm");
  rlim_t size = 0;
  pages >> size;
  const rlim_t most = size * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE)) + (rlim_t{2} << 20);
  const rlimit limit = {most, most};
  if (::setrlimit(RLIMIT_AS, &limit) != 0) ::_exit(1);

  std::size_t seen = 0;
  in_stretches(100, 1, [&](std::size_t s, std::size_t, std::size_t) { seen += s; });
  std::vector<int> list = {3, 1, 2};
  sort_side_by_side(list.begin(), list.end());
  ::_exit(threads_can_start() || seen != 4950 || list != std::vector<int>{1, 2, 3} ? 2 : 7);
}

TEST(Stretches, AreDoneByTheCallerWhereNoThreadStarts) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(count_without_threads(), testing::ExitedWithCode(7), "");
}

// Asked for one thread, all is done by the caller, in order.
TEST(Stretches, SeriallyInOrder) {
  std::vector<std::size_t> order;
  {
    const Serially serially;
    in_stretches(100, 1, [&](std::size_t s, std::size_t, std::size_t) { order.push_back(s); });
  }
  std::vector<std::size_t> expected(100);
  std::iota(expected.begin(), expected.end(), std::size_t{0});
  EXPECT_EQ(order, expected);
  EXPECT_FALSE(Serially::here());
}

// A thread that waits for inner stretches begins no other outer one: what an outer one keeps by thread stays its own.
TEST(Stretches, InnerOnesAreNotMixedWithOuterOnes) {
  using namespace std::chrono_literals;
  const tbb::global_control workers(tbb::global_control::max_allowed_parallelism, 4);
  std::atomic<int> mixed = 0;
  tbb::task_arena(4).execute([&] {
    in_stretches(300, 1, [&](std::size_t, std::size_t, std::size_t) {
      static thread_local bool is_busy = false;
      if (is_busy) ++mixed;
      is_busy = true;
      in_stretches(4, 1, [&](std::size_t s, std::size_t, std::size_t) { std::this_thread::sleep_for(s * 300us); });
      is_busy = false;
    });
  });
  EXPECT_EQ(mixed, 0);
}

TEST(Stretches, LongOnesAreFew) {
  EXPECT_EQ(long_stretch(10, 64), stretch(64));
  EXPECT_LE(1'000'000 / long_stretch(1'000'000, 64), thresholds().stretch == Thresholds{}.stretch ? 64u : SIZE_MAX);
}

}  // namespace
}  // namespace quoin::grid
