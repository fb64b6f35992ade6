/// \file
/// Meshes that are placed by a graph, as 3MF, glTF and AMF do: nodes that hold meshes and place other nodes.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "io/mesh.h"

namespace quoin::io {

struct AssemblyNode;

/// A node where it is placed.
struct PlacedNode {
  std::uint32_t node = 0;
  Placing placing = {};
};
struct AssemblyNode {
  std::string name;
  /// Where the file states it, for errors.
  std::string place;
  /// Their own steps act before those of the node.
  std::vector<PlacedMesh> meshes;
  std::vector<PlacedNode> children;
};

/// What placing may come to: levels, visits of nodes, and corners of all placed meshes together.
inline constexpr std::size_t max_levels = 64;
inline constexpr std::uint64_t max_visits = std::uint64_t{1} << 20, max_placed_corners = std::uint64_t{1} << 28;

/// Walks the trees below placed nodes, and counts over all of them.
class AssemblyWalk {
 public:
  using Emit = std::function<void(const AssemblyNode& node, PlacedMesh placed)>;

  AssemblyWalk(const std::vector<AssemblyNode>& nodes, const std::vector<PolygonMesh>& meshes);

  /// Every mesh at or below `root`, in the order of the file, with the steps that place it.
  /// Errors (with `where` = the node's place): "bad-syntax" (a node contains itself, more levels than the limit),
  /// "absurd-count". Precondition: children are nodes.
  Result<void> visit(const PlacedNode& root, const Emit& emit);

 private:
  Result<void> descend(const PlacedNode& placed, const Placing& outer, std::size_t level, const Emit& emit);

  const std::vector<AssemblyNode>& nodes_;
  const std::vector<PolygonMesh>& meshes_;
  std::vector<bool> is_open_;
  std::uint64_t visits_ = 0, corners_ = 0;
};

}  // namespace quoin::io
