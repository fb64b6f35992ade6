/// \file
/// Triangle meshes as files, for the example programs: OFF and binary STL, fast for millions of triangles.
#pragma once

#include <string>

#include "quoin/quoin.h"

namespace quoin::examples {

/// Writes OFF (the shortest decimals that read back to the same double) or binary STL (float32), by the extension.
/// Errors: "unknown-format", "unwritable".
Result<void> write_mesh_file(const std::string& path, const Mesh& mesh);

/// Reads OFF (polygons become fans) or binary STL (equal points become one), by the extension.
/// Errors: "unknown-format", "missing-file", "bad-syntax", "bad-index".
Result<Mesh> read_mesh_file(const std::string& path);

}  // namespace quoin::examples
