/// \file
/// The numbers of the floating-point filters: nowhere else do they stand.
///
/// A filter is sound when its number is not below what its proof needs. The proofs take the numbers from here. Each is
/// one line,
///   inline constexpr TYPE NAME = NUMBER;  // docs/proofs/FILE.g
/// and @NAME@ in that file stands for NUMBER: tests/proofs/run.sh puts it there, then asks Gappa. A number that its
/// file does not mention is refused, too. How a bound comes about is told beside its filter.
#pragma once

#include <cstdint>
#include <limits>

namespace quoin::exact {

/// Half an ulp of 1: the relative error of one rounding to nearest.
inline constexpr double unit_roundoff = 0x1p-53;  // docs/proofs/rounding.g
static_assert(std::numeric_limits<double>::is_iec559 && 2 * unit_roundoff == std::numeric_limits<double>::epsilon());

/// `side`: unit roundoffs, of the sum of the terms' magnitudes.
inline constexpr double side_bound = 8;  // docs/proofs/side_filter.g

/// `turn`: unit roundoffs, of the permanent of magnitudes.
inline constexpr double turn_bound = 16;  // docs/proofs/turn_filter.g

/// `orientation_in_plane`: unit roundoffs, of E N + F M; and how many M u it adds to E.
inline constexpr double orientation_bound = 16;  // docs/proofs/orientation_filter.g
inline constexpr double orientation_tail = 4;    // docs/proofs/orientation_filter.g

/// `rounded_quotient`: how far the true quotient may lie below and above the quotient of the leading words.
inline constexpr std::uint64_t quotient_below = 2;  // docs/proofs/quotient.g
inline constexpr std::uint64_t quotient_above = 3;  // docs/proofs/quotient.g

}  // namespace quoin::exact
