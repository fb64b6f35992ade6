/// \file
/// What the line of two planes does with a touched face on one of them.
#pragma once

#include "booleans/arrangement/touched.h"

namespace quoin::booleans {

/// A place where the line of two planes meets the boundary of a face.
struct Stop {
  NewVertex vertex;
  int left, right;     // net boundary crossings of the strips just left and just right of the line: entering +1
  bool open;           // the segment from here to the next stop lies in the closed face
  std::uint32_t edge;  // the one edge that crosses the line here (in Touched::edges), else none
};

/// The stops of a face on a line, in the line's direction.
struct Trace {
  Array<Stop> stops;
  int left = 0, right = 0;  // how often the face covers the strips before the first stop
  bool open = false;        // the closed face holds the line before the first stop
  bool runs_along = false;  // an edge lies on the line, even where its ends are no stops, being too far away

  /// Does the line only cross edges, each in a place of its own?
  bool is_plain() const {
    return !runs_along && std::none_of(stops.begin(), stops.end(), [](const Stop& s) { return s.edge == none; });
  }
};

/// The line of a face's plane and another one, on the face's plane; it runs along n_own x n_other (canonical normals).
struct FaceLine {
  TouchedId face;
  PlaneId own, other;
  int axis;       // in which the line runs
  int direction;  // +1 when it runs upwards there, else -1
};

/// Traces lines through faces; owns the points that it makes.
///
/// The strip rule. Left of n_f x n_g the plane g is negative: its value grows along n_g, and
/// n_g . (n_f x (n_f x n_g)) = (n_f . n_g)^2 - |n_f|^2 |n_g|^2 < 0. So on the strip just left of the line a vertex on
/// the plane counts as positive, on the strip just right of it as negative, and an edge that goes from negative to
/// positive, having the face on its left (seen from +n_f), enters the face.
class LineTracer {
 public:
  LineTracer(const Touched& touched, const Names& names) : touched_(touched), names_(names) {}

  /// The stops of a face. Of a face with an edge tree only those within `box`, that of the face it may meet, and all of
  /// those: the crossing of an edge lies in the edge's box.
  void find_stops(const FaceLine& line, const Box& box, Trace& trace);
  /// The same, of a face with an edge tree, but those between the first and the last of some stops on that line.
  void find_stops_between(const FaceLine& line, const Array<Stop>& stops, Trace& trace);
  /// Says which segments between stops lie in the face. `at`: a point of the line where stops were looked for, asked
  /// where those of a face with an edge tree leave open how it begins.
  void find_open_segments(const FaceLine& line, NewVertex at, Trace& trace);

  /// Where a boundary edge of the line's face crosses the other plane. Precondition: its ends lie on both sides.
  NewVertex crossing(const FaceLine& line, const BoundaryEdge& edge);

  /// Order along an axis of points on one line that runs in it: 0 exactly for equal points.
  int compare(int axis, NewVertex u, NewVertex v) const {
    const auto k = static_cast<std::size_t>(axis);
    return exact::compare_rounded(approximation(u)[k], approximation(v)[k],
                                  [&] { return u == v ? 0 : exact::compare_along(axis, point(u), point(v)); });
  }

  Array<exact::Point> points;  // NewVertex::own

 private:
  const std::array<double, 3>& approximation(NewVertex v) const {
    return v.is_own() ? points[v.index()].approximation : names_.vertices.approximation(v.named());
  }
  exact::Point point(NewVertex v) const { return v.is_own() ? points[v.index()] : names_.vertices.point(v.named()); }
  int side(NewVertex v, PlaneId plane) const {
    return v.is_own() ? exact::side(names_.planes[plane], points[v.index()]) : names_.side(v.named(), plane);
  }

  Box box_around(NewVertex v) const {
    Box box;
    if (v.is_own())
      box.add_around(points[v.index()].approximation);
    else
      names_.vertices.add_to(box, v.named());
    return box;
  }

  void collect_stops(const FaceLine& line, std::span<const Box> hull, Trace& trace);
  void add_stops(const FaceLine& line, std::uint32_t edge, Trace& trace);
  void merge(const FaceLine& line, Array<Stop>& stops) const;
  int cover_after(const FaceLine& line, NewVertex at, int strip) const;
  void anchor(const FaceLine& line, NewVertex at, Trace& trace) const;

  /// Both faces at an edge ask for its crossing with a plane, mostly soon after each other.
  struct Crossing {
    VertexId low, high;
    PlaneId plane;
    NewVertex point;
  };
  const Touched& touched_;
  const Names& names_;
  std::array<Crossing, 64> crossings_;  // the last ones, by a hash
};

/// The trace of the same line in the other direction.
void reverse(Trace& trace);

}  // namespace quoin::booleans
