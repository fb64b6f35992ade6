/// \file
/// Contacts: the segments and points in which two touched faces meet, posted to the sheets of both.
#pragma once

#include "booleans/arrangement/touched.h"

namespace quoin::booleans {

/// A piece of the drawing on `plane`: the segment {a, b} on the line of that plane and `line`.
struct ContactSegment {
  PlaneId plane;
  VertexId a, b;
  PlaneId line;  // not parallel to the plane
};

/// A point of the drawing on `plane` that no segment need end in.
struct ContactPoint {
  PlaneId plane;
  VertexId vertex;
};

struct Contacts {
  std::vector<ContactSegment> segments;
  std::vector<ContactPoint> points;
};

/// Two touched faces, smaller id first.
using TouchedPair = std::array<TouchedId, 2>;

/// The pairs of different touched faces that the given faces belong to, each once, in order.
std::vector<TouchedPair> touched_pairs(const Touched& touched, const FacePairs& pairs);

/// The contacts of the given pairs. Pairs on one plane have none here (their sheet draws both), nor have parallel ones.
/// New points get names in the order of the pairs.
Contacts find_contacts(const Touched& touched, const std::vector<TouchedPair>& pairs, Names& names);

}  // namespace quoin::booleans
