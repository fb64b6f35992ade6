/// \file
/// A triangulated body on its way from exact to rounded points.
#pragma once

#include <vector>

#include "booleans/surface/moving_triangles.h"
#include "booleans/surface/rounded.h"

namespace quoin::booleans {

/// All vertices move straight to their rounded places. The arguments must outlive it.
class MovingMesh {
 public:
  /// `points` and `moves`: what rounding made of it (rounded.h); some vertex moved, none by as much as the world.
  MovingMesh(const Body& body, const Triangulated& mesh, Floats floats, const grid::Lattice& lattice,
             const std::vector<double>& points, const Moves& moves);

  std::size_t triangle_count() const { return mesh_.triangle_count(); }
  std::size_t vertex_count() const { return mesh_.vertex_count(); }
  std::array<std::uint32_t, 3> corners(std::uint32_t t) const { return mesh_.triangle(t); }
  /// Triangles before this one did not move.
  std::uint32_t first_moved() const { return static_cast<std::uint32_t>(moves_.first); }
  bool has_moved(std::uint32_t t) const {
    const auto c = mesh_.triangle(t);
    return t >= moves_.first && (moves_.moved[c[0]] | moves_.moved[c[1]] | moves_.moved[c[2]]) != 0;
  }

  /// Equal for vertices whose exact points are.
  std::uint32_t place(std::uint32_t v) const {
    return v < mesh_.source.size() ? mesh_.source[v] : added_place_[v - mesh_.source.size()];
  }
  MovingTriangle triangle(std::uint32_t t) const;

  /// Holds a triangle that did not move, grid steps.
  Box still_box(std::uint32_t t) const;
  /// Does the box of a triangle that did not move meet another one? Soon told for raw ones.
  bool still_meets(std::uint32_t t, const Box& box) const;
  /// Holds the triangle wherever it is on its way, grid steps.
  Box moving_box(std::uint32_t t) const;

 private:
  void number_added();

  const Body& body_;
  const Triangulated& mesh_;
  const std::vector<double>& points_;
  const Moves& moves_;
  std::int32_t pad_;     // an upper bound of all moves, grid steps
  double unit_, floor_;  // what rounding moves a coordinate by at most: a part of it, and besides
  Array<std::uint32_t> added_place_;
};

/// Marks the vertices of moving triangles whose stars stay embedded all the way: all their triangles face one
/// direction.
///
/// Seen against it, these turn counter-clockwise about the vertex. A line in that direction that passes near the vertex
/// leaves the body wherever it meets one; as it cannot leave twice without entering, it meets one alone. So the star is
/// a graph over the plane of the drawing. On the way no triangle turns over in the drawing, so each place around the
/// vertex stays covered as often as before: once. Where parts that touch are taken apart the same holds for each copy
/// of a vertex: its triangles are one fan, which cannot wind about the vertex twice without passing through itself.
Array<std::uint8_t> steady_stars(const MovingMesh& mesh);

}  // namespace quoin::booleans
