/// \file
/// Files <-> plain arrays of points and indices. This room knows no geometry and no grid.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "quoin/format.h"
#include "quoin/limits.h"
#include "quoin/notice.h"
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
  /// What the file holds besides, one a kind: "24 normals are passed over".
  std::vector<Notice> notices = {};

  /// Takes note of what is passed over, if there is any: `one` or `many` of it.
  void pass_over(std::uint64_t count, std::string_view one, std::string_view many);
};

/// A rotation by a quaternion x, y, z, w, of any length but 0.
struct QuaternionStep {
  std::array<double, 4> by;
};
/// A rotation by degrees about axis 0, 1 or 2, right-handed.
struct AngleStep {
  std::size_t axis = 0;
  double degrees = 0;
};
/// p -> A p + t; the rows of A with t behind each.
struct MatrixStep {
  std::array<double, 12> rows;
  friend bool operator==(const MatrixStep&, const MatrixStep&) = default;
};
/// p -> p / by, which numbers of the file may be without being doubles themselves.
struct DivisionStep {
  double by;
};
inline constexpr MatrixStep identity_step = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}};
/// How a mesh is placed, as the file states it: steps in the order in which they act. None: as it stands.
using Placing = std::vector<std::variant<MatrixStep, QuaternionStep, AngleStep, DivisionStep>>;

/// "24 normals are passed over".
Notice passed_over(std::uint64_t count, std::string_view one, std::string_view many);

/// A mesh of the scene, by its number, and where it is.
struct PlacedMesh {
  std::uint32_t mesh = 0;
  Placing placing = {};
};
/// What a file calls one thing: the union of its meshes; none where it has no face.
struct Object {
  std::string name;
  std::vector<PlacedMesh> meshes;
};
/// What a file states: of most formats one object of one mesh, without a unit. One object at
/// least has a mesh.
struct Scene {
  Unit unit = Unit::none;
  std::vector<PolygonMesh> meshes = {};
  std::vector<Object> objects = {};
  std::vector<Notice> notices = {};
};

/// Reads a file beside the one that is read, by its name. Errors: "missing-file", "unreadable".
using Beside = std::function<Result<std::string>(const std::string& name)>;

/// By the file name's extension, any case. Errors: "unknown-format".
Result<Format> format_of(std::string_view file_name);

/// What a file's content shows it to be where it can, else what it is named; nothing where neither tells.
/// `named`: what its name or the caller says. A file of 84 + 50 n bytes for the n it declares is binary STL under the
/// name of an STL, whatever its first word, or under none; "ply", "OFF", "solid" and "quoin" tell their formats.
std::optional<Format> format_to_read(std::string_view bytes, std::optional<Format> named);

/// Text without a byte order mark of UTF-8 before it.
std::string_view without_byte_order_mark(std::string_view bytes);

/// Reads the bytes of a mesh file as `format_to_read` says.
/// Never throws but std::bad_alloc; never allocates more than a small multiple of `bytes`, of an archive of what
/// ZipArchive lets it inflate to, of a glTF of its elements, which meshes may share and need not store (accessors.h).
/// Points are as in the file, none welded; every STL facet has three points of its own.
/// Numbers that round to zero are zero; those that round to infinity are not finite.
/// What stands behind the declared content is refused in OFF and ascii PLY, since the counts are wrong then; behind
/// binary STL fewer than 50 bytes are padding; behind binary PLY anything is passed over.
/// A count that the file's size contradicts is "truncated" for binary STL, "absurd-count" elsewhere.
/// `beside` is asked for files that a glTF names.
/// Errors (with `where` = line, byte offset or part): "truncated", "bad-syntax", "bad-number", "non-finite",
/// "bad-index", "absurd-count", "unknown-format" (an exact file, too; an extension that a 3MF or glTF requires),
/// "no-faces" (a mesh that is as it should be but for that: a wireframe, points), those of `beside`.
Result<Scene> read_scene(std::string_view bytes, Format named, const Beside& beside = {});

/// A triangle mesh as the bytes of a file; `triangles` holds 3 indices each. Equal arrays give equal bytes.
/// Decimals are the shortest that read back to the same double; binary STL stores float32, binary PLY double.
/// Normals of STL are computed, zero where the area is. The unit is stated where the format can (glTF, whose numbers
/// are metres, states it as the scale of the node).
/// Preconditions: a format of meshes; indices below points.size() / 3; finite points, for formats of float32 after
/// rounding to it too; no more than `fits` says.
std::string write_mesh(std::span<const double> points, std::span<const std::uint32_t> triangles, Format format,
                       Unit unit = Unit::none);
/// The most that a file, or a part of its archive, may hold: GLB counts bytes in 32 bits, and of archives no more is
/// read.
std::uint64_t max_bytes(Format format);
/// Whether so many points and triangles surely fit in them.
bool fits(std::uint64_t points, std::uint64_t triangles, Format format);

/// A whole file; "-" is standard input. Errors: "missing-file", "unreadable", "too-large": a regular file by its size,
/// before it is read; "unknown-format": a stream that begins with more zero bytes than any format does.
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
