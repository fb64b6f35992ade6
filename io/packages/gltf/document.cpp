#include "io/packages/gltf/document.h"

#include <algorithm>
#include <cmath>

#include "io/scanner.h"

namespace quoin::io {
namespace {

/// What a glTF may require although it is passed over, by the beginnings of its names: looks alone.
constexpr std::array<std::string_view, 5> looks = {"KHR_materials_", "KHR_texture_", "EXT_texture_", "KHR_lights_",
                                                   "EXT_lights_"};
/// Without which positions cannot be read.
constexpr std::array<std::string_view, 3> compressions = {"KHR_draco_mesh_compression", "EXT_meshopt_compression",
                                                          "KHR_meshopt_compression"};
constexpr std::string_view quantization = "KHR_mesh_quantization";

bool is_read_or_looks(std::string_view extension) {
  return extension == quantization || std::any_of(looks.begin(), looks.end(), [&](std::string_view beginning) {
           return extension.starts_with(beginning);
         });
}

}  // namespace

std::string_view compression_of(const Json& object) {
  const Json* extensions = object.member("extensions");
  if (extensions == nullptr) return {};
  const auto* found = std::find_if(compressions.begin(), compressions.end(),
                                   [&](std::string_view name) { return extensions->member(name) != nullptr; });
  return found == compressions.end() ? std::string_view() : *found;
}

std::string unread_extension(std::string_view extension) {
  const bool is_compression = std::find(compressions.begin(), compressions.end(), extension) != compressions.end();
  return "the file requires the extension " + std::string(extension) + ", which is not read" +
         (is_compression ? ": save it without compression of meshes" : "");
}

bool GltfDocument::fail(Error error) {
  error_ = std::move(error);
  return false;
}

bool GltfDocument::fail(ErrorCode code, std::string message, std::string where) {
  return fail(Error{code, std::move(message), {}, std::move(where)});
}

bool GltfDocument::check_header() {
  const Json* asset = root_.member("asset");
  const Json* version = asset == nullptr ? nullptr : asset->member("version");
  if (version == nullptr || !version->text.starts_with("2"))
    return fail(ErrorCode::unknown_format, "this is no glTF of version 2", root_);
  for (const Json& name : items(root_, "extensionsRequired"))
    if (!is_read_or_looks(name.text)) return fail(ErrorCode::unknown_format, unread_extension(name.text), name);
  return true;
}

bool GltfDocument::number(const Json& json, double& out) {
  if (json.kind != Json::Kind::number) return fail(ErrorCode::bad_number, "a number is due here", json);
  Scanner scanner(json.text);
  return scanner.number(out) || fail(scanner.take_error().code, "this number is not finite in double precision", json);
}

bool GltfDocument::count(const Json& object, std::string_view name, std::optional<std::uint64_t> fallback,
                         std::uint64_t& out) {
  const Json* json = object.member(name);
  if (json == nullptr && !fallback)
    return fail(ErrorCode::bad_syntax, "\"" + std::string(name) + "\" is missing", object);
  if (json == nullptr) {
    out = *fallback;
    return true;
  }
  double value = 0;
  if (!number(*json, value)) return false;
  if (value < 0 || value > 0x1p40 || value != std::floor(value))
    return fail(ErrorCode::absurd_count, "\"" + std::string(name) + "\" is negative, broken or too large", *json);
  out = static_cast<std::uint64_t>(value);
  return true;
}

const std::vector<Json>& GltfDocument::items(const Json& object, std::string_view name) const {
  static const auto& none = *new std::vector<Json>;
  const Json* found = object.member(name);
  return found == nullptr ? none : found->items;
}

bool GltfDocument::entry(std::string_view list, std::uint64_t index, const std::string& named_at, const Json*& out) {
  const auto& entries = items(root_, list);
  if (index >= entries.size())
    return fail(ErrorCode::bad_index,
                "there is no entry " + std::to_string(index) + " of \"" + std::string(list) + "\"", named_at);
  out = &entries[index];
  return true;
}

std::string GltfDocument::name_of(const Json& object) const {
  const Json* name = object.member("name");
  return name == nullptr ? "" : name->text;
}

}  // namespace quoin::io
