/// \file
/// Boolean expressions over operands, and their value as winding numbers change.
#pragma once

#include <cstdint>
#include <vector>

#include "grid/lists/buckets.h"

namespace quoin::booleans {

/// How a node combines its children.
enum class Rule {
  operand,  // a leaf: inside where the operand's winding number is > 0
  any,      // union
  all,      // intersection
  odd,      // symmetric difference: an odd number of children
};

/// An expression tree; node 0 is the root, children come after their parents.
struct Expression {
  struct Node {
    Rule rule = Rule::operand;
    bool negated = false;
    std::uint32_t operand = 0;           // leaves only
    std::uint32_t parent = 0xFFFFFFFFu;  // none for the root
  };
  std::vector<Node> nodes;

  /// Appends a node; returns its index.
  std::uint32_t add(Node node) {
    nodes.push_back(node);
    return static_cast<std::uint32_t>(nodes.size() - 1);
  }
  /// Operand 0.
  static Expression itself();
  /// rule(operand 0, .., operand n - 1), of which those from `negated_from` on are complemented.
  static Expression flat(Rule rule, std::uint32_t n, std::uint32_t negated_from = 0xFFFFFFFFu);
};

/// The value of an expression under changing winding numbers. A change costs the depth of the tree at most.
class Evaluator {
 public:
  /// All winding numbers start at 0.
  Evaluator(const Expression& expression, std::uint32_t operand_count);
  /// Adds to the winding number of an operand.
  void add(std::uint32_t operand, int by);
  bool value() const { return value_[0] != 0; }
  /// How often the expression names an operand.
  std::size_t leaf_count(std::uint32_t operand) const { return leaves_[operand].size(); }

 private:
  bool evaluate(std::uint32_t node) const;
  void flip(std::uint32_t node);

  const Expression& expression_;
  std::vector<int> winding_;
  grid::Buckets<> leaves_;                               // by operand
  std::vector<std::uint32_t> children_, true_children_;  // counts by node
  std::vector<std::uint8_t> value_;
};

}  // namespace quoin::booleans
