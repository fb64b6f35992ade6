#include "booleans/classify/cells.h"

#include "booleans/body/around_edge.h"
#include "booleans/classify/seeds.h"
#include "grid/lists/loops.h"
#include "grid/lists/partition.h"

namespace quoin::booleans {
namespace {

/// The side met counter-clockwise after (before) the facet around the edge low -> high.
SideId after(const Use& u) { return u.left ? canonical_front(u) : opposite(canonical_front(u)); }
SideId before(const Use& u) { return opposite(after(u)); }

/// Counter-clockwise around low -> high, starting from the first use.
void sort_around_edge(const Arrangement& a, std::span<const Use> uses, std::vector<std::uint32_t>& order) {
  int axis = -1, forward = 0;  // an axis in which the edge runs, and its direction there
  while (forward == 0) forward = a.names.vertices.compare_along(++axis, uses[0].high, uses[0].low);
  sort_around(
      order, axis, forward, [&](std::uint32_t i) -> const exact::Plane& { return a.names.planes[uses[i].plane]; },
      [&](std::uint32_t i) { return uses[i].left; });
}

/// Unites the sides that look at each other across the fan of an edge.
void spread_over_fans(const Arrangement& a, grid::Partition& sides) {
  std::vector<std::uint32_t> order;
  a.uses.for_edges([&](std::span<const Use> uses) {
    order.clear();
    for (std::uint32_t i = 0; i < uses.size(); ++i) order.push_back(i);
    if (order.size() > 2) sort_around_edge(a, uses, order);
    for (std::size_t i = 0; i < order.size(); ++i) {
      const Use &u = uses[order[i]], &v = uses[order[grid::next_in_loop(i, order.size())]];
      sides.unite(after(u).value, before(v).value);
    }
  });
}

/// Nodes that hang together over edges.
Components components_of(const Arrangement& a) {
  grid::Partition nodes(a.node_count());
  a.uses.for_edges([&](std::span<const Use> uses) {
    for (const Use& u : uses.subspan(1)) nodes.unite(uses[0].node.value, u.node.value);
  });

  Components c;
  c.of.resize(a.node_count());
  for (const NodeId n : Ids<NodeId>(a.node_count())) {
    const NodeId root = nodes.find(n.value);
    if (root == n) c.of[n] = c.count++;
    c.of[n] = c.of[root];
  }
  return c;
}

}  // namespace

Cells find_cells(const Arrangement& a) {
  const std::uint32_t side_count = 2 * a.node_count(), infinity = side_count;
  grid::Partition sides(side_count + 1);
  spread_over_fans(a, sides);

  // Each component has its place from a far patch, or else from one ray.
  const Components components = components_of(a);
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
