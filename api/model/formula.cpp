#include "api/model/formula.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "io/too_large.h"

namespace quoin {

using exact::Rational;

namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

constexpr int deepest = 200;                // of parentheses and signs in one formula
constexpr int deepest_in_all = 1000;        // in a formula and those of its parameters: bounds the recursion
constexpr std::size_t longest_chain = 200;  // of parameters
constexpr std::size_t longest = 1 << 16;    // bits of a value

}  // namespace

bool is_parameter_name(std::string_view name) {
  return !name.empty() && is_letter(name[0]) &&
         std::all_of(name.begin(), name.end(), [](char c) { return is_letter(c) || is_digit(c); });
}

Error too_many_digits(std::uint64_t digits, std::uint64_t limit) {
  return io::too_large("the number of " + std::to_string(digits) + " digits has more", "digits", limit);
}

/// Reads one formula from left to right; the first error stays.
class FormulaReader {
 public:
  FormulaReader(std::string_view text, Parameters& parameters) : text_(text), parameters_(parameters) {}

  Result<Rational> run() {
    const int outside = parameters_.depth_;
    const Rational v = sum();
    parameters_.depth_ = outside;
    skip();
    if (!error_ && at_ < text_.size())
      fail(ErrorCode::bad_number, "is not understood from character " + std::to_string(at_ + 1) + " on");
    if (error_) return *error_;
    return v;
  }

 private:
  void skip() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
  }
  bool take(char c) {
    skip();
    if (at_ == text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  Rational fail(Error error) {
    if (!error_) error_ = std::move(error);
    at_ = text_.size();
    return 0;
  }
  Rational fail(ErrorCode code, const std::string& what) {
    return fail(Error{code, "\"" + std::string(text_.substr(0, 80)) + "\" " + what});
  }

  Rational checked(const Rational& v) {
    const auto bits = [](const exact::Integer& i) { return mpz_sizeinbase(i.backend().data(), 2); };
    return bits(numerator(v)) + bits(denominator(v)) <= longest ? v
                                                                : fail(ErrorCode::bad_number, "has too many digits");
  }

  Rational sum() {
    Rational v = product();
    for (;;) {
      if (take('+'))
        v = checked(v + product());
      else if (take('-'))
        v = checked(v - product());
      else
        return v;
    }
  }

  Rational product() {
    Rational v = factor();
    for (;;) {
      if (take('*')) {
        v = checked(v * factor());
      } else if (take('/')) {
        const Rational d = factor();
        if (d == 0) return error_ ? v : fail(ErrorCode::bad_number, "divides by 0");
        v = checked(v / d);
      } else {
        return v;
      }
    }
  }

  Rational factor() {
    ++parameters_.depth_;
    if (++depth_ > deepest || parameters_.depth_ > deepest_in_all)
      return fail(ErrorCode::bad_number, "is nested too deeply");

    Rational v = 0;
    if (take('-')) {
      v = -factor();
    } else if (take('(')) {
      v = sum();
      if (!take(')')) fail(ErrorCode::bad_number, "lacks a closing parenthesis");
    } else {
      v = name_or_number();
    }

    --depth_;
    --parameters_.depth_;
    return v;
  }

  Rational name_or_number() {
    skip();
    const std::size_t begin = at_;
    if (at_ < text_.size() && is_letter(text_[at_])) {
      while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]))) ++at_;
      auto v = parameters_.parameter(std::string(text_.substr(begin, at_ - begin)));
      return v ? v.value() : fail(v.error());
    }

    while (at_ < text_.size() && (is_digit(text_[at_]) || text_[at_] == '.')) ++at_;
    // An exponent, if a number follows.
    if (at_ < text_.size() && at_ > begin && (text_[at_] == 'e' || text_[at_] == 'E')) {
      std::size_t end = at_ + 1;
      if (end < text_.size() && (text_[end] == '+' || text_[end] == '-')) ++end;
      const std::size_t digits = end;
      while (end < text_.size() && is_digit(text_[end])) ++end;
      if (end > digits) at_ = end;
    }

    const std::string_view number = text_.substr(begin, at_ - begin);
    const auto digits = static_cast<std::uint64_t>(std::count_if(number.begin(), number.end(), is_digit));
    if (digits > parameters_.most_digits_) return fail(too_many_digits(digits, parameters_.most_digits_));
    const auto v = exact::parse_rational(number, number.size());
    return v ? *v : fail(ErrorCode::bad_number, "is neither a number nor a formula");
  }

  std::string_view text_;
  Parameters& parameters_;
  std::size_t at_ = 0;
  int depth_ = 0;
  std::optional<Error> error_;
};

Result<Rational> Parameters::value(std::string_view formula) { return FormulaReader(formula, *this).run(); }

Result<Rational> Parameters::parameter(const std::string& name) {
  if (const auto at = known_.find(name); at != known_.end()) return at->second;
  const auto definition = definitions_.find(name);
  if (definition == definitions_.end())
    return Error{ErrorCode::bad_parameter, "there is no parameter \"" + name + "\""};
  if (std::find(open_.begin(), open_.end(), name) != open_.end())
    return Error{ErrorCode::bad_parameter, "the parameter \"" + name + "\" is defined by itself"};
  if (open_.size() == longest_chain)
    return Error{ErrorCode::bad_parameter, "parameters are defined by each other in a row of more than " +
                                               std::to_string(longest_chain) + ", up to \"" + name + "\""};

  open_.push_back(name);
  const auto v = value(definition->second);
  open_.pop_back();
  if (v) known_.emplace(name, v.value());
  return v;
}

}  // namespace quoin
