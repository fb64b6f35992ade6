/// \file
/// A workload's operation, done by Quoin.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "quoin/quoin.h"

namespace quoin::bench {

/// The value; an error ends the program.
template <class T>
T must(Result<T> result) {
  if (result) return std::move(result).value();
  std::fprintf(stderr, "%s: %s\n", to_string(result.error().code).c_str(), result.error().message.c_str());
  std::exit(1);
}

/// `operation` is a word of bench::name(Operation); evaluate(expression) gives the solid of each operation.
/// Precondition: there are two operands at least.
template <class Evaluate>
Solid combine(const std::string& operation, const std::vector<Solid>& s, Evaluate evaluate) {
  const std::vector<Expression> all(s.begin(), s.end()), rest(s.begin() + 1, s.end());
  if (operation == "union") return evaluate(Expression::unite(all));
  if (operation == "intersection") return evaluate(Expression::intersect(all));
  if (operation == "difference") return evaluate(all[0] - Expression::unite(rest));
  if (operation == "parts") {
    std::vector<Expression> parts;
    for (std::size_t i = 0; i + 1 < s.size(); i += 2) parts.push_back(all[i] - all[i + 1]);
    return evaluate(Expression::unite(parts));
  }
  if (operation == "nested") {
    Expression nested = all.back();
    for (std::size_t i = all.size() - 1; i-- > 0;) nested = all[i] - nested;
    return evaluate(nested);
  }
  if (operation == "leaning" || operation == "alternating") {
    Expression tree = all[0];
    for (std::size_t i = 1; i < all.size(); ++i)
      tree = operation == "leaning" || i % 2 == 1 ? tree + all[i] : tree - all[i];
    return evaluate(tree);
  }
  if (operation == "remainders") {
    std::vector<Expression> remainders;
    for (const Expression& next : rest) remainders.push_back(all[0] - next);
    return evaluate(Expression::unite(remainders));
  }
  Solid result = s[0];
  for (const Expression& next : rest) result = evaluate(operation == "unions" ? result + next : result - next);
  return result;
}

}  // namespace quoin::bench
