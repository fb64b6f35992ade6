// glTF 2.0: as JSON, with buffers in data URIs or files beside it, and packed as GLB. Triangles alone are read.
#include <utility>

#include "io/formats.h"
#include "io/packages/assembly.h"
#include "io/packages/gltf/accessors.h"
#include "io/packages/gltf/container.h"
#include "io/packages/gltf/document.h"
#include "io/packages/gltf/meshes.h"
#include "io/packages/gltf/nodes.h"

namespace quoin::io {
namespace {

/// Every node with a mesh is an object where a root of the scene places it; errors go to the document.
bool read_gltf_scene(GltfDocument& document, std::optional<std::string_view> binary, const Beside& beside,
                     Scene& scene) {
  if (!document.check_header()) return false;

  GltfAccessors accessors(document, binary, beside);
  GltfMeshes meshes(document, accessors);
  std::vector<PlacedMesh> placed;
  for (const Json& json : document.items(document.root(), "meshes")) {
    placed.push_back({static_cast<std::uint32_t>(placed.size()), {}});
    if (!meshes.read(json, scene.meshes.emplace_back(), placed.back().placing)) return false;
  }

  GltfNodes nodes(document);
  std::vector<PlacedNode> roots;
  if (!nodes.read(placed) || !nodes.roots(roots)) return false;
  AssemblyWalk walk(nodes.nodes(), scene.meshes);
  for (const PlacedNode& root : roots) {
    const auto walked = walk.visit(root, [&](const AssemblyNode& node, PlacedMesh one) {
      scene.objects.push_back({node.name, {std::move(one)}});
    });
    if (!walked) return document.fail(walked.error());
  }

  scene.unit = Unit::meter;
  for (const auto& notices : {meshes.notices(), nodes.notices()})
    scene.notices.insert(scene.notices.end(), notices.begin(), notices.end());
  return true;
}

}  // namespace

bool looks_like_gltf(std::string_view bytes) {
  const std::size_t at = bytes.find_first_not_of(" \t\r\n");
  return at != std::string_view::npos && bytes[at] == '{';
}

Result<Scene> read_gltf(std::string_view bytes, const Beside& beside) {
  const auto chunks = gltf_chunks(bytes);
  if (!chunks) return chunks.error();
  auto root = read_json(chunks.value().json);
  if (!root) {
    Error error = root.error();
    error.code = ErrorCode::bad_syntax;
    return error;
  }

  GltfDocument document(std::move(root).value());
  Scene scene;
  if (!read_gltf_scene(document, chunks.value().binary, beside, scene)) return document.take_error();
  return scene;
}

}  // namespace quoin::io
