#include "grid/lists/array.h"

#include <cstdint>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace quoin::grid {
namespace {

constexpr std::size_t large_page = std::size_t{1} << 21;

/// A whole number of large pages.
std::size_t rounded_up(std::size_t bytes) { return (bytes + large_page - 1) / large_page * large_page; }

}  // namespace

void prefer_large_pages(void* block, std::size_t bytes) noexcept {
#ifdef MADV_HUGEPAGE
  const auto begin = reinterpret_cast<std::uintptr_t>(block);
  const std::uintptr_t first = rounded_up(begin), last = (begin + bytes) / large_page * large_page;
  if (first < last)
    static_cast<void>(::madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE));  // a wish
#else
  static_cast<void>(block), static_cast<void>(bytes);
#endif
}

void* allocate(std::size_t bytes) {
#ifdef MADV_HUGEPAGE
  if (bytes >= large_block) {
    void* const block = ::operator new (rounded_up(bytes), std::align_val_t{large_page});
    prefer_large_pages(block, rounded_up(bytes));
    return block;
  }
#endif
  return ::operator new(bytes);
}

void release(void* block, std::size_t bytes) noexcept {
#ifdef MADV_HUGEPAGE
  if (bytes >= large_block) return ::operator delete (block, std::align_val_t{large_page});
#endif
  static_cast<void>(bytes);
  ::operator delete(block);
}

}  // namespace quoin::grid
