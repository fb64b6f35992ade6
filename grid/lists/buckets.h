/// \file
/// Items by a key: the counting sort.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace quoin::grid {

/// Items in buckets 0 .. size() - 1, those of one bucket in the order in which they came. Time and memory are
/// O(items + buckets); items are below 2^32.
template <class Item = std::uint32_t>
class Buckets {
 public:
  Buckets() = default;
  /// for_items(visit) calls visit(key, item) for every item, each key below `count`. It is called twice and must give
  /// the same keys in the same order: it counts the items, then places them.
  template <class ForItems>
  Buckets(std::size_t count, ForItems&& for_items) : start_(count + 2) {
    // Counted two places on, then summed: start_[k + 1] is where bucket k begins, and when it is full, where it ends.
    for_items([&](std::size_t key, const Item&) {
      assert(key < count);
      ++start_[key + 2];
    });
    for (std::size_t k = 2; k < start_.size(); ++k) start_[k] += start_[k - 1];

    items_ = std::make_unique_for_overwrite<Item[]>(start_.back());
    for_items([&](std::size_t key, auto&& item) { items_[start_[key + 1]++] = std::forward<decltype(item)>(item); });
    start_.pop_back();
  }

  /// The number of buckets.
  std::size_t size() const { return start_.size() - 1; }
  std::span<const Item> operator[](std::size_t bucket) const {
    return {items_.get() + start_[bucket], start_[bucket + 1] - start_[bucket]};
  }
  std::span<Item> operator[](std::size_t bucket) {
    return {items_.get() + start_[bucket], start_[bucket + 1] - start_[bucket]};
  }
  /// All items, bucket by bucket; those of bucket k have the places start(k) .. start(k + 1) - 1.
  std::span<const Item> items() const { return {items_.get(), start_.back()}; }
  std::span<Item> items() { return {items_.get(), start_.back()}; }
  std::uint32_t start(std::size_t bucket) const { return start_[bucket]; }

 private:
  std::vector<std::uint32_t> start_ = {0};
  std::unique_ptr<Item[]> items_;
};

/// The numbers i = 0 .. n - 1 in `count` buckets by key_of(i), which is asked twice.
template <class KeyOf>
Buckets<> in_buckets(std::size_t n, std::size_t count, KeyOf&& key_of) {
  return Buckets<>(count, [&](auto&& visit) {
    for (std::uint32_t i = 0; i < n; ++i) visit(key_of(i), i);
  });
}

/// The items themselves, moved into `count` buckets by key_of(item), which is asked twice.
template <class Item, class KeyOf>
Buckets<Item> moved_to_buckets(std::span<Item> items, std::size_t count, KeyOf&& key_of) {
  return Buckets<Item>(count, [&](auto&& visit) {
    // The first visit leaves them where they are: it takes a reference.
    for (Item& item : items) visit(key_of(std::as_const(item)), std::move(item));
  });
}

}  // namespace quoin::grid
