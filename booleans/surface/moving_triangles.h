/// \file
/// Triangles that move from exact to rounded corners, and what is true of them all the way.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace quoin::booleans {

/// A rounded triangle. Its corners are within `error` of `at`, in each coordinate, all the way. `place`: equal where
/// the exact corners are.
struct MovingTriangle {
  std::array<std::uint32_t, 3> place;
  std::array<std::array<double, 3>, 3> at;
  double error;
};

/// Makes the shared corners of two triangles the first ones of both, in the same order; returns how many they are.
std::size_t align(MovingTriangle& t, MovingTriangle& u);

/// Do aligned triangles meet in their shared corners and edges only, all the way? False if that is not seen.
bool part_all_the_way(const MovingTriangle& t, const MovingTriangle& u, std::size_t shared);

/// The directions that a triangle faces all the way, as far as that is seen: bit 2 k stands for axis k, bit 2 k + 1 for
/// the opposite. A triangle that faces any keeps its area.
unsigned facing(const MovingTriangle& t);
inline constexpr unsigned facing_all = 0x3F;

}  // namespace quoin::booleans
