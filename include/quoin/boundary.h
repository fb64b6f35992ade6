/// \file
/// The exact boundary of a solid: its vertices, edges, faces and shells, in canonical order.
#pragma once

#include "quoin/export.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "quoin/grid.h"
#include "quoin/labels.h"
#include "quoin/solid.h"

namespace quoin {

/// Faces with holes as plain arrays, rounded. Face i has the loops `face_starts[i] .. face_starts[i + 1] - 1`, its
/// outer one first, loop j the corners `corners[loop_starts[j]] .. corners[loop_starts[j + 1] - 1]`, the face on their
/// left seen from outside. docs/boundary.md says which loops there are.
struct Polygons {
  /// x, y, z per vertex in model units, correctly rounded.
  std::vector<double> points = {};
  std::vector<std::uint32_t> face_starts = {0}, loop_starts = {0}, corners = {};
};

/// The same, exact. Numbers are whole decimals of any length: an optional '-', no superfluous zeros.
struct ExactPolygons {
  Grid grid = {};
  /// The solid is what lies outside.
  bool full_at_infinity = false;
  /// x, y, z, w per vertex: the point (x, y, z) / w in grid steps from the grid's origin; w > 0, in lowest terms.
  std::vector<std::array<std::string, 4>> points = {};
  /// a, b, c, d per face: a x + b y + c z + d = 0 in grid steps, the normal (a, b, c) outwards; in lowest terms.
  std::vector<std::array<std::string, 4>> planes = {};
  std::vector<std::uint32_t> face_starts = {0}, loop_starts = {0}, corners = {};
};

/// The boundary of a solid as its canonical form has it (docs/boundary.md): maximal faces, maximal edges, the vertices
/// that must be. With labels (Faces::by_label): faces that are maximal among those that carry the same, with the edges
/// and vertices between them. Vertices, edges, faces and shells are numbered from 0 in canonical order: on one grid
/// equal point sets have equal numbers, however they were made.
///
/// A corner is a place in a loop. Corners are numbered through all faces, and stand for the half-edge from their vertex
/// to that of the next corner of their loop; a loop of one corner, a vertex inside its face, has no half-edge.
///
/// A view, immutable, cheap to copy and safe to read from many threads. What nobody asks for is not computed: edges,
/// shells and their nesting are found when one of them is first asked for, and kept; text is made anew at each call.
/// Preconditions of all: numbers are below the counts. Of a solid that was trusted wrongly answers are unspecified.
class QUOIN_API Boundary {
 public:
  /// Of the empty solid.
  Boundary();
  ~Boundary();
  Boundary(const Boundary&);
  Boundary& operator=(const Boundary&);

  const Grid& grid() const;
  /// False where the solid is what lies outside.
  bool is_bounded() const;

  std::uint32_t vertex_count() const;
  std::uint32_t face_count() const;
  std::uint32_t loop_count() const;
  std::uint32_t corner_count() const;

  /// The vertex x, y, z, w: the point (x, y, z) / w in grid steps, in lowest terms, w > 0.
  std::array<std::string, 4> homogeneous(std::uint32_t vertex) const;
  /// In model units, each "p/q" or "p".
  std::array<std::string, 3> coordinates(std::uint32_t vertex) const;
  /// In model units, correctly rounded.
  std::array<double, 3> point(std::uint32_t vertex) const;

  /// A face: a connected open region of a plane. Its outer loop is the first; the others are holes, slits, which are
  /// run both ways, and loops of one corner.
  struct Face {
    std::uint32_t loop_count() const { return static_cast<std::uint32_t>(starts.size()) - 1; }
    /// The vertices of a loop, the face on its left seen from outside.
    std::span<const std::uint32_t> loop(std::uint32_t i) const {
      return vertices.subspan(starts[i] - starts[0], starts[i + 1] - starts[i]);
    }
    /// The number of a loop's first corner.
    std::uint32_t first_corner(std::uint32_t i = 0) const { return starts[i]; }

    /// Where the loops begin among the corners of all faces, and where the last one ends.
    std::span<const std::uint32_t> starts;
    /// Of all corners of the face, loop by loop.
    std::span<const std::uint32_t> vertices;
  };
  /// It lives as long as a copy of this boundary does.
  Face face(std::uint32_t face) const;
  /// The face's plane a x + b y + c z + d = 0 in grid steps, whole numbers in lowest terms, (a, b, c) outwards.
  std::array<std::string, 4> plane(std::uint32_t face) const;
  /// The same in model units: the same normal, an offset "p/q". A HalfSpace of it has the solid's side.
  std::array<std::string, 4> model_plane(std::uint32_t face) const;
  /// In square model units: the exact area of a projection, rounded, times a factor computed in doubles.
  double area(std::uint32_t face) const;

  /// What a face carries, of a boundary that was asked for with labels; of others it is unlabelled.
  FaceLabel label(std::uint32_t face) const;
  /// Those that labels name.
  const std::vector<Original>& originals() const;

  std::uint32_t edge_count() const;
  /// A half-edge at an edge.
  struct Use {
    std::uint32_t face, corner;
    /// The face runs from the edge's low vertex to its high one.
    bool forward;
  };
  /// An edge: a maximal segment with the same faces around it.
  struct Edge {
    /// The lower number first. Edges ascend by their vertices.
    std::array<std::uint32_t, 2> vertices;
    /// All faces around it, counter-clockwise around the direction from low to high; the first is the one of the lowest
    /// corner. Uses run forward and backward in turn, and the solid lies between each that runs backward and the next.
    std::vector<Use> fan;
  };
  Edge edge(std::uint32_t edge) const;

  std::uint32_t vertex_of(std::uint32_t corner) const;
  std::uint32_t face_of(std::uint32_t corner) const;
  /// The next corner of the loop, and the one before.
  std::uint32_t next(std::uint32_t corner) const;
  std::uint32_t previous(std::uint32_t corner) const;
  /// The edge of the half-edge that begins at a corner; nothing in a loop of one corner.
  std::optional<std::uint32_t> edge_of(std::uint32_t corner) const;
  /// The half-edge of the same edge that bounds the same wedge of the solid: with two faces at an edge, that of the
  /// other face. Nothing in a loop of one corner. An involution, and with `next` it walks around vertices.
  std::optional<std::uint32_t> opposite(std::uint32_t corner) const;
  /// The faces of the opposite half-edges, corner by corner; loops of one corner are passed over.
  std::vector<std::uint32_t> neighbours(std::uint32_t face) const;

  /// Shells: the connected components of the boundary where parts that only touch are taken apart, as `Info` counts
  /// them. Faces hang together over opposite half-edges. Shells ascend by their lowest faces.
  std::uint32_t shell_count() const;
  std::uint32_t shell_of(std::uint32_t face) const;
  /// Ascending.
  std::span<const std::uint32_t> shell_faces(std::uint32_t shell) const;
  /// Handles of the shell: 0 for a sphere, 1 for a torus.
  std::int64_t shell_genus(std::uint32_t shell) const;
  /// What the shell encloses, whatever lies within: exact, "p/q" in cubic model units.
  std::string shell_volume(std::uint32_t shell) const;
  /// The solid lies outside of the shell.
  bool is_void(std::uint32_t shell) const;
  /// The innermost shell around it, which is a void where this is none, and the other way round; nothing where none is.
  std::optional<std::uint32_t> parent(std::uint32_t shell) const;

  /// Components: the solids whose interiors are the connected parts of the interior. Parts that touch in edges or
  /// vertices only are different ones; a solid that touches itself, and hangs together elsewhere, is one. Each has one
  /// shell that is no void, and the voids within; the unbounded one has voids alone. They ascend by their lowest
  /// shells.
  std::uint32_t component_count() const;
  std::uint32_t component_of(std::uint32_t shell) const;
  Solid component(std::uint32_t component) const;
  /// All of them; none of the empty solid.
  std::vector<Solid> components() const;

  Polygons to_polygons() const;
  /// `Solid::from_boundary` gives the solid back.
  ExactPolygons to_exact_polygons() const;

 private:
  friend class Solid;
  struct Data;
  explicit Boundary(std::shared_ptr<const Data> data);
  std::shared_ptr<const Data> data_;
};

}  // namespace quoin
