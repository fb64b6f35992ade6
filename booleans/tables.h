/// \file
/// The shared tables of one arrangement: every point and every plane once, under one id.
///
/// Identity is geometric: two ids are equal exactly when the points (the unoriented planes) are. After this, incidence
/// of vertices is equality of ids.
#pragma once

#include <vector>

#include "booleans/body.h"
#include "exact/predicates.h"

namespace quoin::booleans {

/// Vertex ids with this bit name points that a parallel worker keeps until they enter the table.
inline constexpr std::uint32_t local_bit = 0x80000000u;

/// Distinct planes, each in its canonical orientation.
class PlaneTable {
 public:
  /// The id of a plane, whatever its orientation.
  std::uint32_t id(const exact::Plane& plane);
  const exact::Plane& operator[](std::uint32_t id) const { return planes_[id]; }
  const exact::PlaneApproximation& approximation(std::uint32_t id) const { return approximations_[id]; }
  std::size_t size() const { return planes_.size(); }

 private:
  void grow();

  std::vector<exact::Plane> planes_;
  std::vector<exact::PlaneApproximation> approximations_;
  std::vector<std::uint32_t> slots_ = std::vector<std::uint32_t>(64, none);  // open addressing
};

/// Distinct points. Points with integer coordinates are grid points, however they arose.
class VertexTable {
 public:
  VertexTable();
  std::uint32_t id(const exact::GridPoint& p);
  std::uint32_t id(const exact::Point& p);

  std::size_t size() const { return approximations_.size(); }
  const std::array<double, 3>& approximation(std::uint32_t v) const { return approximations_[v]; }
  bool is_grid(std::uint32_t v) const { return derived_[v] == none; }
  exact::GridPoint grid_point(std::uint32_t v) const;
  exact::Point point(std::uint32_t v) const { return is_grid(v) ? exact::point(grid_point(v)) : points_[derived_[v]]; }

  /// The side of vertex v to a plane: +1 on its positive side, 0 on it, -1.
  int side(std::uint32_t v, const exact::Plane& p, const exact::PlaneApproximation& a) const;
  /// Order of the k-th coordinates.
  int compare_along(int k, std::uint32_t u, std::uint32_t v) const;
  /// Order by (x, y, z); 0 only for u = v.
  int compare_lexicographic(std::uint32_t u, std::uint32_t v) const;

 private:
  std::uint32_t& slot(const std::array<double, 3>& key, const exact::Point* exact);
  void grow();
  std::uint32_t insert(const std::array<double, 3>& key, const exact::Point* exact);

  std::vector<std::array<double, 3>> approximations_;
  std::vector<std::uint32_t> derived_;  // index into points_, none for grid points
  std::vector<exact::Point> points_;
  std::vector<std::uint32_t> slots_;  // open addressing over the approximations
};

}  // namespace quoin::booleans
