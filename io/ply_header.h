/// \file
/// The header of a PLY file.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "quoin/result.h"

namespace quoin::io {

enum class PlyType : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// Bytes of a value.
std::uint64_t ply_size(PlyType type);
bool is_floating(PlyType type);

struct PlyProperty {
  /// x, y, z of a vertex, the corners of a face, or nothing that is used.
  enum class Role : std::uint8_t { x, y, z, corners, none };
  Role role = Role::none;
  /// As the header has it.
  std::string_view name = {};
  bool is_list = false;
  /// Of a list's length: an integer type.
  PlyType count_type = PlyType::uint8;
  PlyType type = PlyType::float32;
};

struct PlyElement {
  /// A strip's corners are those of triangles, each of which shares an edge with the one before it; -1 begins anew.
  enum class Kind : std::uint8_t { vertex, face, strips, other };
  Kind kind = Kind::other;
  std::string_view name = {};
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties = {};
};

struct PlyHeader {
  enum class Encoding : std::uint8_t { ascii, little_endian, big_endian };
  Encoding encoding = Encoding::ascii;
  /// One vertex element with the scalars x, y, z, and an element of faces, of triangle strips, or one of either, with a
  /// list of corners. Names are views of the file's bytes.
  std::vector<PlyElement> elements = {};
  std::uint64_t vertex_count = 0;
  /// Bytes of the header: the body begins there.
  std::size_t size = 0;
};

/// The first line settles how lines end, so that a body may begin with any byte.
/// Errors, with the line: "truncated", "bad-syntax", "bad-number", "absurd-count", "unknown-format",
/// "no-faces" (no element of faces or strips).
Result<PlyHeader> read_ply_header(std::string_view bytes);

}  // namespace quoin::io
