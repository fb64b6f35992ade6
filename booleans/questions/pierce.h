/// \file
/// What a line and a triangle have in common.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "booleans/questions/index.h"
#include "booleans/questions/line.h"

namespace quoin::booleans {

/// How a line meets a closed triangle.
///
/// `jump` is that of the line shifted by (e, e^2, e^3), e > 0 infinitely small: `facing` where the shifted line crosses
/// the triangle, else 0. The shifted line meets no edge, and is parallel to the planes that the line is parallel to. So
/// along it the winding number changes by -jump at each meeting, and where the line is off the boundary the winding
/// number is that of the shifted one.
struct Piercing {
  enum class Kind {
    miss,
    point,  // the line meets the triangle's plane there, within the triangle or on its edges
    along   // the line lies in the triangle's plane; it need not meet the triangle
  };
  Kind kind = Kind::miss;
  int facing = 0;  // of a point: the sign of normal . direction, +1 where the line leaves
  int jump = 0;
  bool is_inside = false;  // of a point: not on the triangle's edges
};

Piercing pierce(const Index& index, const Line& line, std::uint32_t triangle);

/// The sign of the parameter of the point where the line meets the triangle's plane. Precondition: they are not
/// parallel, `facing` is the sign of normal . direction.
int parameter_sign(const Index& index, const Line& line, std::uint32_t triangle, int facing);
/// That parameter. Precondition: not parallel.
exact::Rational parameter(const Index& index, const Line& line, std::uint32_t triangle);

/// First and last parameter of the points of the closed triangle on a line in its plane, perhaps equal; nothing where
/// there are none.
std::optional<std::array<exact::Rational, 2>> parameters_along(const Index& index, const Line& line,
                                                               std::uint32_t triangle);

}  // namespace quoin::booleans
