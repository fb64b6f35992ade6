/// \file
/// Closed polygons of the plane: whether their sides meet, and which polygon lies in which, over abstract predicates.
///
/// Method: plane sweep in lexicographic order (M. I. Shamos and D. Hoey, 1976). Left of the first point in which two
/// sides meet their order is that of the status, and those that meet there follow each other in it: two of them became
/// neighbours before, and were compared then, or one begins there, on the other.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "booleans/surface/triangulate.h"

namespace quoin::rounding {

/// How polygons lie to each other. Side i runs from corner i to the next corner of its polygon.
struct Nesting {
  static constexpr std::uint32_t none = UINT32_MAX;
  /// A side that meets another one, but for neighbours in their common corner; none where there is no such side.
  std::uint32_t meeting = none;
  /// By polygon: the smallest other one around it; none outside of all. Unspecified where sides meet.
  std::vector<std::uint32_t> around;
};

/// Time O(n log n): n log2 n comparisons for the order, four orientations for each two sides that become neighbours, at
/// most 3 n times, and O(log n) for each corner in which two sides begin.
template <booleans::PlanarPoints Points>
class OutlineSweep {
 public:
  /// The corners of polygon i are starts[i] .. starts[i + 1] - 1.
  /// Preconditions: at least three corners each; sides that follow each other are not collinear.
  OutlineSweep(const Points& points, std::span<const std::uint32_t> starts) : points_(points) {
    const Index count = starts.back();
    for (Index l = 0; l + 1 < starts.size(); ++l)
      for (Index i = starts[l]; i < starts[l + 1]; ++i)
        corners_.push_back({l, i == starts[l] ? starts[l + 1] - 1 : i - 1, i + 1 == starts[l + 1] ? starts[l] : i + 1});

    order_.resize(count);
    std::iota(order_.begin(), order_.end(), 0u);
    std::sort(order_.begin(), order_.end(), [&](Index a, Index b) { return points.compare(a, b) < 0; });
    for (Index i = 0; i < count; ++i) corners_[order_[i]].rank = i;
    polygons_.resize(starts.size() - 1);
    status_.reset(count);
  }

  Nesting run() {
    for (std::size_t i = 0; i < order_.size() && meeting_ == none; ++i) {
      const bool is_repeated = i > 0 && points_.compare(order_[i - 1], order_[i]) == 0;
      if (is_repeated)
        meeting_ = order_[i];
      else
        visit(order_[i]);
    }

    Nesting result{meeting_, {}};
    for (const Polygon& p : polygons_) result.around.push_back(p.around);
    return result;
  }

 private:
  using Index = std::uint32_t;
  using Status = booleans::SweepStatus;
  static constexpr Index none = Nesting::none;
  struct Corner {
    Index polygon, previous, next;
    Index rank = 0;  // in the order of the sweep
  };
  struct Polygon {
    Index around = none;
    bool is_reached = false, is_counter_clockwise = false;
  };

  Index from(Index side) const { return side; }
  Index to(Index side) const { return corners_[side].next; }
  bool runs_right(Index side) const { return corners_[from(side)].rank < corners_[to(side)].rank; }
  Index left(Index side) const { return runs_right(side) ? from(side) : to(side); }
  Index right(Index side) const { return runs_right(side) ? to(side) : from(side); }

  void visit(Index corner) {
    const Index in = corners_[corner].previous, out = corner;
    const bool in_ends = right(in) == corner, out_ends = right(out) == corner;
    if (in_ends && out_ends)
      end(in, out);
    else if (in_ends || out_ends)
      pass(in_ends ? in : out, in_ends ? out : in);
    else
      begin(corner, in, out);
  }

  void end(Index in, Index out) {
    for (const Index side : {in, out}) {
      const Index below = status_.neighbour(side, Status::bottom), above = status_.neighbour(side, Status::top);
      status_.erase(side);
      compare(below, above);
    }
  }

  void pass(Index old, Index fresh) {
    status_.replace(old, fresh);
    compare(status_.neighbour(fresh, Status::bottom), fresh);
    compare(fresh, status_.neighbour(fresh, Status::top));
  }

  void begin(Index corner, Index in, Index out) {
    const Index below = side_below(corner);
    if (meeting_ != none) return;
    const bool is_out_lower = points_.orientation(corner, to(out), from(in)) > 0;
    Polygon& polygon = polygons_[corners_[corner].polygon];
    // The first corner of a polygon is convex.
    if (!polygon.is_reached) polygon = {polygon_above(below), true, is_out_lower};

    const Index lower = is_out_lower ? out : in, upper = is_out_lower ? in : out;
    status_.insert_above(below, lower);
    status_.insert_above(lower, upper);
    compare(below, lower);
    compare(upper, status_.neighbour(upper, Status::top));
  }

  /// The active side right below a corner in which no active side ends; a side that runs through it meets those there.
  Index side_below(Index corner) {
    Index below = none;
    for (Index side = status_.root(); side != none;) {
      const int turn = points_.orientation(left(side), right(side), corner);
      if (turn == 0) {
        meeting_ = side;
        return none;
      }
      if (turn > 0) below = side;
      side = status_.child(side, turn > 0 ? Status::top : Status::bottom);
    }
    return below;
  }

  /// The smallest polygon around what lies right above an active side.
  Index polygon_above(Index side) const {
    if (side == none) return none;
    const Index own = corners_[side].polygon;
    const bool is_inside = runs_right(side) == polygons_[own].is_counter_clockwise;
    return is_inside ? own : polygons_[own].around;
  }

  /// Of two neighbours, or fewer.
  void compare(Index a, Index b) {
    if (a != none && b != none && meet(a, b)) meeting_ = corners_[left(a)].rank < corners_[left(b)].rank ? b : a;
  }

  bool meet(Index a, Index b) const {
    if (to(a) == from(b) || to(b) == from(a)) return false;
    const auto sides_of_ends = [&](Index line, Index s) {
      return std::array{points_.orientation(left(line), right(line), left(s)),
                        points_.orientation(left(line), right(line), right(s))};
    };
    const auto [p, q] = sides_of_ends(a, b);
    if (p * q > 0) return false;
    if (p == 0 && q == 0)
      return std::max(corners_[left(a)].rank, corners_[left(b)].rank) <=
             std::min(corners_[right(a)].rank, corners_[right(b)].rank);
    const auto [r, s] = sides_of_ends(b, a);
    return r * s <= 0;
  }

  const Points& points_;
  std::vector<Corner> corners_;
  std::vector<Index> order_;  // corners from left to right, those of one x upward
  std::vector<Polygon> polygons_;
  Status status_;
  Index meeting_ = none;
};

}  // namespace quoin::rounding
