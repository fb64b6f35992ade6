/// \file
/// Laws of files of several objects: they are refused with a sentence and a place, or they are scenes whose meshes can
/// be placed.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "api/doors/placed.h"
#include "fuzz/law.h"
#include "io/mesh.h"

namespace quoin::fuzz {

inline bool is_valid(const io::PolygonMesh& mesh) {
  if (mesh.points.size() % 3 != 0 || mesh.starts.empty() || mesh.starts.front() != 0) return false;
  if (mesh.starts.back() != mesh.corners.size()) return false;
  for (std::size_t i = 0; i + 1 < mesh.starts.size(); ++i)
    if (mesh.starts[i + 1] < mesh.starts[i] + 3) return false;
  return std::all_of(mesh.points.begin(), mesh.points.end(), [](double v) { return std::isfinite(v); }) &&
         std::all_of(mesh.corners.begin(), mesh.corners.end(), [&](auto i) { return i < mesh.points.size() / 3; });
}

/// Files beside the one that is read are not there.
inline void require_scene_or_refusal(std::string_view bytes, Format format) {
  const auto scene = io::read_scene(bytes, format, [](const std::string& name) -> Result<std::string> {
    return Error{ErrorCode::missing_file, "not there", {}, name};
  });
  if (!scene) {
    const std::string text(bytes);
    if (scene.error().message.empty() || scene.error().where.empty())
      fail("a refusal has a sentence and a place", text);
    return;
  }

  const io::Scene& value = scene.value();
  require(std::all_of(value.meshes.begin(), value.meshes.end(), is_valid), "what is read is a mesh");
  constexpr std::size_t enough = 64;
  std::size_t placed_count = 0;
  for (const io::Object& object : value.objects)
    for (const io::PlacedMesh& one : object.meshes) {
      require(one.mesh < value.meshes.size(), "a placed mesh is one of the scene");
      if (++placed_count > enough) return;
      const auto map = map_of(one.placing);
      if (!map) continue;
      const auto image = placed_mesh(value.meshes[one.mesh], map.value());
      require(!image || is_valid(image.value()), "a placed mesh is a mesh");
    }
}

}  // namespace quoin::fuzz
