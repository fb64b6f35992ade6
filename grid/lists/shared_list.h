/// \file
/// Lists that copies share, also when some of them grow.
#pragma once

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cstddef>
#include <initializer_list>
#include <memory>
#include <span>
#include <type_traits>

#include "grid/lists/array.h"

namespace quoin::grid {

/// A list of plain values. Copies share their items; items that are there never change, but for `edit`. A copy may grow
/// in place behind the items it shares, if no other one has done so: an operation that adds little to a long list
/// costs little. Different lists may be used by different threads, also while they share items.
template <class T>
class SharedList {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

 public:
  using value_type = T;

  SharedList() = default;
  SharedList(std::initializer_list<T> items) { append(items.begin(), items.end()); }
  SharedList(Array<T>&& items) : block_(std::make_shared<Block>(std::move(items))) {
    items_ = block_->items;
    size_ = end_ = block_->size;
  }
  SharedList(const SharedList& other) : block_(other.block_), items_(other.items_), size_(other.size_), end_(size_) {}
  SharedList(SharedList&& other) noexcept { swap(other); }
  SharedList& operator=(SharedList other) noexcept {
    swap(other);
    return *this;
  }
  ~SharedList() = default;

  const T* data() const { return items_; }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  const T* begin() const { return items_; }
  const T* end() const { return items_ + size_; }
  const T& operator[](std::size_t i) const {
    assert(i < size_);
    return items_[i];
  }
  friend bool operator==(const SharedList& a, const SharedList& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
  }

  void push_back(const T& item) {
    if (size_ == end_) {
      const T kept = item;  // it may be one of these items
      make_room(size_ + 1);
      items_[size_++] = kept;
    } else {
      items_[size_++] = item;
    }
  }
  template <class Iterator>
  void append(Iterator first, Iterator last) {
    make_room(size_ + static_cast<std::size_t>(last - first));
    for (; first != last; ++first) items_[size_++] = *first;
  }
  /// Appends n items, which the caller writes.
  std::span<T> grow(std::size_t n) {
    make_room(size_ + n);
    size_ += n;
    return {items_ + size_ - n, n};
  }
  void reserve(std::size_t n) {
    if (n > end_) make_room(n);
  }
  /// The items, to be changed: other lists do not see it.
  std::span<T> edit() {
    if (block_.use_count() > 1) move_to(size_);
    std::atomic_thread_fence(std::memory_order_acquire);  // what others read, they read before
    return {items_, size_};
  }
  /// No more items come for now: a copy may grow in place behind these.
  void settle() {
    if (block_ && end_ > size_) block_->used.store(end_ = size_, std::memory_order_release);
  }

 private:
  struct Block {
    explicit Block(std::size_t n)
        : storage(static_cast<T*>(allocate(n * sizeof(T)))), items(storage), size(n), used(n) {}
    explicit Block(Array<T>&& list)
        : adopted(std::move(list)), items(adopted.data()), size(adopted.size()), used(size) {}
    Block(const Block&) = delete;
    Block& operator=(const Block&) = delete;
    ~Block() {
      if (storage) release(storage, size * sizeof(T));
    }

    T* const storage = nullptr;
    Array<T> adopted;
    T* const items;
    const std::size_t size;
    /// Items that belong to some list. A list that ends here may claim the rest.
    std::atomic<std::size_t> used;
  };

  void swap(SharedList& other) noexcept {
    block_.swap(other.block_);
    std::swap(items_, other.items_);
    std::swap(size_, other.size_);
    std::swap(end_, other.end_);
  }
  void make_room(std::size_t n) {
    if (n <= end_) return;
    std::size_t expected = size_;
    if (block_ && n <= block_->size && block_->used.compare_exchange_strong(expected, block_->size)) {
      end_ = block_->size;
    } else {
      move_to(std::max({n, size_ + size_ / 2, std::size_t{4}}));
    }
  }
  void move_to(std::size_t room) {
    const auto block = std::make_shared<Block>(room);
    std::copy(items_, items_ + size_, block->items);
    block_ = block;
    items_ = block->items;
    end_ = room;
  }

  std::shared_ptr<Block> block_;
  T* items_ = nullptr;
  std::size_t size_ = 0;
  std::size_t end_ = 0;  // items below may be written by this list alone
};

}  // namespace quoin::grid
