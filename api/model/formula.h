/// \file
/// Formulas over named parameters, in exact rationals.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "exact/rational.h"
#include "quoin/limits.h"
#include "quoin/result.h"

namespace quoin {

/// The values of parameters, whose definitions may be formulas of each other.
class Parameters {
 public:
  explicit Parameters(std::map<std::string, std::string> definitions, std::uint64_t most_digits = Limits{}.digits)
      : definitions_(std::move(definitions)), most_digits_(most_digits) {}

  /// sum = product {(+ | -) product}; product = factor {(* | /) factor}; factor = "-" factor | decimal | name | "(" sum
  /// ")". Errors: "bad-number" (a syntax error, a division by 0, more than 2^16 bits, more than 200 parentheses and
  /// signs within each other, or 1,000 with those around the parameters on the way), "bad-parameter" (an unknown name,
  /// one that is defined by itself, or a row of more than 200),
  /// "too-large" (a number of more digits than the limit).
  Result<exact::Rational> value(std::string_view formula);
  /// Whether a formula so far has asked for the parameter.
  bool was_used(const std::string& name) const { return known_.count(name) > 0; }

 private:
  friend class FormulaReader;
  Result<exact::Rational> parameter(const std::string& name);

  std::map<std::string, std::string> definitions_;
  std::uint64_t most_digits_;
  std::map<std::string, exact::Rational> known_;
  std::vector<std::string> open_;  // being read
  int depth_ = 0;                  // of what is being read, in all formulas
};

/// The error of a number that is too long.
Error too_many_digits(std::uint64_t digits, std::uint64_t limit);

/// A letter or "_", then letters, digits or "_".
bool is_parameter_name(std::string_view name);

}  // namespace quoin
