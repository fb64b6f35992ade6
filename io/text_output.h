/// \file
/// Decimals appended to a string, without a locale.
#pragma once

#include <array>
#include <charconv>
#include <span>
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

/// Appends `lead` and three numbers, each in quotes behind its name: ` x="` and so on.
template <class Number>
void append_attributes(std::string& out, std::string_view lead, const std::array<std::string_view, 3>& names,
                       std::span<const Number> values) {
  out.append(lead);
  for (std::size_t k = 0; k < 3; ++k) {
    out.append(names[k]);
    append_number(out, values[k]);
    out.push_back('"');
  }
}

}  // namespace quoin::io
