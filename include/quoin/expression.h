/// \file
/// Boolean expressions over many solids and half-spaces, evaluated as one operation.
#pragma once

#include "quoin/export.h"

#include <memory>
#include <vector>

#include "quoin/options.h"
#include "quoin/result.h"
#include "quoin/solid.h"

namespace quoin {

/// A Boolean expression over solids, evaluated as one operation.
class QUOIN_API Expression {
 public:
  Expression(const Solid& solid);           // NOLINT: implicit by design
  Expression(const HalfSpace& half_space);  // NOLINT: the points with a x + b y + c z + d <= 0
  static Expression unite(std::vector<Expression> terms);
  static Expression intersect(std::vector<Expression> terms);
  /// The first minus all others.
  static Expression difference(Expression minuend, std::vector<Expression> subtrahends);
  /// Points in an odd number of terms.
  static Expression symmetric_difference(std::vector<Expression> terms);
  static Expression complement(Expression term);

  friend QUOIN_API Expression operator+(Expression a, Expression b);
  friend QUOIN_API Expression operator-(Expression a, Expression b);
  friend QUOIN_API Expression operator&(Expression a, Expression b);
  friend QUOIN_API Expression operator^(Expression a, Expression b);
  friend QUOIN_API Expression operator~(Expression a);

 private:
  friend struct Access;
  struct Node;
  explicit Expression(std::shared_ptr<const Node> node);
  std::shared_ptr<const Node> node_;
};

/// Evaluates an expression in one arrangement. Solids of different grids go to a common one, and half-spaces to it, as
/// `unite` and `split` do (quoin/solid.h); `report`, when given, receives what was rounded.
/// Errors: "inexact-grid", "cancelled", "inconsistent" (an operand trusted wrongly), "no-operand", "bad-plane". Of an
/// operand that cannot take part `where` begins with its number, "operand 3": solids and half-spaces are counted from 0
/// in the order in which the expression names them.
QUOIN_API Result<Solid> evaluate(const Expression& expression, const Options& options = {},
                                 OperationReport* report = nullptr);

}  // namespace quoin
