// PLY: ascii, binary_little_endian and binary_big_endian.
#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstring>
#include <utility>

#include "io/formats.h"
#include "io/ply_header.h"
#include "io/scanner.h"
#include "io/text_output.h"

namespace quoin::io {
namespace {

/// The body of an ascii PLY: words, whatever line they stand on.
class AsciiBody {
 public:
  AsciiBody(std::string_view bytes, std::size_t start) : in_(bytes) { in_.move_to(bytes.data() + start); }

  std::uint64_t remaining() const { return in_.remaining() + 1; }
  /// A word and what separates it from the next.
  static std::uint64_t min_size(PlyType) { return 2; }
  void mark() { in_.mark(); }
  bool fail(ErrorCode code, std::string message) { return in_.fail(code, std::move(message)); }
  Error take_error() { return in_.take_error(); }

  bool real(PlyType, double& out) {
    in_.skip_space();
    return in_.number(out);
  }

  bool integer(PlyType, std::int64_t& out) {
    in_.skip_space();
    return in_.integer(out);
  }

  bool skip(PlyType, std::uint64_t values) {
    for (std::uint64_t i = 0; i < values; ++i) {
      in_.skip_space();
      if (in_.word().empty()) return in_.fail(ErrorCode::truncated, "the text ends where more is declared");
    }
    return true;
  }

  bool end() {
    in_.skip_space();
    in_.mark();
    return in_.at_end() || in_.fail(ErrorCode::bad_syntax, "the file goes on behind the last declared element");
  }

 private:
  Scanner in_;
};

/// The body of a binary PLY, in the machine's byte order or the other one.
template <bool Swapped>
class BinaryBody {
 public:
  BinaryBody(std::string_view bytes, std::size_t start) : bytes_(bytes), at_(start), mark_(start) {}

  std::uint64_t remaining() const { return bytes_.size() - at_; }
  static std::uint64_t min_size(PlyType type) { return ply_size(type); }
  void mark() { mark_ = at_; }
  bool fail(ErrorCode code, std::string message) {
    error_ = Error{code, std::move(message), {}, "byte " + std::to_string(mark_)};
    return false;
  }
  Error take_error() { return std::move(error_); }

  bool real(PlyType type, double& out) {
    if (!available(type, 1)) return false;
    switch (type) {
      case PlyType::float32:
        out = static_cast<double>(std::bit_cast<float>(load<std::uint32_t>()));
        break;
      case PlyType::float64:
        out = std::bit_cast<double>(load<std::uint64_t>());
        break;
      default:
        out = static_cast<double>(load_integer(type));
    }
    return std::isfinite(out) || fail(ErrorCode::non_finite, "a coordinate is not a finite number");
  }

  /// Floating-point values count when they are integers.
  bool integer(PlyType type, std::int64_t& out) {
    if (is_floating(type)) {
      double value = 0;
      if (!real(type, value)) return false;
      // The bound keeps the conversion defined; all valid indices and counts are below it.
      const bool good = std::trunc(value) == value && std::fabs(value) < 9007199254740992.0;
      if (!good) return fail(ErrorCode::bad_number, "this is not an integer");
      out = static_cast<std::int64_t>(value);
      return true;
    }

    if (!available(type, 1)) return false;
    out = load_integer(type);
    return true;
  }

  bool skip(PlyType type, std::uint64_t values) {
    if (!available(type, values)) return false;
    at_ += values * ply_size(type);
    return true;
  }

  bool end() const { return true; }

 private:
  bool available(PlyType type, std::uint64_t values) {
    mark_ = at_;
    return values <= remaining() / ply_size(type) || fail(ErrorCode::truncated, "the file ends where more is declared");
  }

  template <class Unsigned>
  Unsigned load() {
    std::array<unsigned char, sizeof(Unsigned)> b;
    std::memcpy(b.data(), bytes_.data() + at_, b.size());
    at_ += b.size();
    if constexpr (Swapped) {
      for (std::size_t i = 0; i < b.size() / 2; ++i) std::swap(b[i], b[b.size() - 1 - i]);
    }
    return std::bit_cast<Unsigned>(b);
  }

  std::int64_t load_integer(PlyType type) {
    switch (type) {
      case PlyType::int8:
        return static_cast<std::int8_t>(load<std::uint8_t>());
      case PlyType::uint8:
        return load<std::uint8_t>();
      case PlyType::int16:
        return static_cast<std::int16_t>(load<std::uint16_t>());
      case PlyType::uint16:
        return load<std::uint16_t>();
      case PlyType::int32:
        return static_cast<std::int32_t>(load<std::uint32_t>());
      case PlyType::uint32:
        return load<std::uint32_t>();
      default:
        assert(false);
        return 0;
    }
  }

  std::string_view bytes_;
  std::size_t at_;
  std::size_t mark_;
  Error error_ = {};
};

/// Reads the elements in the header's order.
template <class Body>
class PlyReader {
 public:
  PlyReader(const PlyHeader& header, std::string_view bytes) : header_(header), body_(bytes, header.size) {}

  Result<PolygonMesh> read() {
    for (const PlyElement& element : header_.elements) {
      if (!check_count(element)) return body_.take_error();
      reserve(element);
      for (std::uint64_t row = 0; row < element.count; ++row) {
        if (!read_row(element)) return body_.take_error();
      }
    }
    if (!body_.end()) return body_.take_error();
    for (const PlyElement& element : header_.elements) note_what_is_passed_over(element);
    return std::move(mesh_);
  }

 private:
  /// Refuses a count of rows that the rest of the file cannot hold.
  /// Rows without properties take no bytes: their loop must not run.
  bool check_count(const PlyElement& element) {
    body_.mark();
    std::uint64_t row_size = 0;
    for (const PlyProperty& property : element.properties) {
      row_size += Body::min_size(property.is_list ? property.count_type : property.type);
    }

    if (element.count == 0) return true;
    if (row_size == 0) return body_.fail(ErrorCode::bad_syntax, "an element of the header has no property");
    const bool vertex = element.kind == PlyElement::Kind::vertex;
    if (element.count > body_.remaining() / row_size || (vertex && element.count > max_count)) {
      return body_.fail(ErrorCode::absurd_count,
                        "the file is too short for the " + std::to_string(element.count) +
                            " rows that the header declares: truncated, or the count is wrong");
    }
    return true;
  }

  void note_what_is_passed_over(const PlyElement& element) {
    if (element.count == 0) return;
    const std::string rows = std::to_string(element.count) + (element.count == 1 ? " row of " : " rows of ");
    std::string names;
    for (const PlyProperty& property : element.properties)
      if (property.role == PlyProperty::Role::none) names.append(names.empty() ? "" : ", ").append(property.name);
    if (names.empty()) return;
    const bool whole = element.kind == PlyElement::Kind::other;
    mesh_.notices.push_back({element.count, rows + std::string(element.name) + (whole ? "" : ": " + names) +
                                                (element.count == 1 && whole ? " is" : " are") + " passed over"});
  }

  void reserve(const PlyElement& element) {
    if (element.kind == PlyElement::Kind::vertex) mesh_.points.reserve(element.count * 3);
    if (element.kind != PlyElement::Kind::face) return;
    mesh_.starts.reserve(element.count + 1);
    // Short lists may hide behind a large count: the file's size bounds the corners too.
    mesh_.corners.reserve(std::min(element.count * 3, body_.remaining()));
  }

  bool read_row(const PlyElement& element) {
    std::array<double, 3> point = {};
    for (const PlyProperty& property : element.properties) {
      bool good = true;
      if (property.role == PlyProperty::Role::corners) {
        good = element.kind == PlyElement::Kind::strips ? strip(property) : polygon(property);
      } else if (property.is_list) {
        std::uint64_t length = 0;
        good = list_length(property, length) && body_.skip(property.type, length);
      } else if (property.role == PlyProperty::Role::none) {
        good = body_.skip(property.type, 1);
      } else {
        good = body_.real(property.type, point[static_cast<std::size_t>(property.role)]);
      }
      if (!good) return false;
    }

    if (element.kind == PlyElement::Kind::vertex) mesh_.points.insert(mesh_.points.end(), point.begin(), point.end());
    return true;
  }

  bool list_length(const PlyProperty& property, std::uint64_t& out) {
    std::int64_t length = 0;
    if (!body_.integer(property.count_type, length)) return false;
    if (length < 0 || static_cast<std::uint64_t>(length) > body_.remaining() / Body::min_size(property.type)) {
      return body_.fail(ErrorCode::absurd_count,
                        "the file is too short for this list: truncated, or its length is wrong");
    }
    out = static_cast<std::uint64_t>(length);
    return true;
  }

  bool polygon(const PlyProperty& property) {
    std::uint64_t length = 0;
    if (!list_length(property, length)) return false;
    if (length < 3) return body_.fail(ErrorCode::bad_syntax, "a face needs at least 3 corners");
    if (mesh_.corners.size() + length > max_count)
      return body_.fail(ErrorCode::absurd_count, "the faces have too many corners");

    for (std::uint64_t i = 0; i < length; ++i) {
      std::int64_t index = 0;
      if (!body_.integer(property.type, index)) return false;
      if (index < 0 || static_cast<std::uint64_t>(index) >= header_.vertex_count) {
        return body_.fail(ErrorCode::bad_index, "a face names a vertex that does not exist");
      }
      mesh_.corners.push_back(static_cast<std::uint32_t>(index));
    }
    mesh_.starts.push_back(static_cast<std::uint32_t>(mesh_.corners.size()));
    return true;
  }

  /// Triangles of a strip, every other one turned round; those that name a vertex twice are nothing.
  bool strip(const PlyProperty& property) {
    std::uint64_t length = 0;
    if (!list_length(property, length)) return false;
    std::array<std::uint32_t, 2> last = {};
    for (std::uint64_t i = 0, known = 0; i < length; ++i) {
      std::int64_t index = 0;
      if (!body_.integer(property.type, index)) return false;
      if (index == -1) {
        known = 0;
        continue;
      }
      if (index < 0 || static_cast<std::uint64_t>(index) >= header_.vertex_count)
        return body_.fail(ErrorCode::bad_index, "a strip names a vertex that does not exist");

      const auto corner = static_cast<std::uint32_t>(index);
      if (known >= 2 && !add_triangle(last[known % 2], last[1 - known % 2], corner)) return false;
      last = {last[1], corner};
      ++known;
    }
    return true;
  }

  bool add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (a == b || b == c || c == a) return true;
    if (mesh_.corners.size() + 3 > max_count)
      return body_.fail(ErrorCode::absurd_count, "the faces have too many corners");
    mesh_.corners.insert(mesh_.corners.end(), {a, b, c});
    mesh_.starts.push_back(static_cast<std::uint32_t>(mesh_.corners.size()));
    return true;
  }

  const PlyHeader& header_;
  Body body_;
  PolygonMesh mesh_;
};

std::string header_text(std::string_view encoding, std::size_t vertices, std::size_t faces) {
  std::string out = "ply\nformat ";
  out.append(encoding).append(" 1.0\ncomment Quoin PLY, counter-clockwise seen from outside, units of the model\n");
  out.append("element vertex ").append(std::to_string(vertices));
  out.append("\nproperty double x\nproperty double y\nproperty double z\nelement face ").append(std::to_string(faces));
  // Indices are int where they fit: some readers know no other type.
  out.append("\nproperty list uchar ").append(vertices > 0x80000000U ? "uint" : "int").append(" vertex_indices\n");
  return out.append("end_header\n");
}

template <class Unsigned>
void append_little_endian(std::string& out, Unsigned value) {
  std::array<char, sizeof(Unsigned)> bytes;
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(value >> (8 * i) & 0xFF);
  out.append(bytes.data(), bytes.size());
}

}  // namespace

Result<PolygonMesh> read_ply(std::string_view bytes) {
  const Result<PlyHeader> header = read_ply_header(bytes);
  if (!header) return header.error();
  const PlyHeader& known = header.value();
  if (known.encoding == PlyHeader::Encoding::ascii) return PlyReader<AsciiBody>(known, bytes).read();
  const bool little = known.encoding == PlyHeader::Encoding::little_endian;
  const bool native = little == (std::endian::native == std::endian::little);
  return native ? PlyReader<BinaryBody<false>>(known, bytes).read() : PlyReader<BinaryBody<true>>(known, bytes).read();
}

std::string write_ply(std::span<const double> points, std::span<const std::uint32_t> triangles) {
  std::string out = header_text("binary_little_endian", points.size() / 3, triangles.size() / 3);
  out.reserve(out.size() + points.size() * 8 + triangles.size() / 3 * 13);
  for (const double coordinate : points) append_little_endian(out, std::bit_cast<std::uint64_t>(coordinate));
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    out.push_back('\3');
    for (std::size_t k = 0; k < 3; ++k) append_little_endian(out, triangles[i + k]);
  }
  return out;
}

std::string write_ply_ascii(std::span<const double> points, std::span<const std::uint32_t> triangles) {
  std::string out = header_text("ascii", points.size() / 3, triangles.size() / 3);
  for (std::size_t i = 0; i < points.size(); i += 3) append_line(out, "", points[i], points[i + 1], points[i + 2]);
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    append_line(out, "3 ", triangles[i], triangles[i + 1], triangles[i + 2]);
  }
  return out;
}

}  // namespace quoin::io
