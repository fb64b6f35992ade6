/// \file
/// Decimals appended to a string, without a locale.
#pragma once

#include <charconv>
#include <string>
#include <string_view>

namespace quoin::io {

/// Appends the shortest decimal that reads back to the same value, or the integer's digits.
template <class Number>
void append_number(std::string& out, Number value) {
  char buffer[32];
  const std::to_chars_result result = std::to_chars(buffer, buffer + sizeof buffer, value);
  out.append(buffer, static_cast<std::size_t>(result.ptr - buffer));
}

/// Appends `lead` and three numbers, separated by single spaces, and ends the line.
template <class Number>
void append_line(std::string& out, std::string_view lead, Number a, Number b, Number c) {
  out.append(lead);
  append_number(out, a);
  out.push_back(' ');
  append_number(out, b);
  out.push_back(' ');
  append_number(out, c);
  out.push_back('\n');
}

}  // namespace quoin::io
