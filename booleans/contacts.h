/// \file
/// Contacts: the segments and points in which two touched faces meet, posted to the sheets of both.
#pragma once

#include "booleans/touched.h"

namespace quoin::booleans {

/// A piece of a sheet's drawing: the segment {a, b} on the line of the sheet's plane and `line`.
struct SheetSegment {
  std::uint32_t sheet;
  std::uint32_t a, b;
  std::uint32_t line;  // plane id, not parallel to the sheet's
};

/// A point of a sheet that no segment need end in.
struct SheetPoint {
  std::uint32_t sheet;
  std::uint32_t vertex;
};

struct Contacts {
  std::vector<SheetSegment> segments;
  std::vector<SheetPoint> points;
};

/// A pair of touched faces, indices into TouchedFaces::faces.
using FacePair = std::array<std::uint32_t, 2>;

/// The pairs of different touched faces that the given faces belong to, each once, in order.
std::vector<FacePair> touched_pairs(const TouchedFaces& touched, const std::vector<FaceIdPair>& near);

/// The contacts of the given pairs. Pairs on one plane have none here (their sheet draws both), nor have parallel ones.
Contacts find_contacts(const TouchedFaces& touched, const std::vector<FacePair>& pairs, VertexTable& vertices,
                       const PlaneTable& planes);

}  // namespace quoin::booleans
