#include "booleans/assemble/making.h"
#include "grid/lists/stretches.h"

namespace quoin::booleans {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// A corner of a copied triangle with this bit is a vertex of the table, for now.
constexpr std::uint32_t table_bit = 0x80000000u;

/// Copies of raw triangles of one operand. Their corners are `points` of their own, counted from 0, or vertices of the
/// table, with table_bit.
struct RawCopies {
  Array<exact::GridPoint> points;
  Array<std::uint32_t> table;  // own vertices that are in the table
  Array<Triangle*> at_table;   // triangles that have such
  std::span<Triangle> triangles;
  std::span<Provenance> provenance;  // of the triangles, with labels
  std::uint32_t first = 0;           // the id of the first point
};

bool is_raw(const Operands& operands, const OperandChunk& c) {
  return operands.own(c.operand, c.begin) < operands[c.operand].triangles.size();
}

/// How many raw triangles of a chunk are copied.
std::uint32_t count_raw(const Making& m, const OperandChunk& c) {
  std::uint32_t count = 0;
  if (c.operand != m.host && is_raw(m.a.operands, c))
    for (const FaceId f : Ids<FaceId>(c.begin, c.end)) count += m.kept(f) != 0;
  return count;
}

Triangle* copy_chunk(Making& m, const OperandChunk& c, Triangle* next, RawCopies& copies) {
  const Body& body = m.a.operands[c.operand];
  Array<std::uint32_t>& names = m.vertices.own_names(c.operand);
  bool at_table = false;
  const auto corner = [&](std::uint32_t v) {
    std::uint32_t& name = names[v];
    if (name < ResultVertices::listed) return name;
    if (name == none) {
      name = static_cast<std::uint32_t>(copies.points.size());
      copies.points.push_back(body.grid_points[v]);
      return name;
    }
    if (name == ResultVertices::by_table) {
      copies.table.push_back(v);
      name = ResultVertices::listed;
    }
    at_table = true;
    return m.vertices.table_vertex(c.operand, v).value | table_bit;
  };

  for (const FaceId f : Ids<FaceId>(c.begin, c.end)) {
    const int kept = m.kept(f);
    if (kept == 0) continue;
    const std::uint32_t own = m.a.operands.own(c.operand, f);
    Triangle t = body.triangles[own];
    if (kept < 0) std::swap(t[1], t[2]);
    if (!copies.provenance.empty())
      copies.provenance[static_cast<std::size_t>(next - copies.triangles.data())] = m.kept_provenance(c.operand, own);
    at_table = false;
    *next = {corner(t[0]), corner(t[1]), corner(t[2])};
    if (at_table) copies.at_table.push_back(next);
    ++next;
  }
  return next;
}

/// Gives the corners of copied triangles their names.
void name_raw(Making& m, ById<OperandId, RawCopies>& raw) {
  std::size_t points = m.body.grid_points.size() + m.a.names.vertices.size();
  for (const RawCopies& r : raw) points += r.points.size();
  m.body.grid_points.reserve(points);
  for (RawCopies& r : raw) {
    r.first = static_cast<std::uint32_t>(m.body.grid_points.size());
    m.body.grid_points.append(r.points.begin(), r.points.end());
  }
  for (const OperandId o : m.a.operands.ids())
    for (const std::uint32_t v : raw[o].table) m.vertices.named(o, v);

  grid::in_tasks(raw.size(), points, [&](std::size_t i) {
    const OperandId o = static_cast<std::uint32_t>(i);
    const RawCopies& r = raw[o];
    const auto shift = [&](std::uint32_t& name) {
      if (name < table_bit) name += r.first;
    };
    if (r.first > 0 && !r.points.empty()) {
      for (Triangle& t : r.triangles) std::for_each(t.begin(), t.end(), shift);
      Array<std::uint32_t>& names = m.vertices.own_names(o);
      std::for_each(names.begin(), names.end(), shift);
    }
    for (Triangle* t : r.at_table)
      for (std::uint32_t& v : *t)
        if (v & table_bit) v = m.vertices.name_of_table(v & ~table_bit).as_corner();
  });
}

}  // namespace

void copy_raw(Making& m) {
  const auto& chunks = m.a.operands.chunks;
  const std::size_t n = m.a.operands.bodies.size();
  Array<std::uint32_t> start(chunks.size() + 1, static_cast<std::uint32_t>(m.body.triangles.size()));
  grid::in_stretches(chunks.size(), 512, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) start[i + 1] = count_raw(m, chunks[i]);
  });
  for (std::size_t i = 0; i < chunks.size(); ++i) start[i + 1] += start[i];
  m.body.triangles.reserve(start.back() + m.changed.size() + m.a.sheets.facet_count());
  const auto out = m.body.triangles.grow(start.back() - start.front());
  std::span<Provenance> provenance;
  if (m.has_labels()) provenance = m.body.labels.triangles.grow(out.size());

  ById<OperandId, RawCopies> raw(n);
  grid::in_tasks(n, out.size(), [&](std::size_t i) {
    const OperandId o = static_cast<std::uint32_t>(i);
    const std::uint32_t begin = m.a.operands.first_chunk[o], end = m.a.operands.first_chunk[o.value + 1];
    RawCopies& r = raw[o];
    r.triangles = out.subspan(start[begin] - start.front(), start[end] - start[begin]);
    if (m.has_labels()) r.provenance = provenance.subspan(start[begin] - start.front(), r.triangles.size());
    r.points.reserve(std::min(m.a.operands[o].grid_points.size(), 3 * r.triangles.size()));
    Triangle* next = r.triangles.data();
    for (std::uint32_t c = begin; c < end; ++c)
      if (start[c] < start[c + 1]) next = copy_chunk(m, chunks[c], next, r);
  });
  name_raw(m, raw);

  for (std::size_t i = 0; i < chunks.size(); ++i) keep_chunk(m.raw_chunks, start[i], start[i + 1], chunks[i].box);
}

namespace {

/// Adds every loop of a polygon that stays to `loops`, turned as it stays, with its corners as corner_of(v).
template <class Loops, class CornerOf>
void add_kept_loops(const Making& m, const OwnPolygon& p, CornerOf corner_of, Loops& loops) {
  const Body& body = m.a.operands[p.operand];
  const bool turned = m.kept(m.a.operands.face(p.operand, p.face)) < 0;
  body.polygons.for_loops(body.polygon(p.face), [&](std::span<const std::uint32_t> loop) {
    for (std::size_t i = 0; i < loop.size(); ++i)
      loops.corners.push_back(corner_of(loop[turned ? loop.size() - 1 - i : i]));
    loops.end_loop();
  });
}

/// Copies the polygons of a chunk of which all stay as they are, far from the table; false when it is not such a one.
bool copied_whole(Making& m, const OperandChunk& c) {
  for (const FaceId f : Ids<FaceId>(c.begin, c.end))
    if (m.kept(f) <= 0) return false;

  const Body& body = m.a.operands[c.operand];
  const auto& from = body.polygons;
  const std::size_t p = body.polygon(m.a.operands.own(c.operand, c.begin)), q = p + (c.end.value - c.begin.value);
  const std::uint32_t first = from.face_start[p], last = from.face_start[q];
  const auto corners = std::span<const std::uint32_t>(from.corners)
                           .subspan(from.loop_start[first], from.loop_start[last] - from.loop_start[first]);
  for (const std::uint32_t v : corners)
    if (m.vertices.in_table(c.operand, v)) return false;

  if (m.has_labels()) {
    m.body.labels.append_borders(body.labels, from.corner_range(p).begin, from.corner_range(q - 1).end,
                                 static_cast<std::uint32_t>(m.body.polygons.corners.size()));
    for (std::size_t i = p; i < q; ++i)
      m.body.labels.polygons.push_back(
          m.a.operands.provenance(c.operand, static_cast<std::uint32_t>(body.triangles.size() + i)));
  }
  m.body.polygons.append_faces(from, p, q, [&](std::uint32_t v) { return m.corner(m.vertices.named(c.operand, v)); });
  m.body.planes.append(body.planes.begin() + p, body.planes.begin() + q);
  return true;
}

/// The borders of a polygon whose loops are to be added as they stay.
void copy_borders(Making& m, const OwnPolygon& p) {
  const Body& body = m.a.operands[p.operand];
  const auto& polygons = body.polygons;
  const std::uint32_t polygon = body.polygon(p.face);
  const bool turned = m.kept(m.a.operands.face(p.operand, p.face)) < 0;
  auto to = static_cast<std::uint32_t>(m.body.polygons.corners.size());
  for (std::uint32_t j = polygons.face_start[polygon]; j < polygons.face_start[polygon + 1]; ++j) {
    const std::uint32_t begin = polygons.loop_start[j], end = polygons.loop_start[j + 1];
    if (turned)
      m.body.labels.append_reversed_borders(body.labels, begin, end, to);
    else
      m.body.labels.append_borders(body.labels, begin, end, to);
    to += end - begin;
  }
}

/// The lines of the loops of a polygon that waits, as they stay.
void add_waiting_lines(Making& m, const OwnPolygon& p) {
  const Body& body = m.a.operands[p.operand];
  const bool turned = m.kept(m.a.operands.face(p.operand, p.face)) < 0;
  body.polygons.for_loops(body.polygon(p.face), [&](std::span<const std::uint32_t> loop) {
    const std::size_t to = m.waiting_lines.size();
    const auto begin = static_cast<std::uint32_t>(loop.data() - body.polygons.corners.data()),
               end = begin + static_cast<std::uint32_t>(loop.size());
    m.waiting_lines.resize(to + loop.size(), nullptr);
    for (const Border& b : body.labels.borders_within(begin, end))
      m.waiting_lines[to + (turned ? reversed_corner(b.corner, begin, end) : b.corner) - begin] = &b.other;
  });
}

/// Copies a polygon that stays; one with a vertex in the table is listed instead.
void copy_polygon(Making& m, const OwnPolygon& p) {
  const auto& [o, face] = p;
  const auto corners = m.a.operands[o].corners_of(face);
  if (std::any_of(corners.begin(), corners.end(), [&, o = o](std::uint32_t v) { return m.vertices.in_table(o, v); })) {
    m.waiting.push_back(p);
    return;
  }
  if (m.has_labels()) copy_borders(m, p);
  add_kept_loops(
      m, p, [&, o = o](std::uint32_t v) { return m.corner(m.vertices.named(o, v)); }, m.body.polygons);
  m.close_polygon(m.kept_plane(p), m.has_labels() ? m.kept_provenance(o, face) : Provenance());
}

}  // namespace

void name_spared(Making& m) {
  for (const auto& [facet, face] : m.a.sheets.spared()) {
    const OperandId o = m.a.touched.faces[face].operand;
    if (o == m.host || m.selection.kept[facet] == 0) continue;
    for (const std::uint32_t j : m.a.touched.spared_of(face))
      for (const std::uint32_t v : m.a.operands[o].polygons.loop(j)) m.vertices.named(o, v);
  }
}

void copy_polygons(Making& m) {
  for (const OperandChunk& c : m.a.operands.chunks) {
    if (c.operand == m.host || is_raw(m.a.operands, c)) continue;
    const auto first = static_cast<std::uint32_t>(m.body.planes.size());
    if (!copied_whole(m, c))
      for (const FaceId f : Ids<FaceId>(c.begin, c.end))
        if (m.kept(f) != 0) copy_polygon(m, {c.operand, m.a.operands.own(c.operand, f)});
    keep_chunk(m.polygon_chunks, first, static_cast<std::uint32_t>(m.body.planes.size()), c.box);
  }
  m.listed_polygons = static_cast<std::uint32_t>(m.body.planes.size());

  for (const std::uint32_t f : m.changed)
    if (f >= m.a.operands[m.host].triangles.size()) copy_polygon(m, {m.host, f});
  for (const OwnPolygon& p : m.waiting) {
    add_kept_loops(
        m, p, [&](std::uint32_t v) { return m.vertices.place(p.operand, v); }, m.waiting_loops);
    m.waiting_loops.end_face();
    if (m.has_labels()) add_waiting_lines(m, p);
  }
}

}  // namespace quoin::booleans
