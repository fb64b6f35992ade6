#include "booleans/assemble/making.h"

namespace quoin::booleans {
namespace {

/// By corner of some loops: another plane through the edge that begins there, if it is a border; or nothing, where
/// there are no labels.
using EdgeLines = std::span<const exact::Plane* const>;

/// Tells each vertex on a loop of at least two corners its neighbours there, and those at which a border bends that
/// they are needed.
template <class Corner>
void note_neighbours(ResultVertices& vertices, const grid::Loops<Corner>& loops, EdgeLines lines) {
  for (std::size_t j = 0; j < loops.loop_count(); ++j) {
    const auto loop = loops.loop(j);
    if (loop.size() == 1) continue;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::size_t before = grid::previous_in_loop(i, loop.size()), after = grid::next_in_loop(i, loop.size());
      const PlaceId at = vertices.place(loop[i]), next = vertices.place(loop[after]);
      vertices.add_neighbours(at, vertices.place(loop[before]), next);
      if (lines.empty()) continue;
      const exact::Plane* line = lines[loops.loop_start[j] + before];
      if (line && lines[loops.loop_start[j] + i] && vertices.side(next, *line) != 0) vertices.need(at);
    }
  }
}

/// Room for what waits and for the regions, and for the derived points that they need.
void reserve(Making& m, const Array<Regions>& regions) {
  std::size_t faces = m.waiting.size(), loops = m.waiting_loops.loop_count(), corners = m.waiting_loops.corners.size();
  for (const Regions& r : regions) {
    faces += r.size();
    loops += r.loops.loop_count();
    corners += r.loops.corners.size();
  }
  std::size_t points = 0;
  for (const PlaceId p : Ids<PlaceId>(m.vertices.place_count()))
    points += m.vertices.is_needed(p) && !m.vertices.is_grid(p);

  Body& body = m.body;
  body.points.reserve(body.points.size() + points);
  body.planes.reserve(body.planes.size() + faces);
  body.polygons.reserve(body.polygon_count() + faces, body.polygons.loop_count() + loops,
                        body.polygons.corners.size() + corners);
}

/// The borders of loops first .. last - 1 of an operand, which are to be added next.
void write_borders(Making& m, OperandId operand, std::uint32_t first, std::uint32_t last) {
  const Body& body = m.a.operands[operand];
  m.body.labels.append_borders(body.labels, body.polygons.loop_start[first], body.polygons.loop_start[last],
                               static_cast<std::uint32_t>(m.body.polygons.corners.size()));
}

/// Writes the spared loops of a touched face as loops of a region with that plane.
void write_spared(Making& m, TouchedId face, const exact::Plane& plane) {
  const TouchedFace& f = m.a.touched.faces[face];
  const auto loops = m.a.touched.spared_of(face);
  const auto& from = m.a.operands[f.operand].polygons;
  auto& to = m.body.polygons;
  const bool is_host = f.operand == m.host;
  const auto id = [&](std::uint32_t v) { return is_host ? m.host_id(v) : m.corner(m.vertices.named(f.operand, v)); };

  if (exact::is_canonical(plane) == f.along) {
    for (std::size_t i = 0, next = 0; i < loops.size(); i = next) {
      for (next = i + 1; next < loops.size() && loops[next] == loops[next - 1] + 1;) ++next;
      if (m.has_labels()) write_borders(m, f.operand, loops[i], loops[next - 1] + 1);
      to.append_loops(from, loops[i], loops[next - 1] + 1, id);
    }
    return;
  }
  for (const std::uint32_t j : loops) {
    const auto loop = from.loop(j);
    if (m.has_labels())
      m.body.labels.append_reversed_borders(m.a.operands[f.operand].labels, from.loop_start[j], from.loop_start[j + 1],
                                            static_cast<std::uint32_t>(to.corners.size()));
    for (auto v = loop.rbegin(); v != loop.rend(); ++v) to.corners.push_back(id(*v));
    to.end_loop();
  }
}

/// Writes faces one after the other, without vertices inside straight edges. New points get their names as they come.
class Writer {
 public:
  explicit Writer(Making& m) : m_(m) {}

  /// Writes face i of some loops, on that plane, and with it the spared loops of touched faces. A triangle between grid
  /// points is raw. `lines` are those of the loops; what the face carries counts with labels only.
  template <class Corner>
  void write(const grid::Loops<Corner>& from, EdgeLines lines, std::size_t i, const exact::Plane& plane,
             const Provenance& provenance, std::span<const SparedRegion> spared = {}) {
    gather(from, lines, i);
    if (spared.empty() && is_raw()) {
      m_.body.triangles.push_back({corners_[0].index(), corners_[1].index(), corners_[2].index()});
      if (m_.has_labels()) m_.body.labels.triangles.push_back(provenance);
      return;
    }

    add_loops();
    if (!spared.empty()) {
      // The outer loop is drawn.
      const auto polygon = static_cast<std::uint32_t>(m_.body.planes.size());
      m_.spared_chunks.push_back({polygon, polygon + 1, box()});
    }
    for (const SparedRegion& s : spared) write_spared(m_, s.face, plane);
    m_.close_polygon(plane, provenance);
  }

 private:
  template <class Corner>
  void gather(const grid::Loops<Corner>& from, EdgeLines lines, std::size_t i) {
    corners_.clear();
    ends_.clear();
    lines_.clear();
    from.for_loops(i, [&](std::span<const Corner> loop) {
      const std::size_t before = corners_.size();
      for (const Corner& c : loop) {
        const PlaceId p = m_.vertices.place(c);
        if (!(loop.size() == 1 ? m_.vertices.is_used(p) : m_.vertices.is_needed(p))) continue;
        corners_.push_back(m_.vertices.named(p));
        if (!lines.empty()) lines_.push_back(lines[static_cast<std::size_t>(&c - from.corners.data())]);
      }
      if (corners_.size() > before) ends_.push_back(corners_.size());
    });
  }

  bool is_raw() const {
    return ends_.size() == 1 && corners_.size() == 3 &&
           std::none_of(corners_.begin(), corners_.end(), [](ResultName n) { return n.is_derived(); });
  }
  void add_loops() {
    auto& to = m_.body.polygons;
    const auto shift = static_cast<std::uint32_t>(to.corners.size());
    const auto corners = to.corners.grow(corners_.size());
    std::transform(corners_.begin(), corners_.end(), corners.begin(), [&](ResultName n) { return m_.corner(n); });
    for (const std::size_t end : ends_) to.loop_start.push_back(shift + static_cast<std::uint32_t>(end));
    for (std::uint32_t k = 0; k < lines_.size(); ++k)
      if (lines_[k]) m_.body.labels.borders.push_back({shift + k, *lines_[k]});
  }
  Box box() const {
    Box box;
    for (const ResultName n : corners_)
      if (n.is_derived())
        box.add_around(m_.body.points[n.index()].approximation);
      else
        box.add(m_.body.grid_points[n.index()]);
    return box;
  }

  Making& m_;
  Array<ResultName> corners_;         // of one face
  Array<std::size_t> ends_;           // of its loops
  Array<const exact::Plane*> lines_;  // with labels: as Regions::lines
};

void write_regions(const Making& m, const Regions& regions, Writer& writer) {
  auto spared = regions.spared.begin();
  for (std::size_t i = 0; i < regions.size(); ++i) {
    const auto first = spared;
    while (spared != regions.spared.end() && spared->region == i) ++spared;
    const auto& [id, turned] = regions.planes[i];
    const exact::Plane& plane = m.a.names.planes[id];
    writer.write(regions.loops, regions.lines, i, turned ? plane.opposite() : plane,
                 m.has_labels() ? regions.provenance[i] : Provenance(), {first, spared});
  }
}

}  // namespace

void join_regions(Making& m) {
  const Array<Regions> merged = merged_regions(m.a, m.selection);
  note_neighbours(m.vertices, m.waiting_loops, m.waiting_lines);
  for (const Regions& r : merged) note_neighbours(m.vertices, r.loops, r.lines);
  if (m.host == none) reserve(m, merged);

  Writer writer(m);
  for (std::size_t i = 0; i < m.waiting.size(); ++i) {
    const OwnPolygon& p = m.waiting[i];
    writer.write(m.waiting_loops, m.waiting_lines, i, m.kept_plane(p),
                 m.has_labels() ? m.kept_provenance(p.operand, p.face) : Provenance());
  }
  for (const Regions& r : merged) write_regions(m, r, writer);

  if (m.host == none && !m.body.points.empty())
    for (std::uint32_t& c : m.body.polygons.corners.edit()) c = m.final_id(ResultName::of_corner(c));
}

}  // namespace quoin::booleans
