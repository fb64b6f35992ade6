/// \file
/// One reader and one writer a format; mesh.cpp chooses among them. Contracts: io/mesh.h.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "io/mesh.h"

namespace quoin::io {

/// Whether the bytes are a complete binary STL: 84 + 50 n bytes for the n they declare.
bool is_exact_binary_stl(std::string_view bytes);
/// Whether the bytes begin as ASCII STL does: "solid" and no zero byte in the first 84.
bool looks_like_ascii_stl(std::string_view bytes);
/// Whether the bytes begin with OFF, COFF, NOFF, STOFF, ... as a whole word or glued to digits.
bool looks_like_off(std::string_view bytes);
/// Whether the bytes begin with the line "ply".
bool looks_like_ply(std::string_view bytes);

Result<PolygonMesh> read_stl(std::string_view bytes);
Result<PolygonMesh> read_obj(std::string_view bytes);
Result<PolygonMesh> read_off(std::string_view bytes);
Result<PolygonMesh> read_ply(std::string_view bytes);

std::string write_stl(std::span<const double> points, std::span<const std::uint32_t> triangles);
std::string write_stl_ascii(std::span<const double> points, std::span<const std::uint32_t> triangles);
std::string write_obj(std::span<const double> points, std::span<const std::uint32_t> triangles);
std::string write_off(std::span<const double> points, std::span<const std::uint32_t> triangles);
std::string write_ply(std::span<const double> points, std::span<const std::uint32_t> triangles);
std::string write_ply_ascii(std::span<const double> points, std::span<const std::uint32_t> triangles);

}  // namespace quoin::io
