/// \file
/// Numbers of a glTF: accessors, which see through views into buffers, and may replace some of what they see.
#pragma once

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/mesh.h"
#include "io/packages/gltf/bytes.h"
#include "io/packages/gltf/document.h"

namespace quoin::io {

/// What points and corners of all meshes may come to together: meshes may share their arrays, so that the file does
/// not bound them. And of them those that no buffer holds.
inline constexpr std::uint64_t max_elements = std::uint64_t{1} << 27, max_unstored = std::uint64_t{1} << 20;

/// The type of a component.
struct GltfComponent {
  std::uint32_t code = 0;  // OpenGL's number
  std::uint32_t size = 0;
  bool is_float = false, is_signed = false;
  /// What stands for 1 in normalised integers.
  std::uint32_t largest = 1;
};

/// Elements in bytes; all of them are there.
struct GltfElements {
  std::string_view bytes;
  std::uint64_t count = 0, stride = 0, width = 1;
  GltfComponent component;

  /// A component as it stands, an integer or a float32, which may be no number.
  double at(std::uint64_t element, std::uint64_t k) const {
    assert(element < count && k < width);
    const std::uint32_t bits = little_endian_at(bytes, element * stride + k * component.size, component.size);
    if (component.is_float) return std::bit_cast<float>(bits);
    const std::uint32_t sign = component.is_signed ? std::uint32_t{1} << (8 * component.size - 1) : 0;
    return static_cast<double>(bits) - ((bits & sign) != 0 ? 2.0 * sign : 0.0);
  }
};

/// What an accessor sees: the elements of a view, or zeros; then some of them replaced.
struct GltfAccessor {
  std::uint64_t count = 0;
  GltfElements stored;  // none: zeros
  std::vector<std::uint32_t> replaced = {};
  GltfElements replacements = {};
  /// By which every number is to be divided; 1 but for normalised integers.
  std::uint32_t divisor = 1;

  /// Calls put(element, component, value) for everything that is not zero from the beginning; the last value counts.
  template <class Put>
  void for_each(Put put) const {
    for (std::uint64_t i = 0; i < stored.count; ++i)
      for (std::uint64_t k = 0; k < stored.width; ++k) put(i, k, value(stored, i, k));
    for (std::uint64_t i = 0; i < replaced.size(); ++i)
      for (std::uint64_t k = 0; k < replacements.width; ++k) put(replaced[i], k, value(replacements, i, k));
  }

 private:
  /// Normalised integers are not below -1.
  double value(const GltfElements& elements, std::uint64_t i, std::uint64_t k) const {
    const double stands = elements.at(i, k);
    return divisor > 1 ? std::max(stands, -static_cast<double>(divisor)) : stands;
  }
};

/// Buffers are read when they are asked for, each once. Errors have the accessor, view or buffer as their place:
/// "bad-index", "bad-syntax", "bad-number", "absurd-count" (more than there is, more than the limits above),
/// "truncated", "unknown-format" (compressed), "missing-file", those of `beside`.
class GltfAccessors {
 public:
  GltfAccessors(GltfDocument& document, std::optional<std::string_view> binary, const Beside& beside)
      : document_(document), binary_(binary), beside_(beside) {}

  /// Points: of float32, or quantised to bytes or shorts.
  bool points(std::uint64_t index, const std::string& named_at, GltfAccessor& out);
  /// Unsigned integers.
  bool indices(std::uint64_t index, const std::string& named_at, GltfAccessor& out);

 private:
  bool accessor(std::uint64_t index, const std::string& named_at, std::string_view type, GltfAccessor& out);
  bool sparse(const Json& json, const std::string& place, GltfAccessor& out);
  bool count_elements(const Json& json, const std::string& place, std::uint64_t count);
  bool component(const Json& json, const std::string& place, GltfComponent& out);
  bool elements(const Json& json, const std::string& place, GltfElements& out);
  bool buffer(std::uint64_t index, const std::string& named_at, std::string_view& out);
  bool load(const Json& uri, const std::string& place, std::string& out);

  GltfDocument& document_;
  std::optional<std::string_view> binary_;
  const Beside& beside_;
  std::map<std::uint64_t, std::string> owned_;
  std::map<std::uint64_t, std::string_view> buffers_;
  std::uint64_t elements_ = 0, unstored_ = 0;
};

}  // namespace quoin::io
