/// \file
/// What a solid is made of: its boundary on the grid, in two tiers.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "booleans/body/box.h"
#include "booleans/body/labels.h"
#include "grid/lists/loops.h"
#include "grid/lists/shared_list.h"

namespace quoin::booleans {

using grid::Array;

/// "No element" for every 32-bit index.
inline constexpr std::uint32_t none = 0xFFFFFFFFu;

/// Faces of one tier that follow each other, each near those before it, in one box: what is far away is passed over by
/// the chunk. Meshes come in some order that hangs together; where it jumps, or after Thresholds::chunk faces, a chunk
/// ends.
struct Chunk {
  std::uint32_t begin, end;  // face ids
  Box box;                   // holds them all, perhaps with room to spare
};

/// The boundary of a regular point set.
///
/// Vertices: ids below grid_points.size() are grid points, those from derived_base() on are derived points.
/// Faces: ids below triangles.size() are raw triangles between grid points, the rest are polygons: a plane (normal
/// outwards) and loops, the face on the left of each loop seen from outside.
///
/// A body is *packed*, or it is *patched*: the result of an operation that changed little of an operand, whose lists it
/// shares. A patched body has the faces of its chunks; its lists also hold faces that are gone, and vertices that no
/// face has. Evaluation and triangulation take patched bodies as they are; all else packs them first (`packed`).
///
/// Invariants of a *clean* body, which all operations return (`fault` in fault.h tests B1 and what a body declares):
///   B1  every directed edge is balanced by its reverse;
///   B2  faces meet only in shared vertices and shared edges: no vertex lies inside an edge or a face that does not
///       list it (a touching vertex inside a face is a loop of one corner), no two faces cross or overlap;
///   B3  the winding number is 1 just inside every face and 0 just outside;
///   B4  a polygon is coplanar with no face that shares a two-faced edge with it, but for faces that carry something
///       else (labels.h): then the edge is listed as a border of the polygon.
struct Body {
  grid::SharedList<exact::GridPoint> grid_points;
  grid::SharedList<exact::Point> points;
  grid::SharedList<std::array<std::uint32_t, 3>> triangles;
  grid::SharedList<exact::Plane> planes;                  // one a polygon
  grid::Loops<std::uint32_t, grid::SharedList> polygons;  // of vertex ids
  std::uint32_t room = 0;        // patched: the id of the first derived point, so that grid points can follow
  std::size_t gone_corners = 0;  // patched: those of polygons that are gone
  bool is_packed = true;
  /// False for what was trusted to be clean and never proved, and for what was made of it: a violated invariant is then
  /// no bug of ours.
  bool is_proved = true;
  /// The value at infinity: true for complements of bounded solids.
  bool full_at_infinity = false;
  /// All faces in order, or, of a packed body, nothing: kept so that the next operation need not look at faces far from
  /// it.
  Array<Chunk> chunks;
  Labels labels;

  /// Bounds of ids, and numbers if the body is packed.
  std::size_t vertex_count() const { return derived_base() + points.size(); }
  std::size_t polygon_count() const { return planes.size(); }
  std::size_t face_count() const { return triangles.size() + planes.size(); }
  bool is_grid(std::uint32_t v) const { return v < grid_points.size(); }
  std::size_t derived_base() const { return std::max<std::size_t>(room, grid_points.size()); }
  /// Precondition: not a grid point.
  const exact::Point& derived(std::uint32_t v) const { return points[v - derived_base()]; }
  exact::Point point(std::uint32_t v) const { return is_grid(v) ? exact::point(grid_points[v]) : derived(v); }
  std::array<double, 3> approximation(std::uint32_t v) const {
    if (!is_grid(v)) return derived(v).approximation;
    const exact::GridPoint& p = grid_points[v];
    return {double(p[0]), double(p[1]), double(p[2])};
  }
  /// Makes the box hold a vertex, exactly.
  void add_to(Box& box, std::uint32_t v) const {
    if (is_grid(v))
      box.add(grid_points[v]);
    else
      box.add_around(derived(v).approximation);
  }
  /// A polygon's index among the polygons. Precondition: not a raw triangle.
  std::uint32_t polygon(std::uint32_t face) const { return face - static_cast<std::uint32_t>(triangles.size()); }
  /// Precondition: faces have labels.
  const Provenance& provenance(std::uint32_t face) const {
    return face < triangles.size() ? labels.triangles[face] : labels.polygons[polygon(face)];
  }
  /// Another plane through the edge of a face from u to v; null where that is no border of a polygon.
  const exact::Plane* border(std::uint32_t face, std::uint32_t u, std::uint32_t v) const;
  /// Do faces carry the same?
  bool is_same_surface(std::uint32_t f, std::uint32_t g) const {
    return !labels || labels.origins->is_same_surface(provenance(f), provenance(g));
  }
  std::uint32_t corner_count(std::uint32_t face) const {
    return face < triangles.size() ? 3 : polygons.corner_count(polygon(face));
  }
  /// The corners of a face, loop by loop.
  std::span<const std::uint32_t> corners_of(std::uint32_t face) const {
    return face < triangles.size() ? std::span<const std::uint32_t>(triangles[face])
                                   : polygons.corners_of(polygon(face));
  }
  /// visit(v) for every corner of a face, loop by loop.
  template <class Visit>
  void for_corners(std::uint32_t face, Visit&& visit) const {
    for (const std::uint32_t v : corners_of(face)) visit(v);
  }
  /// visit(u, v) for every directed edge of a face.
  template <class Visit>
  void for_edges(std::uint32_t face, Visit&& visit) const {
    if (face < triangles.size())
      grid::for_loop_edges(triangles[face], visit);
    else
      polygons.for_edges(polygon(face), visit);
  }
  /// Nothing is added for now: a patched body may share these lists and add to them in place.
  void settle();
  /// visit(begin, end) for the faces, run by run.
  template <class Visit>
  void for_runs(Visit&& visit) const {
    if (is_packed) return visit(0u, static_cast<std::uint32_t>(face_count()));
    for (const Chunk& c : chunks) visit(c.begin, c.end);
  }
  /// Oriented plane of a face. Precondition: the triangle is not degenerate.
  exact::Plane plane(std::uint32_t face) const;
  /// The same, of a raw triangle not reduced: for signs.
  exact::Plane sign_plane(std::uint32_t face) const {
    if (face >= triangles.size()) return planes[face - triangles.size()];
    const auto& t = triangles[face];
    return exact::spanned_plane(grid_points[t[0]], grid_points[t[1]], grid_points[t[2]]);
  }
};

/// Holds the face, exactly.
Box face_box(const Body& body, std::uint32_t face);

/// Appends the chunks of the faces begin .. end - 1.
void add_chunks(const Body& body, std::uint32_t begin, std::uint32_t end, Array<Chunk>& chunks);

/// The same solid without what is in no chunk, and with derived points after the last grid point.
Body packed(const Body& body);

/// Empties the polygons that are in no chunk, so that the lists of loops and corners hold what is there only. All else
/// keeps its numbers. Precondition: patched.
void drop_gone_loops(Body& body);

/// The complement: every face turned round, the value at infinity inverted.
Body complement(const Body& body);

/// An axis-parallel box from low to high (low < high in every axis), as twelve raw triangles.
Body box_body(const exact::GridPoint& low, const exact::GridPoint& high);

/// The part of that box where the plane is <= 0, its faces exact polygons; empty or the whole box where the plane
/// misses.
Body half_space_body(const exact::Plane& plane, const exact::GridPoint& low, const exact::GridPoint& high);

}  // namespace quoin::booleans
