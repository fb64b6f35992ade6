// glTF 2.0: as JSON, with buffers in data URIs or files beside it, and packed as GLB. Triangles alone are read.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "io/formats.h"
#include "io/json.h"
#include "io/packages/assembly.h"
#include "io/scanner.h"
#include "io/text_output.h"

namespace quoin::io {
namespace {

constexpr std::string_view glb_magic = "glTF";
constexpr std::uint32_t json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;
/// Points and corners that meshes may come to together: they may share their arrays, so that the file does not bound
/// them.
constexpr std::uint64_t max_elements = std::uint64_t{1} << 27;

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

void append_word(std::string& out, std::uint32_t value) {
  for (int i = 0; i < 4; ++i) out.push_back(static_cast<char>(value >> (8 * i) & 0xff));
}

/// Of a GLB its two chunks, of other bytes all of them as JSON.
struct Chunks {
  std::string_view json;
  std::optional<std::string_view> binary;
};

Result<Chunks> chunks_of(std::string_view bytes) {
  const auto fault = [](ErrorCode code, const char* what, std::size_t at) {
    return Error{code, what, {}, "byte " + std::to_string(at)};
  };
  if (!bytes.starts_with(glb_magic)) return Chunks{bytes, {}};
  if (bytes.size() < 20) return fault(ErrorCode::truncated, "the file ends within its header", bytes.size());
  if (word_at(bytes, 4) != 2) return fault(ErrorCode::unknown_format, "only version 2 of glTF is read", 4);
  if (word_at(bytes, 8) > bytes.size()) return fault(ErrorCode::truncated, "the file is shorter than it says", 8);
  bytes = bytes.substr(0, word_at(bytes, 8));

  Chunks chunks;
  for (std::size_t at = 12; at < bytes.size();) {
    if (bytes.size() - at < 8) return fault(ErrorCode::truncated, "the file ends within the header of a chunk", at);
    const std::uint32_t size = word_at(bytes, at), kind = word_at(bytes, at + 4);
    if (size > bytes.size() - at - 8) return fault(ErrorCode::truncated, "the file ends within a chunk", at);
    const std::string_view chunk = bytes.substr(at + 8, size);
    if (at == 12 && kind != json_chunk) return fault(ErrorCode::bad_syntax, "the first chunk is no JSON", at);
    if (kind == json_chunk && at == 12) chunks.json = chunk;
    if (kind == binary_chunk && !chunks.binary) chunks.binary = chunk;
    at += 8 + std::size_t{size};
  }
  return chunks;
}

constexpr std::string_view base64_digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

std::optional<std::string> from_base64(std::string_view text) {
  while (text.ends_with('=')) text.remove_suffix(1);
  std::string out;
  out.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    const std::size_t digit = base64_digits.find(c);
    if (digit == std::string_view::npos) return std::nullopt;
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    out.push_back(static_cast<char>(bits >> count & 0xff));
  }
  return out;
}

std::string to_base64(std::string_view bytes) {
  std::string out;
  out.reserve(bytes.size() / 3 * 4 + 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      out.push_back(i + k > bytes.size() ? '=' : base64_digits[bits >> (18 - 6 * k) & 63]);
  }
  return out;
}

/// "a%20b" as "a b".
std::string unescaped(std::string_view uri) {
  const auto digit = [](char c) {
    return c >= '0' && c <= '9'   ? c - '0'
           : c >= 'a' && c <= 'f' ? c - 'a' + 10
           : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                  : -1;
  };
  std::string out;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const bool is_escape = uri[i] == '%' && i + 2 < uri.size() && digit(uri[i + 1]) >= 0 && digit(uri[i + 2]) >= 0;
    out.push_back(is_escape ? static_cast<char>(16 * digit(uri[i + 1]) + digit(uri[i + 2])) : uri[i]);
    if (is_escape) i += 2;
  }
  return out;
}

/// Bytes of a buffer in which elements stand.
struct Elements {
  std::string_view bytes;
  std::uint64_t count = 0, stride = 0;
  std::uint64_t component = 0;  // its type, by OpenGL's number
};

class GltfReader {
 public:
  GltfReader(Json root, std::optional<std::string_view> binary, const Beside& beside)
      : root_(std::move(root)), binary_(binary), beside_(beside) {}

  Result<Scene> read() {
    if (!header() || !meshes() || !nodes() || !scene()) return std::move(error_);
    note(materials_, "material", "materials");
    note(attributes_, "list of normals, colours or other attributes", "lists of normals, colours and other attributes");
    note(other_primitives_, "primitive of no triangles, or without positions",
         "primitives of no triangles, or without positions");
    note(targets_, "morph target", "morph targets");
    note(skins_, "skin", "skins");
    return std::move(scene_);
  }

 private:
  bool fail(ErrorCode code, std::string message, std::string where) {
    error_ = {code, std::move(message), {}, std::move(where)};
    return false;
  }
  bool fail(ErrorCode code, std::string message, const Json& at) { return fail(code, std::move(message), at.place()); }

  void note(std::uint64_t count, const char* one, const char* many) {
    if (count > 0) scene_.notices.push_back(passed_over(count, one, many));
  }

  // Values of the JSON.

  bool number(const Json& json, double& out) {
    if (json.kind != Json::Kind::number) return fail(ErrorCode::bad_number, "a number is due here", json);
    Scanner scanner(json.text);
    return scanner.number(out) ||
           fail(scanner.take_error().code, "this number is not finite in double precision", json);
  }

  /// A whole number of an object, or `fallback`; none without one is an error.
  bool count(const Json& object, std::string_view name, std::optional<std::uint64_t> fallback, std::uint64_t& out) {
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

  /// An entry of a list of the root by its number.
  bool entry(std::string_view list, std::uint64_t index, const Json& named_at, const Json*& out) {
    const Json* found = root_.member(list);
    if (found == nullptr || found->kind != Json::Kind::list || index >= found->items.size())
      return fail(ErrorCode::bad_index,
                  "there is no entry " + std::to_string(index) + " of \"" + std::string(list) + "\"", named_at);
    out = &found->items[index];
    return true;
  }

  const std::vector<Json>& items(const Json& object, std::string_view name) const {
    static const auto& none = *new std::vector<Json>;
    const Json* found = object.member(name);
    return found == nullptr ? none : found->items;
  }

  std::string name_of(const Json& object) const {
    const Json* name = object.member("name");
    return name == nullptr ? "" : name->text;
  }

  bool header() {
    const Json* asset = root_.member("asset");
    const Json* version = asset == nullptr ? nullptr : asset->member("version");
    if (version == nullptr || !version->text.starts_with("2"))
      return fail(ErrorCode::unknown_format, "this is no glTF of version 2", root_);
    for (const Json& name : items(root_, "extensionsRequired")) {
      const std::string_view word = name.text;
      const bool is_looks = word.starts_with("KHR_materials_") || word.starts_with("KHR_texture_") ||
                            word.starts_with("EXT_texture_") || word.starts_with("KHR_lights_");
      if (!is_looks)
        return fail(ErrorCode::unknown_format, "the file requires the extension " + name.text + ", which is not read",
                    name);
    }
    return true;
  }

  // Buffers.

  bool buffer(std::uint64_t index, const Json& named_at, std::string_view& out) {
    const auto known = buffers_.find(index);
    if (known != buffers_.end()) {
      out = known->second;
      return true;
    }
    const Json* json = nullptr;
    std::uint64_t size = 0;
    if (!entry("buffers", index, named_at, json) || !count(*json, "byteLength", {}, size)) return false;

    const Json* uri = json->member("uri");
    if (uri == nullptr) {
      if (index != 0 || !binary_) return fail(ErrorCode::truncated, "the file lacks the bytes of this buffer", *json);
      out = *binary_;
    } else {
      if (!load(*uri, buffers_owned_[index])) return false;
      out = buffers_owned_[index];
    }
    if (out.size() < size) return fail(ErrorCode::truncated, "the buffer is shorter than it says", *json);
    out = out.substr(0, size);
    buffers_.emplace(index, out);
    return true;
  }

  bool load(const Json& uri, std::string& out) {
    const std::string_view text = uri.text;
    if (!text.starts_with("data:")) {
      if (!beside_) return fail(ErrorCode::missing_file, "the file names another one, which cannot be read", uri);
      auto bytes = beside_(unescaped(text));
      if (!bytes) {
        error_ = bytes.error();
        if (error_.where.empty()) error_.where = uri.place();
        return false;
      }
      out = std::move(bytes).value();
      return true;
    }
    const std::size_t at = text.find(";base64,");
    if (at == std::string_view::npos) return fail(ErrorCode::bad_syntax, "a data URI in base64 is due here", uri);
    auto bytes = from_base64(text.substr(at + 8));
    if (!bytes) return fail(ErrorCode::bad_syntax, "this is not base64", uri);
    out = std::move(*bytes);
    return true;
  }

  static std::uint64_t size_of(std::uint64_t component) {
    return component == 5125 || component == 5126 ? 4 : component == 5123 ? 2 : component == 5121 ? 1 : 0;
  }

  /// The elements of an accessor, all within its view and buffer.
  bool accessor(std::uint64_t index, const Json& named_at, std::string_view type, Elements& out) {
    const Json *json = nullptr, *view = nullptr;
    std::uint64_t view_index = 0, offset = 0, begin = 0, size = 0, buffer_index = 0;
    if (!entry("accessors", index, named_at, json)) return false;
    if (json->member("sparse") != nullptr || json->member("bufferView") == nullptr)
      return fail(ErrorCode::bad_syntax, "sparse accessors, and those without a bufferView, are not read", *json);
    const Json* kind = json->member("type");
    if (kind == nullptr || kind->text != type)
      return fail(ErrorCode::bad_syntax, "an accessor of " + std::string(type) + " is due here", *json);
    if (!count(*json, "bufferView", {}, view_index) || !count(*json, "byteOffset", 0, offset) ||
        !count(*json, "componentType", {}, out.component) || !count(*json, "count", {}, out.count) ||
        !entry("bufferViews", view_index, *json, view) || !count(*view, "buffer", {}, buffer_index) ||
        !count(*view, "byteOffset", 0, begin) || !count(*view, "byteLength", {}, size))
      return false;

    const std::uint64_t element = size_of(out.component) * (type == "VEC3" ? 3 : 1);
    if (!count(*view, "byteStride", element, out.stride)) return false;
    if (element == 0 || (type == "VEC3" && out.component != 5126) || (type != "VEC3" && out.component == 5126))
      return fail(ErrorCode::bad_syntax, "positions are floats, and indices unsigned integers", *json);
    if (out.stride < element || out.stride > 252)
      return fail(ErrorCode::bad_syntax, "the stride is less than an element, or more than 252", *view);

    std::string_view bytes;
    if (!buffer(buffer_index, *view, bytes)) return false;
    if (begin > bytes.size() || size > bytes.size() - begin)
      return fail(ErrorCode::absurd_count, "the view is longer than its buffer", *view);
    if (out.count == 0) return true;
    if (offset > size || out.count > max_count || (out.count - 1) * out.stride + element > size - offset)
      return fail(ErrorCode::absurd_count, "the accessor is longer than its view", *json);
    elements_ += out.count;
    if (elements_ > max_elements)
      return fail(ErrorCode::absurd_count, "meshes have more than " + std::to_string(max_elements) + " elements",
                  *json);
    out.bytes = bytes.substr(begin + offset, size - offset);
    return true;
  }

  // Meshes.

  bool meshes() {
    for (const Json& json : items(root_, "meshes")) {
      PolygonMesh& mesh = scene_.meshes.emplace_back();
      targets_ += json.member("weights") != nullptr ? 1 : 0;
      std::map<std::uint64_t, std::uint32_t> known;  // of accessors the first of their points
      for (const Json& primitive : items(json, "primitives"))
        if (!read_primitive(primitive, mesh, known)) return false;
    }
    return true;
  }

  bool read_primitive(const Json& json, PolygonMesh& mesh, std::map<std::uint64_t, std::uint32_t>& known) {
    std::uint64_t mode = 0, position = 0, indices = 0;
    if (!count(json, "mode", 4, mode)) return false;
    const Json* attributes = json.member("attributes");
    const bool has_positions = attributes != nullptr && attributes->member("POSITION") != nullptr;
    if (mode < 4 || mode > 6 || !has_positions) {
      ++other_primitives_;
      return true;
    }
    materials_ += json.member("material") != nullptr ? 1 : 0;
    attributes_ += attributes->members.size() - 1;
    if (!count(*attributes, "POSITION", {}, position)) return false;

    // Primitives of one mesh often share their points.
    Elements points;
    if (!accessor(position, *attributes, "VEC3", points)) return false;
    const auto [first, is_new] = known.emplace(position, static_cast<std::uint32_t>(mesh.points.size() / 3));
    if (is_new && !append_points(points, position, mesh)) return false;

    std::vector<std::uint32_t> corners;
    if (json.member("indices") != nullptr) {
      Elements elements;
      if (!count(json, "indices", {}, indices) || !accessor(indices, json, "SCALAR", elements)) return false;
      for (std::uint64_t i = 0; i < elements.count; ++i) {
        const std::uint32_t index = index_at(elements, i);
        if (index >= points.count)
          return fail(ErrorCode::bad_index, "index " + std::to_string(i) + " names a vertex that does not exist",
                      "accessor " + std::to_string(indices));
        corners.push_back(index);
      }
    } else {
      for (std::uint64_t i = 0; i < points.count; ++i) corners.push_back(static_cast<std::uint32_t>(i));
    }
    if (mode == 4 && corners.size() % 3 != 0)
      return fail(ErrorCode::bad_syntax, "the number of corners of triangles is not a multiple of 3", json);
    append_triangles(mode, corners, first->second, mesh);
    return true;
  }

  bool append_points(const Elements& points, std::uint64_t accessor, PolygonMesh& mesh) {
    for (std::uint64_t i = 0; i < points.count; ++i)
      for (std::uint64_t k = 0; k < 3; ++k) {
        const double value = std::bit_cast<float>(word_at(points.bytes, i * points.stride + 4 * k));
        if (!std::isfinite(value))
          return fail(ErrorCode::non_finite, "the position of vertex " + std::to_string(i) + " is not finite",
                      "accessor " + std::to_string(accessor));
        mesh.points.push_back(value);
      }
    return true;
  }

  static std::uint32_t index_at(const Elements& elements, std::uint64_t i) {
    std::uint32_t value = 0;
    for (std::uint64_t k = size_of(elements.component); k-- > 0;)
      value = value << 8 | static_cast<unsigned char>(elements.bytes[i * elements.stride + k]);
    return value;
  }

  /// Of strips every second triangle is turned round, so that all look to one side.
  static void append_triangles(std::uint64_t mode, const std::vector<std::uint32_t>& corners, std::uint32_t first,
                               PolygonMesh& mesh) {
    const std::size_t step = mode == 4 ? 3 : 1;
    for (std::size_t i = 0; i + 2 < corners.size(); i += step) {
      std::array<std::size_t, 3> at = {i, i + 1, i + 2};
      if (mode == 5 && i % 2 == 1) std::swap(at[1], at[2]);
      if (mode == 6) at[0] = 0;
      for (const std::size_t k : at) mesh.corners.push_back(first + corners[k]);
      mesh.starts.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
    }
  }

  // Nodes.

  bool nodes() {
    const auto& list = items(root_, "nodes");
    for (const Json& json : list) {
      AssemblyNode& node = nodes_.emplace_back();
      node.name = name_of(json);
      node.place = json.place();
      skins_ += json.member("skin") != nullptr ? 1 : 0;
      if (!placing(json, placings_.emplace_back())) return false;
      if (json.member("mesh") == nullptr) continue;
      std::uint64_t mesh = 0;
      const Json* found = nullptr;
      if (!count(json, "mesh", {}, mesh) || !entry("meshes", mesh, json, found)) return false;
      node.meshes = {static_cast<std::uint32_t>(mesh)};
      if (node.name.empty()) node.name = name_of(*found);
    }
    is_child_.assign(list.size(), false);
    for (std::size_t i = 0; i < list.size(); ++i)
      if (!children(list[i], "children", nodes_[i].children)) return false;
    return true;
  }

  /// Nodes by their numbers, each with its own placing.
  bool children(const Json& json, std::string_view name, std::vector<PlacedNode>& out) {
    for (const Json& item : items(json, name)) {
      double index = 0;
      if (!number(item, index)) return false;
      if (!(index >= 0 && index < static_cast<double>(nodes_.size())))
        return fail(ErrorCode::bad_index, "there is no node of this number", item);
      const auto node = static_cast<std::uint32_t>(index);
      is_child_[node] = true;
      out.push_back({node, placings_[node]});
    }
    return true;
  }

  template <std::size_t N>
  bool numbers(const Json& json, std::string_view name, std::array<double, N>& out) {
    const Json* list = json.member(name);
    if (list == nullptr) return true;
    if (list->items.size() != N)
      return fail(ErrorCode::bad_syntax, "\"" + std::string(name) + "\" has " + std::to_string(N) + " numbers", *list);
    for (std::size_t i = 0; i < N; ++i)
      if (!number(list->items[i], out[i])) return false;
    return true;
  }

  /// A matrix, column by column; or scale, then rotation, then translation.
  bool placing(const Json& json, Placing& out) {
    std::array<double, 16> columns = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    std::array<double, 3> scale = {1, 1, 1}, shift = {0, 0, 0};
    std::array<double, 4> rotation = {0, 0, 0, 1};
    if (!numbers(json, "matrix", columns) || !numbers(json, "scale", scale) || !numbers(json, "rotation", rotation) ||
        !numbers(json, "translation", shift))
      return false;
    if (columns[3] != 0 || columns[7] != 0 || columns[11] != 0 || columns[15] != 1)
      return fail(ErrorCode::bad_syntax, "the last row of a matrix is 0 0 0 1", json);

    MatrixStep matrix, scaling = identity_step, translation = identity_step;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 4; ++j) matrix.rows[4 * i + j] = columns[4 * j + i];
      scaling.rows[5 * i] = scale[i];
      translation.rows[4 * i + 3] = shift[i];
    }
    if (matrix != identity_step) out.emplace_back(matrix);
    if (scaling != identity_step) out.emplace_back(scaling);
    if (rotation != std::array<double, 4>{0, 0, 0, 1}) out.emplace_back(QuaternionStep{rotation});
    if (translation != identity_step) out.emplace_back(translation);
    return true;
  }

  /// The nodes of the scene that the file shows, or of all trees where it has no scene: each with a mesh is an object.
  bool scene() {
    std::vector<PlacedNode> roots;
    if (!items(root_, "scenes").empty()) {
      std::uint64_t index = 0;
      const Json* json = nullptr;
      if (!count(root_, "scene", 0, index) || !entry("scenes", index, root_, json) || !children(*json, "nodes", roots))
        return false;
    } else {
      for (std::uint32_t i = 0; i < nodes_.size(); ++i)
        if (!is_child_[i]) roots.push_back({i, placings_[i]});
    }

    AssemblyWalk walk(nodes_, scene_.meshes);
    for (const PlacedNode& root : roots) {
      const auto walked = walk.visit(root, [&](const AssemblyNode& node, PlacedMesh placed) {
        scene_.objects.push_back({node.name, {std::move(placed)}});
      });
      if (walked) continue;
      error_ = walked.error();
      return false;
    }
    scene_.unit = Unit::meter;
    return true;
  }

  Json root_;
  std::optional<std::string_view> binary_;
  const Beside& beside_;
  std::map<std::uint64_t, std::string> buffers_owned_;
  std::map<std::uint64_t, std::string_view> buffers_;
  std::vector<AssemblyNode> nodes_;
  std::vector<Placing> placings_;
  std::vector<bool> is_child_;
  Scene scene_;
  Error error_;
  std::uint64_t elements_ = 0;
  std::uint64_t materials_ = 0, attributes_ = 0, other_primitives_ = 0, targets_ = 0, skins_ = 0;
};

/// Positions as float32, then indices.
std::string buffer_of(std::span<const double> points, std::span<const std::uint32_t> triangles) {
  std::string out;
  out.reserve(4 * (points.size() + triangles.size()));
  for (const double v : points) append_word(out, std::bit_cast<std::uint32_t>(static_cast<float>(v)));
  for (const std::uint32_t index : triangles) append_word(out, index);
  return out;
}

/// Metres of a unit; glTF has no other.
std::string_view scale_of(Unit unit) {
  switch (unit) {
    case Unit::micron:
      return "0.000001";
    case Unit::millimeter:
      return "0.001";
    case Unit::centimeter:
      return "0.01";
    case Unit::inch:
      return "0.0254";
    case Unit::foot:
      return "0.3048";
    case Unit::none:
    case Unit::meter:
      break;
  }
  return {};
}

/// The least or greatest coordinates, as float32 has them.
std::string corner_of(std::span<const double> points, bool is_low) {
  std::string out;
  for (std::size_t k = 0; k < 3; ++k) {
    double best = points[k];
    for (std::size_t i = k; i < points.size(); i += 3)
      best = is_low ? std::min(best, points[i]) : std::max(best, points[i]);
    if (k > 0) out.push_back(',');
    append_number(out, static_cast<double>(static_cast<float>(best)));
  }
  return out;
}

/// `uri`: of the buffer; empty where it is a chunk.
std::string json_of(std::span<const double> points, std::span<const std::uint32_t> triangles, Unit unit,
                    std::string_view uri) {
  std::string out = R"({"asset":{"version":"2.0","generator":"quoin"},"scene":0,"scenes":[{)";
  if (triangles.empty()) return out + "}]}";
  const std::string scale(scale_of(unit)), position_size = std::to_string(4 * points.size()),
                                           index_size = std::to_string(4 * triangles.size());
  out += R"("nodes":[0]}],"nodes":[{"mesh":0)";
  if (!scale.empty()) out += R"(,"scale":[)" + scale + "," + scale + "," + scale + "]";
  out += R"(}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"buffers":[{"byteLength":)";
  out += std::to_string(4 * (points.size() + triangles.size()));
  if (!uri.empty()) out.append(R"(,"uri":")").append(uri).append("\"");
  out += R"(}],"bufferViews":[{"buffer":0,"byteLength":)" + position_size;
  out += R"(,"target":34962},{"buffer":0,"byteOffset":)" + position_size + R"(,"byteLength":)" + index_size;
  out += R"(,"target":34963}],"accessors":[{"bufferView":0,"componentType":5126,"count":)";
  out += std::to_string(points.size() / 3) + R"(,"type":"VEC3","min":[)" + corner_of(points, true) + R"(],"max":[)" +
         corner_of(points, false) + R"(]},{"bufferView":1,"componentType":5125,"count":)";
  return out + std::to_string(triangles.size()) + R"(,"type":"SCALAR"}]})";
}

}  // namespace

bool looks_like_glb(std::string_view bytes) { return bytes.starts_with(glb_magic); }

bool looks_like_gltf(std::string_view bytes) {
  const std::size_t at = bytes.find_first_not_of(" \t\r\n");
  return at != std::string_view::npos && bytes[at] == '{';
}

Result<Scene> read_gltf(std::string_view bytes, const Beside& beside) {
  const auto chunks = chunks_of(bytes);
  if (!chunks) return chunks.error();
  auto root = read_json(chunks.value().json);
  if (root) return GltfReader(std::move(root).value(), chunks.value().binary, beside).read();
  Error error = root.error();
  error.code = ErrorCode::bad_syntax;
  return error;
}

std::string write_glb(std::span<const double> points, std::span<const std::uint32_t> triangles, Unit unit) {
  std::string json = json_of(points, triangles, unit, {});
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::string buffer = triangles.empty() ? std::string() : buffer_of(points, triangles);

  std::string out(glb_magic);
  append_word(out, 2);
  append_word(out, static_cast<std::uint32_t>(12 + 8 + json.size() + (buffer.empty() ? 0 : 8 + buffer.size())));
  append_word(out, static_cast<std::uint32_t>(json.size()));
  append_word(out, json_chunk);
  out += json;
  if (buffer.empty()) return out;
  append_word(out, static_cast<std::uint32_t>(buffer.size()));
  append_word(out, binary_chunk);
  return out + buffer;
}

std::string write_gltf(std::span<const double> points, std::span<const std::uint32_t> triangles, Unit unit) {
  return json_of(points, triangles, unit,
                 "data:application/octet-stream;base64," + to_base64(buffer_of(points, triangles))) +
         "\n";
}

}  // namespace quoin::io
