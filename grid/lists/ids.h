/// \file
/// Numbers that name things of one kind.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "grid/lists/array.h"

namespace quoin::grid {

/// A number that names a thing of one kind. Made from a plain number wherever one is needed, turned back by `value`
/// only, and never into another kind: what is one vertex's number is no plane's. Costs nothing: it is its number.
template <class Kind>
struct Id {
  std::uint32_t value = 0xFFFFFFFFu;  // of nothing

  constexpr Id() = default;
  constexpr Id(std::uint32_t v) : value(v) {}  // NOLINT: implicit by design
  template <class Other>
  Id(Id<Other>) = delete;

  Id& operator++() {
    ++value;
    return *this;
  }
  friend constexpr bool operator==(Id a, Id b) { return a.value == b.value; }
  friend constexpr auto operator<=>(Id a, Id b) { return a.value <=> b.value; }
};

/// A list in which things of one kind are found by their ids.
template <class Key, class T>
class ById : public Array<T> {
 public:
  using List = Array<T>;
  using List::List;
  T& operator[](Key k) { return List::operator[](k.value); }
  const T& operator[](Key k) const { return List::operator[](k.value); }
  /// The id that the next item gets.
  Key next_id() const { return static_cast<std::uint32_t>(this->size()); }
  /// Appends an item; its id.
  Key add(T item) {
    this->push_back(std::move(item));
    return static_cast<std::uint32_t>(this->size() - 1);
  }
};

/// The ids first .. last - 1, to be walked through.
template <class Key>
struct Ids {
  struct Iterator {
    std::uint32_t i;
    Key operator*() const { return i; }
    Iterator& operator++() {
      ++i;
      return *this;
    }
    friend bool operator==(Iterator, Iterator) = default;
  };
  std::uint32_t first, last;

  Ids(std::size_t count) : first(0), last(static_cast<std::uint32_t>(count)) {}  // NOLINT: "the first `count`"
  Ids(Key begin, Key end) : first(begin.value), last(end.value) {}
  Iterator begin() const { return {first}; }
  Iterator end() const { return {last}; }
};

}  // namespace quoin::grid
