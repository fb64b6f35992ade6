#include "io/packages/gltf/meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

namespace quoin::io {
namespace {

/// Modes of primitives that are read.
constexpr std::uint64_t triangle_list = 4, triangle_strip = 5, triangle_fan = 6;

/// Of strips every second triangle is turned round, so that all look to one side.
void append_triangles(std::uint64_t mode, const std::vector<std::uint32_t>& corners, std::uint32_t first,
                      PolygonMesh& mesh) {
  const std::size_t step = mode == triangle_list ? 3 : 1;
  for (std::size_t i = 0; i + 2 < corners.size(); i += step) {
    std::array<std::size_t, 3> at = {i, i + 1, i + 2};
    if (mode == triangle_strip && i % 2 == 1) std::swap(at[1], at[2]);
    if (mode == triangle_fan) at[0] = 0;
    for (const std::size_t k : at) mesh.corners.push_back(first + corners[k]);
    mesh.starts.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
  }
}

/// Multiplies numbers; false where a product is no double.
bool multiply_exactly(std::span<double> numbers, double factor) {
  for (double& number : numbers) {
    const double product = number * factor;
    if (std::fma(number, factor, -product) != 0) return false;
    number = product;
  }
  return true;
}

}  // namespace

bool GltfMeshes::read(const Json& json, PolygonMesh& mesh, Placing& placing) {
  mesh_ = &mesh;
  divisor_ = 1;
  known_.clear();
  for (const Json& item : document_.items(json, "primitives"))
    if (!primitive(item)) return false;
  if (divisor_ > 1) placing = {DivisionStep{static_cast<double>(divisor_)}};
  return true;
}

std::vector<Notice> GltfMeshes::notices() const {
  std::vector<Notice> list;
  const auto note = [&](std::uint64_t count, const char* one, const char* many) {
    if (count > 0) list.push_back(passed_over(count, one, many));
  };
  note(materials_, "material", "materials");
  note(attributes_, "list of normals, colours or other attributes", "lists of normals, colours and other attributes");
  note(other_primitives_, "primitive of no triangles, or without positions",
       "primitives of no triangles, or without positions");
  note(targets_, "morph target", "morph targets");
  return list;
}

bool GltfMeshes::primitive(const Json& json) {
  std::uint64_t mode = 0, position = 0;
  if (!document_.count(json, "mode", triangle_list, mode)) return false;
  const Json* attributes = json.member("attributes");
  const bool has_positions = attributes != nullptr && attributes->member("POSITION") != nullptr;
  if (mode < triangle_list || mode > triangle_fan || !has_positions) {
    ++other_primitives_;
    return true;
  }
  materials_ += json.member("material") != nullptr ? 1 : 0;
  attributes_ += attributes->members.size() - 1;
  targets_ += document_.items(json, "targets").size();
  if (!document_.count(*attributes, "POSITION", {}, position)) return false;

  // Primitives of one mesh often share their points.
  GltfAccessor points;
  if (!accessors_.points(position, attributes->place(), points)) return false;
  const std::string_view compression = compression_of(json);
  if (points.stored.count == 0 && !compression.empty())
    return document_.fail(ErrorCode::unknown_format, unread_extension(compression), json);
  const auto [first, is_new] = known_.emplace(position, static_cast<std::uint32_t>(mesh_->points.size() / 3));
  if (is_new && !append_points(points, numbered("accessor", position))) return false;

  std::vector<std::uint32_t> list;
  if (!corners(json, points, list)) return false;
  if (mode == triangle_list && list.size() % 3 != 0)
    return document_.fail(ErrorCode::bad_syntax, "the number of corners of triangles is not a multiple of 3", json);
  append_triangles(mode, list, first->second, *mesh_);
  return true;
}

/// Numbers of points; without indices each point is a corner.
bool GltfMeshes::corners(const Json& json, const GltfAccessor& points, std::vector<std::uint32_t>& out) {
  if (json.member("indices") == nullptr) {
    out.resize(points.count);
    std::iota(out.begin(), out.end(), std::uint32_t{0});
    return true;
  }
  std::uint64_t number = 0;
  GltfAccessor indices;
  if (!document_.count(json, "indices", {}, number) || !accessors_.indices(number, json.place(), indices)) return false;

  out.resize(indices.count);
  indices.for_each([&](std::uint64_t i, std::uint64_t, double value) { out[i] = static_cast<std::uint32_t>(value); });
  const auto wrong = std::find_if(out.begin(), out.end(), [&](std::uint32_t index) { return index >= points.count; });
  if (wrong == out.end()) return true;
  return document_.fail(ErrorCode::bad_index,
                        "index " + std::to_string(wrong - out.begin()) + " names a vertex that does not exist",
                        numbered("accessor", number));
}

/// Points whose divisors differ get the least common one.
bool GltfMeshes::append_points(const GltfAccessor& points, const std::string& place) {
  auto& all = mesh_->points;
  const std::size_t begin = all.size();
  all.resize(begin + 3 * points.count);
  const std::span<double> known(all.data(), begin), fresh(all.data() + begin, 3 * points.count);
  points.for_each([&](std::uint64_t i, std::uint64_t k, double value) { fresh[3 * i + k] = value; });

  const auto wrong = std::find_if(fresh.begin(), fresh.end(), [](double v) { return !std::isfinite(v); });
  if (wrong != fresh.end())
    return document_.fail(ErrorCode::non_finite,
                          "the position of vertex " + std::to_string((wrong - fresh.begin()) / 3) + " is not finite",
                          place);

  // Law: at most lcm(127, 255, 32767, 65535) < 2^38. So integers of 16 bits always fit; float32 where not all of these
  // stand beside it.
  const std::uint64_t common = std::lcm(divisor_, std::uint64_t{points.divisor});
  const double factor = static_cast<double>(common / divisor_), own = static_cast<double>(common / points.divisor);
  divisor_ = common;
  return (multiply_exactly(known, factor) && multiply_exactly(fresh, own)) ||
         document_.fail(ErrorCode::bad_syntax,
                        "the primitives of the mesh quantise positions in ways that no double holds together", place);
}

}  // namespace quoin::io
