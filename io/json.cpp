#include "io/json.h"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

namespace quoin::io {
namespace {

using Library = nlohmann::json;

/// Where reading has come to. Lines and columns of characters.
struct Position {
  std::uint32_t line = 1, column = 0;
  std::uint32_t line_before = 1, column_before = 0;  // of the last character but one
  char last = 0;
  void advance(char c) {
    line_before = line;
    column_before = column;
    last = c;
    if (c == '\n') {
      ++line;
      column = 0;
    } else if ((static_cast<unsigned char>(c) & 0xC0u) != 0x80u) {
      ++column;  // no continuation byte of UTF-8
    }
  }
};

/// Characters that tell a position as they are taken.
class Tracked {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  Tracked(const char* at, Position* position) : at_(at), position_(position) {}
  const char& operator*() const { return *at_; }
  Tracked& operator++() {
    position_->advance(*at_++);
    return *this;
  }
  Tracked operator++(int) {
    Tracked before = *this;
    ++*this;
    return before;
  }
  friend bool operator==(const Tracked& a, const Tracked& b) { return a.at_ == b.at_; }

 private:
  const char* at_;
  Position* position_;
};

constexpr std::size_t deepest = 1000;

/// Takes the parser's events.
class Builder : public nlohmann::json_sax<Library> {
 public:
  explicit Builder(const Position& position) : position_(position) {}

  bool null() override { return add({}); }
  bool boolean(bool v) override { return add({.kind = Json::Kind::boolean, .text = v ? "true" : "false"}); }
  bool number_integer(number_integer_t v) override { return add_number(std::to_string(v)); }
  bool number_unsigned(number_unsigned_t v) override { return add_number(std::to_string(v)); }
  bool number_float(number_float_t, const string_t& text) override { return add_number(text); }
  bool string(string_t& text) override { return add(json_text(std::move(text))); }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(Json::Kind::object); }
  bool start_array(std::size_t) override { return open(Json::Kind::list); }
  bool end_object() override {
    names_.pop_back();
    return close();
  }
  bool end_array() override { return close(); }
  bool key(string_t& name) override {
    if (!names_.back().insert(name).second) return fail("the name \"" + name.substr(0, 80) + "\" occurs twice");
    name_.push_back(std::move(name));
    return true;
  }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception& e) override {
    // What the library says after its own position.
    std::string what = e.what();
    auto at = what.find(": ", what.find("column"));
    if (at == std::string::npos) at = what.find("] ");
    return fail("the text is not JSON: " + (at == std::string::npos ? what : what.substr(at + 2)));
  }

  Json root;
  std::optional<Error> error;

 private:
  bool fail(std::string message) {
    if (!error) error = Error{ErrorCode::bad_model, std::move(message), {}, here().place()};
    return false;
  }

  /// Where the last character was taken; the next one of a text that is empty so far, or ended with its line.
  Json here() const { return {.line = position_.line, .column = std::max(position_.column, 1U)}; }

  /// The parser looks one character beyond a number, which ends in a digit.
  bool add_number(std::string text) {
    Json value = json_number(std::move(text));
    const bool beyond = position_.last < '0' || position_.last > '9';
    value.line = beyond ? position_.line_before : position_.line;
    value.column = beyond ? position_.column_before : position_.column;
    return add(std::move(value));
  }

  bool add(Json value) {
    if (value.line == 0) {
      value.line = position_.line;
      value.column = position_.column;
    }

    if (open_.empty()) {
      root = std::move(value);
    } else if (open_.back().kind == Json::Kind::list) {
      open_.back().items.push_back(std::move(value));
    } else {
      open_.back().members.emplace_back(std::move(name_.back()), std::move(value));
      name_.pop_back();
    }
    return true;
  }

  bool open(Json::Kind kind) {
    if (open_.size() == deepest) return fail("more than 1000 levels");
    open_.push_back({.kind = kind, .line = position_.line, .column = position_.column});
    if (kind == Json::Kind::object) names_.emplace_back();
    return true;
  }

  bool close() {
    Json value = std::move(open_.back());
    open_.pop_back();
    return add(std::move(value));
  }

  const Position& position_;
  std::vector<Json> open_;
  std::vector<std::set<std::string>> names_;
  std::vector<std::string> name_;
};

constexpr std::size_t line_length = 100;

/// On one line; of a list or object that is too long for one, only a part.
std::string flat(const Json& v) {
  std::string s;
  switch (v.kind) {
    case Json::Kind::null:
      return "null";
    case Json::Kind::boolean:
    case Json::Kind::number:
      return v.text;
    case Json::Kind::text:
      return Library(v.text).dump(-1, ' ', false, Library::error_handler_t::replace);
    case Json::Kind::list:
      for (auto item = v.items.begin(); item != v.items.end() && s.size() <= line_length; ++item)
        s += (s.empty() ? "" : ", ") + flat(*item);
      return "[" + s + "]";
    case Json::Kind::object:
      for (auto m = v.members.begin(); m != v.members.end() && s.size() <= line_length; ++m)
        s += (s.empty() ? "" : ", ") + flat(json_text(m->first)) + ": " + flat(m->second);
      return "{" + s + "}";
  }
  return s;
}

void write(const Json& v, std::size_t indent, std::string& out) {
  const bool is_object = v.kind == Json::Kind::object;
  const std::size_t count = is_object ? v.members.size() : v.items.size();
  if (std::string line = flat(v); count == 0 || indent + line.size() <= line_length) {
    out += line;
    return;
  }

  out += is_object ? "{" : "[";
  for (std::size_t i = 0; i < count; ++i) {
    out += (i == 0 ? "\n" : ",\n") + std::string(indent + 2, ' ');
    if (is_object) out += flat(json_text(v.members[i].first)) + ": ";
    write(is_object ? v.members[i].second : v.items[i], indent + 2, out);
  }
  out += "\n" + std::string(indent, ' ') + (is_object ? "}" : "]");
}

}  // namespace

const Json* Json::member(std::string_view name) const {
  const auto at = std::find_if(members.begin(), members.end(), [&](const auto& m) { return m.first == name; });
  return at == members.end() ? nullptr : &at->second;
}

std::string Json::place() const { return "line " + std::to_string(line) + ", column " + std::to_string(column); }

Result<Json> read_json(std::string_view text) {
  Position position;
  Builder builder(position);
  // The parser would take a byte 0 as the end.
  if (const auto zero = text.find('\0'); zero != std::string_view::npos) {
    for (const char c : text.substr(0, zero + 1)) position.advance(c);
    return Error{ErrorCode::bad_model,
                 "the text is not JSON: a byte 0",
                 {},
                 Json{.line = position.line, .column = position.column}.place()};
  }

  const bool good =
      Library::sax_parse(Tracked(text.data(), &position), Tracked(text.data() + text.size(), &position), &builder);
  if (builder.error) return *builder.error;
  if (!good) return Error{ErrorCode::bad_model, "the text is not JSON"};
  return std::move(builder.root);
}

std::string write_json(const Json& value) {
  std::string out;
  write(value, 0, out);
  return out + "\n";
}

Json json_text(std::string text) { return {.kind = Json::Kind::text, .text = std::move(text)}; }
Json json_number(std::string text) { return {.kind = Json::Kind::number, .text = std::move(text)}; }
Json json_list(std::vector<Json> items) { return {.kind = Json::Kind::list, .items = std::move(items)}; }
Json json_object(std::vector<std::pair<std::string, Json>> members) {
  return {.kind = Json::Kind::object, .members = std::move(members)};
}

}  // namespace quoin::io
