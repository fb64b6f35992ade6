/// \file
/// A value or an error: what every door of Quoin returns.
#pragma once

#include "quoin/export.h"

#include <string>
#include <utility>
#include <variant>

#include "quoin/error.h"

namespace quoin {

/// A value or an Error. What is asked for the one that it does not hold throws `Exception`, in every build: `value()`,
/// `*` and `->` of an error carry that error, `error()` of a value carries "internal-defect".
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::move(value)) {}      // NOLINT: implicit by design
  Result(Error error) : state_(std::move(error)) {}  // NOLINT: implicit by design

  explicit operator bool() const { return has_value(); }
  bool has_value() const { return state_.index() == 0; }

  T& value() & {
    demand_value();
    return *std::get_if<0>(&state_);
  }
  const T& value() const& {
    demand_value();
    return *std::get_if<0>(&state_);
  }
  T&& value() && {
    demand_value();
    return std::move(*std::get_if<0>(&state_));
  }

  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T&& operator*() && { return std::move(*this).value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }

  const Error& error() const {
    if (has_value()) throw Exception({ErrorCode::internal_defect, "error() of a Result that holds a value"});
    return *std::get_if<1>(&state_);
  }

 private:
  void demand_value() const {
    if (!has_value()) throw Exception(*std::get_if<1>(&state_));
  }

  std::variant<T, Error> state_;
};

/// The result of an action without a value: done, or an Error. `error()` of one that is done throws `Exception`.
template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : error_(std::move(error)), ok_(false) {}  // NOLINT: implicit by design

  explicit operator bool() const { return ok_; }
  bool has_value() const { return ok_; }

  /// Throws the error if there is one.
  void value() const {
    if (!ok_) throw Exception(error_);
  }
  const Error& error() const {
    if (ok_) throw Exception({ErrorCode::internal_defect, "error() of a Result that is done"});
    return error_;
  }

 private:
  Error error_;
  bool ok_ = true;
};

}  // namespace quoin
