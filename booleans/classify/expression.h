/// \file
/// Boolean expressions over operands, and their value as winding numbers change.
#pragma once

#include <cstdint>
#include <span>
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

/// The value of an expression under changing winding numbers. A change of a leaf costs O(log^2 n) of n nodes.
///
/// Each node with children has a heavy one, that with most nodes below; the others are light. Nodes down heavy children
/// are a path: on the way from the root to a leaf are log n paths at most. Along a path each node's value is a function
/// of the value below it, given by the light children; a binary tree keeps the functions composed.
class Evaluator {
 public:
  /// All winding numbers start at 0.
  Evaluator(const Expression& expression, std::uint32_t operand_count);
  /// Adds to the winding number of an operand.
  void add(std::uint32_t operand, int by);
  bool value() const { return value_of(paths_[0]); }
  std::span<const int> winding() const { return winding_; }
  /// How often the expression names an operand.
  std::size_t leaf_count(std::uint32_t operand) const { return leaves_[operand].size(); }

 private:
  /// Bit 0 is the value of a false argument, bit 1 that of a true one.
  using Function = std::uint8_t;
  struct Node {
    std::uint32_t children = 0, true_light = 0;  // all of them, and light ones that are true
    std::uint32_t path = 0, place = 0;           // in composed_
  };
  /// Its tree of functions: root at begin + 1, children of begin + i at begin + 2 i and begin + 2 i + 1.
  struct Path {
    std::uint32_t begin = 0, top = 0;  // top: a node
  };

  void make_paths();
  void make_values();
  Function function(std::uint32_t node) const;
  /// Composed anew; is it another one?
  bool compose(std::uint32_t begin, std::uint32_t i);
  void update(std::uint32_t node);
  /// The lowest node, without children, has a false argument.
  bool value_of(const Path& path) const { return (composed_[path.begin + 1] & 1) != 0; }

  const Expression& expression_;
  std::vector<int> winding_;
  grid::Buckets<> leaves_;  // by operand
  std::vector<Node> nodes_;
  std::vector<Path> paths_;  // that of the root first
  std::vector<Function> composed_;
};

}  // namespace quoin::booleans
