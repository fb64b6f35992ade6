/// \file
/// The table of formats. A new format is a row of it (formats.cpp), an enumerator (quoin/format.h) and a file with its
/// reader and writer, whose contracts are in io/mesh.h; its line in the README is asked for by a test.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>

#include "io/mesh.h"
#include "quoin/format.h"

namespace quoin::io {

/// Vertices and corners that 32-bit indices can number: a file that holds more is refused.
inline constexpr std::uint64_t max_count = std::numeric_limits<std::uint32_t>::max();

/// How content shows its format.
enum class Evidence {
  none,    // it does not: only a name tells
  word,    // the first word tells, whatever the name; a byte order mark before it is passed over
  length,  // it has the length that it declares. This may be chance: a name with another extension weighs more
};

struct FormatRow {
  FormatInfo info;
  Evidence evidence;
  /// Whether the bytes show this format; none without evidence.
  bool (*is_shown)(std::string_view bytes);
  /// None for exact formats.
  Result<Scene> (*read)(std::string_view bytes, const Beside& beside);
  std::string (*write)(std::span<const double> points, std::span<const std::uint32_t> triangles, Unit unit);
};

/// One row a format, in the order of the enumerators. The first row that fits is taken.
std::span<const FormatRow> format_rows();
const FormatRow& row_of(Format format);

/// Whether the bytes are a complete binary STL: 84 + 50 n bytes for the n they declare.
bool is_exact_binary_stl(std::string_view bytes);
/// Whether the bytes begin as ASCII STL does: "solid" and no zero byte in the first 84.
bool looks_like_ascii_stl(std::string_view bytes);
/// Whether the bytes begin with OFF, COFF, NOFF, STOFF, ... as a whole word or glued to digits.
bool looks_like_off(std::string_view bytes);
/// Whether the bytes begin with the line "ply".
bool looks_like_ply(std::string_view bytes);

/// Whether the bytes are an archive with the parts of a package, as 3MF is.
bool looks_like_threemf(std::string_view bytes);
/// Whether the bytes begin with the magic of GLB.
bool looks_like_glb(std::string_view bytes);
/// Whether the bytes begin with a brace: no other text does.
bool looks_like_gltf(std::string_view bytes);
/// Whether the first element is "amf", or the bytes are an archive of one .amf file.
bool looks_like_amf(std::string_view bytes);

Result<PolygonMesh> read_stl(std::string_view bytes);
Result<PolygonMesh> read_obj(std::string_view bytes);
Result<PolygonMesh> read_off(std::string_view bytes);
Result<PolygonMesh> read_ply(std::string_view bytes);
Result<Scene> read_threemf(std::string_view bytes, const Beside& beside);
Result<Scene> read_gltf(std::string_view bytes, const Beside& beside);
Result<Scene> read_amf(std::string_view bytes, const Beside& beside);

std::string write_stl(std::span<const double> points, std::span<const std::uint32_t> triangles);
std::string write_stl_ascii(std::span<const double> points, std::span<const std::uint32_t> triangles);
std::string write_obj(std::span<const double> points, std::span<const std::uint32_t> triangles);
std::string write_off(std::span<const double> points, std::span<const std::uint32_t> triangles);
std::string write_ply(std::span<const double> points, std::span<const std::uint32_t> triangles);
std::string write_ply_ascii(std::span<const double> points, std::span<const std::uint32_t> triangles);
std::string write_threemf(std::span<const double> points, std::span<const std::uint32_t> triangles, Unit unit);
std::string write_glb(std::span<const double> points, std::span<const std::uint32_t> triangles, Unit unit);
std::string write_gltf(std::span<const double> points, std::span<const std::uint32_t> triangles, Unit unit);
std::string write_amf(std::span<const double> points, std::span<const std::uint32_t> triangles, Unit unit);

}  // namespace quoin::io
