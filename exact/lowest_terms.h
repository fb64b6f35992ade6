/// \file
/// Points in lowest terms.
#pragma once

#include "exact/geometry.h"

namespace quoin::exact {

/// The greatest common divisor; gcd(0, b) = b.
uint128 gcd(uint128 a, uint128 b);

/// Whether x, y, z and w have no common divisor. Without allocation where all are below 2^127.
bool is_reduced(const Point& p);
/// The same point in lowest terms.
Point reduced(const Point& p);

}  // namespace quoin::exact
