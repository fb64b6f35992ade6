/// \file
/// The JSON of a glTF: values that are checked as they are taken, and the first fault.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/json.h"
#include "quoin/result.h"

namespace quoin::io {

/// Methods that return bool return false to stop, after `fail`.
class GltfDocument {
 public:
  explicit GltfDocument(Json root) : root_(std::move(root)) {}

  const Json& root() const { return root_; }

  /// Records why the reading stops, and returns false.
  bool fail(Error error);
  bool fail(ErrorCode code, std::string message, std::string where);
  bool fail(ErrorCode code, std::string message, const Json& at) { return fail(code, std::move(message), at.place()); }
  Error take_error() { return std::move(error_); }

  /// Whether it is glTF 2 and needs no extension that is not read. Errors: "unknown-format".
  bool check_header();

  /// A number as the nearest double. Errors: "bad-number", "non-finite".
  bool number(const Json& json, double& out);
  /// `out` stays where there is no such member. Errors: those of `number`, "bad-syntax" (not N numbers).
  template <std::size_t N>
  bool numbers(const Json& object, std::string_view name, std::array<double, N>& out);
  /// A whole number of an object, or `fallback`; none without one is an error.
  /// Errors: those of `number`, "bad-syntax", "absurd-count" (beyond 2^40).
  bool count(const Json& object, std::string_view name, std::optional<std::uint64_t> fallback, std::uint64_t& out);

  /// The items of a list; none where there is no such list.
  const std::vector<Json>& items(const Json& object, std::string_view name) const;
  /// An entry of a list of the root by its number, named at a place. Errors: "bad-index".
  bool entry(std::string_view list, std::uint64_t index, const std::string& named_at, const Json*& out);
  std::string name_of(const Json& object) const;

 private:
  Json root_;
  Error error_;
};

/// "accessor 3"
inline std::string numbered(const char* what, std::uint64_t number) {
  return std::string(what) + " " + std::to_string(number);
}

/// Which of the extensions that compress a mesh an object has; empty for none.
std::string_view compression_of(const Json& object);
/// Says that an extension is not read, and how the file can be had without it.
std::string unread_extension(std::string_view extension);

template <std::size_t N>
bool GltfDocument::numbers(const Json& object, std::string_view name, std::array<double, N>& out) {
  const Json* list = object.member(name);
  if (list == nullptr) return true;
  if (list->items.size() != N)
    return fail(ErrorCode::bad_syntax, "\"" + std::string(name) + "\" has " + std::to_string(N) + " numbers", *list);
  for (std::size_t i = 0; i < N; ++i)
    if (!number(list->items[i], out[i])) return false;
  return true;
}

}  // namespace quoin::io
