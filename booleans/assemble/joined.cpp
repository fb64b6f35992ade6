#include "booleans/assemble/making.h"

namespace quoin::booleans {
namespace {

/// Tells each vertex on a loop of at least two corners its neighbours there.
template <class Corner>
void note_neighbours(ResultVertices& vertices, const grid::Loops<Corner>& loops) {
  for (std::size_t j = 0; j < loops.loop_count(); ++j) {
    const auto loop = loops.loop(j);
    if (loop.size() == 1) continue;
    for (std::size_t i = 0; i < loop.size(); ++i)
      vertices.add_neighbours(vertices.place(loop[i]), vertices.place(loop[grid::previous_in_loop(i, loop.size())]),
                              vertices.place(loop[grid::next_in_loop(i, loop.size())]));
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

/// Writes faces one after the other, without vertices inside straight edges. New points get their names as they come.
class Writer {
 public:
  explicit Writer(Making& m) : m_(m) {}

  /// Writes face i of some loops, on that plane, and with it the spared loops of touched faces. A triangle between grid
  /// points is raw.
  template <class Corner>
  void write(const grid::Loops<Corner>& from, std::size_t i, const exact::Plane& plane,
             std::span<const SparedRegion> spared = {}) {
    gather(from, i);
    if (spared.empty() && is_raw()) {
      m_.body.triangles.push_back({corners_[0].index(), corners_[1].index(), corners_[2].index()});
      return;
    }

    add_loops();
    if (!spared.empty()) {
      // The outer loop is drawn.
      const auto polygon = static_cast<std::uint32_t>(m_.body.planes.size());
      m_.spared_chunks.push_back({polygon, polygon + 1, box()});
    }
    for (const SparedRegion& s : spared) write_spared(m_, s.face, plane);
    m_.close_polygon(plane);
  }

 private:
  template <class Corner>
  void gather(const grid::Loops<Corner>& from, std::size_t i) {
    corners_.clear();
    ends_.clear();
    from.for_loops(i, [&](std::span<const Corner> loop) {
      const std::size_t before = corners_.size();
      for (const Corner c : loop) {
        const PlaceId p = m_.vertices.place(c);
        if (loop.size() == 1 ? m_.vertices.is_used(p) : m_.vertices.is_needed(p))
          corners_.push_back(m_.vertices.named(p));
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
  Array<ResultName> corners_;  // of one face
  Array<std::size_t> ends_;    // of its loops
};

void write_regions(const Making& m, const Regions& regions, Writer& writer) {
  auto spared = regions.spared.begin();
  for (std::size_t i = 0; i < regions.size(); ++i) {
    const auto first = spared;
    while (spared != regions.spared.end() && spared->region == i) ++spared;
    const auto& [id, turned] = regions.planes[i];
    const exact::Plane& plane = m.a.names.planes[id];
    writer.write(regions.loops, i, turned ? plane.opposite() : plane, {first, spared});
  }
}

}  // namespace

void join_regions(Making& m) {
  const Array<Regions> merged = merged_regions(m.a, m.selection);
  note_neighbours(m.vertices, m.waiting_loops);
  for (const Regions& r : merged) note_neighbours(m.vertices, r.loops);
  if (m.host == none) reserve(m, merged);

  Writer writer(m);
  for (std::size_t i = 0; i < m.waiting.size(); ++i) writer.write(m.waiting_loops, i, m.kept_plane(m.waiting[i]));
  for (const Regions& r : merged) write_regions(m, r, writer);

  if (m.host == none && !m.body.points.empty())
    for (std::uint32_t& c : m.body.polygons.corners.edit()) c = m.final_id(ResultName::of_corner(c));
}

}  // namespace quoin::booleans
