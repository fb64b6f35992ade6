/// \file
/// Meshes of a glTF: of each the triangles of all its primitives.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "io/mesh.h"
#include "io/packages/gltf/accessors.h"
#include "io/packages/gltf/document.h"

namespace quoin::io {

/// Reads meshes one by one; errors go to the document.
class GltfMeshes {
 public:
  GltfMeshes(GltfDocument& document, GltfAccessors& accessors) : document_(document), accessors_(accessors) {}

  /// The mesh as numbers that are exactly what the file states once they are divided as `placing` says.
  bool read(const Json& json, PolygonMesh& mesh, Placing& placing);

  /// What is passed over.
  std::vector<Notice> notices() const;

 private:
  bool primitive(const Json& json);
  bool corners(const Json& json, const GltfAccessor& points, std::vector<std::uint32_t>& out);
  bool append_points(const GltfAccessor& points, const std::string& place);

  GltfDocument& document_;
  GltfAccessors& accessors_;
  std::uint64_t materials_ = 0, attributes_ = 0, other_primitives_ = 0, targets_ = 0;

  // Of the mesh that is being read.
  PolygonMesh* mesh_ = nullptr;
  std::uint64_t divisor_ = 1;                     // of all its points
  std::map<std::uint64_t, std::uint32_t> known_;  // of accessors the first of their points
};

}  // namespace quoin::io
