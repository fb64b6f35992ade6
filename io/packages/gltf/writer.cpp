// glTF as it is written: one mesh, positions as float32 and indices of 32 bits in one buffer.
#include <algorithm>
#include <bit>

#include "io/formats.h"
#include "io/packages/gltf/bytes.h"
#include "io/packages/gltf/container.h"
#include "io/packages/gltf/uri.h"
#include "io/text_output.h"

namespace quoin::io {
namespace {

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

std::string write_glb(std::span<const double> points, std::span<const std::uint32_t> triangles, Unit unit) {
  return packed_glb(json_of(points, triangles, unit, {}), triangles.empty() ? "" : buffer_of(points, triangles));
}

std::string write_gltf(std::span<const double> points, std::span<const std::uint32_t> triangles, Unit unit) {
  return json_of(points, triangles, unit,
                 "data:application/octet-stream;base64," + to_base64(buffer_of(points, triangles))) +
         "\n";
}

}  // namespace quoin::io
