#include "api/flatten.h"

#include <algorithm>
#include <unordered_map>

#include "grid/lists/array.h"
#include "grid/lists/thresholds.h"

namespace quoin {

using booleans::none;
using booleans::Rule;
using ExpressionNode = Access::ExpressionNode;

namespace {

class Flattener {
 public:
  explicit Flattener(const KnownTerms& known) : known_(known) {
    constexpr std::size_t usual = 8;
    nodes().reserve(usual);
    pending_.reserve(usual);
    is_half_space_.reserve(usual);
    out_.solids.reserve(usual / 2);
    out_.solid_places.reserve(usual / 2);
  }

  Flattened run(const ExpressionNode* root) {
    pending_.push_back({root, false, none});
    while (!pending_.empty()) {
      const Item item = pending_.back();
      pending_.pop_back();
      visit(item);
    }

    // Solids come first.
    const auto solids = static_cast<std::uint32_t>(out_.solids.size());
    for (std::size_t i = 0; i < nodes().size(); ++i)
      if (is_half_space_[i]) nodes()[i].operand += solids;
    return std::move(out_);
  }

 private:
  struct Item {
    const ExpressionNode* node;
    bool negated;
    std::uint32_t parent;
  };
  using SolidKey = std::pair<const booleans::Body*, const grid::Lattice*>;
  template <class Key>
  using Numbers = std::map<Key, std::uint32_t, std::less<Key>, grid::LargePages<std::pair<const Key, std::uint32_t>>>;

  std::vector<booleans::Expression::Node>& nodes() { return out_.expression.nodes; }

  std::uint32_t add(booleans::Expression::Node node, bool is_half_space = false) {
    is_half_space_.push_back(is_half_space);
    return out_.expression.add(node);
  }

  void visit(const Item& item) {
    static const ExpressionNode& nothing = *new ExpressionNode(ExpressionNode::Kind::any, std::vector<Expression>());
    const ExpressionNode& node = item.node ? *item.node : nothing;
    if (const auto known = known_.find(item.node); known != known_.end()) return add_solid(known->second, item);

    switch (node.kind) {
      case ExpressionNode::Kind::solid:
        add_solid(node.solid, item);
        break;
      case ExpressionNode::Kind::half_space:
        add({Rule::operand, item.negated,
             number(half_spaces_, &node, out_.half_spaces, node.half_space, out_.half_space_places), item.parent},
            true);
        break;
      case ExpressionNode::Kind::complement:
        push(node, !item.negated, item.parent);
        break;
      case ExpressionNode::Kind::any:
      case ExpressionNode::Kind::all: {
        // De Morgan.
        const Rule rule = (node.kind == ExpressionNode::Kind::any) != item.negated ? Rule::any : Rule::all;
        const bool joins = item.parent != none && nodes()[item.parent].rule == rule;
        push(node, item.negated, joins ? item.parent : add({rule, false, 0, item.parent}));
        break;
      }
      case ExpressionNode::Kind::odd: {
        const bool joins = item.parent != none && nodes()[item.parent].rule == Rule::odd;
        if (joins && item.negated) nodes()[item.parent].negated = !nodes()[item.parent].negated;
        push(node, false, joins ? item.parent : add({Rule::odd, item.negated, 0, item.parent}));
        break;
      }
    }
  }

  void add_solid(const Solid& solid, const Item& item) {
    // Empty solids have no body, but each a grid.
    const booleans::Body* const body = Access::identity(solid);
    const SolidKey key{body, body ? nullptr : &Access::lattice(solid)};
    add({Rule::operand, item.negated, number(solids_, key, out_.solids, solid, out_.solid_places), item.parent});
  }

  void push(const ExpressionNode& node, bool negated, std::uint32_t parent) {
    for (std::size_t i = node.terms.size(); i-- > 0;)
      pending_.push_back({Access::node(node.terms[i]), negated, parent});
  }

  /// The number of a leaf's operand, which is listed if it is new.
  template <class Key, class Value>
  std::uint32_t number(Numbers<Key>& known, Key key, std::vector<Value>& list, const Value& value,
                       std::vector<std::uint32_t>& places) {
    const auto [at, is_new] = known.emplace(key, static_cast<std::uint32_t>(list.size()));
    if (is_new) {
      list.push_back(value);
      places.push_back(leaves_);
    }
    ++leaves_;
    return at->second;
  }

  const KnownTerms& known_;
  grid::Array<Item> pending_;
  grid::Array<std::uint8_t> is_half_space_;  // by node
  std::uint32_t leaves_ = 0;                 // so far
  Numbers<SolidKey> solids_;
  Numbers<const ExpressionNode*> half_spaces_;
  Flattened out_;
};

/// The terms of a graph that have terms themselves.
class SharedTerms {
 public:
  Result<std::vector<const Expression*>> run(const Expression& root) {
    walk(root);
    for (const Expression* term : order_) measure(*term);
    constexpr std::uint64_t most = 1 << 24;
    if (leaves(root).count > most)
      return Error{ErrorCode::too_many_terms,
                   "shared terms with half-spaces make more than 2^24 terms when they are written out"};
    return std::move(large_);
  }

 private:
  struct Leaves {
    std::uint64_t count = 0;
    bool has_half_space = false;
  };
  struct Term {
    std::uint32_t places = 1;
    Leaves leaves = {};
  };

  /// Every term once, children first, and in how many places it stands.
  void walk(const Expression& root) {
    struct Visit {
      const Expression* term;
      std::size_t next = 0;
    };
    std::vector<Visit> stack;

    const auto enter = [&](const Expression& e) {
      const ExpressionNode* node = Access::node(e);
      if (!node || node->terms.empty()) return;
      const auto [at, fresh] = terms_.try_emplace(node);
      if (fresh)
        stack.push_back({&e});
      else
        ++at->second.places;
    };

    enter(root);
    while (!stack.empty()) {
      Visit& visit = stack.back();
      const auto& below = Access::node(*visit.term)->terms;
      if (visit.next < below.size()) {
        enter(below[visit.next++]);
      } else {
        order_.push_back(visit.term);
        stack.pop_back();
      }
    }
  }

  Leaves leaves(const Expression& e) const {
    const ExpressionNode* node = Access::node(e);
    if (!node) return {};
    if (node->kind == ExpressionNode::Kind::solid) return {1};
    if (node->kind == ExpressionNode::Kind::half_space) return {1, true};
    return node->terms.empty() ? Leaves{} : terms_.at(node).leaves;
  }

  void measure(const Expression& e) {
    const ExpressionNode* node = Access::node(e);
    Term& term = terms_.at(node);
    for (const Expression& below : node->terms) {
      const Leaves l = leaves(below);
      // Far more than too many is enough to know.
      term.leaves.count = std::min<std::uint64_t>(term.leaves.count + l.count, std::uint64_t{1} << 40);
      term.leaves.has_half_space = term.leaves.has_half_space || l.has_half_space;
    }

    if (term.places == 1 || term.leaves.count <= grid::thresholds().few_leaves || term.leaves.has_half_space) return;
    large_.push_back(&e);
    term.leaves.count = 1;
  }

  std::unordered_map<const ExpressionNode*, Term> terms_;
  std::vector<const Expression*> order_, large_;
};

/// Has the expression, written out, so few nodes that none of its terms has many leaves?
bool is_small(const Expression& expression) {
  constexpr std::size_t usual = 16;
  grid::Array<const ExpressionNode*> nodes;
  nodes.reserve(usual);
  nodes.push_back(Access::node(expression));
  for (std::size_t i = 0; i < nodes.size() && nodes.size() <= grid::thresholds().few_leaves; ++i)
    if (nodes[i])
      for (const Expression& below : nodes[i]->terms) nodes.push_back(Access::node(below));
  return nodes.size() <= grid::thresholds().few_leaves;
}

}  // namespace

Flattened flattened(const Expression& expression, const KnownTerms& known) {
  return Flattener(known).run(Access::node(expression));
}

Result<std::vector<const Expression*>> large_shared_terms(const Expression& expression) {
  if (is_small(expression)) return std::vector<const Expression*>();
  return SharedTerms().run(expression);
}

}  // namespace quoin
