/// \file
/// The file formats: one table, which reading, writing, the command line and the docs share.
#pragma once

#include "quoin/export.h"

#include <optional>
#include <span>
#include <string_view>

#include "quoin/result.h"

namespace quoin {

/// `stl` and `ply` are the binary variants when written; reading takes either for either. `threemf` is 3MF.
enum class Format { stl, stl_ascii, obj, off, ply, ply_ascii, threemf, glb, gltf, amf, quoin };

/// The unit of length that a file states; `none` where it states none, so that its numbers are just model units.
enum class Unit { none, micron, millimeter, centimeter, inch, foot, meter };

/// "millimeter", as 3MF writes it; "none".
QUOIN_API std::string_view name_of(Unit unit);
/// The unit that a word stands for: "millimeter" or "mm"; micron um, cm, in, ft, m.
QUOIN_API std::optional<Unit> unit_called(std::string_view word);

struct FormatInfo {
  Format format;
  /// The word for it, as of --format: "stl-ascii".
  std::string_view name;
  /// ".stl", which stands for the first format that has it.
  std::string_view extension;
  /// It holds exact solids; others hold meshes.
  bool is_exact = false;
  /// Coordinates are rounded to float32 when they are written.
  bool is_float32 = false;
  /// It states the unit of its numbers. What is written without one is then read as the format's default.
  bool has_unit = false;
};

/// All of them, each once, in the order of the enumerators.
QUOIN_API std::span<const FormatInfo> formats();
QUOIN_API const FormatInfo& info_of(Format format);

/// The format that a name stands for: "stl-ascii".
QUOIN_API std::optional<Format> format_called(std::string_view name);
/// The format that the extension of a file name says, any case. Errors: "unknown-format".
QUOIN_API Result<Format> format_of(std::string_view file_name);

}  // namespace quoin
