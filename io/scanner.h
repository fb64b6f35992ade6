/// \file
/// Words, numbers and lines of a text, without a locale, without copies.
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include <fast_float/fast_float.h>

#include "quoin/result.h"

namespace quoin::io {

/// What a text's lines may hold besides words.
struct ScannerOptions {
  /// '#' at the start of a word ends the line.
  bool hash_comments = false;
  /// A backslash before the end of a line joins the next line to it.
  bool line_continuation = false;
};

/// Walks a text from front to back.
/// Lines end with LF, CRLF or CR; blanks are space, tab, VT and FF.
/// Methods that return bool return false exactly when they failed; the first failure is kept for `take_error`.
class Scanner {
 public:
  explicit Scanner(std::string_view text, ScannerOptions options = {})
      : begin_(text.data()),
        position_(text.data()),
        end_(text.data() + text.size()),
        mark_(text.data()),
        options_(options) {}

  const char* position() const { return position_; }
  std::uint64_t remaining() const { return static_cast<std::uint64_t>(end_ - position_); }
  bool at_end() const { return position_ == end_; }

  /// Whether no word of this line is left. Call after `skip_blanks`.
  bool at_line_end() const {
    return at_end() || is_newline(*position_) || (options_.hash_comments && *position_ == '#');
  }

  /// Moves over blanks and joined line ends, not over the end of the line.
  void skip_blanks() {
    while (position_ != end_) {
      if (is_blank(*position_)) {
        ++position_;
      } else if (is_joint(position_)) {
        ++position_;
        step_over_newline();
      } else {
        return;
      }
    }
  }

  /// Moves over blanks, ends of lines and comments.
  void skip_space() {
    for (skip_blanks(); at_line_end() && !at_end(); skip_blanks()) skip_line();
  }

  /// Moves to the start of the next line; a joined line is a part of this one, except behind a comment.
  void skip_line() {
    for (;;) {
      const char* start = position_;
      while (position_ != end_ && !is_newline(*position_)) ++position_;
      const bool joined = options_.line_continuation && position_ != start && position_[-1] == '\\' &&
                          std::find(start, position_, '#') == position_;
      if (position_ != end_) step_over_newline();
      if (!joined || at_end()) return;
    }
  }

  /// The next word of this line; empty at its end.
  std::string_view word() {
    skip_blanks();
    mark_ = position_;
    if (at_line_end()) return {};
    while (position_ != end_ && !ends_word(position_)) ++position_;
    return {mark_, static_cast<std::size_t>(position_ - mark_)};
  }

  /// Reads the next word of this line as the double nearest to its decimal.
  /// Decimals that round to zero are zero of their sign; those that round to infinity are not finite.
  /// Errors: "truncated", "bad-syntax" (no word), "bad-number", "non-finite".
  bool number(double& out) {
    if (!start_word("a number is missing")) return false;
    double value = 0;
    const char* first = after_plus();
    // What is out of range is infinite or zero, whether or not it is called so.
    const auto result = fast_float::from_chars(first, end_, value);
    if (result.ec == std::errc::invalid_argument || !ends_word(result.ptr) || is_blank(*first)) {
      return fail(ErrorCode::bad_number, "this is not a decimal number");
    }
    if (!std::isfinite(value)) return fail(ErrorCode::non_finite, "this number is not finite in double precision");

    position_ = result.ptr;
    out = value;
    return true;
  }

  /// Reads the next word of this line as an integer, saturating at the range of int64.
  /// Errors: "truncated", "bad-syntax" (no word), "bad-number".
  bool integer(std::int64_t& out) {
    if (!start_word("an integer is missing")) return false;
    const char* after = integer_prefix(out);
    if (after == nullptr || !ends_word(after)) return fail(ErrorCode::bad_number, "this is not an integer");
    position_ = after;
    return true;
  }

  /// Reads the integer at the start of the next word and stops right behind it.
  /// Errors: "truncated", "bad-syntax" (no word), "bad-number".
  bool leading_integer(std::int64_t& out) {
    if (!start_word("an integer is missing")) return false;
    const char* after = integer_prefix(out);
    if (after == nullptr) return fail(ErrorCode::bad_number, "this is not an integer");
    position_ = after;
    return true;
  }

  /// Whether the character here belongs to a word.
  bool inside_word() const { return !ends_word(position_); }
  /// The character here. Precondition: not `at_end`.
  char peek() const { return *position_; }
  void advance() { ++position_; }
  /// Goes on at `place`, a place within the text.
  void move_to(const char* place) { position_ = place; }

  /// Puts errors at the place here.
  void mark() { mark_ = position_; }
  /// Puts errors at `place`, a former `position`.
  void mark_at(const char* place) { mark_ = place; }

  /// Records an error at the mark (the start of the last word) and returns false.
  bool fail(ErrorCode code, std::string message) {
    error_ = Error{code, std::move(message), {}, "line " + std::to_string(line_of(mark_))};
    return false;
  }
  Error take_error() { return std::move(error_); }

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
  static bool is_newline(char c) { return c == '\n' || c == '\r'; }

  bool is_joint(const char* p) const {
    return options_.line_continuation && *p == '\\' && p + 1 != end_ && is_newline(p[1]);
  }
  bool ends_word(const char* p) const { return p == end_ || is_blank(*p) || is_newline(*p) || is_joint(p); }

  void step_over_newline() {
    const bool crlf = *position_ == '\r' && position_ + 1 != end_ && position_[1] == '\n';
    position_ += crlf ? 2 : 1;
  }

  bool start_word(const char* complaint) {
    skip_blanks();
    mark_ = position_;
    if (at_end()) return fail(ErrorCode::truncated, "the text ends where more is declared");
    if (at_line_end()) return fail(ErrorCode::bad_syntax, std::string(complaint) + " on this line");
    return true;
  }

  /// from_chars takes no plus sign; a second sign stays an error, and so does a blank behind it.
  const char* after_plus() const {
    const bool plus = *position_ == '+' && position_ + 1 != end_ && position_[1] != '-';
    return position_ + (plus ? 1 : 0);
  }

  /// The end of the integer here, nullptr when there is none.
  const char* integer_prefix(std::int64_t& out) const {
    const char* first = after_plus();
    const std::from_chars_result result = std::from_chars(first, end_, out);
    if (result.ec == std::errc::invalid_argument) return nullptr;
    if (result.ec == std::errc::result_out_of_range) {
      out = *first == '-' ? std::numeric_limits<std::int64_t>::min() : std::numeric_limits<std::int64_t>::max();
    }
    return result.ptr;
  }

  /// Counted only when an error needs it.
  std::uint64_t line_of(const char* place) const {
    std::uint64_t line = 1;
    for (const char* p = begin_; p != place; ++p) {
      const bool half_of_crlf = *p == '\r' && p + 1 != end_ && p[1] == '\n';
      if (is_newline(*p) && !half_of_crlf) ++line;
    }
    return line;
  }

  const char* begin_;
  const char* position_;
  const char* end_;
  const char* mark_;
  ScannerOptions options_;
  Error error_ = {};
};

}  // namespace quoin::io
