/// \file
/// Exact polyhedra: what primitives are before they are carried to the grid.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "booleans/canonical.h"
#include "grid/grid.h"
#include "rounding/plane_rounding.h"

namespace quoin::rounding {

/// The boundary of a bounded solid with rational vertices, maximal faces and edges. Model units, or grid steps.
/// Normals point outwards, loops run counter-clockwise seen from outside.
struct Polyhedron {
  std::vector<Vector> points;
  std::vector<WidePlane> planes;                  // one a face
  std::vector<std::uint32_t> face_loops = {0};    // face i has the loops face_loops[i] .. face_loops[i + 1] - 1
  std::vector<std::uint32_t> loop_corners = {0};  // loop j has the corners corners[loop_corners[j]] ..
  std::vector<std::uint32_t> corners;             // indices of points

  std::size_t face_count() const { return planes.size(); }
  std::span<const std::uint32_t> loop(std::uint32_t j) const {
    return std::span(corners).subspan(loop_corners[j], loop_corners[j + 1] - loop_corners[j]);
  }
  /// visit(u, v) for every directed edge of a face.
  template <class Visit>
  void for_edges(std::size_t face, Visit&& visit) const {
    for (std::uint32_t j = face_loops[face]; j < face_loops[face + 1]; ++j) {
      const auto l = loop(j);
      for (std::size_t i = 0; i < l.size() && l.size() > 1; ++i) visit(l[i], l[i + 1 < l.size() ? i + 1 : 0]);
    }
  }

  std::uint32_t add_point(Vector p);
  /// A face through these corners, its first loop the outer one. Precondition: planar, the first three corners of the
  /// first loop are a convex corner and not collinear.
  void add_face(std::initializer_list<std::span<const std::uint32_t>> loops);
  void add_face(std::span<const std::uint32_t> loop) { add_face({loop}); }
  /// The next loop of the last face.
  void add_loop(std::span<const std::uint32_t> loop);
};

/// Model units to grid steps.
AffineMap to_grid(const grid::Lattice& lattice);
/// A solid's boundary, in grid steps. Precondition: bounded.
Polyhedron polyhedron_of(const booleans::Canonical& form);
/// The image under a map. Precondition: its determinant is positive.
Polyhedron carried(Polyhedron p, const AffineMap& map);

/// Six times the enclosed volume.
Rational sixfold_volume(const Polyhedron& p);

/// Triangles of points, counter-clockwise from outside, that tile the faces. Nothing where a face's loops are seen not
/// to bound regions (crossings may go unseen, and give unspecified triangles).
std::optional<std::vector<std::array<std::uint32_t, 3>>> triangulated(const Polyhedron& p);

/// What makes a polyhedron trihedral: every vertex lies on exactly three distinct planes and every edge on two faces.
/// It is then determined by its planes: rounding them keeps every incidence.
struct Trihedral {
  /// Three faces with different planes at each vertex, ascending, and the sign of the determinant of their normals.
  std::vector<std::array<std::uint32_t, 3>> faces;
  std::vector<int> sign;
  /// Of each directed edge (from, to): the face through `to` whose plane does not hold the edge, and on which side of
  /// it `from` lies.
  struct Order {
    std::uint32_t from, to, face;
    int side;
  };
  std::vector<Order> orders;
};
/// Nothing for a polyhedron that is not.
std::optional<Trihedral> trihedral(const Polyhedron& p);

}  // namespace quoin::rounding
