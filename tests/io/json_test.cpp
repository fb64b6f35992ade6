#include "io/json.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "tests/io/io_support.h"

namespace quoin::io {
namespace {

Json parsed(const std::string& text) {
  // A copy of exact size, so that the sanitizer sees a read behind the end.
  const std::vector<char> copy(text.begin(), text.end());
  auto json = read_json(std::string_view(copy.data(), copy.size()));
  if (!json) ADD_FAILURE() << json.error().message << " (" << json.error().where << ")\n" << text.substr(0, 200);
  return json ? std::move(json).value() : Json();
}

/// "place: message" of a text that is refused, "" of one that is read.
std::string refusal(const std::string& text) {
  const std::vector<char> copy(text.begin(), text.end());
  const auto json = read_json(std::string_view(copy.data(), copy.size()));
  if (json) return "";
  EXPECT_EQ(json.error().code, ErrorCode::bad_model);
  return json.error().where + ": " + json.error().message;
}

void expect_refused(const std::string& text, const std::string& place, const std::string& words) {
  const std::string found = refusal(text);
  EXPECT_EQ(found.substr(0, found.find(": ")), place) << found << "\n" << text.substr(0, 200);
  EXPECT_NE(found.find(words), std::string::npos) << found << "\n" << text.substr(0, 200);
}

bool same(const Json& a, const Json& b) {
  return a.kind == b.kind && a.text == b.text && std::ranges::equal(a.items, b.items, same) &&
         std::ranges::equal(a.members, b.members, [](const auto& m, const auto& n) {
           return m.first == n.first && same(m.second, n.second);
         });
}

/// Kinds, texts and places of a tree, values before what is in them.
void outline(const Json& v, std::string& out) {
  const std::string_view kind = std::vector<std::string_view>{
      "null", "boolean", "number", "text", "list", "object"}[static_cast<std::size_t>(v.kind)];
  out += std::to_string(v.line) + ":" + std::to_string(v.column) + " " + std::string(kind);
  if (!v.text.empty()) out += " " + v.text;
  out += "\n";
  for (const Json& item : v.items) outline(item, out);
  for (const auto& [name, value] : v.members) {
    out += name + " = ";
    outline(value, out);
  }
}

std::string outline(const Json& v) {
  std::string out;
  outline(v, out);
  return out;
}

std::string repeated(const std::string& s, int n) {
  std::string r;
  for (int i = 0; i < n; ++i) r += s;
  return r;
}

TEST(Json, NumbersStayAsTheyAreWritten) {
  for (const std::string number : {"0",
                                   "-5",
                                   "1",
                                   "0.10",
                                   "1e-3",
                                   "1E+5",
                                   "-0.0",
                                   "-1.50e-07",
                                   "1e-400",
                                   "123456789012345",
                                   "9007199254740993",
                                   "9223372036854775807",
                                   "-9223372036854775808",
                                   "9223372036854775808",
                                   "18446744073709551615",
                                   "18446744073709551616",
                                   "-9223372036854775809",
                                   "12345678901234567890123",
                                   "-12345678901234567890123",
                                   "0.1000000000000000055511151231257827021181583404541015625"}) {
    EXPECT_TRUE(same(parsed(number), json_number(number))) << parsed(number).text;
    EXPECT_TRUE(same(parsed("[" + number + "]"), json_list({json_number(number)})));
    EXPECT_EQ(write_json(parsed(number)), number + "\n");
  }
}

TEST(Json, NumbersBeyondTheDoublesAreRefused) {
  expect_refused("1e400", "line 1, column 5", "number overflow");
  expect_refused("[1, -1e400]", "line 1, column 11", "number overflow");
  expect_refused(std::string(400, '9'), "line 1, column 400", "number overflow");
}

TEST(Json, OtherSpellingsOfNumbersAreRefused) {
  for (const std::string text : {"+1", ".5", "5.", "01", "-", "1e", "0x10", "1/3", "NaN", "Infinity", "1_000", "--1"}) {
    EXPECT_NE(refusal(text), "") << text;
    EXPECT_NE(refusal("[" + text + "]"), "") << text;
  }
}

TEST(Json, ValuesOfAllKinds) {
  const Json v = parsed(R"({"a": [null, true, false, "x", 1, {}, []], "b": {"c": "d"}})");
  const Json expected = json_object({{"a", json_list({{},
                                                      {.kind = Json::Kind::boolean, .text = "true"},
                                                      {.kind = Json::Kind::boolean, .text = "false"},
                                                      json_text("x"),
                                                      json_number("1"),
                                                      json_object(),
                                                      json_list()})},
                                     {"b", json_object({{"c", json_text("d")}})}});
  EXPECT_TRUE(same(v, expected)) << outline(v);
  ASSERT_NE(v.member("b"), nullptr);
  EXPECT_TRUE(same(*v.member("b"), expected.members[1].second));
  EXPECT_EQ(v.member("c"), nullptr);
  EXPECT_EQ(v.member("a")->member("a"), nullptr);
  // Members stay in their order.
  EXPECT_EQ(write_json(parsed(R"({"z": 1, "a": 2, "m": 3})")), "{\"z\": 1, \"a\": 2, \"m\": 3}\n");
}

TEST(Json, Escapes) {
  EXPECT_EQ(parsed(R"("\"\\\/\b\f\n\r\t")").text, "\"\\/\b\f\n\r\t");
  EXPECT_EQ(parsed(R"("\u00e9 \u20AC \ud83d\ude00 \u0000.")").text,
            std::string("\xc3\xa9 \xe2\x82\xac \xf0\x9f\x98\x80 \0.", 14));
  EXPECT_EQ(write_json(json_text("a\"b\\c\n\t\x01/\x7f \xc3\xa9")), "\"a\\\"b\\\\c\\n\\t\\u0001/\x7f \xc3\xa9\"\n");
  EXPECT_EQ(write_json(json_object({{"a\"\n", json_number("1")}})), "{\"a\\\"\\n\": 1}\n");
  // What is no UTF-8 is replaced, so that any text can be read again.
  EXPECT_EQ(parsed(write_json(json_text("a\xff"))).text, "a\xef\xbf\xbd");
}

// A scalar stands where it ends, a list or an object where it begins.
TEST(Json, Places) {
  EXPECT_EQ(outline(parsed("{\"a\": [true, \"xy\",\n  null],\n\t\"b\":{ \"c\" : false } }")),
            "1:1 object\n"
            "a = 1:7 list\n"
            "1:11 boolean true\n"
            "1:17 text xy\n"
            "2:6 null\n"
            "b = 3:6 object\n"
            "c = 3:18 boolean false\n");
  EXPECT_EQ(parsed("\n\n  []").place(), "line 3, column 3");
  // Characters count, not bytes.
  EXPECT_EQ(outline(parsed("[\"\xc3\xa9\xe2\x82\xac\", {}]")), "1:1 list\n1:5 text \xc3\xa9\xe2\x82\xac\n1:8 object\n");
}

TEST(Json, PlacesOfNumbers) {
  EXPECT_EQ(parsed("125").place(), "line 1, column 3");
  EXPECT_EQ(outline(parsed("[5, 16,\n 7.5]")), "1:1 list\n1:2 number 5\n1:6 number 16\n2:4 number 7.5\n");
  EXPECT_EQ(outline(parsed("{\"a\": 5\n}")), "1:1 object\na = 1:7 number 5\n");
}

TEST(Json, EmptyAndTruncated) {
  EXPECT_EQ(refusal("").substr(0, 4), "line");
  EXPECT_NE(refusal("").find("not JSON"), std::string::npos);
  expect_refused("  \n ", "line 2, column 1", "unexpected end of input");
  // No proper prefix of a list or an object is one.
  const std::string whole = R"({"a": [1, "x\u00e9\n", true, null], "b": {"c": -1.5e-3}})";
  EXPECT_EQ(refusal(whole), "");
  for (std::size_t n = 0; n < whole.size(); ++n) EXPECT_NE(refusal(whole.substr(0, n)), "") << n;
}

TEST(Json, Refusals) {
  expect_refused("[1] x", "line 1, column 5", "expected end of input");
  expect_refused("{}\n\n{}", "line 3, column 1", "expected end of input");
  expect_refused("[1]]", "line 1, column 4", "expected end of input");
  expect_refused("[1,]", "line 1, column 4", "unexpected ']'");
  expect_refused("{\"a\" 1}", "line 1, column 7", "expected ':'");
  expect_refused("{\"a\": 1,}", "line 1, column 9", "expected string literal");
  expect_refused("{a: 1}", "line 1, column 2", "expected string literal");
  expect_refused("[1 // one\n]", "line 1, column 4", "not JSON");
  expect_refused("['a']", "line 1, column 2", "not JSON");
  expect_refused("[\"a\nb\"]", "line 2, column 1", "control character");
  expect_refused("\"\\x\"", "line 1, column 3", "not JSON");
  expect_refused("nul", "line 1, column 3", "invalid literal");
}

TEST(Json, NoZeroByteEndsTheText) {
  using namespace std::string_literals;
  EXPECT_NE(refusal("1\0 x"s), "");
  EXPECT_NE(refusal("[1]\0"s), "");
  EXPECT_NE(refusal("[1\0]"s), "");
  EXPECT_NE(refusal("\0"s), "");
  EXPECT_NE(refusal("\"a\0b\""s), "");
}

TEST(Json, BadUtf8) {
  expect_refused("\"\xff\"", "line 1, column 2", "UTF-8");
  for (const std::string bytes : {"\x80", "\xc3", "\xc3(", "\xc0\xaf", "\xe2\x82", "\xed\xa0\x80", "\xf4\x90\x80\x80"})
    EXPECT_NE(refusal("[\"" + bytes + "\"]").find("UTF-8"), std::string::npos);
  EXPECT_NE(refusal(R"("\ud800")"), "");
  EXPECT_NE(refusal(R"("\udc00")"), "");
  // A byte order mark is passed over.
  EXPECT_TRUE(same(parsed("\xef\xbb\xbf[]"), json_list()));
}

TEST(Json, NamesAreDistinct) {
  expect_refused("{\"a\": 1,\n \"a\": 2}", "line 2, column 4", "the name \"a\" occurs twice");
  expect_refused("[{\"b\": {\"\\u0061\": 1, \"c\": [], \"a\": {}}}]", "line 1, column 33", "occurs twice");
  EXPECT_EQ(refusal(R"({"a": {"a": 1}, "b": [{"a": 1}, {"a": 1}]})"), "");
}

TEST(Json, ThousandLevels) {
  EXPECT_EQ(refusal(repeated("[", 1000) + repeated("]", 1000)), "");
  expect_refused(repeated("[", 1001) + repeated("]", 1001), "line 1, column 1001", "more than 1000 levels");
  EXPECT_EQ(refusal(repeated("{\"a\":", 1000) + "1" + repeated("}", 1000)), "");
  expect_refused(repeated("{\"a\":", 1000) + "[]" + repeated("}", 1000), "line 1, column 5001", "1000 levels");
  // A million are refused without being built.
  expect_refused(repeated("[\n", 1000000), "line 1001, column 1", "1000 levels");
}

TEST(Json, LineBreaks) {
  EXPECT_EQ(write_json(json_list()), "[]\n");
  EXPECT_EQ(write_json(json_object()), "{}\n");
  EXPECT_EQ(write_json({}), "null\n");
  EXPECT_EQ(write_json(json_list({json_number("1"), json_text("a")})), "[1, \"a\"]\n");
  const std::string long_text(90, 'x');
  EXPECT_EQ(write_json(json_list({json_text(long_text), json_list({json_number("1"), json_number("2")}),
                                  json_object({{"a", json_text(long_text)}, {"b", json_object()}})})),
            "[\n"
            "  \"" +
                long_text +
                "\",\n"
                "  [1, 2],\n"
                "  {\n"
                "    \"a\": \"" +
                long_text +
                "\",\n"
                "    \"b\": {}\n"
                "  }\n"
                "]\n");
}

std::string random_text(std::mt19937_64& random) {
  const std::vector<std::string> letters{"a",
                                         "b",
                                         " ",
                                         "\"",
                                         "\\",
                                         "/",
                                         "\n",
                                         "\x01",
                                         std::string(1, '\0'),
                                         "\x7f",
                                         "{}",
                                         "0",
                                         "\xc3\xa9",
                                         "\xe2\x82\xac",
                                         "\xf0\x9f\x98\x80"};
  std::string text;
  for (std::uint64_t n = random() % (random() % 8 == 0 ? 150 : 6); n > 0; --n)
    text += letters[random() % letters.size()];
  return text;
}

std::string random_number(std::mt19937_64& random) {
  const auto digits = [&](std::uint64_t most) {
    std::string s;
    for (std::uint64_t n = random() % most + 1; n > 0; --n) s += static_cast<char>('0' + random() % 10);
    return s;
  };
  std::string s = digits(random() % 4 == 0 ? 40 : 3);
  s.erase(0, std::min(s.find_first_not_of('0'), s.size() - 1));
  // -0 alone may lose its sign.
  if (random() % 2 == 0 && s != "0") s = "-" + s;
  if (random() % 2 == 0) s += "." + digits(random() % 4 == 0 ? 30 : 3);
  if (random() % 3 == 0) s += std::string(1, "eE"[random() % 2]) + std::vector{"", "+", "-"}[random() % 3] + digits(2);
  return s;
}

Json random_tree(std::mt19937_64& random, int depth) {
  switch (random() % (depth > 0 ? 7 : 4)) {
    case 0:
      return {};
    case 1:
      return {.kind = Json::Kind::boolean, .text = random() % 2 == 0 ? "true" : "false"};
    case 2:
      return json_number(random_number(random));
    case 3:
      return json_text(random_text(random));
    case 4: {
      Json list = json_list();
      for (std::uint64_t n = random() % 9; n > 0; --n) list.items.push_back(random_tree(random, depth - 1));
      return list;
    }
    default: {
      Json object = json_object();
      for (std::uint64_t n = random() % 7; n > 0; --n)
        if (const std::string name = random_text(random); !object.member(name))
          object.members.emplace_back(name, random_tree(random, depth - 1));
      return object;
    }
  }
}

TEST(Json, RandomTreesAreReadAsWritten) {
  std::mt19937_64 random(test::seed());
  for (int round = 0; round < 500; ++round) {
    const Json tree = random_tree(random, static_cast<int>(random() % 7));
    const std::string text = write_json(tree);
    const Json again = parsed(text);
    ASSERT_TRUE(same(again, tree)) << text;
    ASSERT_EQ(write_json(again), text);
    EXPECT_EQ(text.back(), '\n');
  }
}

// A cut, changed or added byte is refused, or gives a tree that can be written and read again.
TEST(Json, RandomDamage) {
  std::mt19937_64 random(test::seed());
  std::size_t refused = 0;
  for (int round = 0; round < 2000; ++round) {
    std::string text = write_json(random_tree(random, 4));
    const std::size_t at = random() % text.size();
    if (random() % 2 == 0)
      text[at] = static_cast<char>(random());
    else
      text.insert(at, 1, "[]{},:\"\\0e-. "[random() % 13]);
    const auto read = read_json(text);
    if (!read) {
      ++refused;
      EXPECT_EQ(read.error().where.substr(0, 5), "line ");
      continue;
    }
    ASSERT_TRUE(same(parsed(write_json(read.value())), read.value())) << text;
  }
  EXPECT_GT(refused, 500U);
  EXPECT_LT(refused, 2000U);
}

}  // namespace
}  // namespace quoin::io
