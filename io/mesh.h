/// \file
/// Files <-> plain arrays of points and indices. This room knows no geometry and no grid.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "quoin/format.h"
#include "quoin/limits.h"
#include "quoin/options.h"
#include "quoin/result.h"

namespace quoin::io {

/// A polygon mesh as a file states it.
/// `points`: x, y, z per vertex in model units, exactly the doubles nearest to the written decimals.
/// Polygon i has the corners corners[starts[i]] .. corners[starts[i + 1] - 1]; starts has one entry more than there are
/// polygons (and is {0} for none). Indices are below points.size() / 3, polygons have at least 3 corners: readers
/// check. What is read from a file has at least one polygon.
struct PolygonMesh {
  std::vector<double> points;
  std::vector<std::uint32_t> starts = {0};
  std::vector<std::uint32_t> corners;
};

/// By the file name's extension, any case. Errors: "unknown-format".
Result<Format> format_of(std::string_view file_name);

/// What a file's content shows it to be where it can, else what it is named; nothing where neither tells.
/// `named`: what its name or the caller says. A file of 84 + 50 n bytes for the n it declares is binary STL under the
/// name of an STL, whatever its first word, or under none; "ply", "OFF", "solid" and "quoin" tell their formats.
std::optional<Format> format_to_read(std::string_view bytes, std::optional<Format> named);

/// Text without a byte order mark of UTF-8 before it.
std::string_view without_byte_order_mark(std::string_view bytes);

/// Reads the bytes of a mesh file as `format_to_read` says.
/// Never throws but std::bad_alloc; never allocates more than a small multiple of `bytes`.
/// Points are as in the file, none welded; every STL facet has three points of its own.
/// Numbers that round to zero are zero; those that round to infinity are not finite.
/// What stands behind the declared content is refused in OFF and ascii PLY, since the counts are wrong then; behind
/// binary STL fewer than 50 bytes are padding; behind binary PLY anything is passed over.
/// A count that the file's size contradicts is "truncated" for binary STL, "absurd-count" elsewhere.
/// Errors (with `where` = line or byte offset): "truncated", "bad-syntax", "bad-number", "non-finite", "bad-index",
/// "absurd-count", "unknown-format" (an exact file, too), "no-faces" (a mesh that is as it should be but for that: a
/// wireframe, points).
Result<PolygonMesh> read_mesh(std::string_view bytes, Format named);

/// A triangle mesh as the bytes of a file; `triangles` holds 3 indices each. Equal arrays give equal bytes.
/// Decimals are the shortest that read back to the same double; binary STL stores float32, binary PLY double.
/// Normals of STL are computed, zero where the area is.
/// Preconditions: a format of meshes; indices below points.size() / 3; finite points, for binary STL after rounding to
/// float32 too.
std::string write_mesh(std::span<const double> points, std::span<const std::uint32_t> triangles, Format format);

/// A whole file; "-" is standard input. Errors: "missing-file", "unreadable", "too-large": a regular file by its size,
/// before it is read.
Result<std::string> read_file(const std::string& path, const Limits& limits = {});
/// Writes beside `path`, synchronises and renames: the file appears whole or not at all; "-" is standard output.
/// What was there keeps its owner, group and permissions. Symbolic links stay and what they name is replaced.
/// A file with several hard links, of an owner whom nobody else can name, or in a folder that nobody may write to, is
/// written in place, once there is room for it: only a failing device or the end of the process leave a part of it.
/// What may not be written is not replaced. Devices and pipes are written to.
/// Threads may call it at once.
/// Errors: "unwritable"; "cancelled", which leaves nothing behind (`cancel`: nullptr, or the flag that asks for it).
Result<void> write_file(const std::string& path, std::string_view bytes, const Cancel* cancel = nullptr);

}  // namespace quoin::io
