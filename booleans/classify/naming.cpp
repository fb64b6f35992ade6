#include "booleans/classify/naming.h"

namespace quoin::booleans {

Naming::Naming(const Arrangement& a, const Expression& expression)
    : a_(a), expression_(expression), nodes_(expression.nodes.size()) {
  named_.assign(a.sheets.facet_count(), none);
  for (const NodeId n : Ids<NodeId>(a.sheets.facet_count())) {
    const auto covers = a.sheets[a.sheets.sheet_of(n)].covers(a.sheets.facet_of(n));
    if (covers.size() == 1) named_[n] = covers[0];
  }
}

TouchedId Naming::first(TouchedId t, TouchedId u) const {
  if (t == none || u == none) return t == none ? u : t;
  const TouchedFace &x = a_.touched.faces[t], &y = a_.touched.faces[u];
  const Provenance p = a_.operands.provenance(x.operand, x.source), q = a_.operands.provenance(y.operand, y.source);
  return a_.operands.origins->comes_before(q, p) ? u : t;
}

void Naming::list_changes(NodeId facet) {
  changes_.clear();
  for (const TouchedId t : a_.sheets[a_.sheets.sheet_of(facet)].covers(a_.sheets.facet_of(facet))) {
    const TouchedFace& face = a_.touched.faces[t];
    if (changes_.empty() || changes_.back().operand != face.operand) changes_.push_back({face.operand, 0, none, none});
    Change& change = changes_.back();
    change.jump += face.jump();
    TouchedId& named = face.jump() > 0 ? change.forward : change.backward;
    named = first(named, t);
  }
}

void Naming::name(NodeId facet, std::span<const int> winding) {
  if (named_[facet] != none) return;
  list_changes(facet);
  for (Node& node : nodes_) node = {false, false, none, 0, 0, 0};

  for (auto i = static_cast<std::uint32_t>(nodes_.size()); i-- > 0;) {
    const Expression::Node& rule = expression_.nodes[i];
    Node& node = nodes_[i];
    switch (rule.rule) {
      case Rule::operand: {
        node.front = node.back = winding[rule.operand] > 0;
        const auto change = std::lower_bound(changes_.begin(), changes_.end(), OperandId(rule.operand),
                                             [](const Change& c, OperandId o) { return c.operand < o; });
        if (change == changes_.end() || change->operand != OperandId(rule.operand)) break;
        node.back = winding[rule.operand] + change->jump > 0;
        if (node.front != node.back) node.name = node.back ? change->forward : change->backward;
        break;
      }
      case Rule::any:
        node.front = node.true_front > 0;
        node.back = node.true_back > 0;
        break;
      case Rule::all:
        node.front = node.true_front == node.children;
        node.back = node.true_back == node.children;
        break;
      case Rule::odd:
        node.front = node.true_front % 2 == 1;
        node.back = node.true_back % 2 == 1;
        break;
    }
    if (rule.negated) {
      node.front = !node.front;
      node.back = !node.back;
    }
    if (i > 0) give_to_parent(i);
  }
  if (nodes_[0].front != nodes_[0].back) named_[facet] = nodes_[0].name;
}

void Naming::give_to_parent(std::uint32_t i) {
  const Node& node = nodes_[i];
  Node& parent = nodes_[expression_.nodes[i].parent];
  ++parent.children;
  parent.true_front += node.front;
  parent.true_back += node.back;
  if (node.front != node.back) parent.name = first(parent.name, node.name);
}

Provenance provenance_of(const Arrangement& a, TouchedId named_by, int kept) {
  const TouchedFace& face = a.touched.faces[named_by];
  const Provenance p = a.operands.provenance(face.operand, face.source);
  return (kept > 0) == face.along ? p : p.turned();
}

}  // namespace quoin::booleans
