/// \file
/// Where points lie, and what a ray or a segment meets.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "booleans/questions/index.h"
#include "booleans/questions/line.h"

namespace quoin::booleans {

/// +1 inside, 0 on the boundary, -1 outside. About O(log n) where few faces lie above each other.
int locate(const Index& index, const QueryPoint& point);

/// A maximal piece that a ray or a segment has in common with the boundary: a point, or a segment between two.
struct Contact {
  exact::Rational begin, end;
  /// Just before and just behind it: +1 inside, -1 outside, 0 where the boundary goes on beyond the end of the ray or
  /// segment.
  int before, behind;
  /// Those that it meets, by their names, ascending.
  std::vector<std::uint32_t> faces;
};

/// What a ray or a segment passes.
struct Passage {
  /// Of its first point: +1 inside, 0 on the boundary, -1 outside.
  int start;
  /// In order. Between them the line is off the boundary.
  std::vector<Contact> contacts;
};

/// The points with parameters from 0 to `last`, or to infinity. Precondition: last >= 0.
Passage passage(const Index& index, const Line& line, const std::optional<exact::Rational>& last);

}  // namespace quoin::booleans
