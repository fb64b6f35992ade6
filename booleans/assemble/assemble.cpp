#include "booleans/assemble/assemble.h"

#include "booleans/assemble/making.h"

namespace quoin::booleans {
namespace {

/// Room for what may stay of the operands; what is not written costs no memory.
void reserve(Making& m) {
  std::size_t points = 0, corners = 0, loops = 0, planes = 0;
  for (const Body* body : m.a.operands.bodies) {
    points += body->points.size();
    corners += body->polygons.corners.size();
    loops += body->polygons.loop_count();
    planes += body->planes.size();
  }
  m.body.points.reserve(points);
  m.body.polygons.reserve(planes, loops, corners);
  m.body.planes.reserve(planes);
}

/// Raw triangles of the host that stay turned round.
void copy_changed_triangles(Making& m) {
  if (m.host == none) return;
  const Body& host = m.a.operands[m.host];
  const auto id = [&](std::uint32_t v) { return m.vertices.named(m.host, v).as_corner(); };
  for (const std::uint32_t f : m.changed) {
    if (f >= host.triangles.size()) continue;
    const auto& t = host.triangles[f];
    m.body.triangles.push_back({id(t[0]), id(t[2]), id(t[1])});
    if (m.has_labels()) m.body.labels.triangles.push_back(m.kept_provenance(m.host, f));
  }
}

/// Copied faces keep their chunks' boxes. `raw`: how many triangles are in chunks already.
void list_chunks(Making& m, std::uint32_t raw) {
  Body& body = m.body;
  const auto triangles = static_cast<std::uint32_t>(body.triangles.size());
  body.chunks = std::move(m.raw_chunks);
  add_chunks(body, raw, triangles, body.chunks);
  for (const Chunk& c : m.polygon_chunks) body.chunks.push_back({triangles + c.begin, triangles + c.end, c.box});

  std::uint32_t next = triangles + m.listed_polygons;
  for (const Chunk& c : m.spared_chunks) {
    add_chunks(body, next, triangles + c.begin, body.chunks);
    body.chunks.push_back({triangles + c.begin, triangles + c.end, c.box});
    next = triangles + c.end;
  }
  add_chunks(body, next, static_cast<std::uint32_t>(body.face_count()), body.chunks);
}

}  // namespace

Body assemble(const Arrangement& a, const Selection& selection) {
  Making m(a, selection, find_host(a, selection));
  if (m.host == none)
    reserve(m);
  else
    keep_host(m);
  if (m.has_labels()) keep_labels(m);
  m.body.full_at_infinity = selection.full_at_infinity;
  m.body.is_proved = a.operands.are_proved;

  copy_raw(m);
  const auto listed_triangles = static_cast<std::uint32_t>(m.body.triangles.size());
  copy_changed_triangles(m);
  name_spared(m);
  copy_polygons(m);
  join_regions(m);

  list_chunks(m, listed_triangles);
  if (m.host != none) tidy(m.body);
  m.body.settle();
  return std::move(m.body);
}

}  // namespace quoin::booleans
