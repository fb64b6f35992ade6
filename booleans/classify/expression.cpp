#include "booleans/classify/expression.h"

#include <bit>
#include <utility>

#include "booleans/body/body.h"

namespace quoin::booleans {
namespace {

constexpr std::uint8_t never = 0b00, identity = 0b10, always = 0b11;  // functions of a value

}  // namespace

Expression Expression::itself() {
  Expression e;
  e.add({Rule::operand, false, 0, none});
  return e;
}

Expression Expression::flat(Rule rule, std::uint32_t n, std::uint32_t negated_from) {
  Expression e;
  e.add({rule, false, 0, none});
  for (std::uint32_t i = 0; i < n; ++i) e.add({Rule::operand, i >= negated_from, i, 0});
  return e;
}

Evaluator::Evaluator(const Expression& expression, std::uint32_t operand_count)
    : expression_(expression), winding_(operand_count), nodes_(expression.nodes.size()) {
  const auto& nodes = expression.nodes;
  leaves_.assign(operand_count, [&](auto&& visit) {
    for (std::uint32_t i = 0; i < nodes.size(); ++i)
      if (nodes[i].rule == Rule::operand) visit(nodes[i].operand, i);
  });
  make_paths();
  make_values();
}

void Evaluator::make_paths() {
  const auto& nodes = expression_.nodes;
  const auto count = static_cast<std::uint32_t>(nodes.size());
  std::vector<std::uint32_t> below(count, 1), heavy(count, none);
  for (std::uint32_t i = count; i-- > 1;) {
    const std::uint32_t parent = nodes[i].parent;
    ++nodes_[parent].children;
    below[parent] += below[i];
    if (heavy[parent] == none || below[i] > below[heavy[parent]]) heavy[parent] = i;
  }

  for (std::uint32_t top = 0; top < count; ++top) {
    if (top > 0 && heavy[nodes[top].parent] == top) continue;
    std::uint32_t length = 0;
    for (std::uint32_t i = top; i != none; i = heavy[i]) ++length;
    const std::uint32_t width = std::bit_ceil(length), begin = static_cast<std::uint32_t>(composed_.size());
    std::uint32_t place = begin + width;
    for (std::uint32_t i = top; i != none; i = heavy[i]) {
      nodes_[i].path = static_cast<std::uint32_t>(paths_.size());
      nodes_[i].place = place++;
    }
    paths_.push_back({begin, top});
    composed_.resize(begin + 2 * width, identity);
  }
}

/// All below a node comes after it.
void Evaluator::make_values() {
  for (auto i = static_cast<std::uint32_t>(nodes_.size()); i-- > 0;) {
    composed_[nodes_[i].place] = function(i);
    const Path& path = paths_[nodes_[i].path];
    if (path.top != i) continue;
    for (std::uint32_t k = nodes_[i].place - path.begin; k-- > 1;) compose(path.begin, k);
    if (i > 0) nodes_[expression_.nodes[i].parent].true_light += value_of(path);
  }
}

Evaluator::Function Evaluator::function(std::uint32_t node) const {
  const auto& n = expression_.nodes[node];
  const Node& counts = nodes_[node];
  Function f = identity;
  switch (n.rule) {
    case Rule::operand:
      f = winding_[n.operand] > 0 ? always : never;
      break;
    case Rule::any:
      if (counts.true_light > 0) f = always;
      break;
    case Rule::all:
      if (counts.children == 0) f = always;
      if (counts.true_light + 1 < counts.children) f = never;
      break;
    case Rule::odd:
      if (counts.true_light % 2 == 1) f ^= always;
      break;
  }
  return n.negated ? f ^ always : f;
}

bool Evaluator::compose(std::uint32_t begin, std::uint32_t i) {
  const unsigned upper = composed_[begin + 2 * i], lower = composed_[begin + 2 * i + 1];
  const auto f = static_cast<Function>((upper >> (lower & 1) & 1) | (upper >> (lower >> 1) & 1) << 1);
  return std::exchange(composed_[begin + i], f) != f;
}

/// After a change of what its function comes of.
void Evaluator::update(std::uint32_t node) {
  for (;;) {
    const Path& path = paths_[nodes_[node].path];
    const bool before = value_of(path);
    const Function f = function(node);
    if (std::exchange(composed_[nodes_[node].place], f) == f) return;
    for (std::uint32_t i = (nodes_[node].place - path.begin) / 2; i > 0 && compose(path.begin, i);) i /= 2;

    const bool after = value_of(path);
    if (after == before || path.top == 0) return;
    node = expression_.nodes[path.top].parent;
    nodes_[node].true_light += after ? 1u : ~0u;
  }
}

void Evaluator::add(std::uint32_t operand, int by) {
  winding_[operand] += by;
  for (const std::uint32_t leaf : leaves_[operand]) update(leaf);
}

}  // namespace quoin::booleans
