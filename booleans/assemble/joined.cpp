#include "booleans/assemble/making.h"

namespace quoin::booleans {
namespace {

/// Adds the merged regions of all sheets to what waits.
void add_regions(Making& m) {
  const Regions<VertexId> merged = merged_regions(m.a, m.selection);
  m.waiting.reserve(merged.size(), merged.loops.loop_count(), merged.loops.corners.size());
  for (const auto& [region, face] : merged.spared) m.waiting.spared.push_back({m.waiting.size() + region, face});
  for (std::size_t i = 0; i < merged.size(); ++i) {
    merged.loops.for_loops(i, [&](std::span<const VertexId> loop) {
      for (const VertexId v : loop) m.waiting.loops.corners.push_back(m.vertices.place_of_table(v));
      m.waiting.loops.end_loop();
    });
    m.waiting.close(merged.planes[i]);
  }
}

void add_neighbour(ResultVertices::Place& place, PlaceId q) {
  place.used = true;
  auto& n = place.neighbours;
  if (n[0] == none || n[0] == q)
    n[0] = q;
  else if (n[1] == none || n[1] == q)
    n[1] = q;
  else
    place.fixed = true;
}

/// A vertex with exactly two neighbours lies inside a straight edge: at least two faces that are not coplanar pass
/// through both of its edges, so both lie on the line of their planes.
Regions<PlaceId> without_straight_vertices(Making& m) {
  auto& places = m.vertices.places();
  for (std::size_t r = 0; r < m.waiting.size(); ++r)
    m.waiting.loops.for_edges(r, [&](PlaceId p, PlaceId q) {
      add_neighbour(places[p], q);
      add_neighbour(places[q], p);
    });

  Regions<PlaceId> kept;
  kept.reserve(m.waiting.size(), m.waiting.loops.loop_count(), m.waiting.loops.corners.size());
  for (std::size_t r = 0; r < m.waiting.size(); ++r) {
    m.waiting.loops.for_loops(r, [&](std::span<const PlaceId> loop) {
      const std::size_t before = kept.loops.corners.size();
      for (const PlaceId p : loop)
        if (loop.size() == 1 ? places[p].used : places[p].fixed) kept.loops.corners.push_back(p);
      if (kept.loops.corners.size() > before) kept.loops.end_loop();
    });
    kept.close(m.waiting.planes[r]);
  }
  kept.spared = std::move(m.waiting.spared);
  return kept;
}

/// Gives the places that regions have their ids, grid points first.
ById<PlaceId, std::uint32_t> numbered(Making& m, const Regions<PlaceId>& regions) {
  auto& places = m.vertices.places();
  ById<PlaceId, std::uint32_t> id(places.size(), none);
  ById<PlaceId, std::uint8_t> needed(places.size());
  for (const PlaceId p : regions.loops.corners) needed[p] = 1;
  if (m.host == none) {
    std::size_t derived = 0;
    for (const PlaceId i : Ids<PlaceId>(places.size())) derived += needed[i] && !m.vertices.is_grid(places[i]);
    m.body.points.reserve(m.body.points.size() + derived);
  }

  for (const bool grid : {true, false})
    for (const PlaceId i : Ids<PlaceId>(places.size())) {
      const ResultVertices::Place& p = places[i];
      if (!needed[i] || m.vertices.is_grid(p) != grid) continue;
      ResultName name = m.vertices.known_name(p);
      if (name.is_none()) name = m.vertices.add_point(p);
      id[i] = m.final_id(name);
    }
  return id;
}

/// Writes the spared loops of a touched face as loops of a region with that plane.
void write_spared(Making& m, TouchedId face, const exact::Plane& plane) {
  const TouchedFace& f = m.a.touched.faces[face];
  const auto loops = m.a.touched.spared_of(face);
  const auto& from = m.a.operands[f.operand].polygons;
  auto& to = m.body.polygons;
  const bool is_host = f.operand == m.host;
  const auto id = [&](std::uint32_t v) { return is_host ? m.host_id(v) : m.final_id(m.vertices.named(f.operand, v)); };

  if (exact::is_canonical(plane) == f.along) {
    for (std::size_t i = 0, next = 0; i < loops.size(); i = next) {
      for (next = i + 1; next < loops.size() && loops[next] == loops[next - 1] + 1;) ++next;
      to.append_loops(from, loops[i], loops[next - 1] + 1, id);
    }
    return;
  }
  for (const std::uint32_t j : loops) {
    const auto loop = from.loop(j);
    for (auto v = loop.rbegin(); v != loop.rend(); ++v) to.corners.push_back(id(*v));
    to.end_loop();
  }
}

/// The box of the corners from one on.
Box box_of_corners(const Body& body, std::size_t first) {
  Box box;
  for (std::size_t i = first; i < body.polygons.corners.size(); ++i) body.add_to(box, body.polygons.corners[i]);
  return box;
}

/// Writes regions as faces; triangles between grid points are raw.
void write(Making& m, const Regions<PlaceId>& regions, const ById<PlaceId, std::uint32_t>& id) {
  Body& body = m.body;
  const auto grid_count = static_cast<std::uint32_t>(body.grid_points.size());
  if (m.host == none) {
    body.planes.reserve(body.planes.size() + regions.size());
    body.polygons.reserve(body.planes.size() + regions.size(), body.polygons.loop_count() + regions.loops.loop_count(),
                          body.polygons.corners.size() + regions.loops.corners.size());
  }
  auto spared = regions.spared.begin();
  for (std::size_t i = 0; i < regions.size(); ++i) {
    const auto corners = regions.loops.corners_of(i);
    const bool is_whole = spared == regions.spared.end() || spared->region != i;
    if (is_whole && regions.loops.loop_count(i) == 1 && corners.size() == 3 &&
        std::all_of(corners.begin(), corners.end(), [&](PlaceId p) { return id[p] < grid_count; })) {
      body.triangles.push_back({id[corners[0]], id[corners[1]], id[corners[2]]});
      continue;
    }
    const std::size_t first = body.polygons.corners.size();
    regions.loops.for_loops(i, [&](std::span<const PlaceId> loop) {
      for (const PlaceId p : loop) body.polygons.corners.push_back(id[p]);
      body.polygons.end_loop();
    });
    if (!is_whole) {
      // The outer loop is drawn.
      const auto polygon = static_cast<std::uint32_t>(body.planes.size());
      m.spared_chunks.push_back({polygon, polygon + 1, box_of_corners(body, first)});
    }
    for (; spared != regions.spared.end() && spared->region == i; ++spared)
      write_spared(m, spared->face, regions.planes[i]);
    m.close_polygon(regions.planes[i]);
  }
}

}  // namespace

void join_regions(Making& m) {
  add_regions(m);
  const Regions<PlaceId> regions = without_straight_vertices(m);
  const auto id = numbered(m, regions);

  if (m.host == none)
    for (std::uint32_t& c : m.body.polygons.corners.edit()) c = m.final_id(ResultName::of_corner(c));
  write(m, regions, id);
}

}  // namespace quoin::booleans
