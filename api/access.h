/// \file
/// The way from the public values to what they hold, and back.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "booleans/body/body.h"
#include "grid/grid.h"
#include "quoin/quoin.h"
#include "rounding/motions/motion.h"

namespace quoin {

struct Grid::Data {
  grid::Lattice lattice;
};

/// A node of a public expression: a solid, a half-space, or terms under a rule.
struct Expression::Node {
  enum class Kind { solid, half_space, any, all, odd, complement };

  Kind kind;
  Solid solid = {};
  HalfSpace half_space = {};
  mutable std::vector<Expression> terms = {};  // taken apart by the destructor alone

  Node(Kind k, std::vector<Expression> t) : kind(k), terms(std::move(t)) {}
  explicit Node(const Solid& s) : kind(Kind::solid), solid(s) {}
  explicit Node(const HalfSpace& h) : kind(Kind::half_space), half_space(h) {}
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;
  /// Without recursion: expressions may be deep.
  ~Node();
};

struct Motion::Data {
  rounding::Motion motion;
};

struct Access {
  using ExpressionNode = Expression::Node;
  using ModelNode = Model::Node;

  static const grid::Lattice& lattice(const Grid& grid) { return grid.data_->lattice; }
  static const grid::Lattice& lattice(const Solid& solid) { return lattice(solid.grid_); }
  /// Precondition: the step is positive.
  static Grid grid(grid::Lattice lattice);

  static Solid solid(const Grid& grid, booleans::Body&& body);
  /// A packed body. A solid without one (empty by default, or moved from) has the empty one.
  static const booleans::Body& body(const Solid& solid);
  /// The same, perhaps patched: to be evaluated.
  static const booleans::Body& operand(const Solid& solid);
  /// Equal identities are equal bodies; nullptr is the empty one.
  static const booleans::Body* identity(const Solid& solid) { return solid.body_.get(); }

  static Motion motion(rounding::Motion motion) {
    return Motion(std::make_shared<const Motion::Data>(Motion::Data{std::move(motion)}));
  }
  static const rounding::Motion& motion(const Motion& motion) {
    static const rounding::Motion& identity = *new rounding::Motion;
    return motion.data_ ? motion.data_->motion : identity;
  }

  /// nullptr for the empty model.
  static const std::shared_ptr<const ModelNode>& node(const Model& model) { return model.node_; }
  static Model model(std::shared_ptr<const ModelNode> node) { return Model(std::move(node)); }

  /// nullptr where an expression was moved from: no terms.
  static const ExpressionNode* node(const Expression& expression) { return expression.node_.get(); }
};

}  // namespace quoin
