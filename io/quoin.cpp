#include "io/quoin.h"

#include <cassert>
#include <cstring>
#include <limits>
#include <optional>
#include <utility>

#include "io/text_output.h"

namespace quoin::io {
namespace {

/// All counts and indices stay below it.
constexpr std::uint32_t count_limit = std::numeric_limits<std::uint32_t>::max();

// The fewest bytes that one record takes, "\n" included.
constexpr std::uint64_t smallest_vertex = sizeof "0 0 0" - 1 + 1;
constexpr std::uint64_t smallest_loop = sizeof "0" - 1 + 1;
constexpr std::uint64_t smallest_face = sizeof "0 0 1 0 1" - 1 + 1 + smallest_loop;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Walks a text line by line and each line field by field; fields are separated by single spaces.
/// Methods that return bool return false exactly when they failed; the first failure is kept for `take_error`.
class Lines {
 public:
  explicit Lines(std::string_view text) : next_(text.data()), end_(text.data() + text.size()) {}

  /// Bytes behind this line.
  std::uint64_t remaining() const { return static_cast<std::uint64_t>(end_ - next_); }

  /// Moves to the next line, which may be a comment.
  bool raw_line() {
    if (field_ != nullptr) ++line_;
    if (next_ == end_) return fail("the text is truncated: it ends before the line \"end\"");
    const char* newline = static_cast<const char*>(std::memchr(next_, '\n', remaining()));
    if (newline == nullptr) return fail("the text is truncated: this line has no line end");
    field_ = next_;
    line_end_ = newline != next_ && newline[-1] == '\r' ? newline - 1 : newline;
    next_ = newline + 1;
    return true;
  }

  /// Moves to the next line that is no comment.
  bool line() {
    do {
      if (!raw_line()) return false;
    } while (field_ != line_end_ && *field_ == '#');
    return true;
  }

  /// What is left of this line.
  std::string_view rest() const { return {field_, static_cast<std::size_t>(line_end_ - field_)}; }
  bool at_line_end() const { return field_ == line_end_; }
  bool no_more_fields() { return at_line_end() || fail("this line has too many fields"); }

  /// Reads the fixed word that begins a line with further fields.
  bool word(std::string_view expected) {
    const bool found = rest().substr(0, expected.size()) == expected;
    field_ += found ? expected.size() : 0;
    return (found && end_field()) || fail("a line \"" + std::string(expected) + " ...\" is expected here");
  }

  /// Reads an integer of at most `max_digits` digits.
  bool integer(std::size_t max_digits, std::string_view& out) {
    const char* first = field_;
    return scan_integer(max_digits) && assign(first, out) && end_field();
  }

  /// Reads "p" or "p/q".
  bool rational(std::size_t max_digits, std::string_view& out) {
    const char* first = field_;
    if (!scan_integer(max_digits)) return false;
    if (field_ != line_end_ && *field_ == '/') {
      const char* denominator = ++field_;
      if (!scan_integer(max_digits)) return false;
      const bool below_two = *denominator == '-' || (field_ - denominator == 1 && *denominator <= '1');
      if (below_two || *first == '0') return fail("a rational is p, or p/q with p not 0 and q at least 2");
    }
    return assign(first, out) && end_field();
  }

  /// Reads a number below `limit`. Precondition: limit < 2^32.
  bool below(std::uint64_t limit, const char* complaint, std::uint32_t& out) {
    const char* first = field_;
    std::uint64_t value = 0;
    while (field_ != line_end_ && is_digit(*field_) && value < limit) {
      value = 10 * value + static_cast<std::uint64_t>(*field_++ - '0');
    }
    if (field_ == first && (at_line_end() || !is_digit(*first))) return fail("a number (digits only) is expected here");
    if (value >= limit) return fail(complaint);
    if (*first == '0' && field_ - first > 1) return fail("numbers have no leading zeros");
    out = static_cast<std::uint32_t>(value);
    return end_field();
  }

  /// Reads the number of records to come, each of which takes `bytes` at least.
  bool count(std::uint64_t bytes, std::uint32_t& out) {
    if (!below(count_limit, "this count is too large", out)) return false;
    return out <= remaining() / bytes || fail("this count is larger than the rest of the text can hold");
  }

  bool fail(std::string message) {
    if (!error_) error_ = Error{ErrorCode::bad_quoin, std::move(message), {}, "line " + std::to_string(line_)};
    return false;
  }
  Error take_error() { return std::move(*error_); }

 private:
  /// Moves over an integer.
  bool scan_integer(std::size_t max_digits) {
    const char* first = field_;
    if (field_ != line_end_ && *field_ == '-') ++field_;
    const char* digits = field_;
    while (field_ != line_end_ && is_digit(*field_)) ++field_;
    const auto size = static_cast<std::size_t>(field_ - digits);
    if (size == 0) return fail("an integer is expected here");
    if (size > max_digits) return fail("this integer has more than " + std::to_string(max_digits) + " digits");
    if (*digits == '0' && field_ - first > 1) return fail("integers have no leading zeros, and there is no -0");
    return true;
  }

  bool assign(const char* first, std::string_view& out) const {
    out = {first, static_cast<std::size_t>(field_ - first)};
    return true;
  }

  /// Moves over the space behind a field unless the line ends.
  bool end_field() {
    if (at_line_end()) return true;
    if (*field_ != ' ') return fail("this field holds a character that does not belong there");
    ++field_;
    return !at_line_end() || fail("this line ends with a space");
  }

  const char* next_;  // behind this line
  const char* end_;
  const char* field_ = nullptr;
  const char* line_end_ = nullptr;
  std::uint64_t line_ = 1;
  std::optional<Error> error_ = {};
};

constexpr std::string_view magic = "quoin ";

bool read_version(std::string_view text, Lines& lines) {
  if (!looks_like_quoin(text)) return lines.fail("this is no .quoin file: it does not begin with \"quoin 1\"");
  if (!lines.raw_line()) return false;
  const std::string_view version = lines.rest().substr(magic.size());
  return version == "1" || lines.fail("this .quoin file is not of version 1, the only one known here");
}

bool read_lattice(Lines& lines, ExactDocument& out) {
  if (!lines.line() || !lines.word("grid") || !lines.rational(max_lattice_digits, out.step)) return false;
  if (out.step[0] == '-' || out.step[0] == '0') return lines.fail("the step of the grid must be positive");
  for (std::string_view& coordinate : out.origin) {
    if (!lines.rational(max_lattice_digits, coordinate)) return false;
  }
  return lines.no_more_fields();
}

bool read_infinity(Lines& lines, ExactDocument& out) {
  if (!lines.line() || !lines.word("infinity")) return false;
  out.full_at_infinity = lines.rest() == "full";
  return out.full_at_infinity || lines.rest() == "empty" || lines.fail("infinity is \"empty\" or \"full\"");
}

bool read_vertex(Lines& lines, std::array<std::string_view, 4>& out) {
  if (!lines.line()) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!lines.integer(max_coordinate_digits, out[k])) return false;
  }

  if (lines.at_line_end()) {
    out[3] = "1";
    return true;
  }
  if (!lines.integer(max_coordinate_digits, out[3])) return false;
  if (out[3][0] == '-' || out[3] == "0" || out[3] == "1") return lines.fail("w, where it is written, is at least 2");
  return lines.no_more_fields();
}

bool read_vertices(Lines& lines, ExactDocument& out) {
  std::uint32_t count = 0;
  if (!lines.line() || !lines.word("vertices") || !lines.count(smallest_vertex, count) || !lines.no_more_fields()) {
    return false;
  }
  out.vertices.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (!read_vertex(lines, out.vertices.emplace_back())) return false;
  }
  return true;
}

bool read_loop(Lines& lines, ExactDocument& out) {
  if (!lines.line()) return false;
  do {
    std::uint32_t corner = 0;
    if (!lines.below(out.vertices.size(), "a corner is the index of a vertex, counted from 0", corner)) return false;
    out.corners.push_back(corner);
  } while (!lines.at_line_end());
  if (out.corners.size() >= count_limit) return lines.fail("the faces have too many corners");
  out.loop_corners.push_back(static_cast<std::uint32_t>(out.corners.size()));
  return true;
}

bool read_face(Lines& lines, ExactDocument& out) {
  if (!lines.line()) return false;
  for (std::string_view& coefficient : out.planes.emplace_back()) {
    if (!lines.integer(max_coefficient_digits, coefficient)) return false;
  }

  std::uint32_t loops = 0;
  if (!lines.count(smallest_loop, loops) || !lines.no_more_fields()) return false;
  if (loops == 0) return lines.fail("a face has at least one loop");
  for (std::uint32_t j = 0; j < loops; ++j) {
    if (!read_loop(lines, out)) return false;
  }
  out.face_loops.push_back(static_cast<std::uint32_t>(out.loop_corners.size() - 1));
  return true;
}

bool read_faces(Lines& lines, ExactDocument& out) {
  std::uint32_t count = 0;
  if (!lines.line() || !lines.word("faces") || !lines.count(smallest_face, count) || !lines.no_more_fields()) {
    return false;
  }

  out.planes.reserve(count);
  out.face_loops.reserve(std::size_t{count} + 1);
  out.loop_corners.reserve(std::size_t{count} + 1);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (!read_face(lines, out)) return false;
  }
  return true;
}

bool read_end(Lines& lines) {
  if (!lines.line()) return false;
  if (lines.rest() != "end") return lines.fail("the line \"end\" is expected here");
  return lines.remaining() == 0 || lines.fail("there is something behind the line \"end\"");
}

[[maybe_unused]] bool are_offsets(const std::vector<std::uint32_t>& offsets, std::size_t groups, std::size_t total) {
  if (offsets.size() != groups + 1 || offsets.front() != 0 || offsets.back() != total) return false;
  for (std::size_t i = 0; i < groups; ++i) {
    if (offsets[i] >= offsets[i + 1]) return false;
  }
  return true;
}

/// About the text's size, not less, so that it is allocated once.
std::size_t size_bound(const ExactDocument& document) {
  std::size_t size = 128 + document.step.size();
  for (const std::string_view coordinate : document.origin) size += coordinate.size();
  for (const auto& vertex : document.vertices)
    for (const std::string_view number : vertex) size += number.size() + 1;
  for (const auto& plane : document.planes)
    for (const std::string_view number : plane) size += number.size() + 1;
  const std::size_t index_size = std::to_string(document.vertices.size()).size() + 1;
  return size + 11 * document.planes.size() + index_size * document.corners.size();
}

void append_count(std::string& out, std::string_view name, std::size_t count) {
  out.append(name);
  append_number(out, count);
  out.push_back('\n');
}

}  // namespace

bool looks_like_quoin(std::string_view bytes) { return bytes.substr(0, magic.size()) == magic; }

void QuoinWriter::begin(std::string_view step, const std::array<std::string_view, 3>& origin, bool full_at_infinity) {
  out_.append("quoin 1\ngrid ").append(step);
  for (const std::string_view coordinate : origin) out_.append(1, ' ').append(coordinate);
  out_.append(full_at_infinity ? "\ninfinity full\n" : "\ninfinity empty\n");
}

void QuoinWriter::vertices(std::size_t count) { append_count(out_, "vertices ", count); }

void QuoinWriter::vertex(const std::array<std::string_view, 4>& point) {
  const auto& [x, y, z, w] = point;
  out_.append(x).append(1, ' ').append(y).append(1, ' ').append(z);
  if (w != "1") out_.append(1, ' ').append(w);
  out_.push_back('\n');
}

void QuoinWriter::faces(std::size_t count) { append_count(out_, "faces ", count); }

void QuoinWriter::face(const std::array<std::string_view, 4>& plane, std::size_t loops) {
  for (const std::string_view coefficient : plane) out_.append(coefficient).append(1, ' ');
  append_count(out_, "", loops);
}

void QuoinWriter::loop(std::span<const std::uint32_t> corners) {
  for (const std::uint32_t corner : corners) {
    append_number(out_, corner);
    out_.push_back(' ');
  }
  out_.back() = '\n';
}

std::string QuoinWriter::end() {
  out_.append("end\n");
  return std::move(out_);
}

std::string write_quoin(const ExactDocument& document) {
  assert(!document.loop_corners.empty());
  assert(are_offsets(document.face_loops, document.planes.size(), document.loop_corners.size() - 1));
  assert(are_offsets(document.loop_corners, document.loop_corners.size() - 1, document.corners.size()));

  std::string room;
  room.reserve(size_bound(document));
  QuoinWriter writer(std::move(room));
  writer.begin(document.step, document.origin, document.full_at_infinity);
  writer.vertices(document.vertices.size());
  for (const auto& vertex : document.vertices) writer.vertex(vertex);

  writer.faces(document.planes.size());
  const std::span<const std::uint32_t> corners(document.corners);
  for (std::size_t i = 0; i < document.planes.size(); ++i) {
    writer.face(document.planes[i], document.face_loops[i + 1] - document.face_loops[i]);
    for (std::size_t j = document.face_loops[i]; j < document.face_loops[i + 1]; ++j)
      writer.loop(corners.subspan(document.loop_corners[j], document.loop_corners[j + 1] - document.loop_corners[j]));
  }
  return writer.end();
}

Result<ExactDocument> read_quoin(std::string_view text) {
  Lines lines(text);
  ExactDocument document;
  if (!read_version(text, lines) || !read_lattice(lines, document) || !read_infinity(lines, document) ||
      !read_vertices(lines, document) || !read_faces(lines, document) || !read_end(lines)) {
    return lines.take_error();
  }
  return document;
}

}  // namespace quoin::io
