/// \file
/// Contacts: the segments and points in which two touched faces meet, posted to the sheets of both.
#pragma once

#include "booleans/arrangement/touched.h"

namespace quoin::booleans {

/// Where an end of a segment lies in the face that has it: inside a boundary edge (its index in Touched::edges), inside
/// the face, or at a place that nobody looked for.
inline constexpr std::uint32_t inside_face = none - 1, unknown_place = none;

/// A piece of the drawing on `plane`: the segment {a, b} on the line of that plane and `line`.
struct ContactSegment {
  PlaneId plane;
  VertexId a, b;
  PlaneId line;                                              // not parallel to the plane
  OperandId other = none;                                    // whose face meets the face on the plane there
  std::uint32_t at_a = unknown_place, at_b = unknown_place;  // where its ends lie, both known or both unknown
};

/// A point of the drawing on `plane` that no segment need end in.
struct ContactPoint {
  PlaneId plane;
  VertexId vertex;
};

struct Contacts {
  Array<ContactSegment> segments;
  Array<ContactPoint> points;
};

/// Two touched faces, smaller id first.
using TouchedPair = std::array<TouchedId, 2>;

/// The pairs of different touched faces that the given faces belong to, each once, in order.
Array<TouchedPair> touched_pairs(const Touched& touched, const FacePairs& pairs);

/// The contacts of the given pairs. Pairs on one plane have none here (their sheet draws both), nor have parallel ones.
/// New points get names in the order of the pairs.
Contacts find_contacts(const Touched& touched, const Array<TouchedPair>& pairs, Names& names);

}  // namespace quoin::booleans
