/// \file
/// Little-endian numbers in bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace quoin::io {

/// The number of `size` bytes, at most 4. Precondition: they are there.
inline std::uint32_t little_endian_at(std::string_view bytes, std::uint64_t at, std::size_t size) {
  std::uint32_t value = 0;
  for (std::size_t i = size; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

inline void append_word(std::string& out, std::uint32_t value) {
  for (int i = 0; i < 4; ++i) out.push_back(static_cast<char>(value >> (8 * i) & 0xff));
}

}  // namespace quoin::io
