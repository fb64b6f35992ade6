/// \file
/// Where things of an arrangement are, for messages.
#pragma once

#include <string>

#include "booleans/arrangement/arrangement.h"

namespace quoin::booleans {

/// "(x, y, z) grid steps", rounded.
std::string in_grid_steps(const std::array<double, 3>& point);

/// The first of the faces that a node is a part of, and one of its corners.
struct NodePlace {
  FaceId face;
  std::array<double, 3> corner;
};
NodePlace place_of(const Arrangement& a, NodeId n);

}  // namespace quoin::booleans
