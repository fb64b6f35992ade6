/// \file
/// Files of solids and meshes.
#pragma once

#include "quoin/export.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "quoin/format.h"
#include "quoin/grid.h"
#include "quoin/import.h"
#include "quoin/limits.h"
#include "quoin/notice.h"
#include "quoin/options.h"
#include "quoin/result.h"
#include "quoin/solid.h"
#include "quoin/triangles.h"

namespace quoin {

/// Polygons as arrays: `points` is x, y, z per vertex in model units, polygon i has the corners
/// `corners[starts[i]] .. corners[starts[i + 1] - 1]`, counter-clockwise seen from outside.
struct PolygonMesh {
  std::vector<double> points;
  std::vector<std::uint32_t> starts = {0};
  std::vector<std::uint32_t> corners;
};

/// What a file calls one thing: a build item of 3MF, a node with a mesh of glTF, an object of AMF, all of another file.
struct FileObject {
  /// From 1, in the order of the file.
  std::uint64_t number = 1;
  /// As the file has it; may be empty.
  std::string name = {};
  std::uint64_t faces = 0;
};

/// What a file holds, or an object of it, parsed but not yet on a common grid.
struct Source {
  /// Names the file in errors.
  std::string name;
  /// As the file states it, and where the file places it; empty when `exact` is set.
  PolygonMesh mesh = {};
  /// The solid of a .quoin file.
  std::optional<Solid> exact = {};
  /// Further meshes: `build` unites all of them, solid by solid, so that what overlaps is one by its meaning.
  std::vector<PolygonMesh> others = {};
  /// Of the numbers of the meshes.
  Unit unit = Unit::none;
  /// What is in it.
  std::vector<FileObject> objects = {};
  /// What the file holds besides.
  std::vector<Notice> notices = {};
};

/// Reads and parses one file; "-" is standard input. Content decides the format where it can, then `format` if given,
/// then the extension. "part.3mf#2" is the second object of part.3mf, "part.3mf#lid" the one of that name; without a
/// "#" behind the extension it is all objects, united. `trust` is for .quoin files; meshes are proved by `build`.
/// Transforms of the file act exactly, and each coordinate is rounded once, to the nearest double; what they mirror is
/// turned round. Numbers keep their unit, unless `unit` asks for another: then they are converted in the same rounding,
/// and those of a file that states none are taken to be in `unit`.
/// Errors: "missing-file", "unreadable", "unknown-format", "truncated", "bad-syntax", "bad-number", "non-finite",
/// "bad-index" (an object that is not there, too), "absurd-count", "no-faces", "bad-quoin",
/// "too-large" (the file; its mesh is measured by `build`); `file` is the path.
QUOIN_API Result<Source> read_source(const std::string& path, std::optional<Format> format = {},
                                     Trust trust = Trust::nothing, std::optional<Unit> unit = {},
                                     const Limits& limits = {});
/// The same, each object by itself, those without faces left out. There is one at least.
QUOIN_API Result<std::vector<Source>> read_objects(const std::string& path, std::optional<Format> format = {},
                                                   Trust trust = Trust::nothing, std::optional<Unit> unit = {},
                                                   const Limits& limits = {});

/// The path without the object that stands behind "#": "part.3mf" of "part.3mf#2". Only behind an extension of a
/// format, or "-", does "#" name an object, and only where no such extension follows it.
QUOIN_API std::string file_of(const std::string& path);

/// Solids of sources on one common grid, in their order: `options.grid` if given, where exact sources are re-expressed
/// only if that is exact; else of meshes alone the one that fits all of them together; else the common grid of the
/// exact sources (quoin/solid.h, `unite`), to which meshes are snapped. Where a mesh lies beyond its world, all meshes
/// get the grid that fits them, and the common grid is that of all. `reports`, when given, receives one report a
/// source, also of one that is refused; of an exact one it tells of rounding to the common grid.
/// Errors: those of `Solid::from_polygons`, "inexact-grid", "mixed-units" (two sources state different units); `file`
/// is the source's name.
QUOIN_API Result<std::vector<Solid>> build(std::vector<Source> sources, const ImportOptions& options = {},
                                           std::vector<ImportReport>* reports = nullptr);

/// A triangle mesh as the bytes of a file; decimals are the shortest that read back to the same double, and binary STL
/// and glTF round to float32 (see ExportOptions). The unit is stated where the format can (FormatInfo::has_unit).
/// Errors: "bad-index" (a triangle names a point that is not there, an array has a wrong length), "non-finite" (for
/// formats of float32 after rounding to it, too), "out-of-range" (more than the format can count), "unknown-format"
/// (Format::quoin: see Solid::to_quoin).
QUOIN_API Result<std::string> to_bytes(const Mesh& mesh, Format format, Unit unit = Unit::none);

/// Writes a file that appears whole or not at all: written beside `path`, then renamed. "-" is standard output.
/// Errors: "unwritable"; "cancelled", which leaves nothing behind; `file` is the path.
QUOIN_API Result<void> write_bytes(const std::string& path, std::string_view bytes, const Cancel* cancel = nullptr);

/// Reads files (those of `formats`; content decides where it can) onto one common grid, as `read_source` does.
/// `reports`, when given, receives one report a file.
QUOIN_API Result<std::vector<Solid>> read(const std::vector<std::string>& paths, const ImportOptions& options = {},
                                          std::vector<ImportReport>* reports = nullptr);
/// The same for one file.
QUOIN_API Result<Solid> read_solid(const std::string& path, const ImportOptions& options = {},
                                   ImportReport* report = nullptr);

}  // namespace quoin
