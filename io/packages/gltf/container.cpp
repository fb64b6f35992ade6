#include "io/packages/gltf/container.h"

#include "io/formats.h"
#include "io/packages/gltf/bytes.h"

namespace quoin::io {
namespace {

constexpr std::string_view glb_magic = "glTF";
constexpr std::uint32_t json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;
constexpr std::size_t glb_header_size = 12, chunk_header_size = 8;

Error glb_fault(ErrorCode code, const char* what, std::size_t at) {
  return {code, what, {}, "byte " + std::to_string(at)};
}

void append_chunk(std::string& out, std::uint32_t kind, std::string_view content) {
  append_word(out, static_cast<std::uint32_t>(content.size()));
  append_word(out, kind);
  out += content;
}

}  // namespace

bool looks_like_glb(std::string_view bytes) { return bytes.starts_with(glb_magic); }

Result<GltfChunks> gltf_chunks(std::string_view bytes) {
  if (!looks_like_glb(bytes)) return GltfChunks{bytes, {}};
  if (bytes.size() < glb_header_size + chunk_header_size)
    return glb_fault(ErrorCode::truncated, "the file ends within its header", bytes.size());
  if (little_endian_at(bytes, 4, 4) != 2)
    return glb_fault(ErrorCode::unknown_format, "only version 2 of glTF is read", 4);
  const std::uint32_t length = little_endian_at(bytes, 8, 4);
  if (length > bytes.size()) return glb_fault(ErrorCode::truncated, "the file is shorter than it says", 8);
  bytes = bytes.substr(0, length);

  GltfChunks chunks;
  for (std::size_t at = glb_header_size; at < bytes.size();) {
    if (bytes.size() - at < chunk_header_size)
      return glb_fault(ErrorCode::truncated, "the file ends within the header of a chunk", at);
    const std::uint32_t size = little_endian_at(bytes, at, 4), kind = little_endian_at(bytes, at + 4, 4);
    if (size > bytes.size() - at - chunk_header_size)
      return glb_fault(ErrorCode::truncated, "the file ends within a chunk", at);
    const std::string_view chunk = bytes.substr(at + chunk_header_size, size);
    if (at == glb_header_size && kind != json_chunk)
      return glb_fault(ErrorCode::bad_syntax, "the first chunk is no JSON", at);
    if (at == glb_header_size) chunks.json = chunk;
    if (kind == binary_chunk && !chunks.binary) chunks.binary = chunk;
    at += chunk_header_size + std::size_t{size};
  }
  return chunks;
}

std::string packed_glb(std::string json, std::string_view buffer) {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::size_t rest = buffer.empty() ? 0 : chunk_header_size + buffer.size();

  std::string out(glb_magic);
  append_word(out, 2);
  append_word(out, static_cast<std::uint32_t>(glb_header_size + chunk_header_size + json.size() + rest));
  append_chunk(out, json_chunk, json);
  if (!buffer.empty()) append_chunk(out, binary_chunk, buffer);
  return out;
}

}  // namespace quoin::io
