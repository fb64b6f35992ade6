/// \file
/// Measures of a body, in grid units, and its box in model units.
#pragma once

#include <array>
#include <optional>

#include "booleans/body/body.h"
#include "exact/rational.h"
#include "grid/grid.h"

namespace quoin::booleans {

/// The signed volume enclosed by the faces, cubic grid steps. For a body that is full at infinity it is minus the
/// volume of the complement.
exact::Rational volume(const Body& body);

/// The exact volume's denominator has no more bits than this and three, its numerator no more than that and 100.
std::size_t volume_bits(const Body& body);

/// That volume times a positive scale, as a double: correctly rounded (ties to even). Long sums of fractions are not
/// needed for that, only where the volume lies so near the middle of two doubles, or 0, that nothing else tells.
double rounded_volume(const Body& body, const exact::Rational& scale);

/// The area, squared grid steps, in doubles.
double approximate_area(const Body& body);

/// The low and the high corner of the faces, model units, correctly rounded; nothing where there is no face.
std::optional<std::array<std::array<double, 3>, 2>> rounded_box(const Body& body, const grid::Lattice& lattice);

}  // namespace quoin::booleans
