/// \file
/// What a solid weighs and where: integrals over it, and its area. Grid steps.
#pragma once

#include <array>

#include "booleans/classify/interval.h"
#include "booleans/questions/index.h"
#include "exact/rational.h"

namespace quoin::booleans {

/// Integrals over a solid: of 1, of x, y, z, of xx, yy, zz, yz, zx, xy. They are additive over solids without common
/// interior. Those of a body that is full at infinity are minus those of its complement.
struct Moments {
  exact::Rational volume = 0;
  std::array<exact::Rational, 3> first = {0, 0, 0};
  std::array<exact::Rational, 6> second = {0, 0, 0, 0, 0, 0};
};

/// The two axes of second moment m.
constexpr std::array<std::size_t, 2> axes_of_moment(std::size_t m) {
  return m < 3 ? std::array<std::size_t, 2>{m, m} : std::array<std::size_t, 2>{(m + 1) % 3, (m + 2) % 3};
}

/// Exact, however long that is.
Moments moments(const Index& index);

/// Holds the area.
Interval area(const Index& index);

}  // namespace quoin::booleans
