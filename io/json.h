/// \file
/// JSON text as a tree that keeps what models need: numbers as they are written, and where every value stands.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "quoin/result.h"

namespace quoin::io {

struct Json {
  enum class Kind { null, boolean, number, text, list, object };
  Kind kind = Kind::null;
  /// Of a text, or of a number as it is written; "true" or "false" of a boolean.
  std::string text = {};
  std::vector<Json> items = {};                            // of a list
  std::vector<std::pair<std::string, Json>> members = {};  // of an object, in order; names are distinct
  std::uint32_t line = 0, column = 0;  // from 1, where the value ends or, of a list or object, begins

  /// nullptr where there is none.
  const Json* member(std::string_view name) const;
  /// "line L, column C"
  std::string place() const;
};

/// Errors: "bad-model" (`where` is the place): no JSON, a name twice in an object, more than 1000 levels.
Result<Json> read_json(std::string_view text);
/// With line breaks; a list or object that fits a line stays on it. Ends with a line break.
std::string write_json(const Json& value);

Json json_text(std::string text);
Json json_number(std::string text);
Json json_list(std::vector<Json> items = {});
Json json_object(std::vector<std::pair<std::string, Json>> members = {});

}  // namespace quoin::io
