/// \file
/// Numbers of corners: corner k of triangle t is 3 t + k.
#pragma once

#include <cstdint>

namespace quoin::booleans {

/// The corners of the same triangle after and before one, counter-clockwise.
inline std::uint32_t next_corner(std::uint32_t c) { return c % 3 == 2 ? c - 2 : c + 1; }
inline std::uint32_t previous_corner(std::uint32_t c) { return c % 3 == 0 ? c + 2 : c - 1; }

}  // namespace quoin::booleans
