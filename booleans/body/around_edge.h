/// \file
/// The cyclic order of half-planes around their common edge.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "exact/predicates.h"

namespace quoin::booleans {

/// Sorts items counter-clockwise around a directed edge, the first one staying first.
/// Item i lies on plane_of(i), on the left of the edge seen from that plane's positive side when left_of(i).
/// `axis`: one in which the edge runs; `forward`: +1 when it runs upwards there, else -1.
///
/// The direction from the edge into item i is s n x e, s = +1 for left. Turning all of them by 90 degrees about e keeps
/// their order, so for two items the turn is s s' (n x n') . e; n x n' is parallel to e, so one component decides.
template <class PlaneOf, class LeftOf>
void sort_around(std::vector<std::uint32_t>& items, int axis, int forward, PlaneOf plane_of, LeftOf left_of) {
  const auto turn = [&](std::uint32_t i, std::uint32_t j) {
    return exact::cross_sign(plane_of(i), plane_of(j), axis) * forward * (left_of(i) == left_of(j) ? 1 : -1);
  };
  const std::uint32_t first = items[0];
  // 0: along the first item, 1: left of it, 2: opposite, 3: right.
  const auto quarter = [&](std::uint32_t i) {
    const int t = turn(first, i);
    if (t != 0) return t > 0 ? 1 : 3;
    const bool same = (exact::dot_sign(plane_of(first), plane_of(i)) > 0) == (left_of(first) == left_of(i));
    return same ? 0 : 2;
  };
  std::sort(items.begin() + 1, items.end(), [&](std::uint32_t i, std::uint32_t j) {
    const int p = quarter(i), q = quarter(j);
    if (p != q) return p < q;
    const int t = turn(i, j);
    return t != 0 ? t > 0 : i < j;
  });
}

}  // namespace quoin::booleans
