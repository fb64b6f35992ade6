/// \file
/// Errors and results: what every door of Quoin returns.
#pragma once

#include <cassert>
#include <string>
#include <utility>
#include <variant>

namespace quoin {

/// Why something was refused, for people and for programs.
struct Error {
  /// Stable identifier in kebab-case, listed in docs/errors.md, e.g. "open-boundary".
  std::string code;
  /// One sentence that says what is wrong and, where possible, what would help.
  std::string message;
  /// The file concerned; empty when there is none.
  std::string file = {};
  /// The place: a face, an edge, coordinates, a line number; empty when there is none.
  std::string where = {};
};

/// A value or an Error. `value()` on an error is a bug of the caller (asserted).
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::move(value)) {}      // NOLINT: implicit by design
  Result(Error error) : state_(std::move(error)) {}  // NOLINT: implicit by design

  explicit operator bool() const { return state_.index() == 0; }
  bool has_value() const { return state_.index() == 0; }

  T& value() & {
    assert(has_value());
    return *std::get_if<0>(&state_);
  }
  const T& value() const& {
    assert(has_value());
    return *std::get_if<0>(&state_);
  }
  T&& value() && {
    assert(has_value());
    return std::move(*std::get_if<0>(&state_));
  }
  const Error& error() const {
    assert(!has_value());
    return *std::get_if<1>(&state_);
  }

 private:
  std::variant<T, Error> state_;
};

/// The result of an action without a value.
template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : error_(std::move(error)), ok_(false) {}  // NOLINT: implicit by design

  explicit operator bool() const { return ok_; }
  bool has_value() const { return ok_; }
  const Error& error() const {
    assert(!ok_);
    return error_;
  }

 private:
  Error error_;
  bool ok_ = true;
};

}  // namespace quoin
