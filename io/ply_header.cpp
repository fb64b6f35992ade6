#include "io/ply_header.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

#include "io/formats.h"
#include "io/scanner.h"

namespace quoin::io {
namespace {

using Role = PlyProperty::Role;
using Kind = PlyElement::Kind;

struct TypeName {
  std::string_view name;
  PlyType type;
};

constexpr std::array<TypeName, 16> type_names = {{{"char", PlyType::int8},
                                                  {"int8", PlyType::int8},
                                                  {"uchar", PlyType::uint8},
                                                  {"uint8", PlyType::uint8},
                                                  {"short", PlyType::int16},
                                                  {"int16", PlyType::int16},
                                                  {"ushort", PlyType::uint16},
                                                  {"uint16", PlyType::uint16},
                                                  {"int", PlyType::int32},
                                                  {"int32", PlyType::int32},
                                                  {"uint", PlyType::uint32},
                                                  {"uint32", PlyType::uint32},
                                                  {"float", PlyType::float32},
                                                  {"float32", PlyType::float32},
                                                  {"double", PlyType::float64},
                                                  {"float64", PlyType::float64}}};

/// How the first line ends; empty when the text does not begin with the line "ply".
std::string_view line_end_of(std::string_view bytes) {
  constexpr std::array<std::string_view, 3> ends = {"\r\n", "\n", "\r"};
  if (!bytes.starts_with("ply")) return {};
  const auto* found =
      std::find_if(ends.begin(), ends.end(), [&](auto end) { return bytes.substr(3).starts_with(end); });
  return found == ends.end() ? std::string_view() : *found;
}

Role role_of(Kind kind, bool is_list, std::string_view name) {
  if (kind == Kind::vertex && !is_list && name.size() == 1 && name[0] >= 'x' && name[0] <= 'z') {
    return static_cast<Role>(name[0] - 'x');
  }
  const bool corners = name == "vertex_indices" || name == "vertex_index";
  const bool has_corners = kind == Kind::face || kind == Kind::strips;
  return has_corners && is_list && corners ? Role::corners : Role::none;
}

bool has_role(const PlyElement& element, Role role) {
  return std::any_of(element.properties.begin(), element.properties.end(),
                     [&](const PlyProperty& property) { return property.role == role; });
}

class HeaderReader {
 public:
  explicit HeaderReader(std::string_view bytes) : bytes_(bytes), line_end_(line_end_of(bytes)) {}

  Result<PlyHeader> read() {
    if (line_end_.empty()) return fail(ErrorCode::unknown_format, "the line 'ply' is due here");
    std::optional<Error> error = next_line();
    while (!error) {
      error = next_line();
      if (error) break;
      Scanner words(line_);
      const std::string_view keyword = words.word();
      if (keyword == "end_header") return finish();
      error = statement(keyword, words);
    }
    return *error;
  }

 private:
  Error fail(ErrorCode code, std::string message) const {
    return Error{code, std::move(message), {}, "line " + std::to_string(std::max<std::uint64_t>(line_number_, 1))};
  }

  std::optional<Error> next_line() {
    const std::size_t length = bytes_.substr(header_.size).find(line_end_);
    ++line_number_;
    if (length == std::string_view::npos) {
      // The last line of a file without a body may lack its end.
      line_ = bytes_.substr(header_.size);
      header_.size = bytes_.size();
      Scanner words(line_);
      if (words.word() != "end_header") return fail(ErrorCode::truncated, "the header ends without 'end_header'");
      return {};
    }

    line_ = bytes_.substr(header_.size, length);
    header_.size += length + line_end_.size();
    return {};
  }

  std::optional<Error> statement(std::string_view keyword, Scanner& words) {
    if (keyword == "comment" || keyword == "obj_info" || keyword.empty()) return {};
    if (keyword == "format") return format(words);
    if (keyword == "element") return element(words);
    if (keyword == "property") return property(words);
    return fail(ErrorCode::bad_syntax, "a PLY header has no such statement");
  }

  std::optional<Error> format(Scanner& words) {
    const std::string_view encoding = words.word();
    if (encoding == "ascii") {
      header_.encoding = PlyHeader::Encoding::ascii;
    } else if (encoding == "binary_little_endian") {
      header_.encoding = PlyHeader::Encoding::little_endian;
    } else if (encoding == "binary_big_endian") {
      header_.encoding = PlyHeader::Encoding::big_endian;
    } else {
      return fail(ErrorCode::unknown_format, "the format is ascii, binary_little_endian or binary_big_endian");
    }

    if (words.word() != "1.0") return fail(ErrorCode::unknown_format, "only version 1.0 of PLY is known");
    has_format_ = true;
    return {};
  }

  /// element NAME COUNT
  std::optional<Error> element(Scanner& words) {
    const std::string_view name = words.word();
    PlyElement element;
    element.name = name;
    element.kind = name == "vertex"      ? Kind::vertex
                   : name == "face"      ? Kind::face
                   : name == "tristrips" ? Kind::strips
                                         : Kind::other;
    std::int64_t count = 0;
    if (!words.integer(count))
      return fail(words.at_end() ? ErrorCode::bad_syntax : ErrorCode::bad_number, "an element needs a count");
    if (count < 0) return fail(ErrorCode::absurd_count, "the count of an element is negative");
    if (element.kind != Kind::other && find(element.kind) != nullptr) {
      return fail(ErrorCode::bad_syntax, "this element is declared twice");
    }

    element.count = static_cast<std::uint64_t>(count);
    if (element.kind == Kind::vertex) header_.vertex_count = element.count;
    header_.elements.push_back(std::move(element));
    return {};
  }

  /// property TYPE NAME or property list TYPE TYPE NAME
  std::optional<Error> property(Scanner& words) {
    if (header_.elements.empty()) return fail(ErrorCode::bad_syntax, "a property needs an element before it");
    PlyElement& element = header_.elements.back();
    PlyProperty property;

    std::string_view type = words.word();
    property.is_list = type == "list";
    if (property.is_list) {
      if (!find_type(words.word(), property.count_type)) return unknown_type();
      if (is_floating(property.count_type)) return fail(ErrorCode::bad_syntax, "the length of a list is an integer");
      type = words.word();
    }
    if (!find_type(type, property.type)) return unknown_type();

    const std::string_view name = words.word();
    if (name.empty()) return fail(ErrorCode::bad_syntax, "a property needs a name");
    property.name = name;
    property.role = role_of(element.kind, property.is_list, name);
    if (property.role != Role::none && has_role(element, property.role)) {
      return fail(ErrorCode::bad_syntax, "this property is declared twice");
    }
    element.properties.push_back(property);
    return {};
  }

  static bool find_type(std::string_view name, PlyType& out) {
    const auto* found =
        std::find_if(type_names.begin(), type_names.end(), [&](const TypeName& known) { return known.name == name; });
    if (found == type_names.end()) return false;
    out = found->type;
    return true;
  }

  Error unknown_type() const { return fail(ErrorCode::bad_syntax, "a PLY property has no such type"); }

  Result<PlyHeader> finish() {
    if (!has_format_) return fail(ErrorCode::bad_syntax, "the header has no 'format'");

    const PlyElement* vertex = find(Kind::vertex);
    const PlyElement* face = find(Kind::face);
    if (vertex == nullptr || !has_role(*vertex, Role::x) || !has_role(*vertex, Role::y) ||
        !has_role(*vertex, Role::z)) {
      return fail(ErrorCode::bad_syntax, "the header declares no vertices with x, y and z");
    }
    const PlyElement* strips = find(Kind::strips);
    if (face == nullptr && strips == nullptr)
      return fail(ErrorCode::no_faces, "the header declares no faces: points alone bound no solid");
    if ((face != nullptr && !has_role(*face, Role::corners)) ||
        (strips != nullptr && !has_role(*strips, Role::corners))) {
      return fail(ErrorCode::bad_syntax, "the header declares no faces with a list vertex_indices");
    }
    return std::move(header_);
  }

  const PlyElement* find(Kind kind) const {
    const auto found = std::find_if(header_.elements.begin(), header_.elements.end(),
                                    [&](const PlyElement& element) { return element.kind == kind; });
    return found == header_.elements.end() ? nullptr : &*found;
  }

  std::string_view bytes_;
  std::string_view line_end_;
  std::string_view line_ = {};
  std::uint64_t line_number_ = 0;
  bool has_format_ = false;
  PlyHeader header_ = {};
};

}  // namespace

std::uint64_t ply_size(PlyType type) {
  constexpr std::array<std::uint8_t, 8> sizes = {1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

bool is_floating(PlyType type) { return type == PlyType::float32 || type == PlyType::float64; }

bool looks_like_ply(std::string_view bytes) { return !line_end_of(bytes).empty(); }

Result<PlyHeader> read_ply_header(std::string_view bytes) { return HeaderReader(bytes).read(); }

}  // namespace quoin::io
