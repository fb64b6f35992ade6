/// \file
/// What is wrong with what a boundary declares.
#pragma once

#include <optional>
#include <string>

#include "booleans/body/boundary.h"

namespace quoin::booleans {

/// What is wrong, and what with: "vertex 3", "face 7".
struct Fault {
  std::string message, where;
};

/// Whether a boundary declares that of a solid, as far as can be said without asking where faces meet. Nothing when it
/// does, else the first fault found:
///   V1  no two vertices are the same point;
///   V2  corners lie on the plane of their face, edges have a length;
///   V3  a face has a positive area, seen from outside;
///   V4  a face has every directed edge once, every point inside it once and on no edge of it;
///   V5  every directed edge is balanced by its reverse, and the faces at an edge lie on several planes: so faces are
///       maximal;
///   V6  an edge ends in every vertex.
/// What has no fault and is embedded (embedding.h) makes a clean body. It need not be in canonical order, nor need its
/// edges be maximal: that is the canonical form's (canonical.h).
/// Preconditions: points and planes are reduced and within the ladder's bounds, faces have loops, loops have corners,
/// corners are vertices. O(n log n).
std::optional<Fault> fault(const Boundary& boundary);

}  // namespace quoin::booleans
