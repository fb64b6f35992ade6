#include "booleans/pairs/cell_filter.h"

#include <atomic>

namespace quoin::booleans {

CellFilter::CellFilter(const Box& all, const Array<Box>& sample, std::size_t share, std::size_t work)
    : low_(all.low), high_(all.high) {
  while (cell_count() > std::min(work, std::size_t{1} << 21)) ++shift_;
  const auto coverage = [&] {
    std::size_t sum = 0;
    for (const Box& box : sample) sum += share * cells_of(box);
    return sum;
  };
  while (shift_ < 31 && coverage() > work) ++shift_;
  width_ = cell(0, high_[0]) + std::size_t{1};
  depth_ = cell(1, high_[1]) + std::size_t{1};
  owner_.assign(cell_count(), none);
}

std::size_t CellFilter::cell_count() const {
  std::size_t n = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    n *= std::size_t{cell(k, high_[k])} + 1;
    if (n > std::size_t{1} << 32) break;
  }
  return n;
}

std::size_t CellFilter::cells_of(const Box& box) const {
  std::size_t n = 1;
  for (std::size_t k = 0; k < 3; ++k) n *= std::size_t{cell(k, box.high[k])} - cell(k, box.low[k]) + 1;
  return n;
}

template <class Visit>
void CellFilter::for_cells(const Box& box, Visit&& visit) const {
  const std::size_t x0 = cell(0, box.low[0]), x1 = cell(0, box.high[0]), y0 = cell(1, box.low[1]),
                    y1 = cell(1, box.high[1]), z0 = cell(2, box.low[2]), z1 = cell(2, box.high[2]);
  for (std::size_t z = z0; z <= z1; ++z)
    for (std::size_t y = y0; y <= y1; ++y)
      for (std::size_t x = x0; x <= x1; ++x)
        if (!visit((z * depth_ + y) * width_ + x)) return;
}

void CellFilter::add(const Box& box, std::uint32_t group) {
  for_cells(box, [&](std::size_t i) {
    // none, then one group, then mixed, whatever the order of additions: no one waits for it, so nothing else follows.
    const std::atomic_ref<std::uint32_t> owner(owner_[i]);
    std::uint32_t seen = owner.load(std::memory_order_relaxed);
    if (seen == none && owner.compare_exchange_strong(seen, group, std::memory_order_relaxed)) return true;
    if (seen != group && seen != mixed) owner.store(mixed, std::memory_order_relaxed);
    return true;
  });
}

bool CellFilter::is_shared(const Box& box) const {
  bool found = false;
  for_cells(box, [&](std::size_t i) { return !(found = owner_[i] == mixed); });
  return found;
}

}  // namespace quoin::booleans
