#include "io/scanner.h"

#include <array>
#include <charconv>
#include <cstdio>
#include <locale>

#include "tests/io/io_support.h"

namespace quoin::io {
namespace {

/// "" when the whole text was read as a number, else the code of the error.
std::string number_code(std::string_view text, double& out) {
  Scanner scanner(text);
  return scanner.number(out) ? "" : to_string(scanner.take_error().code);
}

void expect_as_strtod(const std::string& text) {
  double value = 1;
  const std::string code = number_code(text, value);
  const double expected = std::strtod(text.c_str(), nullptr);
  if (std::isfinite(expected)) {
    EXPECT_EQ(code, "") << text;
    EXPECT_EQ(std::bit_cast<std::uint64_t>(value), std::bit_cast<std::uint64_t>(expected)) << text;
  } else {
    EXPECT_EQ(code, "non-finite") << text;
  }
}

TEST(Scanner, NumbersAreNearestDoubles) {
  const std::string zeros(400, '0');
  for (const std::string& text :
       std::vector<std::string>{"0",
                                "-0",
                                "+1",
                                "1.",
                                ".5",
                                "-.5",
                                "1e5",
                                "1E+5",
                                "1e-5",
                                "+1.25E-3",
                                "0.1",
                                "1e22",
                                "1e23",
                                "8.5e22",
                                "2.2250738585072011e-308",
                                "2.2250738585072012e-308",
                                "4.9e-324",
                                "2.4703282292062327e-324",
                                "2.4703282292062328e-324",
                                "2.5e-324",
                                "-1e-400",
                                "1e-99999",
                                "0e99999",
                                "-0.0e400",
                                "1.7976931348623157e308",
                                "1.7976931348623158e308",
                                "1.7976931348623159e308",
                                "1e309",
                                "-1e400",
                                "1e99999",
                                "1e99999999999999999999",
                                "1e-99999999999999999999",
                                "9007199254740993",
                                "9007199254740992.5",
                                "9007199254740993.00000000000000000000000000000000000001",
                                "0." + zeros + "1e401",
                                "1" + zeros + "e-400",
                                "1" + zeros,
                                "0." + zeros + "1",
                                "100000000000000000000000000000000000000000e-41",
                                "7.2057594037927933e16",
                                "0.000000000000000000000000000000000000012345678901234567890123"}) {
    expect_as_strtod(text);
  }
}

TEST(Scanner, RandomNumbersAreNearestDoubles) {
  std::mt19937_64 random(test::seed());
  for (int round = 0; round < 20000; ++round) {
    const double value = test::any_finite(random);
    char buffer[1200];
    (void)std::snprintf(buffer, sizeof buffer, "%.*e", static_cast<int>(random() % 40), value);
    expect_as_strtod(buffer);
    std::string digits = std::to_string(random()) + "." + std::to_string(random());
    expect_as_strtod(digits + "e" + std::to_string(static_cast<int>(random() % 700) - 350));
    // Halfway between two neighbours, exactly, and one digit beyond.
    const auto odd = static_cast<double>((random() >> 11) | 1);
    (void)std::snprintf(buffer, sizeof buffer, "%.0f", odd * 1024);
    expect_as_strtod(buffer);
    expect_as_strtod(std::string(buffer) + ".0000000000000000000000000001");
  }
}

TEST(Scanner, RefusesWhatIsNoDecimal) {
  double value = 0;
  for (const char* text :
       {"x", "-", "+", "+-1", "-+1", "--1", "1,5", "0x10", "1e", "1e+", "1.2.3", "1f", "1#", "e5", "."}) {
    EXPECT_EQ(number_code(text, value), "bad-number") << text;
  }
  for (const char* text : {"nan", "NaN", "-nan", "nan(0x1)", "inf", "-inf", "+inf", "Infinity", "-INFINITY"}) {
    EXPECT_EQ(number_code(text, value), "non-finite") << text;
  }
  EXPECT_EQ(number_code("", value), "truncated");
  EXPECT_EQ(number_code("  \n1", value), "bad-syntax");
}

TEST(Scanner, IgnoresTheLocale) {
  struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  const auto mesh = test::strip({0.5, 1.5, 1e6, 1e22});
  const auto texts = [&] {
    std::vector<std::string> result;
    for (const Format format : {Format::obj, Format::off, Format::ply_ascii, Format::stl_ascii}) {
      result.push_back(write_mesh(mesh.points, mesh.triangles, format));
    }
    return result;
  };
  const std::vector<std::string> expected = texts();
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
  double value = 0;
  EXPECT_EQ(number_code("1.5", value), "");
  EXPECT_EQ(value, 1.5);
  EXPECT_EQ(number_code("1,5", value), "bad-number");
  EXPECT_EQ(texts(), expected);
  std::locale::global(before);
}

TEST(Scanner, IntegersSaturate) {
  const auto integer = [](std::string_view text) {
    Scanner scanner(text);
    std::int64_t value = 0;
    return scanner.integer(value) ? std::to_string(value) : to_string(scanner.take_error().code);
  };
  EXPECT_EQ(integer("42"), "42");
  EXPECT_EQ(integer(" +42 "), "42");
  EXPECT_EQ(integer("-7"), "-7");
  EXPECT_EQ(integer("99999999999999999999"), "9223372036854775807");
  EXPECT_EQ(integer("-99999999999999999999"), "-9223372036854775808");
  EXPECT_EQ(integer("1.0"), "bad-number");
  EXPECT_EQ(integer("1e3"), "bad-number");
  EXPECT_EQ(integer("#"), "bad-number");
}

TEST(Scanner, LinesEndInThreeWays) {
  Scanner scanner("a\nb\r\nc\rd", {});
  for (const char* expected : {"a", "b", "c", "d"}) {
    scanner.skip_space();
    EXPECT_EQ(scanner.word(), expected);
  }
  (void)scanner.fail(ErrorCode::bad_syntax, "message");
  EXPECT_EQ(scanner.take_error().where, "line 4");
}

TEST(Scanner, JoinsLinesOnlyOnRequest) {
  Scanner joined("a \\\nb\nc", {.hash_comments = true, .line_continuation = true});
  EXPECT_EQ(joined.word(), "a");
  EXPECT_EQ(joined.word(), "b");
  EXPECT_EQ(joined.word(), "");
  Scanner passed("a \\\r\nb\nc", {.hash_comments = true, .line_continuation = true});
  passed.skip_line();
  EXPECT_EQ(passed.word(), "c");
  Scanner comment("# a \\\nb", {.hash_comments = true, .line_continuation = true});
  comment.skip_line();
  EXPECT_EQ(comment.word(), "b");
  Scanner plain("a \\\nb");
  EXPECT_EQ(plain.word(), "a");
  EXPECT_EQ(plain.word(), "\\");
}

// Decimals around the middle of two doubles, written with up to 800 digits, and random words: the standard library's
// from_chars is the second way, to the bit.
TEST(Scanner, NumbersAreThoseOfTheStandardLibrary) {
  std::mt19937_64 random(test::seed());
  std::vector<std::string> words = {"0x10", "1e", "1e+", ".", "-", "+", "+-1", "--1", "1.2.3", "1,5", "e5", "1d5"};
  for (int round = 0; round < 4000; ++round) {
    const double value = std::fabs(test::any_finite(random));
    std::array<char, 1200> exact = {};
    // All digits of a double, and of a number close to the middle between it and the next one.
    const auto size = static_cast<std::size_t>(std::snprintf(exact.data(), exact.size(), "%.780e", value));
    std::string digits(exact.data(), size);
    words.push_back(digits);
    digits[2 + random() % 770] = static_cast<char>('0' + random() % 10);
    words.push_back(digits);
    words.push_back("-" + std::to_string(random()) + "e" + std::to_string(static_cast<int>(random() % 700) - 350));
    words.push_back(std::to_string(random() >> 11) + "5" + std::string(random() % 30, '0') + "1e-" +
                    std::to_string(random() % 340));
    std::string junk;
    for (std::size_t i = random() % 9 + 1; i > 0; --i) junk.push_back("0123456789.eE+-nif"[random() % 18]);
    words.push_back(junk);
  }

  for (const std::string& word : words) {
    const char* const first = word.data() + (word.size() > 1 && word[0] == '+' && word[1] != '-' ? 1 : 0);
    const char* const last = word.data() + word.size();
    double expected = 0, value = 0;
    const auto [end, code] = std::from_chars(first, last, expected);
    const std::string found = number_code(word, value);
    if (code == std::errc::invalid_argument || end != last) {
      EXPECT_EQ(found, "bad-number") << word;
    } else if (code == std::errc() && std::isfinite(expected)) {
      EXPECT_EQ(found, "") << word;
      EXPECT_EQ(std::bit_cast<std::uint64_t>(value), std::bit_cast<std::uint64_t>(expected)) << word;
    }
  }
}

}  // namespace
}  // namespace quoin::io
