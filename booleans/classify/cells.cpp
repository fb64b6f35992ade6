#include "booleans/classify/cells.h"

#include "booleans/body/around_edge.h"
#include "booleans/classify/seeds.h"
#include "grid/lists/loops.h"
#include "grid/lists/partition.h"

namespace quoin::booleans {
namespace {

/// The side met counter-clockwise after (before) the facet around the edge low -> high.
SideId after(const Use& u) { return u.left() ? front_of(u.node()) : back_of(u.node()); }
SideId before(const Use& u) { return opposite(after(u)); }

/// Unites the sides that look at each other across the fan of each edge, and the nodes that hang together there.
class Fans {
 public:
  Fans(const Arrangement& a, grid::Partition& sides, grid::Partition& nodes) : a_(a), sides_(sides), nodes_(nodes) {
    order_.reserve(usual_fan);
    planes_.reserve(usual_fan);
    fan_.reserve(usual_fan);
  }

  void add(VertexId low, std::span<const Use> uses) {
    for (const Use& u : uses.subspan(1)) nodes_.unite(uses[0].node().value, u.node().value);

    const std::span<const Use> fan = uses.size() > 2 ? sorted(low, uses) : uses;
    for (std::size_t i = 0; i < fan.size(); ++i)
      sides_.unite(after(fan[i]).value, before(fan[grid::next_in_loop(i, fan.size())]).value);
  }

 private:
  static constexpr std::size_t usual_fan = 8;

  /// Of the node's front, to be asked for signs.
  exact::Plane plane(const Use& u) const {
    if (u.is_facet()) return a_.names.planes[u.plane()];
    const OwnFace own = a_.operands.own(u.face());
    return a_.operands[own.operand].sign_plane(own.face);
  }
  /// Counter-clockwise around low -> high, starting from the first use.
  std::span<const Use> sorted(VertexId low, std::span<const Use> uses) {
    order_.clear();
    planes_.clear();
    for (const Use& u : uses) {
      order_.push_back(static_cast<std::uint32_t>(order_.size()));
      planes_.push_back(plane(u));
    }
    int axis = -1, forward = 0;  // an axis in which the edge runs, and its direction there
    while (forward == 0) forward = a_.names.vertices.compare_along(++axis, uses[0].high(), low);
    sort_around(
        order_, axis, forward, [&](std::uint32_t i) -> const exact::Plane& { return planes_[i]; },
        [&](std::uint32_t i) { return uses[i].left(); });

    fan_.clear();
    for (const std::uint32_t i : order_) fan_.push_back(uses[i]);
    return fan_;
  }

  const Arrangement& a_;
  grid::Partition &sides_, &nodes_;
  std::vector<std::uint32_t> order_;  // of one fan
  Array<exact::Plane> planes_;
  Array<Use> fan_;
};

/// Nodes that hang together over edges.
Components components_of(grid::Partition& nodes, std::uint32_t count) {
  Components c;
  c.of.resize(count);
  for (const NodeId n : Ids<NodeId>(count)) {
    const NodeId root = nodes.find(n.value);
    if (root == n) c.of[n] = c.count++;
    c.of[n] = c.of[root];
  }
  return c;
}

}  // namespace

Cells find_cells(const Arrangement& a) {
  const std::uint32_t side_count = 2 * a.node_count(), infinity = side_count;
  grid::Partition sides(side_count + 1), nodes(a.node_count());
  Fans fans(a, sides, nodes);
  a.uses.for_edges([&](VertexId low, std::span<const Use> uses) { fans.add(low, uses); });

  // Each component has its place from a far patch, or else from one ray.
  const Components components = components_of(nodes, a.node_count());
  ById<ComponentId, std::uint8_t> is_placed(components.count);
  for (const OperandId o : a.operands.ids()) {
    const NodeId far = a.patches().far[o];
    if (far == none) continue;
    const SideId open = a.operands[o].full_at_infinity ? back_of(far) : front_of(far);
    sides.unite(open.value, infinity);
    is_placed[components.of[far]] = 1;
  }
  Cells cells;
  for (const Seed& s : find_seeds(a, components, is_placed)) {
    if (s.outer == none)
      cells.is_consistent = false;
    else
      sides.unite(s.outer.value, s.beyond == none ? infinity : s.beyond.value);
  }

  cells.count = side_count + 1;
  cells.of.reserve(side_count);
  for (std::uint32_t s = 0; s < side_count; ++s) cells.of.push_back(sides.find(s));
  cells.infinity = sides.find(infinity);
  return cells;
}

}  // namespace quoin::booleans
