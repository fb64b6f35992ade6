// STL, binary and ASCII. Every facet keeps three points of its own.
#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstring>
#include <initializer_list>
#include <limits>

#include "io/formats.h"
#include "io/scanner.h"
#include "io/text_output.h"

namespace quoin::io {
namespace {

constexpr std::size_t header_size = 80;
constexpr std::size_t facets_offset = 84;
constexpr std::size_t facet_size = 50;
constexpr std::size_t normal_size = 12;
constexpr std::size_t attribute_offset = 48;
/// Corners are counted in 32 bits.
constexpr std::uint64_t max_facets = std::numeric_limits<std::uint32_t>::max() / 3;

std::uint32_t load_u32(const char* from) {
  std::array<unsigned char, 4> b;
  std::memcpy(b.data(), from, 4);
  return static_cast<std::uint32_t>(b[0]) | static_cast<std::uint32_t>(b[1]) << 8 |
         static_cast<std::uint32_t>(b[2]) << 16 | static_cast<std::uint32_t>(b[3]) << 24;
}

void append_u32(std::string& out, std::uint32_t value) {
  const std::array<char, 4> bytes = {static_cast<char>(value & 0xFF), static_cast<char>(value >> 8 & 0xFF),
                                     static_cast<char>(value >> 16 & 0xFF), static_cast<char>(value >> 24)};
  out.append(bytes.data(), bytes.size());
}

std::uint64_t binary_size(std::string_view bytes) {
  return facets_offset + facet_size * std::uint64_t{load_u32(bytes.data() + header_size)};
}

bool equal_ignoring_case(std::string_view word, std::string_view lower_word) {
  return std::equal(word.begin(), word.end(), lower_word.begin(), lower_word.end(),
                    [](char a, char b) { return (a >= 'A' && a <= 'Z' ? static_cast<char>(a - 'A' + 'a') : a) == b; });
}

/// starts and corners for facets that own their points: 0, 1, 2, 3, ...
void number_corners(PolygonMesh& mesh, std::uint32_t facets) {
  mesh.starts.resize(std::size_t{facets} + 1);
  mesh.corners.resize(std::size_t{facets} * 3);
  for (std::size_t i = 0; i < mesh.starts.size(); ++i) mesh.starts[i] = static_cast<std::uint32_t>(3 * i);
  for (std::size_t i = 0; i < mesh.corners.size(); ++i) mesh.corners[i] = static_cast<std::uint32_t>(i);
}

/// Refuses sizes that contradict the declared count.
/// Fewer than a facet's bytes behind the last facet are padding.
Result<void> check_binary_size(std::string_view bytes) {
  const std::string size = std::to_string(bytes.size());
  if (bytes.size() < facets_offset) {
    return Error{ErrorCode::truncated, "a binary STL has at least 84 bytes, this file has " + size, {}, "byte " + size};
  }

  const std::uint64_t expected = binary_size(bytes);
  const std::string story = "the header declares " + std::to_string(load_u32(bytes.data() + header_size)) +
                            " facets, which take " + std::to_string(expected) + " bytes, but the file has " + size;
  if (bytes.size() < expected) return Error{ErrorCode::truncated, story, {}, "byte " + size};
  if (bytes.size() >= expected + facet_size)
    return Error{ErrorCode::bad_syntax, story, {}, "byte " + std::to_string(expected)};
  if (load_u32(bytes.data() + header_size) > max_facets) return Error{ErrorCode::absurd_count, story, {}, "byte 80"};
  return {};
}

Result<PolygonMesh> read_binary_stl(std::string_view bytes) {
  if (Result<void> check = check_binary_size(bytes); !check) return check.error();
  const std::uint32_t facets = load_u32(bytes.data() + header_size);
  PolygonMesh mesh;
  mesh.points.resize(std::size_t{facets} * 9);
  double* to = mesh.points.data();
  std::uint64_t attributes = 0;

  for (std::uint32_t facet = 0; facet < facets; ++facet) {
    const std::size_t offset = facets_offset + facet_size * std::size_t{facet} + normal_size;
    const char* from = bytes.data() + offset;
    const char* attribute = from - normal_size + attribute_offset;
    if (attribute[0] != 0 || attribute[1] != 0) ++attributes;
    bool finite = true;
    for (int i = 0; i < 9; ++i) {
      const std::uint32_t bits = load_u32(from + 4 * i);
      finite &= (bits & 0x7F800000U) != 0x7F800000U;
      *to++ = static_cast<double>(std::bit_cast<float>(bits));
    }
    if (!finite) {
      return Error{ErrorCode::non_finite,
                   "facet " + std::to_string(facet) + " has a coordinate that is not a finite number",
                   {},
                   "byte " + std::to_string(offset)};
    }
  }

  number_corners(mesh, facets);
  mesh.pass_over(attributes, "attribute of a facet (a colour, as a rule)", "attributes of facets (colours, as a rule)");
  return mesh;
}

class AsciiStlReader {
 public:
  explicit AsciiStlReader(std::string_view text) : in_(text) {}

  Result<PolygonMesh> read() {
    for (in_.skip_space(); !in_.at_end(); in_.skip_space()) {
      if (!solid()) return in_.take_error();
    }
    number_corners(mesh_, static_cast<std::uint32_t>(mesh_.points.size() / 9));
    mesh_.pass_over(words_, "word behind a facet", "words behind facets");
    if (!mesh_.points.empty()) mesh_.pass_over(empty_parts_, "part without facets", "parts without facets");
    return std::move(mesh_);
  }

 private:
  /// The next word on any line; empty at the end of the text.
  std::string_view next_word() {
    in_.skip_space();
    return in_.word();
  }

  bool unexpected(std::string_view word, std::string_view wanted) {
    const bool cut =
        in_.at_end() && (word.size() < wanted.size() && equal_ignoring_case(word, wanted.substr(0, word.size())));
    if (cut) return in_.fail(ErrorCode::truncated, "the text ends where '" + std::string(wanted) + "' is due");
    return in_.fail(ErrorCode::bad_syntax, "'" + std::string(wanted) + "' is due here");
  }

  bool expect(std::string_view keyword) {
    const std::string_view word = next_word();
    return equal_ignoring_case(word, keyword) || unexpected(word, keyword);
  }

  /// solid NAME, facets, endsolid NAME; both names go up to the end of their lines.
  bool solid() {
    if (!expect("solid")) return false;
    in_.skip_line();
    const std::size_t before = mesh_.points.size();

    for (;;) {
      const std::string_view word = next_word();
      if (equal_ignoring_case(word, "endsolid")) {
        if (mesh_.points.size() == before) ++empty_parts_;
        in_.skip_line();
        return true;
      }
      if (!equal_ignoring_case(word, "facet")) {
        const bool end = word.empty() || equal_ignoring_case(word, std::string_view("endsolid").substr(0, word.size()));
        return unexpected(word, end ? "endsolid" : "facet");
      }
      if (!facet()) return false;
    }
  }

  /// What follows "facet". The normal may hold any three words: it is redundant.
  bool facet() {
    if (!expect("normal")) return false;
    for (int i = 0; i < 3; ++i) {
      if (next_word().empty()) return in_.fail(ErrorCode::truncated, "the text ends within a normal");
    }

    if (!expect("outer") || !expect("loop")) return false;
    for (int i = 0; i < 3; ++i) {
      if (!vertex()) return false;
    }
    if (!expect("endloop")) return false;
    skip_words({"endfacet"});
    if (!expect("endfacet")) return false;
    skip_words({"facet", "endsolid"});
    if (mesh_.points.size() / 9 > max_facets) return in_.fail(ErrorCode::absurd_count, "the file has too many facets");
    return true;
  }

  /// On this line, up to one of the statements that may follow.
  void skip_words(std::initializer_list<std::string_view> statements) {
    const auto is_next = [&](std::string_view word) {
      return std::any_of(statements.begin(), statements.end(),
                         [&](std::string_view statement) { return equal_ignoring_case(word, statement); });
    };
    for (in_.skip_blanks(); !in_.at_line_end(); in_.skip_blanks()) {
      const char* place = in_.position();
      if (is_next(in_.word())) return in_.move_to(place);
      ++words_;
    }
  }

  bool vertex() {
    if (!expect("vertex")) return false;
    for (int i = 0; i < 3; ++i) {
      double coordinate = 0;
      in_.skip_space();
      if (!in_.number(coordinate)) return false;
      mesh_.points.push_back(coordinate);
    }
    return true;
  }

  Scanner in_;
  PolygonMesh mesh_;
  std::uint64_t words_ = 0, empty_parts_ = 0;
};

using Vector = std::array<double, 3>;

double largest(const Vector& v) { return std::max({std::fabs(v[0]), std::fabs(v[1]), std::fabs(v[2])}); }

/// v times a power of two so that its largest entry is within 2^-74 .. 2^24; zero stays zero.
/// Products of entries and their squares then neither overflow nor vanish. Clamping keeps the factor finite.
Vector scaled(const Vector& v) {
  int exponent = 0;
  (void)std::frexp(largest(v), &exponent);
  const double factor = std::ldexp(1.0, -std::clamp(exponent, -1000, 1000));
  return {v[0] * factor, v[1] * factor, v[2] * factor};
}

Vector difference(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

/// The unit normal of a counter-clockwise triangle in float32, zero for a computed area of zero.
/// The scalings keep differences of huge coordinates and products of tiny ones in range.
std::array<float, 3> unit_normal(const std::array<Vector, 3>& corners) {
  const double size = std::max({largest(corners[0]), largest(corners[1]), largest(corners[2])});
  const double shrink = size > 1e300 ? 0.25 : 1.0;
  std::array<Vector, 3> p = corners;
  for (Vector& corner : p) {
    for (double& coordinate : corner) coordinate *= shrink;
  }

  const Vector u = scaled(difference(p[1], p[0]));
  const Vector v = scaled(difference(p[2], p[0]));
  const Vector n = scaled({u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]});
  const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  if (length == 0) return {0, 0, 0};
  // Adding zero turns -0 into 0.
  return {static_cast<float>(n[0] / length + 0.0), static_cast<float>(n[1] / length + 0.0),
          static_cast<float>(n[2] / length + 0.0)};
}

Vector point(std::span<const double> points, std::uint32_t index) {
  const std::size_t at = std::size_t{index} * 3;
  return {points[at], points[at + 1], points[at + 2]};
}

float to_float(double value) {
  const float result = static_cast<float>(value);
  assert(std::isfinite(result));
  return result;
}

void append_float(std::string& out, float value) { append_u32(out, std::bit_cast<std::uint32_t>(value)); }

}  // namespace

bool is_exact_binary_stl(std::string_view bytes) {
  return bytes.size() >= facets_offset && bytes.size() == binary_size(bytes);
}

bool looks_like_ascii_stl(std::string_view bytes) {
  const std::string_view head = bytes.substr(0, facets_offset);
  if (head.find('\0') != std::string_view::npos) return false;
  Scanner scanner(bytes);
  scanner.skip_space();
  return equal_ignoring_case(scanner.word(), "solid");
}

Result<PolygonMesh> read_stl(std::string_view bytes) {
  if (is_exact_binary_stl(bytes) || !looks_like_ascii_stl(bytes)) return read_binary_stl(bytes);
  return AsciiStlReader(bytes).read();
}

std::string write_stl(std::span<const double> points, std::span<const std::uint32_t> triangles) {
  std::string out = "Quoin binary STL, counter-clockwise seen from outside, units of the model";
  out.resize(header_size, ' ');
  out.reserve(facets_offset + facet_size * (triangles.size() / 3));
  append_u32(out, static_cast<std::uint32_t>(triangles.size() / 3));

  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    std::array<Vector, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector exact = point(points, triangles[i + k]);
      corners[k] = {to_float(exact[0]), to_float(exact[1]), to_float(exact[2])};
    }

    for (const float coordinate : unit_normal(corners)) append_float(out, coordinate);
    for (const Vector& corner : corners) {
      for (const double coordinate : corner) append_float(out, static_cast<float>(coordinate));
    }
    out.append(2, '\0');
  }
  return out;
}

std::string write_stl_ascii(std::span<const double> points, std::span<const std::uint32_t> triangles) {
  std::string out = "solid Quoin\n";
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    const std::array<Vector, 3> corners = {point(points, triangles[i]), point(points, triangles[i + 1]),
                                           point(points, triangles[i + 2])};
    const std::array<float, 3> normal = unit_normal(corners);
    append_line(out, "facet normal ", normal[0], normal[1], normal[2]);
    out.append("  outer loop\n");
    for (const Vector& corner : corners) append_line(out, "    vertex ", corner[0], corner[1], corner[2]);
    out.append("  endloop\nendfacet\n");
  }
  out.append("endsolid Quoin\n");
  return out;
}

}  // namespace quoin::io
