#include "io/mesh.h"

#include <algorithm>
#include <cassert>

#include "io/formats.h"

namespace quoin::io {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool ends_with_ignoring_case(std::string_view text, std::string_view ending) {
  if (text.size() < ending.size()) return false;
  text.remove_prefix(text.size() - ending.size());
  return std::equal(text.begin(), text.end(), ending.begin(), [](char a, char b) { return lower(a) == b; });
}

/// The format the content shows, else the hint.
Format format_by_content(std::string_view bytes, Format hint) {
  const bool stl = hint == Format::stl || hint == Format::stl_ascii;
  if (stl && is_exact_binary_stl(bytes)) return Format::stl;
  if (looks_like_ply(bytes)) return Format::ply;
  if (looks_like_off(bytes)) return Format::off;
  if (looks_like_ascii_stl(bytes)) return Format::stl_ascii;
  return hint;
}

}  // namespace

Result<Format> format_of(std::string_view file_name) {
  if (ends_with_ignoring_case(file_name, ".stl")) return Format::stl;
  if (ends_with_ignoring_case(file_name, ".obj")) return Format::obj;
  if (ends_with_ignoring_case(file_name, ".off")) return Format::off;
  if (ends_with_ignoring_case(file_name, ".ply")) return Format::ply;
  return Error{"unknown-format", "the file name does not end with .stl, .obj, .off or .ply", std::string(file_name)};
}

Result<PolygonMesh> read_mesh(std::string_view bytes, Format format) {
  if (bytes.empty()) return Error{"truncated", "the file is empty", {}, "byte 0"};
  if (bytes.starts_with(byte_order_mark)) {
    const bool binary = (format == Format::stl || format == Format::stl_ascii) && is_exact_binary_stl(bytes);
    if (!binary) bytes.remove_prefix(byte_order_mark.size());
  }
  switch (format_by_content(bytes, format)) {
    case Format::stl:
    case Format::stl_ascii:
      return read_stl(bytes);
    case Format::obj:
      return read_obj(bytes);
    case Format::off:
      return read_off(bytes);
    case Format::ply:
    case Format::ply_ascii:
      return read_ply(bytes);
  }
  assert(false);
  return Error{"unknown-format", "no such format"};
}

std::string write_mesh(std::span<const double> points, std::span<const std::uint32_t> triangles, Format format) {
  assert(points.size() % 3 == 0 && triangles.size() % 3 == 0);
  assert(std::all_of(triangles.begin(), triangles.end(), [&](std::uint32_t i) { return i < points.size() / 3; }));
  switch (format) {
    case Format::stl:
      return write_stl(points, triangles);
    case Format::stl_ascii:
      return write_stl_ascii(points, triangles);
    case Format::obj:
      return write_obj(points, triangles);
    case Format::off:
      return write_off(points, triangles);
    case Format::ply:
      return write_ply(points, triangles);
    case Format::ply_ascii:
      return write_ply_ascii(points, triangles);
  }
  assert(false);
  return {};
}

}  // namespace quoin::io
