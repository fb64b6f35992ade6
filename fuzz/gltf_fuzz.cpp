/// \file
/// Laws of glTF files. Bytes that begin with a brace are JSON, those with the magic a GLB; others are the chunks
/// of a GLB, with a blank before its JSON, which ends at the first zero.
#include <algorithm>

#include "fuzz/scene_law.h"

namespace quoin::fuzz {
namespace {

std::string word(std::size_t value) {
  std::string out;
  for (int i = 0; i < 4; ++i) out.push_back(static_cast<char>(value >> (8 * i) & 0xff));
  return out;
}

std::string packed(const std::string& bytes) {
  const std::size_t end = std::min(bytes.find('\0'), bytes.size());
  const std::string json = bytes.substr(0, end), binary = bytes.substr(end);
  return "glTF" + word(2) + word(28 + json.size() + binary.size()) + word(json.size()) + "JSON" + json +
         word(binary.size()) + std::string("BIN\0", 4) + binary;
}

}  // namespace
}  // namespace quoin::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  const bool is_whole = bytes.starts_with('{') || bytes.starts_with("glTF");
  quoin::fuzz::require_scene_or_refusal(is_whole ? bytes : quoin::fuzz::packed(bytes), quoin::Format::glb);
  return 0;
}
