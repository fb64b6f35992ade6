/// \file
/// Irrational numbers as certified enclosures: intervals with rational ends, as narrow as asked for. Never a double.
/// Bits are at most 2^16.
#pragma once

#include <functional>

#include "rounding/numbers/approximation.h"

namespace quoin::rounding {

/// low <= the number <= high.
struct Enclosure {
  Rational low, high;
};

/// Of width below 2^-bits. Method: Machin's formula, pi = 16 atan(1/5) - 4 atan(1/239).
Enclosure enclosed_pi(unsigned bits);
/// tan of an angle in degrees, of width below 2^-bits. Precondition: 0 <= degrees <= 45.
/// Method: the alternating series of sine and cosine, every operation rounded outward.
Enclosure enclosed_tangent(const Rational& degrees, unsigned bits);
/// The square root, of relative width below 2^(1 - bits). Precondition: v >= 0.
Enclosure enclosed_root(const Rational& v, unsigned bits);

/// An upper bound of the square root, at most 2^-60 of it too large. Precondition: v >= 0.
Rational root_above(const Rational& v);

/// The best approximation (approximation.h) of an irrational number that `enclosed` encloses ever more narrowly as its
/// argument, the bits, grows; `error` becomes an upper bound of the distance.
/// Why it ends: best_approximation is monotone, so it is the answer as soon as it is the same for both ends, and no
/// irrational number lies halfway between two fractions.
Rational best_approximation(const std::function<Enclosure(unsigned)>& enclosed, const Integer& Q, Rational& error);

}  // namespace quoin::rounding
