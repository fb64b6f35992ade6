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

/// What a file holds, parsed but not yet on a common grid.
struct Source {
  /// Names the file in errors.
  std::string name;
  /// As the file states it; empty when `exact` is set.
  PolygonMesh mesh = {};
  /// The solid of a .quoin file.
  std::optional<Solid> exact = {};
};

/// Reads and parses one file; "-" is standard input. Content decides the format where it can, then `format` if given,
/// then the extension. `trust` is for .quoin files; meshes are proved by `build`. Errors: "missing-file", "unreadable",
/// "unknown-format", "truncated", "bad-syntax", "bad-number", "non-finite", "bad-index", "absurd-count", "no-faces",
/// "bad-quoin", "too-large" (the file; its mesh is measured by `build`); `file` is the path.
QUOIN_API Result<Source> read_source(const std::string& path, std::optional<Format> format = {},
                                     Trust trust = Trust::nothing, const Limits& limits = {});

/// Solids of sources on one common grid, in their order: `options.grid` if given, else that of the exact sources (the
/// finest one), else the one that fits all meshes together. Exact sources are re-expressed only where that is exact.
/// `reports`, when given, receives one report a source (all zero for an exact one).
/// Errors: those of `Solid::from_polygons`, "inexact-grid"; `file` is the source's name.
QUOIN_API Result<std::vector<Solid>> build(std::vector<Source> sources, const ImportOptions& options = {},
                                           std::vector<ImportReport>* reports = nullptr);

/// A triangle mesh as the bytes of a file; decimals are the shortest that read back to the same double, and binary STL
/// rounds to float32 (see ExportOptions).
/// Errors: "bad-index" (a triangle names a point that is not there, an array has a wrong length), "non-finite" (for
/// binary STL, after rounding to float32 too), "unknown-format" (Format::quoin: see Solid::to_quoin).
QUOIN_API Result<std::string> to_bytes(const Mesh& mesh, Format format);

/// Writes a file that appears whole or not at all: written beside `path`, then renamed. "-" is standard output.
/// Errors: "unwritable"; "cancelled", which leaves nothing behind; `file` is the path.
QUOIN_API Result<void> write_bytes(const std::string& path, std::string_view bytes, const Cancel* cancel = nullptr);

/// Reads files (.stl, .obj, .off, .ply, .quoin; content decides where it can) onto one common grid.
/// `reports`, when given, receives one report a file.
QUOIN_API Result<std::vector<Solid>> read(const std::vector<std::string>& paths, const ImportOptions& options = {},
                                          std::vector<ImportReport>* reports = nullptr);
/// The same for one file.
QUOIN_API Result<Solid> read_solid(const std::string& path, const ImportOptions& options = {},
                                   ImportReport* report = nullptr);

}  // namespace quoin
