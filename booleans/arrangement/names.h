/// \file
/// Names: every point and every plane of one operation once, under one id.
///
/// Identity is geometric: two ids are equal exactly when the points (the unoriented planes) are. After this, incidence
/// of vertices is equality of ids. Names are the only tables that grow from stage to stage, and only between stages.
#pragma once

#include <span>
#include <vector>

#include "booleans/body/body.h"
#include "booleans/body/ids.h"
#include "exact/predicates.h"
#include "grid/lists/paged.h"

namespace quoin::booleans {

/// A vertex named at once, or a point that a parallel worker keeps until it enters the table.
class NewVertex {
 public:
  NewVertex() = default;
  NewVertex(VertexId named) : bits_(named.value) {}  // NOLINT: implicit by design
  /// The worker's point of that index.
  static NewVertex own(std::size_t index) {
    NewVertex v;
    v.bits_ = static_cast<std::uint32_t>(index) | own_bit;
    return v;
  }
  bool is_own() const { return (bits_ & own_bit) != 0; }
  /// Precondition: is_own().
  std::uint32_t index() const { return bits_ & ~own_bit; }
  /// Precondition: !is_own().
  VertexId named() const { return bits_; }
  friend bool operator==(NewVertex, NewVertex) = default;

 private:
  static constexpr std::uint32_t own_bit = 0x80000000u;
  std::uint32_t bits_ = none;
};

/// Distinct planes, each in its canonical orientation.
class PlaneTable {
 public:
  /// The id of a plane, whatever its orientation.
  PlaneId id(const exact::Plane& plane);
  const exact::Plane& operator[](PlaneId id) const { return planes_[id]; }
  const exact::PlaneApproximation& approximation(PlaneId id) const { return approximations_[id]; }
  std::size_t size() const { return planes_.size(); }
  /// Room for so many more.
  void reserve(std::size_t more);

 private:
  void grow(std::size_t slots);

  ById<PlaneId, exact::Plane> planes_;
  ById<PlaneId, exact::PlaneApproximation> approximations_;
  Array<PlaneId> slots_ = Array<PlaneId>(64, none);  // open addressing
};

/// Distinct points. Points with integer coordinates are grid points, however they arose.
class VertexTable {
 public:
  VertexTable();
  VertexId id(const exact::GridPoint& p);
  VertexId id(const exact::Point& p);
  /// Of a body's vertex.
  VertexId id(const Body& body, std::uint32_t v);

  std::size_t size() const { return approximations_.size(); }
  /// Room for so many more, of which `derived` are no grid points.
  void reserve(std::size_t more, std::size_t derived);
  const std::array<double, 3>& approximation(VertexId v) const { return approximations_[v]; }
  bool is_grid(VertexId v) const { return derived_[v] == none; }
  /// Precondition: is_grid(v).
  exact::GridPoint grid_point(VertexId v) const { return exact::grid_point(approximations_[v]); }
  /// Makes the box hold a vertex, exactly.
  void add_to(Box& box, VertexId v) const {
    if (is_grid(v))
      box.add(grid_point(v));
    else
      box.add_around(approximation(v));
  }
  exact::Point point(VertexId v) const { return is_grid(v) ? exact::point(grid_point(v)) : points_[derived_[v]]; }

  /// The side of a vertex to a plane: +1 on its positive side, 0 on it, -1.
  int side(VertexId v, const exact::Plane& p, const exact::PlaneApproximation& a) const {
    const int filtered = exact::side_filter(a, approximations_[v]);
    if (filtered == 2) return exact_side(v, p);
    ++exact::counters().filter;
    return filtered;
  }
  /// Order of the k-th coordinates.
  int compare_along(int k, VertexId u, VertexId v) const;
  /// Order by (x, y, z); 0 only for u = v.
  int compare_lexicographic(VertexId u, VertexId v) const;

 private:
  VertexId& slot(const std::array<double, 3>& key, const exact::Point* exact);
  void grow(std::size_t slots);
  VertexId insert(const std::array<double, 3>& key, const exact::Point* exact);
  int exact_side(VertexId v, const exact::Plane& p) const;

  ById<VertexId, std::array<double, 3>> approximations_;
  ById<VertexId, std::uint32_t> derived_;  // index into points_, none for grid points
  Array<exact::Point> points_;
  Array<VertexId> slots_;  // open addressing over the approximations
};

/// Which vertices of one operand are in the table of vertices.
struct OperandNames {
  grid::Paged<VertexId> name_of;  // by own vertex, none where it has no name; of no size where none has
  Array<std::uint32_t> listed;    // the own vertices that have a name

  VertexId of(std::uint32_t v) const { return name_of.size() == 0 ? VertexId(none) : name_of[v]; }
};

struct Names {
  VertexTable vertices;
  PlaneTable planes;
  ById<OperandId, OperandNames> operands;

  /// The side of a vertex to a plane.
  int side(VertexId v, PlaneId p) const { return vertices.side(v, planes[p], planes.approximation(p)); }
  /// The name of an operand's vertex, which gets one if it has none.
  VertexId name(const Body& body, OperandId operand, std::uint32_t v);
};

}  // namespace quoin::booleans
