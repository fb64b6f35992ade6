#include "booleans/parts.h"

#include <map>
#include <memory>
#include <optional>

#include "booleans/body/locate.h"
#include "booleans/pairs/crowd.h"
#include "booleans/pairs/operands.h"
#include "grid/lists/stretches.h"

namespace quoin::booleans {
namespace {

/// How many operands are combined at a time.
std::size_t group_size() { return grid::thresholds().group; }

/// A leaf of the expression that may be combined with its like under the same node.
struct Member {
  std::uint32_t leaf;
  Box box;
};

/// Twice the centre.
std::int64_t middle(const Box& b, std::size_t k) { return std::int64_t{b.low[k]} + b.high[k]; }

/// Orders members so that runs of group_size() lie close together: halves again and again along the longest side.
void sort_in_space(std::span<Member> members) {
  if (members.size() <= group_size()) return;
  std::array<std::int64_t, 3> low{INT64_MAX, INT64_MAX, INT64_MAX}, high{INT64_MIN, INT64_MIN, INT64_MIN};
  for (const Member& m : members)
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], middle(m.box, k));
      high[k] = std::max(high[k], middle(m.box, k));
    }
  const std::size_t k = exact::longest_component(std::array{high[0] - low[0], high[1] - low[1], high[2] - low[2]});
  std::size_t half = group_size();
  while (2 * half < members.size()) half *= 2;
  const auto split = members.begin() + static_cast<std::ptrdiff_t>(half);
  std::nth_element(members.begin(), split, members.end(), [&](const Member& x, const Member& y) {
    const std::int64_t a = middle(x.box, k), b = middle(y.box, k);
    return a != b ? a < b : x.leaf < y.leaf;
  });
  sort_in_space(members.first(half));
  sort_in_space(members.subspan(half));
}

bool are_crowded(const std::vector<Member>& members) {
  Array<Box> boxes;
  for (const Member& m : members) boxes.push_back(m.box);
  return are_crowded(boxes);
}

/// What is still to be evaluated.
struct Task {
  std::vector<const Body*> operands;
  Expression expression;

  bool is_leaf(std::uint32_t node) const { return expression.nodes[node].rule == Rule::operand; }
};

/// A piece of the expression that is evaluated by itself and becomes one leaf.
struct Part {
  std::uint32_t place;                 // the node that becomes that leaf
  std::vector<std::uint32_t> covered;  // the other nodes of the piece
  bool negated;                        // the leaf's

  Task task = {};
  Body result = {};
  std::optional<Error> error = {};
};

/// What the negation of a leaf does to a group of such leaves: any(not a, not b) = not all(a, b), and odd(not a, not b)
/// = odd(a, b), negated when the leaves are odd in number.
Rule group_rule(Rule rule, bool negated) {
  if (!negated || rule == Rule::odd) return rule;
  return rule == Rule::any ? Rule::all : Rule::any;
}
bool is_group_negated(Rule rule, bool negated, std::size_t size) {
  return negated && (rule != Rule::odd || size % 2 == 1);
}

/// Groups of leaves of one node that crowd each other.
std::vector<Part> crowded_groups(const Task& task, bool has_labels) {
  const auto& nodes = task.expression.nodes;
  std::map<std::pair<std::uint32_t, bool>, std::vector<Member>> like;  // by node and negation
  for (std::uint32_t i = 0; i < nodes.size(); ++i) {
    if (!task.is_leaf(i) || nodes[i].parent == none) continue;
    // Who names a face of a symmetric difference depends on who is combined first (naming.h).
    if (has_labels && nodes[nodes[i].parent].rule == Rule::odd) continue;
    if (const auto box = bounds(*task.operands[nodes[i].operand]))
      like[{nodes[i].parent, nodes[i].negated}].push_back({i, *box});
  }

  std::vector<Part> groups;
  for (auto& [key, members] : like) {
    if (members.size() <= group_size() || !are_crowded(members)) continue;
    sort_in_space(members);
    const auto [node, negated] = key;
    const Rule rule = nodes[node].rule;

    for (std::size_t i = 0; i + 1 < members.size(); i += group_size()) {  // a last one alone waits for the next round
      const std::size_t size = std::min(members.size() - i, group_size());
      Part& group = groups.emplace_back(Part{members[i].leaf, {}, is_group_negated(rule, negated, size)});
      for (std::size_t j = i; j < i + size; ++j) {
        if (j > i) group.covered.push_back(members[j].leaf);
        group.task.operands.push_back(task.operands[nodes[members[j].leaf].operand]);
      }
      group.task.expression = Expression::flat(group_rule(rule, negated), static_cast<std::uint32_t>(size));
    }
  }
  return groups;
}

/// The value of an expression far from everything.
bool value_at_infinity(const Task& task) {
  Evaluator value(task.expression, static_cast<std::uint32_t>(task.operands.size()));
  for (std::uint32_t i = 0; i < task.operands.size(); ++i) value.add(i, task.operands[i]->full_at_infinity);
  return value.value();
}

/// By node: the root of the largest small subtree that it belongs to, none outside of all, or if the whole is small.
std::vector<std::uint32_t> small_subtrees(const Task& task) {
  const auto& nodes = task.expression.nodes;
  const auto count = static_cast<std::uint32_t>(nodes.size());
  std::vector<std::uint32_t> leaves(count), top(count, none);
  for (std::uint32_t i = count; i-- > 0;) {
    leaves[i] += task.is_leaf(i);
    if (i > 0) leaves[nodes[i].parent] += leaves[i];
  }
  const std::size_t small = grid::thresholds().subtree;
  if (leaves[0] <= small) return top;

  for (std::uint32_t i = 1; i < count; ++i) {
    const std::uint32_t parent = nodes[i].parent;
    if (top[parent] != none)
      top[i] = top[parent];
    else if (!task.is_leaf(i) && leaves[i] > 1 && leaves[i] <= small)
      top[i] = i;
  }
  return top;
}

/// By the root of a subtree: does it share an operand with another one, or with a leaf outside of all?
std::vector<std::uint8_t> sharing_subtrees(const Task& task, const std::vector<std::uint32_t>& top) {
  const auto& nodes = task.expression.nodes;
  std::vector<std::uint32_t> user(task.operands.size(), none);  // of an operand: the first subtree, or leaf elsewhere
  std::vector<std::uint8_t> is_sharing(nodes.size());
  for (std::uint32_t i = 0; i < nodes.size(); ++i) {
    if (!task.is_leaf(i)) continue;
    const std::uint32_t here = top[i] != none ? top[i] : i;
    std::uint32_t& first = user[nodes[i].operand];
    if (first == none) first = here;
    if (first != here) is_sharing[first] = is_sharing[here] = 1;
  }
  return is_sharing;
}

/// Bounded results meet less than their complements do.
void make_bounded(Part& part) {
  const bool negated = value_at_infinity(part.task);
  part.task.expression.nodes[0].negated = negated;
  part.negated = part.negated != negated;
}

/// The small subtrees that share no operand with the rest of the expression: what several of them need would be done
/// several times. Nothing, unless that takes a quarter of all leaves away: so there are few rounds, however deep the
/// tree.
std::vector<Part> own_subtrees(const Task& task) {
  const auto& nodes = task.expression.nodes;
  const std::vector<std::uint32_t> top = small_subtrees(task);
  const std::vector<std::uint8_t> is_sharing = sharing_subtrees(task, top);

  std::vector<Part> parts;
  std::vector<std::uint32_t> name(nodes.size());                   // of a node in its part
  std::vector<std::uint32_t> part_of(nodes.size());                // by top
  std::vector<std::uint32_t> operand(task.operands.size(), none);  // of an operand in its part
  std::size_t leaves = 0, covered_leaves = 0;
  for (std::uint32_t i = 0; i < nodes.size(); ++i) {
    leaves += task.is_leaf(i);
    if (top[i] == none || is_sharing[top[i]]) continue;
    Expression::Node node = nodes[i];
    if (top[i] == i) {
      part_of[i] = static_cast<std::uint32_t>(parts.size());
      parts.push_back({i, {}, node.negated});
      node.negated = false;
      node.parent = none;
    } else {
      node.parent = name[node.parent];
      parts[part_of[top[i]]].covered.push_back(i);
    }

    Part& part = parts[part_of[top[i]]];
    if (task.is_leaf(i)) {
      ++covered_leaves;
      std::uint32_t& own = operand[node.operand];
      if (own == none) {
        own = static_cast<std::uint32_t>(part.task.operands.size());
        part.task.operands.push_back(task.operands[node.operand]);
      }
      node.operand = own;
    }
    name[i] = part.task.expression.add(node);
  }
  if (4 * (covered_leaves - parts.size()) < leaves) return {};

  for (Part& part : parts) make_bounded(part);
  return parts;
}

/// Makes the expression smaller, round by round.
class Reduction {
 public:
  Reduction(std::span<const Body* const> operands, const Expression& expression, const Run& run,
            std::shared_ptr<const Origins> origins)
      : task_{{operands.begin(), operands.end()}, expression},
        run_(run),
        origins_(origins ? std::move(origins) : joint_origins(operands)) {}

  Result<Body> run() {
    drop_repeated_leaves();
    double done = 0;
    for (; find_parts(); done += (1 - done) / 2) {
      if (run_.stage) run_.stage("parts");
      if (run_.progress) run_.progress(done);
      if (auto combined = combine(); !combined) return combined.error();
      replace();
    }
    Run rest = run_;
    if (run_.progress) rest.progress = [&](double fraction) { run_.progress(done + (1 - done) * fraction); };
    return evaluate(task_.operands, task_.expression, rest, origins_);
  }

 private:
  /// One leaf says what equal leaves of a node say; of a symmetric difference every two of them cancel.
  void drop_repeated_leaves() {
    const auto& nodes = task_.expression.nodes;
    if (nodes.size() <= group_size() && !origins_) return;
    std::vector<std::uint8_t> gone(nodes.size());
    std::map<std::array<std::uint32_t, 3>, std::uint32_t> known;  // (node, operand, negated) -> leaf
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
      const auto& node = nodes[i];
      if (!task_.is_leaf(i) || node.parent == none) continue;
      const auto [at, fresh] = known.try_emplace({node.parent, node.operand, node.negated}, i);
      if (fresh) continue;
      gone[i] = 1;
      if (nodes[node.parent].rule != Rule::odd) continue;
      gone[at->second] = 1;
      known.erase(at);
    }
    remove(gone);
  }

  /// The parts of the next round.
  bool find_parts() {
    parts_.clear();
    if (task_.expression.nodes.size() <= group_size()) return false;
    parts_ = own_subtrees(task_);
    if (parts_.empty()) parts_ = crowded_groups(task_, origins_ != nullptr);
    return !parts_.empty();
  }

  Result<void> combine() {
    grid::in_stretches(parts_.size(), 1, [&](std::size_t i, std::size_t, std::size_t) {
      Part& part = parts_[i];
      Result<Body> result = evaluate(part.task.operands, part.task.expression, run_.of_part(), origins_);
      if (result)
        part.result = std::move(result).value();
      else
        part.error = result.error();
    });
    for (const Part& part : parts_)
      if (part.error) return *part.error;
    return {};
  }

  /// Puts a leaf in the place of each part.
  void replace() {
    std::vector<std::uint8_t> gone(task_.expression.nodes.size());
    for (Part& part : parts_) {
      for (std::uint32_t node : part.covered) gone[node] = 1;
      auto& leaf = task_.expression.nodes[part.place];
      leaf.rule = Rule::operand;
      leaf.negated = part.negated;
      leaf.operand = static_cast<std::uint32_t>(task_.operands.size());
      task_.operands.push_back(results_.emplace_back(std::make_unique<Body>(std::move(part.result))).get());
    }
    remove(gone);
  }

  /// Takes nodes away, and lets go of what no leaf names any more.
  void remove(const std::vector<std::uint8_t>& gone) {
    const auto& nodes = task_.expression.nodes;
    Task smaller;
    std::vector<std::uint32_t> node_name(nodes.size(), none), operand_name(task_.operands.size(), none);
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
      if (gone[i]) continue;
      auto node = nodes[i];
      if (node.parent != none) node.parent = node_name[node.parent];
      if (node.rule == Rule::operand) {
        std::uint32_t& name = operand_name[node.operand];
        if (name == none) {
          name = static_cast<std::uint32_t>(smaller.operands.size());
          smaller.operands.push_back(task_.operands[node.operand]);
        }
        node.operand = name;
      }
      node_name[i] = smaller.expression.add(node);
    }
    task_ = std::move(smaller);

    std::vector<const Body*> used = task_.operands;
    std::sort(used.begin(), used.end());
    std::erase_if(results_, [&](const auto& r) { return !std::binary_search(used.begin(), used.end(), r.get()); });
  }

  Task task_;
  const Run& run_;
  const std::shared_ptr<const Origins> origins_;  // of all operands: parts are named as the whole would be
  std::vector<Part> parts_;
  std::vector<std::unique_ptr<Body>> results_;  // of parts, while a leaf names them
};

}  // namespace

Result<Body> evaluate_in_parts(std::span<const Body* const> operands, const Expression& expression, const Run& run,
                               std::shared_ptr<const Origins> origins) {
  return Reduction(operands, expression, run, std::move(origins)).run();
}

}  // namespace quoin::booleans
