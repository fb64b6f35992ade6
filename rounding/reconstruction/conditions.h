/// \file
/// The consistency conditions of a rounded trihedral primitive (reconstruct.h): each is checked, none assumed.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "booleans/body/body.h"
#include "booleans/body/boundary.h"
#include "rounding/shapes/trihedral.h"

namespace quoin::rounding {

/// A condition that a rounding breaks.
struct Violation {
  enum class Kind { shape, world };
  /// `world`: the vertex lies beyond the world, which no other rounding would change.
  Kind kind = Kind::shape;
  /// Of C1 and C2: the condition is that of this vertex with the plane of this face. Else booleans::none.
  std::uint32_t vertex = booleans::none, face = booleans::none;
  std::string what = {};
};

/// Appends the vertices in which the boundary's planes meet, up to the first that breaks C1 or lies beyond the world.
/// `turn` is -1 for a mirror image, else 1.
std::optional<Violation> meet_vertices(const Trihedral& t, int turn, booleans::Boundary& boundary);
/// C2.
std::optional<Violation> order_violation(const Trihedral& t, const booleans::Boundary& boundary);
/// C3.
std::optional<Violation> crossing_violation(const booleans::Body& body);

}  // namespace quoin::rounding
