/// \file
/// Items by a key: the counting sort.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>

#include "grid/lists/array.h"

namespace quoin::grid {

/// The counting sort in memory of the caller. for_items(visit) calls visit(key, item) for every item, each key below
/// start.size() - 2. It is called twice and must give the same keys in the same order: it counts the items, then places
/// them in to(n), the memory of n items. `start` holds zeros; then the items of key k have the places start[k] ..
/// start[k + 1] - 1, in the order in which they came. Items are below 2^32.
template <class ForItems, class To>
void counting_sort(std::span<std::uint32_t> start, ForItems&& for_items, To&& to) {
  // Counted two places on, then summed: start[k + 1] is where key k begins, and when all its items are placed, ends.
  for_items([&](std::size_t key, const auto&) {
    assert(key + 2 < start.size());
    ++start[key + 2];
  });
  for (std::size_t k = 2; k < start.size(); ++k) start[k] += start[k - 1];

  auto* const items = to(start.back());
  for_items([&](std::size_t key, auto&& item) { items[start[key + 1]++] = std::forward<decltype(item)>(item); });
}

/// Items in buckets 0 .. size() - 1, those of one bucket in the order in which they came. Time and memory are
/// O(items + buckets); items are below 2^32.
template <class Item = std::uint32_t>
class Buckets {
 public:
  Buckets() = default;
  /// The items that for_items gives `counting_sort`, each key below `count`.
  template <class ForItems>
  Buckets(std::size_t count, ForItems&& for_items) {
    assign(count, for_items);
  }
  /// Other items, in the memory of those before.
  template <class ForItems>
  void assign(std::size_t count, ForItems&& for_items) {
    start_.assign(count + 2, 0);
    counting_sort(std::span(start_), for_items, [&](std::size_t n) { return memory(n); });
    start_.pop_back();
  }

  /// The number of buckets.
  std::size_t size() const { return start_.empty() ? 0 : start_.size() - 1; }
  std::span<const Item> operator[](std::size_t bucket) const {
    return {items_.get() + start_[bucket], start_[bucket + 1] - start_[bucket]};
  }
  std::span<Item> operator[](std::size_t bucket) {
    return {items_.get() + start_[bucket], start_[bucket + 1] - start_[bucket]};
  }
  /// All items, bucket by bucket; those of bucket k have the places start(k) .. start(k + 1) - 1.
  std::span<const Item> items() const { return {items_.get(), item_count()}; }
  std::span<Item> items() { return {items_.get(), item_count()}; }
  std::uint32_t start(std::size_t bucket) const { return start_[bucket]; }

 private:
  /// n items without a value of their own.
  class Memory {
   public:
    Memory() = default;
    explicit Memory(std::size_t n) : items_(LargePages<Item>().allocate(n)), size_(n) {
      std::uninitialized_default_construct_n(items_, n);
    }
    Memory(Memory&& other) noexcept
        : items_(std::exchange(other.items_, nullptr)), size_(std::exchange(other.size_, 0)) {}
    Memory& operator=(Memory&& other) noexcept {
      std::swap(items_, other.items_);
      std::swap(size_, other.size_);
      return *this;
    }
    ~Memory() {
      if (!items_) return;
      std::destroy_n(items_, size_);
      LargePages<Item>().deallocate(items_, size_);
    }
    Item* get() const { return items_; }
    std::size_t size() const { return size_; }

   private:
    Item* items_ = nullptr;
    std::size_t size_ = 0;
  };

  std::uint32_t item_count() const { return start_.empty() ? 0 : start_.back(); }
  Item* memory(std::size_t n) {
    if (n <= items_.size()) return items_.get();
    items_ = Memory(std::max(n, 2 * items_.size()));
    return items_.get();
  }

  Array<std::uint32_t> start_;
  Memory items_;
};

/// The numbers i = 0 .. n - 1 in `count` buckets by key_of(i), which is asked twice.
template <class KeyOf>
Buckets<> in_buckets(std::size_t n, std::size_t count, KeyOf&& key_of) {
  return Buckets<>(count, [&](auto&& visit) {
    for (std::uint32_t i = 0; i < n; ++i) visit(key_of(i), i);
  });
}

}  // namespace quoin::grid
