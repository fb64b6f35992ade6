#include "booleans/classify/selection.h"

#include <bit>
#include <optional>

#include "booleans/classify/naming.h"
#include "grid/lists/buckets.h"
#include "grid/lists/partition.h"

namespace quoin::booleans {
namespace {

/// A well-mixed 64-bit constant per operand: labels are compared as sums of these.
std::uint64_t label_weight(OperandId operand) {
  std::uint64_t x = (operand.value + 1) * 0x9E3779B97F4A7C15u;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
  return x ^ (x >> 31);
}

/// A label, as far as anyone asks: the expression's value there, and a sum of weights that shows whether every way to a
/// cell agrees.
class Label {
 public:
  Label(const Arrangement& a, const Expression& expression)
      : evaluator_(expression, static_cast<std::uint32_t>(a.operands.bodies.size())) {
    for (const OperandId o : a.operands.ids())
      if (a.operands[o].full_at_infinity) add(o, 1);
  }
  bool value() const { return evaluator_.value(); }
  std::uint64_t sum() const { return sum_; }
  std::span<const int> winding() const { return evaluator_.winding(); }

  /// Goes through a node from one of its sides to the other.
  void cross(const Arrangement& a, SideId from) {
    const int way = is_back(from) ? -1 : 1;  // from front to back adds the jump
    a.for_jumps(node_of(from), [&](OperandId operand, int by) { add(operand, way * by); });
  }
  /// How many leaves of the expression a node changes.
  std::size_t leaf_count(const Arrangement& a, NodeId n) const {
    std::size_t count = 0;
    a.for_jumps(n, [&](OperandId operand, int) { count += evaluator_.leaf_count(operand.value); });
    return count;
  }
  /// Does the expression name an operand more than once?
  bool repeats(const Arrangement& a) const {
    bool found = false;
    for (const OperandId o : a.operands.ids()) found = found || evaluator_.leaf_count(o.value) > 1;
    return found;
  }

 private:
  void add(OperandId operand, int by) {
    evaluator_.add(operand.value, by);
    sum_ += label_weight(operand) * static_cast<std::uint64_t>(std::int64_t{by});
  }

  Evaluator evaluator_;
  std::uint64_t sum_ = 0;
};

/// What is known of the cells that can be reached from infinity.
struct CellValues {
  ById<CellId, std::uint8_t> is_seen, is_inside;
  ById<CellId, std::uint64_t> sum;

  explicit CellValues(std::size_t cells) : is_seen(cells), is_inside(cells), sum(cells) {}
  void set(CellId cell, const Label& label) {
    is_seen[cell] = 1;
    is_inside[cell] = label.value();
    sum[cell] = label.sum();
  }
};

/// Nodes that connect all cells that nodes do, without a cycle. Those that change fewer leaves come first, by powers of
/// two: all together change at most twice as many as they must (Kruskal).
ById<NodeId, std::uint8_t> tree_of_few_leaves(const Arrangement& a, const Cells& cells, const Label& label) {
  const grid::Buckets<> by_leaves(8 * sizeof(std::size_t) + 1, [&](auto&& visit) {
    for (const NodeId n : Ids<NodeId>(a.node_count()))
      visit(static_cast<std::size_t>(std::bit_width(label.leaf_count(a, n))), n.value);
  });

  ById<NodeId, std::uint8_t> is_in_tree(a.node_count());
  grid::Partition connected(cells.count);
  for (const NodeId n : by_leaves.items()) {
    const std::uint32_t front = connected.find(cells.of[front_of(n)].value),
                        back = connected.find(cells.of[back_of(n)].value);
    if (front == back) continue;
    connected.unite(front, back);
    is_in_tree[n] = 1;
  }
  return is_in_tree;
}

/// Walks from infinity through nodes, changing one label as it goes; labels are never stored. Nodes that change many
/// leaves are walked through where there is no other way only. Facets are named on the way, if there is a `naming`.
CellValues evaluate_cells(const Arrangement& a, const Cells& cells, const Expression& expression, Naming* naming) {
  const auto sides = grid::in_buckets(cells.of.size(), cells.count, [&](SideId s) { return cells.of[s].value; });
  CellValues values(cells.count);
  Label label(a, expression);
  ById<NodeId, std::uint8_t> is_way;  // empty: all nodes are
  if (label.repeats(a)) is_way = tree_of_few_leaves(a, cells, label);

  struct Visit {
    CellId cell;
    SideId entered;      // through which the walk came, none at infinity
    std::uint32_t next;  // into the cell's sides
  };
  Array<Visit> stack;
  stack.reserve(16);
  const auto enter = [&](CellId cell, SideId through) {
    values.set(cell, label);
    stack.push_back({cell, through, 0});
  };

  enter(cells.infinity, none);
  while (!stack.empty()) {
    Visit& top = stack.back();
    const auto around = sides[top.cell.value];
    if (top.next == around.size()) {
      if (top.entered != none) label.cross(a, opposite(top.entered));  // back where it came from
      stack.pop_back();
      continue;
    }
    const SideId s = around[top.next++];
    if (naming && !is_back(s) && a.sheets.is_facet(node_of(s))) naming->name(node_of(s), label.winding());
    const CellId beyond = cells.of[opposite(s)];
    if (values.is_seen[beyond] || (!is_way.empty() && !is_way[node_of(s)])) continue;
    label.cross(a, s);
    enter(beyond, s);
  }
  return values;
}

/// The first node whose two sides' labels do not differ by its jump; none where all do.
NodeId contradiction(const Arrangement& a, const Cells& cells, const CellValues& values) {
  for (const NodeId n : Ids<NodeId>(a.node_count())) {
    const CellId front = cells.of[front_of(n)], back = cells.of[back_of(n)];
    std::uint64_t expected = values.sum[front];
    a.for_jumps(n, [&](OperandId operand, int by) {
      expected += label_weight(operand) * static_cast<std::uint64_t>(std::int64_t{by});
    });
    if (!values.is_seen[front] || !values.is_seen[back] || values.sum[back] != expected) return n;
  }
  return none;
}

/// A facet with spared loops, or the far patch that these lead to, where their labels differ; none where all agree.
NodeId spared_contradiction(const Arrangement& a, const Cells& cells, const CellValues& values) {
  for (const auto& [facet, face] : a.sheets.spared()) {
    const TouchedFace& f = a.touched.faces[face];
    const NodeId far = a.patches().far[f.operand];
    if (facet == none || far == none) return facet == none ? far : facet;
    const SideId outside = f.along ? front_of(facet) : back_of(facet);
    if (values.sum[cells.of[outside]] != values.sum[cells.of[front_of(far)]]) return facet;
  }
  return none;
}

/// Do a kept facet and a kept untouched face at its edge have one oriented plane?
bool is_flat(const Arrangement& a, const Selection& selection, const Use& facet, const Use& untouched) {
  const OwnFace own = a.operands.own(untouched.face());
  const exact::Plane plane = a.operands[own.operand].plane(own.face);
  const exact::Plane& sheet = a.names.planes[facet.plane()];
  return selection.kept[untouched.node()] == selection.kept[facet.node()] ? plane == sheet : plane == sheet.opposite();
}

/// Marks the edge of these uses where it is a border.
void mark_border(const Arrangement& a, std::span<const Use> uses, Selection& selection) {
  const Use *facet = nullptr, *untouched = nullptr;
  for (const Use& u : uses)
    if (selection.kept[u.node()] != 0) (u.is_facet() ? facet : untouched) = &u;
  if (facet && untouched && is_flat(a, selection, *facet, *untouched)) selection.is_border[facet->element()] = 1;
}

}  // namespace

Selection select(const Arrangement& a, const Cells& cells, const Expression& expression) {
  Selection selection;
  std::optional<Naming> naming;
  if (a.operands.origins) naming.emplace(a, expression);
  const CellValues values = evaluate_cells(a, cells, expression, naming ? &*naming : nullptr);
  if (naming) selection.named_by = naming->take();
  if (cells.is_consistent) selection.contradiction = contradiction(a, cells, values);
  if (selection.contradiction == none) selection.contradiction = spared_contradiction(a, cells, values);
  selection.is_consistent = cells.is_consistent && selection.contradiction == none;
  selection.full_at_infinity = values.is_inside[cells.infinity];

  selection.kept.reserve(a.node_count());
  for (const NodeId n : Ids<NodeId>(a.node_count())) {
    const int front = values.is_inside[cells.of[front_of(n)]], back = values.is_inside[cells.of[back_of(n)]];
    selection.kept.push_back(static_cast<std::int8_t>(back - front));
  }

  selection.kept_at.assign(a.sheets.element_count(), 0);
  if (naming) selection.is_border.assign(a.sheets.element_count(), 0);
  a.uses.for_edges([&](VertexId, std::span<const Use> uses) {
    std::size_t count = 0;
    for (const Use& u : uses) count += selection.kept[u.node()] != 0;
    for (const Use& u : uses)
      if (u.is_facet()) selection.kept_at[u.element()] = static_cast<std::uint8_t>(std::min<std::size_t>(count, 255));
    if (naming && count == 2) mark_border(a, uses, selection);
  });
  return selection;
}

}  // namespace quoin::booleans
