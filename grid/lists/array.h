/// \file
/// Lists whose memory costs little to touch for the first time.
///
/// An operation on large operands fills some dozens of lists of some megabytes each, once. The system hands out memory
/// page by page when it is first touched, which takes longer than to write it: 0.6 ns a byte in pages of 4 kB. Large
/// blocks therefore ask for large pages, where the system has them.
#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace quoin::grid {

/// Blocks of at least so many bytes are in large pages, if the system has some.
inline constexpr std::size_t large_block = std::size_t{1} << 20;

/// As operator new and delete; a block is released with the number of bytes that it was asked for. Small blocks are
/// kept for the next ones of the thread, a few of each size.
void* allocate(std::size_t bytes);
void release(void* block, std::size_t bytes) noexcept;

/// Asks for large pages in memory that is not touched yet, as far as it holds some.
void prefer_large_pages(void* block, std::size_t bytes) noexcept;

/// Allocates for standard containers.
template <class T>
struct LargePages {
  using value_type = T;

  LargePages() = default;
  template <class Other>
  LargePages(const LargePages<Other>&) {}  // NOLINT: implicit by design

  T* allocate(std::size_t n) {
    static_assert(alignof(T) <= __STDCPP_DEFAULT_NEW_ALIGNMENT__);
    if (n > static_cast<std::size_t>(-1) / sizeof(T)) throw std::bad_array_new_length();
    return static_cast<T*>(grid::allocate(n * sizeof(T)));
  }
  void deallocate(T* items, std::size_t n) noexcept { grid::release(items, n * sizeof(T)); }
  friend bool operator==(LargePages, LargePages) { return true; }
};

/// A vector for lists that grow with the operands.
template <class T, class Allocator = LargePages<T>>
using Array = std::vector<T, Allocator>;

/// Room for n items of a list that is to be a plain vector, in large pages where it is large.
template <class T>
void reserve_large(std::vector<T>& list, std::size_t n) {
  list.reserve(n);
  prefer_large_pages(list.data(), n * sizeof(T));
}

}  // namespace quoin::grid
