/// \file
/// What URIs of a glTF say: data in base64, and names of files.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace quoin::io {

/// Nothing where a character is none of base64.
std::optional<std::string> from_base64(std::string_view text);
std::string to_base64(std::string_view bytes);

/// "a%20b" as "a b"; a "%" without two digits stays.
std::string without_escapes(std::string_view uri);

}  // namespace quoin::io
