#include "booleans/classify/expression.h"

namespace quoin::booleans {

Expression Expression::itself() {
  Expression e;
  e.add({Rule::operand, false, 0, 0xFFFFFFFFu});
  return e;
}

Expression Expression::flat(Rule rule, std::uint32_t n, std::uint32_t negated_from) {
  Expression e;
  e.add({rule, false, 0, 0xFFFFFFFFu});
  for (std::uint32_t i = 0; i < n; ++i) e.add({Rule::operand, i >= negated_from, i, 0});
  return e;
}

Evaluator::Evaluator(const Expression& expression, std::uint32_t operand_count)
    : expression_(expression),
      winding_(operand_count),
      children_(expression.nodes.size()),
      true_children_(expression.nodes.size()),
      value_(expression.nodes.size()) {
  const auto& nodes = expression.nodes;
  leaves_.assign(operand_count, [&](auto&& visit) {
    for (std::uint32_t i = 0; i < nodes.size(); ++i)
      if (nodes[i].rule == Rule::operand) visit(nodes[i].operand, i);
  });
  for (auto i = static_cast<std::uint32_t>(nodes.size()); i-- > 0;) {
    if (i > 0) ++children_[nodes[i].parent];
    value_[i] = evaluate(i);
    if (i > 0 && value_[i]) ++true_children_[nodes[i].parent];
  }
}

bool Evaluator::evaluate(std::uint32_t node) const {
  const auto& n = expression_.nodes[node];
  bool v = false;
  switch (n.rule) {
    case Rule::operand:
      v = winding_[n.operand] > 0;
      break;
    case Rule::any:
      v = true_children_[node] > 0;
      break;
    case Rule::all:
      v = true_children_[node] == children_[node];
      break;
    case Rule::odd:
      v = true_children_[node] % 2 == 1;
      break;
  }
  return v != n.negated;
}

void Evaluator::flip(std::uint32_t node) {
  for (;;) {
    value_[node] = !value_[node];
    if (node == 0) return;
    const std::uint32_t parent = expression_.nodes[node].parent;
    true_children_[parent] += value_[node] ? 1u : ~0u;
    if (evaluate(parent) == (value_[parent] != 0)) return;
    node = parent;
  }
}

void Evaluator::add(std::uint32_t operand, int by) {
  winding_[operand] += by;
  for (const std::uint32_t leaf : leaves_[operand])
    if (evaluate(leaf) != (value_[leaf] != 0)) flip(leaf);
}

}  // namespace quoin::booleans
