#include "io/packages/assembly.h"

namespace quoin::io {
namespace {

Error fault(ErrorCode code, std::string message, const AssemblyNode& node) {
  return {code, std::move(message), {}, node.place};
}

}  // namespace

AssemblyWalk::AssemblyWalk(const std::vector<AssemblyNode>& nodes, const std::vector<PolygonMesh>& meshes)
    : nodes_(nodes), meshes_(meshes), is_open_(nodes.size()) {}

Result<void> AssemblyWalk::visit(const PlacedNode& root, const Emit& emit) { return descend(root, {}, 1, emit); }

Result<void> AssemblyWalk::descend(const PlacedNode& placed, const Placing& outer, std::size_t level,
                                   const Emit& emit) {
  const AssemblyNode& node = nodes_[placed.node];
  if (is_open_[placed.node]) return fault(ErrorCode::bad_syntax, "an object contains itself", node);
  if (level > max_levels)
    return fault(ErrorCode::bad_syntax, "objects are nested more than " + std::to_string(max_levels) + " levels deep",
                 node);
  if (++visits_ > max_visits)
    return fault(ErrorCode::absurd_count, "more than " + std::to_string(max_visits) + " objects are placed", node);

  // The innermost steps act first.
  Placing placing = placed.placing;
  placing.insert(placing.end(), outer.begin(), outer.end());
  for (const PlacedMesh& placed_mesh : node.meshes) {
    corners_ += meshes_[placed_mesh.mesh].corners.size();
    if (corners_ > max_placed_corners)
      return fault(ErrorCode::absurd_count,
                   "placed meshes have more than " + std::to_string(max_placed_corners) + " corners together", node);
    PlacedMesh made = placed_mesh;
    made.placing.insert(made.placing.end(), placing.begin(), placing.end());
    emit(node, std::move(made));
  }

  is_open_[placed.node] = true;
  for (const PlacedNode& child : node.children)
    if (auto walked = descend(child, placing, level + 1, emit); !walked) return walked;
  is_open_[placed.node] = false;
  return {};
}

}  // namespace quoin::io
