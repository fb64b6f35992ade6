/// \file
/// What the cures of import work on, and what they say of it.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "exact/geometry.h"
#include "exact/rational.h"
#include "grid/lists/array.h"
#include "grid/seal.h"
#include "quoin/repair.h"

namespace quoin::grid {

/// Triangles of grid points. In canonical order points and triangles are sorted, and a triangle begins with its least
/// corner: the order of the input is forgotten, so no cure depends on it.
struct Surface {
  using Triangle = std::array<std::uint32_t, 3>;
  Array<exact::GridPoint> points;
  Array<Triangle> triangles;
  Sources sources = {};

  /// Brings into canonical order, without the points that no triangle has.
  void sort();
  /// Twice the area of a triangle, |x| + |y| + |z| of its vector, which is exact; below 2^63.
  std::int64_t area(const Triangle& t) const;
  /// Adds triangles that are no part of the input.
  void add(const Array<Triangle>& more);
  /// Drops triangles without area.
  void drop_flat();
  /// Seals exact T-junctions, whichever way the triangles look. Returns the points put on edges.
  std::uint64_t seal();
};

/// One kind of damage, grid steps.
struct Damage {
  Defect kind = Defect::hole;
  std::uint64_t count = 0;
  double size = 0;
  exact::GridPoint where = {};
  bool is_planar = false;  // of holes
  bool is_curable = true;  // of orientation

  /// One place more, or several of one size.
  void add(double place_size, const exact::GridPoint& place, std::uint64_t places = 1) {
    if (count == 0 || place_size > size) {
      size = place_size;
      where = place;
    }
    count += places;
  }
};

/// A triangle at an edge; `half` is 3 t + k for the edge from corner k of triangle t.
struct EdgeUse {
  std::uint32_t low, high, half;
  std::int32_t way;  // 1 from low to high, -1 back

  std::uint32_t triangle() const { return half / 3; }
  std::uint32_t from() const { return way > 0 ? low : high; }
  std::uint32_t to() const { return way > 0 ? high : low; }
};

/// All of them, edge by edge, by the half at each.
Array<EdgeUse> edge_uses(std::span<const Surface::Triangle> triangles);

/// visit(uses) for every edge.
template <class Visit>
void for_edges(std::span<const EdgeUse> uses, Visit&& visit) {
  for (std::size_t i = 0, j = 0; i < uses.size(); i = j) {
    while (j < uses.size() && uses[j].low == uses[i].low && uses[j].high == uses[i].high) ++j;
    visit(uses.subspan(i, j - i));
  }
}

/// How much more often an edge is run from its low to its high end than back.
inline std::int64_t excess(std::span<const EdgeUse> edge) {
  std::int64_t sum = 0;
  for (const EdgeUse& use : edge) sum += use.way;
  return sum;
}

/// From one grid point to another, components at most 2^30; or a product of two of those, at most 2^61.
using GridVector = std::array<std::int64_t, 3>;

inline GridVector between(const exact::GridPoint& p, const exact::GridPoint& q) {
  return {std::int64_t{q[0]} - p[0], std::int64_t{q[1]} - p[1], std::int64_t{q[2]} - p[2]};
}
inline GridVector cross(const GridVector& u, const GridVector& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}
inline exact::int128 dot(const GridVector& u, const GridVector& v) {
  return exact::int128(u[0]) * v[0] + exact::int128(u[1]) * v[1] + exact::int128(u[2]) * v[2];
}

inline exact::int128 squared_distance(const exact::GridPoint& p, const exact::GridPoint& q) {
  const GridVector v = between(p, q);
  return dot(v, v);
}

/// For reports only.
double length_of(exact::int128 squared);

/// How far a cure reaches: a tolerance, exact, in grid steps. A careful one asks the mesh, too: a gap is closed only
/// where it is at most 1/8 of the shortest edge at its ends.
class Reach {
 public:
  explicit Reach(const exact::Rational& distance);
  /// 1/128 of the longest side of the box of the points.
  static Reach careful(std::span<const exact::GridPoint> points);

  bool is_careful() const { return is_careful_; }
  /// Not below the tolerance.
  std::int64_t radius() const { return radius_; }
  /// Whether value <= tolerance^2 * scale; scale <= 2^62.
  bool holds(exact::int128 value, exact::int128 scale = 1) const;

 private:
  exact::Rational squared_;
  exact::int128 floor_ = 0;  // of squared_, at most 2^64
  std::int64_t radius_ = 0;
  bool is_careful_ = false;
};

/// Vertices at edges that an odd number of triangles share, and those edges.
struct Boundary {
  Array<EdgeUse> edges;           // one use of each
  Array<std::uint32_t> vertices;  // ascending
  /// Of each vertex in `vertices`: its neighbours over all edges, neighbours[starts[i]] .. neighbours[starts[i+1]-1],
  /// and the square of the shortest of these edges.
  Array<std::uint32_t> starts, neighbours;
  Array<exact::int128> shortest;
  /// Of any vertex: its place in `vertices`, or `absent`.
  Array<std::uint32_t> place;
  static constexpr std::uint32_t absent = UINT32_MAX;
};
Boundary boundary_of(const Surface& surface);

}  // namespace quoin::grid
