#include "booleans/parts.h"

#include <map>
#include <memory>
#include <optional>

#include "booleans/body/locate.h"
#include "booleans/pairs/box_tree.h"
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

/// Do the boxes of more pairs meet than Thresholds::neighbours a member?
bool is_crowded(const std::vector<Member>& members) {
  const std::size_t most = (2 * grid::thresholds().neighbours + 1) * members.size();  // each itself, each pair twice
  std::vector<BoxTree::Item> items;
  for (std::uint32_t i = 0; i < members.size(); ++i) items.push_back({members[i].box, i, i});
  const BoxTree tree(items);
  std::size_t met = 0;
  for (std::size_t i = 0; i < members.size() && met <= most; ++i)
    tree.meeting(members[i].box, [&](std::uint32_t) { ++met; });
  return met > most;
}

/// What the negation of a leaf does to a group of such leaves: any(not a, not b) = not all(a, b), and odd(not a, not b)
/// = odd(a, b), negated when the leaves are odd in number.
Rule group_rule(Rule rule, bool negated) {
  if (!negated || rule == Rule::odd) return rule;
  return rule == Rule::any ? Rule::all : Rule::any;
}
bool is_group_negated(Rule rule, bool negated, std::size_t size) {
  return negated && (rule != Rule::odd || size % 2 == 1);
}

/// Makes the expression smaller, round by round.
class Reduction {
 public:
  Reduction(std::span<const Body* const> operands, const Expression& expression, const Run& run)
      : operands_(operands.begin(), operands.end()), expression_(expression), run_(run) {}

  Result<Body> run() {
    drop_repeated_leaves();
    double done = 0;
    for (; find_groups(); done += (1 - done) / 2) {
      if (run_.stage) run_.stage("parts");
      if (run_.progress) run_.progress(done);
      if (auto combined = combine(); !combined) return combined.error();
      replace();
    }
    Run rest = run_;
    if (run_.progress) rest.progress = [&](double fraction) { run_.progress(done + (1 - done) * fraction); };
    return evaluate(operands_, expression_, rest);
  }

 private:
  struct Group {
    std::vector<std::uint32_t> leaves;
    Body result;
    std::optional<Error> error;
  };

  /// One leaf says what equal leaves of a node say; of a symmetric difference every two of them cancel.
  void drop_repeated_leaves() {
    if (expression_.nodes.size() <= group_size()) return;
    std::vector<std::uint8_t> gone(expression_.nodes.size());
    std::map<std::array<std::uint32_t, 3>, std::uint32_t> known;  // (node, operand, negated) -> leaf
    for (std::uint32_t i = 0; i < expression_.nodes.size(); ++i) {
      const auto& node = expression_.nodes[i];
      if (node.rule != Rule::operand || node.parent == none) continue;
      const auto [at, fresh] = known.try_emplace({node.parent, node.operand, node.negated}, i);
      if (fresh) continue;
      gone[i] = 1;
      if (expression_.nodes[node.parent].rule != Rule::odd) continue;
      gone[at->second] = 1;
      known.erase(at);
    }
    remove(gone);
  }

  /// The groups of the next round.
  bool find_groups() {
    groups_.clear();
    if (expression_.nodes.size() <= group_size()) return false;
    std::map<std::pair<std::uint32_t, bool>, std::vector<Member>> like;  // by node and negation
    for (std::uint32_t i = 0; i < expression_.nodes.size(); ++i) {
      const auto& node = expression_.nodes[i];
      if (node.rule != Rule::operand || node.parent == none) continue;
      if (const auto box = bounds(*operands_[node.operand])) like[{node.parent, node.negated}].push_back({i, *box});
    }
    for (auto& [key, members] : like) {
      if (members.size() <= group_size() || !is_crowded(members)) continue;
      sort_in_space(members);
      for (std::size_t i = 0; i + 1 < members.size(); i += group_size()) {  // a last one alone waits for the next round
        Group& group = groups_.emplace_back();
        for (std::size_t j = i; j < std::min(members.size(), i + group_size()); ++j)
          group.leaves.push_back(members[j].leaf);
      }
    }
    return !groups_.empty();
  }

  Result<void> combine() {
    grid::in_stretches(groups_.size(), 1, [&](std::size_t g, std::size_t, std::size_t) {
      Group& group = groups_[g];
      const auto& first = expression_.nodes[group.leaves[0]];
      std::vector<const Body*> bodies;
      for (std::uint32_t leaf : group.leaves) bodies.push_back(operands_[expression_.nodes[leaf].operand]);
      const Rule rule = group_rule(expression_.nodes[first.parent].rule, first.negated);
      Result<Body> result =
          evaluate(bodies, Expression::flat(rule, static_cast<std::uint32_t>(bodies.size())), Run{{}, run_.cancel, {}});
      if (result)
        group.result = std::move(result).value();
      else
        group.error = result.error();
    });
    for (const Group& group : groups_)
      if (group.error) return *group.error;
    return {};
  }

  /// Puts one leaf in the place of each group's leaves.
  void replace() {
    std::vector<std::uint8_t> gone(expression_.nodes.size());
    for (Group& group : groups_) {
      for (std::uint32_t leaf : group.leaves) gone[leaf] = 1;
      gone[group.leaves[0]] = 0;
      auto& first = expression_.nodes[group.leaves[0]];
      first.negated = is_group_negated(expression_.nodes[first.parent].rule, first.negated, group.leaves.size());
      first.operand = static_cast<std::uint32_t>(operands_.size());
      operands_.push_back(results_.emplace_back(std::make_unique<Body>(std::move(group.result))).get());
    }
    remove(gone);
  }

  /// Takes leaves away, and lets go of what no leaf names any more.
  void remove(const std::vector<std::uint8_t>& gone) {
    Expression smaller;
    std::vector<const Body*> used;
    std::vector<std::uint32_t> node_name(expression_.nodes.size(), none), operand_name(operands_.size(), none);
    for (std::uint32_t i = 0; i < expression_.nodes.size(); ++i) {
      if (gone[i]) continue;
      auto node = expression_.nodes[i];
      if (node.parent != none) node.parent = node_name[node.parent];
      if (node.rule == Rule::operand) {
        std::uint32_t& name = operand_name[node.operand];
        if (name == none) {
          name = static_cast<std::uint32_t>(used.size());
          used.push_back(operands_[node.operand]);
        }
        node.operand = name;
      }
      node_name[i] = smaller.add(node);
    }
    expression_ = std::move(smaller);
    operands_ = used;
    std::sort(used.begin(), used.end());
    std::erase_if(results_, [&](const auto& r) { return !std::binary_search(used.begin(), used.end(), r.get()); });
  }

  std::vector<const Body*> operands_;
  Expression expression_;
  const Run& run_;
  std::vector<Group> groups_;
  std::vector<std::unique_ptr<Body>> results_;  // of groups, while a leaf names them
};

}  // namespace

Result<Body> evaluate_in_parts(std::span<const Body* const> operands, const Expression& expression, const Run& run) {
  return Reduction(operands, expression, run).run();
}

}  // namespace quoin::booleans
