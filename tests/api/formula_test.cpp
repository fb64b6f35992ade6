#include "api/model/formula.h"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "tests/api/solids.h"

namespace quoin {
namespace {

using exact::Rational;

using Definitions = std::map<std::string, std::string>;

/// The value as text, or the error's code.
std::string value(const std::string& formula, const Definitions& definitions = {}) {
  const auto v = Parameters(definitions).value(formula);
  return v ? exact::to_string(v.value()) : to_string(v.error().code);
}

void expect_refused(const std::string& formula, const std::string& code, const std::string& message,
                    const Definitions& definitions = {}) {
  const auto v = Parameters(definitions).value(formula);
  ASSERT_FALSE(v) << formula;
  EXPECT_EQ(to_string(v.error().code), code) << formula;
  EXPECT_EQ(v.error().message, message);
}

std::string repeated(const std::string& s, int n) {
  std::string r;
  for (int i = 0; i < n; ++i) r += s;
  return r;
}

TEST(Formula, Numbers) {
  EXPECT_EQ(value("0"), "0");
  EXPECT_EQ(value("007"), "7");
  EXPECT_EQ(value("0.10"), "1/10");
  EXPECT_EQ(value(".5"), "1/2");
  EXPECT_EQ(value("5."), "5");
  EXPECT_EQ(value("1e-3"), "1/1000");
  EXPECT_EQ(value("1.25E+2"), "125");
  EXPECT_EQ(value("-1.25e-3"), "-1/800");
  EXPECT_EQ(value("1/3"), "1/3");
  EXPECT_EQ(value("-6/4"), "-3/2");
  EXPECT_EQ(value("12345678901234567890123"), "12345678901234567890123");
  EXPECT_EQ(value("1e400"), "1" + std::string(400, '0'));
  EXPECT_EQ(value("1e401"), "bad-number");
  EXPECT_EQ(value(std::string(4000, '1')), std::string(4000, '1'));
  EXPECT_EQ(value(std::string(4001, '1')), "too-large");
}

TEST(Formula, Precedence) {
  EXPECT_EQ(value("1+2*3"), "7");
  EXPECT_EQ(value("(1+2)*3"), "9");
  EXPECT_EQ(value("2*3+1"), "7");
  EXPECT_EQ(value("10-4-3"), "3");
  EXPECT_EQ(value("10-(4-3)"), "9");
  EXPECT_EQ(value("12/3/2"), "2");
  EXPECT_EQ(value("12/(3/2)"), "8");
  EXPECT_EQ(value("12/3*2"), "8");
  EXPECT_EQ(value("1/2+1/3"), "5/6");
  EXPECT_EQ(value("2*(1+2)*(3-5)/4"), "-3");
  EXPECT_EQ(value("((((7))))"), "7");
}

TEST(Formula, UnaryMinus) {
  EXPECT_EQ(value("-2"), "-2");
  EXPECT_EQ(value("-2*3"), "-6");
  EXPECT_EQ(value("2*-3"), "-6");
  EXPECT_EQ(value("6/-3"), "-2");
  EXPECT_EQ(value("2--3"), "5");
  EXPECT_EQ(value("2+-3"), "-1");
  EXPECT_EQ(value("-(2-5)"), "3");
  EXPECT_EQ(value("- a", {{"a", "-4"}}), "4");
  EXPECT_EQ(value("--3"), "3");
  EXPECT_EQ(value("+3"), "bad-number");
}

TEST(Formula, Spaces) {
  EXPECT_EQ(value("  1\t+ 2 *\t( a -1 )  ", {{"a", " 4 "}}), "7");
  for (const std::string text : {"1 2", "1. 5", "a b", "1 e3", "1\n", "1\r\n", "\v1"})
    EXPECT_EQ(value(text, {{"a", "1"}, {"b", "1"}, {"e3", "1"}}), "bad-number") << text;
}

TEST(Formula, Parameters) {
  const Definitions d{{"width", "10"}, {"half", "width / 2"}, {"_x1", "half * half - 1/3"}, {"e3", "7"}, {"E", "2"}};
  EXPECT_EQ(value("width", d), "10");
  EXPECT_EQ(value("half", d), "5");
  EXPECT_EQ(value("_x1", d), "74/3");
  EXPECT_EQ(value("2 * (width + 1) / 3", d), "22/3");
  // An exponent belongs to a number alone.
  EXPECT_EQ(value("e3*E", d), "14");
  EXPECT_EQ(value("1e3", d), "1000");
  EXPECT_EQ(value("2e", d), "bad-number");
  EXPECT_EQ(value("2E", d), "bad-number");
  // Upper and lower case differ.
  EXPECT_EQ(value("Width", d), "bad-parameter");
}

TEST(Formula, ADefinitionIsOneValueNotItsText) {
  EXPECT_EQ(value("2*a", {{"a", "1+1"}}), "4");
  EXPECT_EQ(value("-a/a", {{"a", "1-3"}}), "-1");
}

TEST(Formula, OneObjectReadsManyFormulas) {
  Parameters p({{"a", "b + 1"}, {"b", "2"}, {"c", "d"}, {"d", "c"}, {"bad", "1 +"}});
  EXPECT_EQ(exact::to_string(p.value("a").value()), "3");
  EXPECT_EQ(p.value("c").error().code, ErrorCode::bad_parameter);
  EXPECT_EQ(p.value("bad").error().code, ErrorCode::bad_number);
  EXPECT_EQ(p.value("d").error().message, "the parameter \"d\" is defined by itself");
  EXPECT_EQ(exact::to_string(p.value("a*b").value()), "6");
}

TEST(Formula, Cycles) {
  expect_refused("a", "bad-parameter", "the parameter \"a\" is defined by itself", {{"a", "a"}});
  expect_refused("a", "bad-parameter", "the parameter \"a\" is defined by itself", {{"a", "a + 1"}});
  const Definitions three{{"a", "2 * b"}, {"b", "1 - c"}, {"c", "(a)"}, {"x", "b"}};
  expect_refused("a", "bad-parameter", "the parameter \"a\" is defined by itself", three);
  expect_refused("x", "bad-parameter", "the parameter \"b\" is defined by itself", three);
  // Twice is no cycle.
  EXPECT_EQ(value("a + b", {{"a", "c + c"}, {"b", "c + a"}, {"c", "1"}}), "5");
}

TEST(Formula, UnknownNames) {
  expect_refused("x", "bad-parameter", "there is no parameter \"x\"");
  expect_refused("1 + a", "bad-parameter", "there is no parameter \"x_2\"", {{"a", "x_2"}});
  // The first error counts.
  expect_refused("x + y", "bad-parameter", "there is no parameter \"x\"");
  expect_refused("1/0 + x", "bad-number", "\"1/0 + x\" divides by 0");
  expect_refused("1/x", "bad-parameter", "there is no parameter \"x\"");
}

TEST(Formula, DivisionByZero) {
  expect_refused("1/0", "bad-number", "\"1/0\" divides by 0");
  expect_refused("1/(a-2)", "bad-number", "\"1/(a-2)\" divides by 0", {{"a", "2"}});
  expect_refused("0/0.00", "bad-number", "\"0/0.00\" divides by 0");
  expect_refused("1/-0", "bad-number", "\"1/-0\" divides by 0");
  // Where it happens, not where the parameter is used.
  expect_refused("1 + a", "bad-number", "\"1/0\" divides by 0", {{"a", "1/0"}});
  EXPECT_EQ(value("0/5"), "0");
}

TEST(Formula, SyntaxErrors) {
  for (const std::string text :
       {"", " ", "-", "3*", "*3", "3+", "()", "(", ")", ".", "e", "é", "1.2.3", "(1+)", "1//2"})
    EXPECT_EQ(value(text, {{"e", "-"}}), "bad-number") << text;
  expect_refused("", "bad-number", "\"\" is neither a number nor a formula");
  expect_refused("1 +", "bad-number", "\"1 +\" is neither a number nor a formula");
  expect_refused("1 2", "bad-number", "\"1 2\" is not understood from character 3 on");
  expect_refused("1)", "bad-number", "\"1)\" is not understood from character 2 on");
  expect_refused("2a", "bad-number", "\"2a\" is not understood from character 2 on", {{"a", "1"}});
  expect_refused("a(2)", "bad-number", "\"a(2)\" is not understood from character 2 on", {{"a", "1"}});
  expect_refused("2e+", "bad-number", "\"2e+\" is not understood from character 2 on");
  expect_refused("(1", "bad-number", "\"(1\" lacks a closing parenthesis");
  expect_refused("((1)", "bad-number", "\"((1)\" lacks a closing parenthesis");
  expect_refused("2^3", "bad-number", "\"2^3\" is not understood from character 2 on");
  // Long texts are quoted in part.
  expect_refused(std::string(200, '1') + "!", "bad-number",
                 "\"" + std::string(80, '1') + "\" is not understood from character 201 on");
}

TEST(Formula, Depth) {
  EXPECT_EQ(value(repeated("(", 199) + "1" + repeated(")", 199)), "1");
  EXPECT_EQ(value(repeated("(", 200) + "1" + repeated(")", 200)), "bad-number");
  EXPECT_EQ(value(repeated("-", 199) + "1"), "-1");
  EXPECT_EQ(value(repeated("-", 200) + "1"), "bad-number");
  expect_refused(repeated("(", 1000000), "bad-number", "\"" + repeated("(", 80) + "\" is nested too deeply");
  // Length is no depth.
  EXPECT_EQ(value("0" + repeated("+(1)", 10000)), "10000");
  EXPECT_EQ(value("1" + repeated("*-1", 10001)), "-1");
}

TEST(Formula, ChainsOfParameters) {
  const auto chain = [](int n) {
    Definitions d{{"p0", "1"}};
    for (int i = 1; i <= n; ++i) d["p" + std::to_string(i)] = "p" + std::to_string(i - 1) + " + 1";
    return value("p" + std::to_string(n), d);
  };
  EXPECT_EQ(chain(100), "101");
  // A value or an error, no crash.
  const std::string far = chain(20000);
  EXPECT_TRUE(far == "20001" || far.rfind("bad-", 0) == 0) << far;
}

// Parentheses around parameters of parameters are within each other too.
TEST(Formula, DepthOfAllFormulasTogether) {
  const auto chain = [](int n, int parentheses) {
    Definitions d{{"p0", "1"}};
    for (int i = 1; i <= n; ++i)
      d["p" + std::to_string(i)] =
          repeated("(", parentheses) + "p" + std::to_string(i - 1) + " + 1" + repeated(")", parentheses);
    return value("p" + std::to_string(n), d);
  };
  EXPECT_EQ(chain(150, 4), "151");
  EXPECT_EQ(chain(199, 100), "bad-number");
  // An error leaves no trace: the next formula may be as deep.
  Parameters parameters({{"deep", repeated("(", 201) + "1" + repeated(")", 201)}});
  for (int i = 0; i < 20; ++i) {
    EXPECT_FALSE(parameters.value("deep"));
    EXPECT_TRUE(parameters.value(repeated("(", 199) + "1" + repeated(")", 199)));
  }
}

TEST(Formula, ParameterNames) {
  for (const std::string name : {"a", "_", "Z9", "long_name_2", "e5"}) {
    EXPECT_TRUE(is_parameter_name(name)) << name;
    EXPECT_EQ(value(name + "+1", {{name, "1"}}), "2") << name;
  }
  for (const std::string name : {"", "1a", "a b", "a-b", "é", "a.b", " a", "a\n"}) {
    EXPECT_FALSE(is_parameter_name(name)) << name;
    EXPECT_NE(value(name + "+1", {{name, "1"}}), "2") << name;
  }
}

/// A formula as a tree, evaluated on the way up and printed with no more parentheses than it needs, or with more.
struct Tree {
  Rational value;
  std::string text;
  int level;  // 0: sum, 1: product, 2: factor
};

class RandomFormula {
 public:
  explicit RandomFormula(std::mt19937_64& random) : random_(random) {}

  Definitions definitions;

  void define(const std::string& name, int depth) {
    const Tree t = tree(depth);
    definitions[name] = t.text;
    names_.emplace_back(name, t.value);
  }

  Tree tree(int depth) {
    if (depth == 0) return leaf();
    const Tree a = tree(depth - 1);
    switch (random_() % 6) {
      case 0:
        return {-a.value, "-" + space() + at_level(a, 2), 2};
      case 1:
        return a;
      default:
        break;
    }
    const Tree b = tree(static_cast<int>(random_() % static_cast<unsigned>(depth)));
    switch (random_() % (b.value == 0 ? 3 : 4)) {
      case 0:
        return {a.value + b.value, at_level(a, 0) + sign("+") + at_level(b, 1), 0};
      case 1:
        return {a.value - b.value, at_level(a, 0) + sign("-") + at_level(b, 1), 0};
      case 2:
        return {a.value * b.value, at_level(a, 1) + sign("*") + at_level(b, 2), 1};
      default:
        return {a.value / b.value, at_level(a, 1) + sign("/") + at_level(b, 2), 1};
    }
  }

 private:
  std::string space() { return std::vector{"", "", " ", "\t "}[random_() % 4]; }
  std::string sign(const std::string& s) { return space() + s + space(); }
  std::string at_level(const Tree& t, int level) {
    if (t.level >= level && random_() % 8 != 0) return t.text;
    return "(" + space() + t.text + space() + ")";
  }
  Tree leaf() {
    if (!names_.empty() && random_() % 3 == 0) {
      const auto& [name, v] = names_[random_() % names_.size()];
      return {v, name, 2};
    }
    // digits * 10^(exponent - places), written with a point.
    std::string digits = std::to_string(random_() % (random_() % 2 == 0 ? 10 : 100000));
    const std::size_t places = random_() % 4;
    const int exponent = random_() % 3 == 0 ? static_cast<int>(random_() % 13) - 6 : 0;
    Rational v = std::stoi(digits);
    for (int i = static_cast<int>(places) - exponent; i > 0; --i) v /= 10;
    for (int i = static_cast<int>(places) - exponent; i < 0; ++i) v *= 10;
    while (digits.size() < places) digits.insert(0, "0");
    if (places > 0) digits.insert(digits.size() - places, ".");
    if (exponent != 0) digits += (random_() % 2 == 0 ? "e" : "E") + std::to_string(exponent);
    return {v, digits, 2};
  }

  std::mt19937_64& random_;
  std::vector<std::pair<std::string, Rational>> names_;
};

TEST(Formula, RandomFormulasAgreeWithTheirTrees) {
  auto random = api_test::random_engine();
  for (int round = 0; round < 200; ++round) {
    RandomFormula formula(random);
    // Names in an order that is not that of their definitions.
    for (const char* name : {"width", "b", "_1", "e2"}) formula.define(name, static_cast<int>(random() % 4));
    Parameters parameters(formula.definitions);
    for (int i = 0; i < 10; ++i) {
      const Tree t = formula.tree(static_cast<int>(random() % 8));
      const auto v = parameters.value(t.text);
      ASSERT_TRUE(v) << t.text << ": " << v.error().message;
      ASSERT_EQ(v.value(), t.value) << t.text;
    }
  }
}

}  // namespace
}  // namespace quoin
