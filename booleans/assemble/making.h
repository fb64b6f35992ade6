/// \file
/// A result in the making: the body, its vertices, and what is still to be written.
#pragma once

#include "booleans/assemble/regions.h"
#include "booleans/assemble/result_vertices.h"

namespace quoin::booleans {

/// A polygon of an operand.
struct OwnPolygon {
  OperandId operand;
  std::uint32_t face;
};

struct Making {
  const Arrangement& a;
  const Selection& selection;
  OperandId host;  // whose lists the body shares, none when it shares none
  Body body;
  ResultVertices vertices;
  /// Copied polygons that wait until all faces are known, turned as they stay.
  Array<OwnPolygon> waiting;
  grid::Loops<PlaceId> waiting_loops;
  Array<const exact::Plane*> waiting_lines;  // with labels: as Regions::lines
  /// Untouched faces of the host that stay, but not as they are; own numbers.
  Array<std::uint32_t> changed;
  /// Of copied faces; polygons count from the first polygon.
  Array<Chunk> raw_chunks, polygon_chunks;
  std::uint32_t listed_polygons = 0;  // polygons before this one are in chunks
  /// Chunks of one polygon each, which has spared loops, counted from the first polygon.
  Array<Chunk> spared_chunks;

  Making(const Arrangement& arrangement, const Selection& s, OperandId host_operand)
      : a(arrangement), selection(s), host(host_operand), vertices(arrangement, host_operand, body) {}
  Making(const Making&) = delete;
  Making& operator=(const Making&) = delete;

  /// +1 an untouched face stays, -1 turned round, 0 it goes or is touched.
  int kept(FaceId f) const {
    const NodeId patch = a.patches().of[f];
    return patch == none ? 0 : selection.kept[patch];
  }
  /// The plane of an untouched polygon, turned as it stays.
  exact::Plane kept_plane(const OwnPolygon& p) const {
    const exact::Plane plane = a.operands[p.operand].plane(p.face);
    return kept(a.operands.face(p.operand, p.face)) < 0 ? plane.opposite() : plane;
  }
  /// The id of a vertex. Precondition: all grid points are there, or the body has room for them.
  std::uint32_t final_id(ResultName name) const {
    return name.is_derived() ? static_cast<std::uint32_t>(body.derived_base()) + name.index() : name.index();
  }
  /// The id of a vertex of the host, which has its own name.
  std::uint32_t host_id(std::uint32_t v) const {
    const Body& own = a.operands[host];
    return own.is_grid(v) ? v : v + static_cast<std::uint32_t>(body.derived_base() - own.derived_base());
  }
  /// A name as a corner; as an id, if ids of derived points are known already.
  std::uint32_t corner(ResultName name) const { return host == none ? name.as_corner() : final_id(name); }
  bool has_labels() const { return a.operands.origins != nullptr; }
  /// What an untouched face carries, turned as it stays. Precondition: there are labels.
  Provenance kept_provenance(OperandId operand, std::uint32_t face) const {
    const Provenance p = a.operands.provenance(operand, face);
    return kept(a.operands.face(operand, face)) < 0 ? p.turned() : p;
  }
  /// `provenance`: counts with labels only.
  void close_polygon(const exact::Plane& plane, const Provenance& provenance) {
    body.planes.push_back(plane);
    body.polygons.end_face();
    if (has_labels()) body.labels.polygons.push_back(provenance);
  }
};

/// Adds a chunk of the faces begin .. end - 1, those that stay of one chunk; short ones that follow each other are one.
void keep_chunk(Array<Chunk>& chunks, std::uint32_t begin, std::uint32_t end, const Box& box);

/// An operand whose lists the result may share: all of it but little lies far from the others and stays; else none.
OperandId find_host(const Arrangement& a, const Selection& selection);
/// Begins with the labels of the host, if there is one: its faces name their origins among those of all operands.
void keep_labels(Making& m);
/// Begins with the host's lists. Of its chunks remains what stays as it is; other faces of it are left to `changed`.
void keep_host(Making& m);
/// How much of the lists of a patched body is gone: more than a quarter of the faces, or as many vertices as are there;
/// else as many corners as are there; else less.
enum class Waste { little, loops, much };
Waste waste(const Body& body);
/// Packs a patched body where much is gone, or drops loops.
void tidy(Body& body);

/// Copies the untouched raw triangles that stay, operand by operand, side by side; those of the host that are turned
/// round follow.
void copy_raw(Making& m);
/// Names the vertices of spared loops that stay: as those of copied faces they stay or go with all their faces.
void name_spared(Making& m);
/// Copies the untouched polygons that have no vertex in the table; the others wait.
void copy_polygons(Making& m);

/// Writes the polygons that wait and the regions of the sheets, without vertices inside straight edges.
void join_regions(Making& m);

}  // namespace quoin::booleans
