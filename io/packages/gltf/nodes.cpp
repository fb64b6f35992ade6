#include "io/packages/gltf/nodes.h"

#include <array>

namespace quoin::io {
namespace {

/// Each of its lists places the mesh of a node many times.
constexpr std::string_view instancing = "EXT_mesh_gpu_instancing";

}  // namespace

bool GltfNodes::read(const std::vector<PlacedMesh>& meshes) {
  const auto& list = document_.items(document_.root(), "nodes");
  for (const Json& json : list)
    if (!node(json, meshes)) return false;
  is_child_.assign(list.size(), false);
  for (std::size_t i = 0; i < list.size(); ++i)
    if (!children(list[i], "children", nodes_[i].children)) return false;
  return true;
}

bool GltfNodes::roots(std::vector<PlacedNode>& out) {
  const Json& root = document_.root();
  if (!document_.items(root, "scenes").empty()) {
    std::uint64_t index = 0;
    const Json* scene = nullptr;
    return document_.count(root, "scene", 0, index) && document_.entry("scenes", index, root.place(), scene) &&
           children(*scene, "nodes", out);
  }
  for (std::uint32_t i = 0; i < nodes_.size(); ++i)
    if (!is_child_[i]) out.push_back({i, placings_[i]});
  return true;
}

std::vector<Notice> GltfNodes::notices() const {
  std::vector<Notice> list;
  if (skins_ > 0) list.push_back(passed_over(skins_, "skin", "skins"));
  if (instances_ > 0) list.push_back(passed_over(instances_, "list of instances", "lists of instances"));
  return list;
}

bool GltfNodes::node(const Json& json, const std::vector<PlacedMesh>& meshes) {
  AssemblyNode& made = nodes_.emplace_back();
  made.name = document_.name_of(json);
  made.place = json.place();
  skins_ += json.member("skin") != nullptr ? 1 : 0;
  const Json* extensions = json.member("extensions");
  instances_ += extensions != nullptr && extensions->member(instancing) != nullptr ? 1 : 0;
  if (!placing(json, placings_.emplace_back())) return false;
  if (json.member("mesh") == nullptr) return true;

  std::uint64_t number = 0;
  const Json* mesh = nullptr;
  if (!document_.count(json, "mesh", {}, number) || !document_.entry("meshes", number, json.place(), mesh))
    return false;
  made.meshes = {meshes[number]};
  if (made.name.empty()) made.name = document_.name_of(*mesh);
  return true;
}

/// A matrix, column by column; or scale, then rotation, then translation.
bool GltfNodes::placing(const Json& json, Placing& out) {
  std::array<double, 16> columns = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  std::array<double, 3> scale = {1, 1, 1}, shift = {0, 0, 0};
  std::array<double, 4> rotation = {0, 0, 0, 1};
  if (!document_.numbers(json, "matrix", columns) || !document_.numbers(json, "scale", scale) ||
      !document_.numbers(json, "rotation", rotation) || !document_.numbers(json, "translation", shift))
    return false;
  if (columns[3] != 0 || columns[7] != 0 || columns[11] != 0 || columns[15] != 1)
    return document_.fail(ErrorCode::bad_syntax, "the last row of a matrix is 0 0 0 1", json);

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

/// Nodes by their numbers, each with its own placing.
bool GltfNodes::children(const Json& json, std::string_view name, std::vector<PlacedNode>& out) {
  for (const Json& item : document_.items(json, name)) {
    double index = 0;
    if (!document_.number(item, index)) return false;
    if (!(index >= 0 && index < static_cast<double>(nodes_.size())))
      return document_.fail(ErrorCode::bad_index, "there is no node of this number", item);
    const auto node = static_cast<std::uint32_t>(index);
    is_child_[node] = true;
    out.push_back({node, placings_[node]});
  }
  return true;
}

}  // namespace quoin::io
