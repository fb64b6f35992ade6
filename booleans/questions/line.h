/// \file
/// Points and lines that questions are asked about: numbers of any length, grid steps.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "booleans/body/box.h"
#include "booleans/classify/interval.h"
#include "exact/rational.h"
#include "grid/grid.h"

namespace quoin::booleans {

using RationalPoint = std::array<exact::Rational, 3>;
using IntervalPoint = std::array<Interval, 3>;

/// x / w with w > 0.
struct Homogeneous {
  std::array<exact::Integer, 3> x;
  exact::Integer w;
};
Homogeneous homogeneous(const RationalPoint& p);
Homogeneous homogeneous(const exact::Point& p);

/// Holds the number; whatever it is if it is longer than floating point.
Interval enclosure(const exact::Rational& v);

/// The way of doubles in model units to grid steps.
class ModelFrame {
 public:
  /// The lattice must outlive it.
  explicit ModelFrame(const grid::Lattice& lattice);
  explicit ModelFrame(grid::Lattice&&) = delete;

  RationalPoint point(const RationalPoint& model) const;
  RationalPoint direction(const RationalPoint& model) const;
  /// Holds the point. Precondition: finite.
  IntervalPoint enclosure(const std::array<double, 3>& model) const;
  const grid::Lattice& lattice() const { return lattice_; }

 private:
  const grid::Lattice& lattice_;
  IntervalPoint origin_;
  Interval step_;
};

/// A point: intervals that hold it, and its exact numbers, which are made when they are first asked for. One thread
/// at a time.
class QueryPoint {
 public:
  explicit QueryPoint(const RationalPoint& exact);
  /// Precondition: finite.
  QueryPoint(const ModelFrame& frame, const std::array<double, 3>& model);

  const IntervalPoint& near() const { return near_; }
  const Homogeneous& exact() const;
  RationalPoint rational() const;

 private:
  const ModelFrame* frame_ = nullptr;
  std::array<double, 3> model_{};
  IntervalPoint near_;
  mutable std::optional<Homogeneous> exact_;
};

/// The points p + t d, and the way along them from p towards infinity.
class Line {
 public:
  /// Precondition: d is not 0.
  Line(QueryPoint p, const RationalPoint& d);
  /// With d = +1 or -1 along an axis.
  Line(QueryPoint p, std::size_t axis, int d);

  const QueryPoint& start() const { return p_; }
  const Homogeneous& direction() const { return d_; }
  const IntervalPoint& near_direction() const { return near_d_; }
  /// Whether intervals may be computed with: products of three numbers do not overflow.
  bool is_tame() const { return is_tame_; }

  /// A box that holds the part t >= 0 of the line within a box.
  Box way(const Box& within) const;
  /// False only where the line misses the box.
  bool may_meet(const Box& box) const;

 private:
  void find_tame();

  QueryPoint p_;
  Homogeneous d_;
  IntervalPoint near_d_;
  bool is_axis_, is_tame_ = false;
};

}  // namespace quoin::booleans
