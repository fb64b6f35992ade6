#include "api/access.h"

namespace quoin {

using ExpressionNode = Access::ExpressionNode;

// Children that nobody else holds are taken over before they could recurse.
Expression::Node::~Node() {
  std::vector<Expression> pending = std::move(terms);
  while (!pending.empty()) {
    const Expression last = std::move(pending.back());
    pending.pop_back();
    if (!last.node_ || last.node_.use_count() > 1) continue;
    auto& inner = last.node_->terms;
    std::move(inner.begin(), inner.end(), std::back_inserter(pending));
    inner.clear();
  }
}

Expression::Expression(std::shared_ptr<const ExpressionNode> node) : node_(std::move(node)) {}
Expression::Expression(const Solid& solid) : node_(std::make_shared<const ExpressionNode>(solid)) {}
Expression::Expression(const HalfSpace& half_space) : node_(std::make_shared<const ExpressionNode>(half_space)) {}

Expression Expression::unite(std::vector<Expression> terms) {
  return Expression(std::make_shared<const ExpressionNode>(ExpressionNode::Kind::any, std::move(terms)));
}

Expression Expression::intersect(std::vector<Expression> terms) {
  return Expression(std::make_shared<const ExpressionNode>(ExpressionNode::Kind::all, std::move(terms)));
}

Expression Expression::symmetric_difference(std::vector<Expression> terms) {
  return Expression(std::make_shared<const ExpressionNode>(ExpressionNode::Kind::odd, std::move(terms)));
}

Expression Expression::difference(Expression minuend, std::vector<Expression> subtrahends) {
  if (subtrahends.empty()) return minuend;
  std::vector<Expression> terms;
  terms.reserve(subtrahends.size() + 1);
  terms.push_back(std::move(minuend));
  for (Expression& e : subtrahends) terms.push_back(complement(std::move(e)));
  return intersect(std::move(terms));
}

Expression Expression::complement(Expression term) {
  std::vector<Expression> terms;
  terms.push_back(std::move(term));
  return Expression(std::make_shared<const ExpressionNode>(ExpressionNode::Kind::complement, std::move(terms)));
}

namespace {

std::vector<Expression> two(Expression a, Expression b) {
  std::vector<Expression> terms;
  terms.reserve(2);
  terms.push_back(std::move(a));
  terms.push_back(std::move(b));
  return terms;
}

}  // namespace

Expression operator+(Expression a, Expression b) { return Expression::unite(two(std::move(a), std::move(b))); }
Expression operator-(Expression a, Expression b) {
  return Expression::intersect(two(std::move(a), Expression::complement(std::move(b))));
}
Expression operator&(Expression a, Expression b) { return Expression::intersect(two(std::move(a), std::move(b))); }
Expression operator^(Expression a, Expression b) {
  return Expression::symmetric_difference(two(std::move(a), std::move(b)));
}
Expression operator~(Expression a) { return Expression::complement(std::move(a)); }

}  // namespace quoin
