#include "io/packages/gltf/accessors.h"

#include <algorithm>
#include <array>

#include "io/packages/gltf/uri.h"

namespace quoin::io {
namespace {

constexpr std::array<GltfComponent, 6> components = {{{5120, 1, false, true, 127},
                                                      {5121, 1, false, false, 255},
                                                      {5122, 2, false, true, 32767},
                                                      {5123, 2, false, false, 65535},
                                                      {5125, 4, false, false, 4294967295},
                                                      {5126, 4, true, true, 1}}};
constexpr std::string_view point_type = "VEC3", index_type = "SCALAR";
constexpr std::uint64_t max_stride = 252;

}  // namespace

bool GltfAccessors::points(std::uint64_t index, const std::string& named_at, GltfAccessor& out) {
  return accessor(index, named_at, point_type, out);
}

bool GltfAccessors::indices(std::uint64_t index, const std::string& named_at, GltfAccessor& out) {
  return accessor(index, named_at, index_type, out);
}

bool GltfAccessors::accessor(std::uint64_t index, const std::string& named_at, std::string_view type,
                             GltfAccessor& out) {
  const Json* json = nullptr;
  if (!document_.entry("accessors", index, named_at, json)) return false;
  const std::string place = numbered("accessor", index);
  const Json* kind = json->member("type");
  if (kind == nullptr || kind->text != type)
    return document_.fail(ErrorCode::bad_syntax, "an accessor of " + std::string(type) + " is due here", place);

  GltfElements& stored = out.stored;
  if (!document_.count(*json, "count", {}, out.count) || !component(*json, place, stored.component)) return false;
  const bool is_fit = type == point_type ? stored.component.size < 4 || stored.component.is_float
                                         : !stored.component.is_float && !stored.component.is_signed;
  if (!is_fit)
    return document_.fail(ErrorCode::bad_syntax, "positions are floats, bytes or shorts, and indices unsigned integers",
                          place);
  const Json* normalized = json->member("normalized");
  if (type == point_type && normalized != nullptr && normalized->text == "true") out.divisor = stored.component.largest;

  if (!count_elements(*json, place, out.count)) return false;
  stored.width = type == point_type ? 3 : 1;
  if (json->member("bufferView") != nullptr) {
    stored.count = out.count;
    if (!elements(*json, place, stored)) return false;
  }
  const Json* replacing = json->member("sparse");
  return replacing == nullptr || sparse(*replacing, place, out);
}

/// Before anything is allocated.
bool GltfAccessors::count_elements(const Json& json, const std::string& place, std::uint64_t count) {
  elements_ += count;
  unstored_ += json.member("bufferView") == nullptr ? count : 0;
  if (elements_ > max_elements)
    return document_.fail(ErrorCode::absurd_count,
                          "meshes have more than " + std::to_string(max_elements) + " elements", place);
  if (unstored_ > max_unstored)
    return document_.fail(ErrorCode::absurd_count,
                          "meshes have more than " + std::to_string(max_unstored) + " elements that no buffer holds",
                          place);
  return true;
}

bool GltfAccessors::sparse(const Json& json, const std::string& place, GltfAccessor& out) {
  const Json *indices = json.member("indices"), *values = json.member("values");
  if (indices == nullptr || values == nullptr)
    return document_.fail(ErrorCode::bad_syntax, "a sparse accessor has indices and values", place);
  GltfElements places;
  GltfElements& replacements = out.replacements;
  if (!document_.count(json, "count", {}, replacements.count)) return false;
  if (replacements.count > out.count)
    return document_.fail(ErrorCode::absurd_count, "more elements are replaced than the accessor has", place);

  places.count = replacements.count;
  replacements.width = out.stored.width;
  replacements.component = out.stored.component;
  if (!component(*indices, place, places.component) || !elements(*indices, place, places) ||
      !elements(*values, place, replacements))
    return false;
  if (places.component.is_float || places.component.is_signed)
    return document_.fail(ErrorCode::bad_syntax, "indices of a sparse accessor are unsigned integers", place);

  out.replaced.reserve(places.count);
  for (std::uint64_t i = 0; i < places.count; ++i) {
    const auto index = static_cast<std::uint32_t>(places.at(i, 0));
    if (index >= out.count || (i > 0 && index <= out.replaced.back()))
      return document_.fail(
          ErrorCode::bad_index,
          "index " + std::to_string(i) + " of the sparse accessor does not ascend within its elements", place);
    out.replaced.push_back(index);
  }
  return true;
}

bool GltfAccessors::component(const Json& json, const std::string& place, GltfComponent& out) {
  std::uint64_t code = 0;
  if (!document_.count(json, "componentType", {}, code)) return false;
  const auto* found = std::find_if(components.begin(), components.end(),
                                   [&](const GltfComponent& component) { return component.code == code; });
  if (found == components.end())
    return document_.fail(ErrorCode::bad_syntax, "there is no component type " + std::to_string(code), place);
  out = *found;
  return true;
}

/// The bytes of elements whose count, width and component are known, all within their view and buffer.
bool GltfAccessors::elements(const Json& json, const std::string& place, GltfElements& out) {
  const Json* view = nullptr;
  std::uint64_t view_index = 0, offset = 0, begin = 0, size = 0, buffer_index = 0;
  if (!document_.count(json, "bufferView", {}, view_index) || !document_.count(json, "byteOffset", 0, offset) ||
      !document_.entry("bufferViews", view_index, place, view))
    return false;
  const std::string view_place = numbered("bufferView", view_index);

  const std::uint64_t element = out.component.size * out.width;
  if (!document_.count(*view, "buffer", {}, buffer_index) || !document_.count(*view, "byteOffset", 0, begin) ||
      !document_.count(*view, "byteLength", {}, size) || !document_.count(*view, "byteStride", element, out.stride))
    return false;
  if (out.stride < element || out.stride > max_stride)
    return document_.fail(ErrorCode::bad_syntax, "the stride is less than an element, or more than 252", view_place);

  std::string_view bytes;
  if (!buffer(buffer_index, view_place, bytes)) return false;
  if (begin > bytes.size() || size > bytes.size() - begin)
    return document_.fail(ErrorCode::absurd_count, "the view is longer than its buffer", view_place);
  if (out.count == 0) return true;
  // A count is at most 2^40, and a stride 252.
  if (offset > size || (out.count - 1) * out.stride + element > size - offset)
    return document_.fail(ErrorCode::absurd_count, "the accessor is longer than its view", place);
  out.bytes = bytes.substr(begin + offset, size - offset);
  return true;
}

bool GltfAccessors::buffer(std::uint64_t index, const std::string& named_at, std::string_view& out) {
  const auto known = buffers_.find(index);
  if (known != buffers_.end()) {
    out = known->second;
    return true;
  }
  const Json* json = nullptr;
  std::uint64_t size = 0;
  if (!document_.entry("buffers", index, named_at, json) || !document_.count(*json, "byteLength", {}, size))
    return false;

  const std::string place = numbered("buffer", index);
  const Json* uri = json->member("uri");
  if (uri == nullptr) {
    const bool is_there = index == 0 && binary_;
    if (const auto extension = compression_of(*json); !is_there && !extension.empty())
      return document_.fail(ErrorCode::unknown_format, unread_extension(extension), place);
    if (!is_there) return document_.fail(ErrorCode::truncated, "the file lacks the bytes of this buffer", place);
    out = *binary_;
  } else {
    if (!load(*uri, place, owned_[index])) return false;
    out = owned_[index];
  }
  if (out.size() < size) return document_.fail(ErrorCode::truncated, "the buffer is shorter than it says", place);
  out = out.substr(0, size);
  buffers_.emplace(index, out);
  return true;
}

bool GltfAccessors::load(const Json& uri, const std::string& place, std::string& out) {
  const std::string_view text = uri.text;
  if (text.starts_with("data:")) {
    constexpr std::string_view mark = ";base64,";
    const std::size_t at = text.find(mark);
    if (at == std::string_view::npos)
      return document_.fail(ErrorCode::bad_syntax, "a data URI in base64 is due here", place);
    auto bytes = from_base64(text.substr(at + mark.size()));
    if (!bytes) return document_.fail(ErrorCode::bad_syntax, "this is not base64", place);
    out = std::move(*bytes);
    return true;
  }

  if (!beside_)
    return document_.fail(ErrorCode::missing_file, "the file names another one, which cannot be read", place);
  auto bytes = beside_(without_escapes(text));
  if (!bytes) {
    Error error = bytes.error();
    if (error.where.empty()) error.where = place;
    return document_.fail(std::move(error));
  }
  out = std::move(bytes).value();
  return true;
}

}  // namespace quoin::io
