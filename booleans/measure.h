/// \file
/// Exact measures of a body, grid units.
#pragma once

#include "booleans/body.h"
#include "exact/rational.h"

namespace quoin::booleans {

/// The signed volume enclosed by the faces, cubic grid steps. For a body that is full at infinity it is minus the
/// volume of the complement.
exact::Rational volume(const Body& body);

/// The area, squared grid steps, in doubles.
double approximate_area(const Body& body);

}  // namespace quoin::booleans
