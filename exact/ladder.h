/// \file
/// The word ladder: how wide every exact quantity is, derived from one number, L.
///
/// L = 2^62 - 1; planes have |a|, |b|, |c| <= L and |d| <= L^2. A 3x3 determinant of entries bounded by 1 is at most 4,
/// a 4x4 one at most 16 (attained at corners), so every bound below is (4 or 16) times a power of L.
#pragma once

#include "exact/int.h"

namespace quoin::exact {

inline constexpr int coefficient_magnitude = 62;  // bits of L

/// Signed bits of a quantity of at most factor * L^degree, factor = 2^log2_factor.
/// L^degree < 2^(62 degree), so the magnitude needs 62 degree + log2_factor bits, plus one for the sign.
inline constexpr int ladder_bits(int degree, int log2_factor) {
  return coefficient_magnitude * degree + log2_factor + 1;
}

using Coefficient = Int<ladder_bits(1, 0)>;   // a, b, c
using Offset = Int<ladder_bits(2, 0)>;        // d
using Denominator = Int<ladder_bits(3, 2)>;   // w, determinant of three normals: 4 L^3
using Numerator = Int<ladder_bits(4, 2)>;     // x, y, z of a vertex: 4 L^4
using SideValue = Int<ladder_bits(5, 4)>;     // 4x4 determinant, a plane at a vertex: 16 L^5
using OrderValue = Int<ladder_bits(7, 5)>;    // x1 w2 - x2 w1: 32 L^7
using TripleValue = Int<ladder_bits(11, 8)>;  // orientation of three derived points in a plane: 256 L^11

static_assert(Coefficient::bits == 63 && Coefficient::words == 1);
static_assert(Offset::bits == 125 && Offset::words == 2);
static_assert(Denominator::bits == 189 && Denominator::words == 3);
static_assert(Numerator::bits == 251 && Numerator::words == 4);
static_assert(SideValue::bits == 315 && SideValue::words == 5);
static_assert(OrderValue::bits == 440 && OrderValue::words == 7);
static_assert(TripleValue::bits == 691 && TripleValue::words == 11);

/// Every vertex lies in the world |x|, |y|, |z| <= 2^29 grid steps.
inline constexpr int world_bits = 29;
inline constexpr std::int32_t world = std::int32_t{1} << world_bits;
/// L itself and L^2.
inline constexpr std::int64_t coefficient_limit = (std::int64_t{1} << coefficient_magnitude) - 1;
inline constexpr int128 offset_limit = int128(coefficient_limit) * coefficient_limit;

}  // namespace quoin::exact
