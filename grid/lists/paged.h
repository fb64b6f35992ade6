/// \file
/// Lists most of which nobody writes.
///
/// A small change of a large solid looks at few of its faces and vertices. What it keeps by face or vertex costs time
/// and memory for the pages that it writes only.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>

#include "grid/lists/array.h"

namespace quoin::grid {

/// A list of a fixed size; places that are not written have the usual value, or that of their range.
template <class T>
class Paged {
 public:
  Paged() = default;
  explicit Paged(std::size_t size, T usual = T())
      : size_(size), pages_((size + length - 1) / length, Page{absent, usual}) {}

  std::size_t size() const { return size_; }
  const T& operator[](std::size_t i) const {
    assert(i < size_);
    const Page& page = pages_[i / length];
    return page.start == absent ? page.usual : items_[page.start + i % length];
  }
  /// The place, to be written at once: the next call may move it.
  T& at(std::size_t i) {
    assert(i < size_);
    return items_[open(i / length) + i % length];
  }
  /// Gives the places begin .. end - 1 a value; whole pages of it are not written.
  void fill(std::size_t begin, std::size_t end, const T& value) {
    while (begin < end) {
      const std::size_t page = begin / length, stop = std::min(end, page * length + page_length(page));
      if (begin == page * length && stop == page * length + page_length(page) && pages_[page].start == absent) {
        pages_[page].usual = value;
      } else {
        const std::uint32_t start = open(page);
        std::fill(items_.data() + start + begin % length, items_.data() + start + (stop - page * length), value);
      }
      begin = stop;
    }
  }

 private:
  static constexpr std::size_t length = 1024;
  static constexpr std::uint32_t absent = UINT32_MAX;

  std::size_t page_length(std::size_t page) const { return std::min(length, size_ - page * length); }
  /// Where the items of a page begin, which are written from now on.
  std::uint32_t open(std::size_t number) {
    Page& page = pages_[number];
    if (page.start == absent) {
      page.start = static_cast<std::uint32_t>(items_.size());
      items_.resize(items_.size() + page_length(number), page.usual);
    }
    return page.start;
  }

  struct Page {
    std::uint32_t start;  // its first item, absent while it has none
    T usual;
  };
  std::size_t size_ = 0;
  Array<Page> pages_;
  Array<T> items_;
};

/// The same, by ids.
template <class Key, class T>
class PagedById : public Paged<T> {
 public:
  using Paged<T>::Paged;
  const T& operator[](Key k) const { return Paged<T>::operator[](k.value); }
  T& at(Key k) { return Paged<T>::at(k.value); }
};

/// Gives some of 0 .. n - 1 the numbers 0, 1, .., in the order in which they come.
class Numbering {
 public:
  static constexpr std::uint32_t none = UINT32_MAX;

  Numbering() = default;
  explicit Numbering(std::size_t n) : number_(n, none) {}

  /// How many have one.
  std::uint32_t size() const { return count_; }
  /// The number of i, or none.
  std::uint32_t operator[](std::size_t i) const { return number_[i]; }
  /// The number of i, which gets one if it has none.
  std::uint32_t add(std::size_t i) {
    std::uint32_t& number = number_.at(i);
    if (number == none) number = count_++;
    return number;
  }

 private:
  Paged<std::uint32_t> number_;
  std::uint32_t count_ = 0;
};

}  // namespace quoin::grid
