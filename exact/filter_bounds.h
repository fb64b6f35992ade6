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

// Of filters in the rooms above.

/// `Snapper`: unit roundoffs, of a coordinate and of the origin, both in steps; what is added, in steps.
inline constexpr double snap_bound = 4;        // docs/proofs/snap_filter.g
inline constexpr double snap_origin = 2;       // docs/proofs/snap_filter.g
inline constexpr double snap_floor = 0x1p-60;  // docs/proofs/snap_filter.g

/// `BlockSlabs`: how far a computed place along a line may be off, in steps times components of up to 2^30.
inline constexpr double crossing_slack = 0x1p13;  // docs/proofs/crossing.g

/// `place_of_crossing`: how far a computed place on an edge may be off, in steps, but for the error of the values.
inline constexpr double line_slack = 0x1p-19;  // docs/proofs/line_place.g

/// `area_sign` of m terms: area_bound (m + area_roundings) unit roundoffs, of the sum of the terms' magnitudes.
inline constexpr double area_bound = 2;      // docs/proofs/area_filter.g
inline constexpr double area_roundings = 5;  // docs/proofs/area_filter.g

/// `effect` of rounding on a triangle: unit roundoffs, of the sum of the terms' magnitudes; what is added to that sum,
/// of the product of two edges' longest components.
inline constexpr double effect_bound = 16;       // docs/proofs/effect_filter.g
inline constexpr double effect_floor = 0x1p-60;  // docs/proofs/effect_filter.g

/// `MovingPlane` and `moving_turn`: unit roundoffs, of the product of the rows' largest components.
inline constexpr double moving_bound = 64;      // docs/proofs/moving_filter.g
inline constexpr double moving_turn_bound = 8;  // docs/proofs/moving_turn.g

/// `MapFilter`: unit roundoffs, of the sum of the terms' magnitudes; what is added, of 1 and the factors' magnitudes.
inline constexpr double map_bound = 8;          // docs/proofs/map_filter.g
inline constexpr double map_floor = 0x1p-1000;  // docs/proofs/map_filter.g

}  // namespace quoin::exact
