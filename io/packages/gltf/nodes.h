/// \file
/// Nodes of a glTF, and the scene that they make.
#pragma once

#include <string_view>
#include <vector>

#include "io/packages/assembly.h"
#include "io/packages/gltf/document.h"

namespace quoin::io {

/// Errors go to the document.
class GltfNodes {
 public:
  explicit GltfNodes(GltfDocument& document) : document_(document) {}

  /// All nodes, with the meshes that they name: `meshes` by their numbers.
  bool read(const std::vector<PlacedMesh>& meshes);
  /// The roots of the scene that the file shows, or of all trees where it has no scene.
  bool roots(std::vector<PlacedNode>& out);

  const std::vector<AssemblyNode>& nodes() const { return nodes_; }
  /// What is passed over.
  std::vector<Notice> notices() const;

 private:
  bool node(const Json& json, const std::vector<PlacedMesh>& meshes);
  bool placing(const Json& json, Placing& out);
  bool children(const Json& json, std::string_view name, std::vector<PlacedNode>& out);

  GltfDocument& document_;
  std::vector<AssemblyNode> nodes_;
  std::vector<Placing> placings_;
  std::vector<bool> is_child_;
  std::uint64_t skins_ = 0, instances_ = 0;
};

}  // namespace quoin::io
