/// \file
/// Exact polyhedra: what primitives are before they are carried to the grid.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "booleans/body/canonical.h"
#include "grid/grid.h"
#include "grid/lists/loops.h"
#include "quoin/result.h"
#include "rounding/planes/wide_plane.h"

namespace quoin::rounding {

inline Error bad_primitive(std::string message) { return {ErrorCode::bad_primitive, std::move(message)}; }

/// The boundary of a bounded solid with rational vertices, maximal faces and edges. Model units, or grid steps.
/// Normals point outwards, loops run counter-clockwise seen from outside.
struct Polyhedron {
  std::vector<Vector> points;
  std::vector<WidePlane> planes;     // one a face
  grid::Loops<std::uint32_t> faces;  // of indices of points

  /// What faces carry (booleans/body/labels.h); nothing where `origins` is null.
  std::shared_ptr<const booleans::Origins> origins = nullptr;
  std::vector<booleans::Provenance> provenance = {};  // one a face
  /// Another plane through the edge that begins at a corner, where faces on one plane meet.
  struct Border {
    std::uint32_t corner;
    WidePlane other;
  };
  std::vector<Border> borders = {};  // by corner

  std::size_t face_count() const { return planes.size(); }

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
/// A solid's boundary, as a canonical form or with labels, in grid steps. Precondition: bounded.
Polyhedron polyhedron_of(const booleans::Boundary& form);
/// The image under a map. Precondition: its determinant is positive.
Polyhedron carried(Polyhedron p, const AffineMap& map);

/// Triangles of points, counter-clockwise from outside, that tile the faces.
struct FaceTriangles {
  std::vector<std::array<std::uint32_t, 3>> corners;
  std::vector<std::uint32_t> face;  // of each
};
/// Nothing where a face's loops are seen not to bound regions (crossings may go unseen, and give unspecified
/// triangles).
std::optional<FaceTriangles> triangulated(const Polyhedron& p);

}  // namespace quoin::rounding
