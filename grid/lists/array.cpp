#include "grid/lists/array.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include "grid/lists/kept.h"

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace quoin::grid {
namespace {

constexpr std::size_t large_page = std::size_t{1} << 21;

/// A whole number of large pages.
std::size_t rounded_up(std::size_t bytes) { return (bytes + large_page - 1) / large_page * large_page; }

/// Small blocks that a thread has released, for its next ones: an operation on small solids asks for hundreds. Blocks
/// of a class have the size of its largest; how many are kept is bounded.
class SmallBlocks {
 public:
  static constexpr std::size_t largest = 4096;
  static bool has_class(std::size_t bytes) { return bytes - 1 < largest; }

  /// The thread's, null before it keeps some and when it has ended.
  static inline constinit thread_local SmallBlocks* mine = nullptr;

  /// Null when none is kept.
  void* take(std::size_t bytes) {
    const unsigned c = size_class(bytes);
    Block* const block = first_[c];
    if (!block) return nullptr;
    first_[c] = block->next;
    --count_[c];
    return block;
  }
  /// A block of the same size, by itself: any thread may keep it when it is released.
  static void* make(std::size_t bytes) { return ::operator new (std::size_t{1} << size_class(bytes)); }
  void give(void* memory, std::size_t bytes) noexcept {
    const unsigned c = size_class(bytes);
    if (count_[c] == most(c)) return ::operator delete(memory);
    first_[c] = new (memory) Block{first_[c]};
    ++count_[c];
  }
  ~SmallBlocks() {
    mine = nullptr;
    for (Block* block : first_)
      while (block) {
        Block* const next = block->next;
        ::operator delete(block);
        block = next;
      }
  }

 private:
  struct Block {
    Block* next;
  };
  /// Of a class: 16 kB, and not too few.
  static constexpr std::uint32_t most(unsigned c) { return std::max(32u, (1u << 14) >> c); }

  /// Blocks of class c have 2^c bytes. Precondition: bytes > 0.
  static unsigned size_class(std::size_t bytes) { return static_cast<unsigned>(std::bit_width((bytes - 1) | 31)); }

  std::array<Block*, 13> first_ = {};
  std::array<std::uint32_t, 13> count_ = {};
};

/// Null where a thread keeps none: also where a sanitizer is to see each block's end.
SmallBlocks* kept_blocks() {
#ifdef __SANITIZE_ADDRESS__
  return nullptr;
#else
  if (!SmallBlocks::mine) [[unlikely]]
    SmallBlocks::mine = kept_by_thread<SmallBlocks>();
  return SmallBlocks::mine;
#endif
}

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
  if (SmallBlocks::has_class(bytes)) {
    SmallBlocks* const kept = kept_blocks();
    void* const block = kept ? kept->take(bytes) : nullptr;
    return block ? block : SmallBlocks::make(bytes);
  }
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
  if (SmallBlocks::has_class(bytes))
    if (SmallBlocks* const kept = kept_blocks()) return kept->give(block, bytes);
#ifdef MADV_HUGEPAGE
  if (bytes >= large_block) return ::operator delete (block, std::align_val_t{large_page});
#endif
  static_cast<void>(bytes);
  ::operator delete(block);
}

}  // namespace quoin::grid
