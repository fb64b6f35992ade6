#include "api/flatten.h"

#include <map>

#include "api/access.h"

namespace quoin {

using booleans::none;
using booleans::Rule;
using Node = Access::Node;

namespace {

class Flattener {
 public:
  Flattened run(const Node* root) {
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
    const Node* node;
    bool negated;
    std::uint32_t parent;
  };

  std::vector<booleans::Expression::Node>& nodes() { return out_.expression.nodes; }

  std::uint32_t add(booleans::Expression::Node node, bool is_half_space = false) {
    is_half_space_.push_back(is_half_space);
    return out_.expression.add(node);
  }

  void visit(const Item& item) {
    static const Node nothing(Node::Kind::any, {});
    const Node& node = item.node ? *item.node : nothing;
    switch (node.kind) {
      case Node::Kind::solid:
        add({Rule::operand, item.negated, number(solids_, Access::identity(node.solid), out_.solids, node.solid),
             item.parent});
        break;
      case Node::Kind::half_space:
        add({Rule::operand, item.negated, number(half_spaces_, &node, out_.half_spaces, node.half_space), item.parent},
            true);
        break;
      case Node::Kind::complement:
        push(node, !item.negated, item.parent);
        break;
      case Node::Kind::any:
      case Node::Kind::all: {
        // De Morgan.
        const Rule rule = (node.kind == Node::Kind::any) != item.negated ? Rule::any : Rule::all;
        const bool joins = item.parent != none && nodes()[item.parent].rule == rule;
        push(node, item.negated, joins ? item.parent : add({rule, false, 0, item.parent}));
        break;
      }
      case Node::Kind::odd: {
        const bool joins = item.parent != none && nodes()[item.parent].rule == Rule::odd;
        if (joins && item.negated) nodes()[item.parent].negated = !nodes()[item.parent].negated;
        push(node, false, joins ? item.parent : add({Rule::odd, item.negated, 0, item.parent}));
        break;
      }
    }
  }

  void push(const Node& node, bool negated, std::uint32_t parent) {
    for (std::size_t i = node.terms.size(); i-- > 0;)
      pending_.push_back({Access::node(node.terms[i]), negated, parent});
  }

  template <class Key, class Value>
  static std::uint32_t number(std::map<Key, std::uint32_t>& known, Key key, std::vector<Value>& list,
                              const Value& value) {
    const auto [at, is_new] = known.emplace(key, static_cast<std::uint32_t>(list.size()));
    if (is_new) list.push_back(value);
    return at->second;
  }

  std::vector<Item> pending_;
  std::vector<bool> is_half_space_;  // by node
  std::map<const booleans::Body*, std::uint32_t> solids_;
  std::map<const Node*, std::uint32_t> half_spaces_;
  Flattened out_;
};

}  // namespace

Flattened flattened(const Expression& expression) { return Flattener().run(Access::node(expression)); }

}  // namespace quoin
