#include "exact/counters.h"

#include <memory>
#include <mutex>
#include <vector>

namespace quoin::exact {
namespace {

struct Registry {
  std::mutex mutex;
  std::vector<std::unique_ptr<Counters>> all;  // outlives the threads, so that their counts stay
};

Registry& registry() {
  // Never destroyed: threads, and static objects on their way out, may still count.
  static Registry& instance = *new Registry;
  return instance;
}

}  // namespace

Counters* detail::registered() {
  Registry& r = registry();
  const std::lock_guard lock(r.mutex);
  r.all.push_back(std::make_unique<Counters>());
  return r.all.back().get();
}

Counters total_counters() {
  Registry& r = registry();
  const std::lock_guard lock(r.mutex);
  Counters sum;
  for (const auto& c : r.all) {
    sum.symbolic += c->symbolic;
    sum.filter += c->filter;
    sum.fixed_width += c->fixed_width;
    sum.rational += c->rational;
  }
  return sum;
}

}  // namespace quoin::exact
