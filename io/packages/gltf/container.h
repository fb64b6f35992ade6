/// \file
/// GLB, the binary container of glTF: a JSON text and a buffer.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "quoin/result.h"

namespace quoin::io {

/// Of a GLB its two chunks, of other bytes all of them as JSON.
struct GltfChunks {
  std::string_view json;
  std::optional<std::string_view> binary;
};

/// Errors (with `where` = byte): "truncated", "bad-syntax", "unknown-format" (another version than 2).
Result<GltfChunks> gltf_chunks(std::string_view bytes);

/// A GLB of both; without a second chunk where the buffer is empty. Precondition: it is below 4 GiB, and the buffer's
/// size a multiple of 4.
std::string packed_glb(std::string json, std::string_view buffer);

}  // namespace quoin::io
