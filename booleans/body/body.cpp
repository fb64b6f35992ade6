#include "booleans/body/body.h"

#include <algorithm>

#include "exact/predicates.h"
#include "grid/lists/stretches.h"

namespace quoin::booleans {

exact::Plane Body::plane(std::uint32_t face) const {
  if (face >= triangles.size()) return planes[face - triangles.size()];
  const auto& t = triangles[face];
  const auto p = exact::plane_through(grid_points[t[0]], grid_points[t[1]], grid_points[t[2]]);
  assert(p);
  return *p;
}

const exact::Plane* Body::border(std::uint32_t face, std::uint32_t u, std::uint32_t v) const {
  if (face < triangles.size() || labels.borders.empty()) return nullptr;
  const std::uint32_t p = polygon(face);
  std::uint32_t j = polygons.face_start[p];
  const auto [begin, end] = polygons.corner_range(p);
  for (const Border& b : labels.borders_within(begin, end)) {
    while (polygons.loop_start[j + 1] <= b.corner) ++j;
    const std::uint32_t next = b.corner + 1 < polygons.loop_start[j + 1] ? b.corner + 1 : polygons.loop_start[j];
    if (polygons.corners[b.corner] == u && polygons.corners[next] == v) return &b.other;
  }
  return nullptr;
}

void Body::settle() {
  grid_points.settle();
  points.settle();
  triangles.settle();
  planes.settle();
  polygons.face_start.settle();
  polygons.loop_start.settle();
  polygons.corners.settle();
  labels.settle();
}

namespace {

WideBox triangle_box(const Body& body, std::uint32_t t) {
  const auto& c = body.triangles[t];
  WideBox box(body.grid_points[c[0]]);
  box.add(body.grid_points[c[1]]);
  box.add(body.grid_points[c[2]]);
  return box;
}

Box polygon_box(const Body& body, std::uint32_t face) {
  Box box;
  body.for_corners(face, [&](std::uint32_t v) { body.add_to(box, v); });
  return box;
}

/// Appends the chunks of faces of one tier.
template <class BoxOf>
void add_chunks_of_stretch(std::uint32_t begin, std::uint32_t end, Array<Chunk>& chunks, BoxOf box_of) {
  while (begin < end) {
    WideBox all = box_of(begin);
    std::uint32_t next = begin + 1;
    for (; next < end && next - begin < grid::thresholds().chunk; ++next) {
      const WideBox box = box_of(next);
      if (!box.meets(all)) break;
      all.add(box);
    }
    chunks.push_back({begin, next, all.box()});
    begin = next;
  }
}

template <class BoxOf>
void add_chunks(std::uint32_t begin, std::uint32_t end, Array<Chunk>& chunks, BoxOf box_of) {
  if (begin >= end) return;

  const std::size_t length = grid::stretch(std::size_t{1} << 15);
  Array<Array<Chunk>> parts((end - begin - 1) / length);  // behind the first
  grid::in_stretches(end - begin, length, [&](std::size_t s, std::size_t from, std::size_t to) {
    add_chunks_of_stretch(begin + static_cast<std::uint32_t>(from), begin + static_cast<std::uint32_t>(to),
                          s == 0 ? chunks : parts[s - 1], box_of);
  });
  for (const auto& p : parts) chunks.insert(chunks.end(), p.begin(), p.end());
}

}  // namespace

Box face_box(const Body& body, std::uint32_t face) {
  return face < body.triangles.size() ? triangle_box(body, face).box() : polygon_box(body, face);
}

void add_chunks(const Body& body, std::uint32_t begin, std::uint32_t end, Array<Chunk>& chunks) {
  const auto triangles = static_cast<std::uint32_t>(body.triangles.size());
  add_chunks(begin, std::min(end, triangles), chunks, [&](std::uint32_t f) { return triangle_box(body, f); });
  add_chunks(std::max(begin, triangles), end, chunks, [&](std::uint32_t f) { return WideBox(polygon_box(body, f)); });
}

Body packed(const Body& body) {
  if (body.is_packed) return body;

  Body r;
  r.full_at_infinity = body.full_at_infinity;
  r.is_proved = body.is_proved;
  r.labels.origins = body.labels.origins;
  constexpr std::uint32_t derived = 1u << 31;  // until the number of grid points is known
  Array<std::uint32_t> name(body.vertex_count(), none);
  const auto named = [&](std::uint32_t v) {
    if (name[v] != none) return name[v];
    if (body.is_grid(v)) {
      name[v] = static_cast<std::uint32_t>(r.grid_points.size());
      r.grid_points.push_back(body.grid_points[v]);
    } else {
      name[v] = static_cast<std::uint32_t>(r.points.size()) | derived;
      r.points.push_back(body.derived(v));
    }
    return name[v];
  };

  const auto raw = body.triangles.size();
  for (const Chunk& c : body.chunks) {
    const auto begin = static_cast<std::uint32_t>(r.face_count());
    for (std::uint32_t f = c.begin; f < c.end; ++f) {
      if (f < raw) {
        const auto& t = body.triangles[f];
        r.triangles.push_back({named(t[0]), named(t[1]), named(t[2])});
        if (body.labels) r.labels.triangles.push_back(body.labels.triangles[f]);
        continue;
      }

      if (body.labels) {
        r.labels.polygons.push_back(body.labels.polygons[f - raw]);
        const auto [first, last] = body.polygons.corner_range(f - raw);
        r.labels.append_borders(body.labels, first, last, static_cast<std::uint32_t>(r.polygons.corners.size()));
      }
      body.polygons.for_loops(f - raw, [&](std::span<const std::uint32_t> loop) {
        for (const std::uint32_t v : loop) r.polygons.corners.push_back(named(v));
        r.polygons.end_loop();
      });
      r.polygons.end_face();
      r.planes.push_back(body.planes[f - raw]);
    }
    r.chunks.push_back({begin, static_cast<std::uint32_t>(r.face_count()), c.box});
  }

  for (std::uint32_t& v : r.polygons.corners.edit())
    if (v & derived) v = static_cast<std::uint32_t>(r.grid_points.size()) + (v & ~derived);
  return r;
}

void drop_gone_loops(Body& body) {
  const auto raw = static_cast<std::uint32_t>(body.triangles.size());
  const std::size_t corners = body.polygons.corners.size() - body.gone_corners;
  // Room for more than as much again: results that share these lists add to them before the next time. Room that is not
  // used costs no memory.
  decltype(body.polygons) left;
  Labels left_labels{body.labels.origins, body.labels.triangles, body.labels.polygons, {}};
  left.reserve(body.polygon_count() + body.polygon_count() / 2, 2 * body.polygons.loop_count(), 3 * corners);

  std::uint32_t next = 0;
  const auto skip_to = [&](std::uint32_t polygon) {
    for (; next < polygon; ++next) left.end_face();
  };
  for (const Chunk& c : body.chunks) {
    if (c.begin < raw) continue;
    skip_to(c.begin - raw);
    left_labels.append_borders(body.labels, body.polygons.corner_range(next).begin,
                               body.polygons.corner_range(c.end - raw - 1).end,
                               static_cast<std::uint32_t>(left.corners.size()));
    left.append_faces(body.polygons, next, c.end - raw, [](std::uint32_t v) { return v; });
    next = c.end - raw;
  }
  skip_to(static_cast<std::uint32_t>(body.polygon_count()));

  body.polygons = std::move(left);
  body.labels = std::move(left_labels);
  body.gone_corners = 0;
}

Body complement(const Body& body) {
  Body r = body;
  for (auto& t : r.triangles.edit()) std::swap(t[1], t[2]);

  for (auto& p : r.planes.edit()) p = p.opposite();
  const auto corners = r.polygons.corners.edit();
  for (std::size_t j = 0; j + 1 < r.polygons.loop_start.size(); ++j)
    std::reverse(corners.begin() + r.polygons.loop_start[j], corners.begin() + r.polygons.loop_start[j + 1]);

  for (auto& p : r.labels.triangles.edit()) p = p.turned();
  for (auto& p : r.labels.polygons.edit()) p = p.turned();
  r.labels.reverse_loops(r.polygons.loop_start);

  r.full_at_infinity = !r.full_at_infinity;
  return r;
}

Body box_body(const exact::GridPoint& low, const exact::GridPoint& high) {
  Body r;
  for (int i = 0; i < 8; ++i)
    r.grid_points.push_back({{i & 1 ? high[0] : low[0], i & 2 ? high[1] : low[1], i & 4 ? high[2] : low[2]}});
  static constexpr std::array<std::array<std::uint32_t, 4>, 6> quads{
      {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
  for (const auto& q : quads) {
    r.triangles.push_back({q[0], q[1], q[2]});
    r.triangles.push_back({q[0], q[2], q[3]});
  }
  return r;
}

namespace {

/// Clips one box face (a convex loop of corner ids 0..7) by the plane; crossings come from `crossing(u, v)`.
template <class Side, class Crossing>
Array<std::uint32_t> clipped_loop(const std::array<std::uint32_t, 4>& quad, Side side, Crossing crossing) {
  Array<std::uint32_t> loop;
  grid::for_loop_edges(quad, [&](std::uint32_t u, std::uint32_t v) {
    if (side(u) <= 0) loop.push_back(u);
    if (side(u) * side(v) < 0) loop.push_back(crossing(u, v));
  });
  return loop;
}

}  // namespace

Body half_space_body(const exact::Plane& plane, const exact::GridPoint& low, const exact::GridPoint& high) {
  Body box = box_body(low, high);
  std::array<int, 8> sides{};
  int below = 0, above = 0;
  for (std::uint32_t v = 0; v < 8; ++v) {
    sides[v] = exact::side(plane, box.grid_points[v]);
    below += sides[v] < 0;
    above += sides[v] > 0;
  }
  if (above == 0) return box;
  if (below == 0) return {};

  Body r;
  r.grid_points = box.grid_points;
  Array<std::array<std::uint32_t, 3>> crossings;  // edge (u < v) -> vertex
  const auto crossing = [&](std::uint32_t u, std::uint32_t v) {
    if (u > v) std::swap(u, v);
    for (const auto& c : crossings)
      if (c[0] == u && c[1] == v) return c[2];
    const exact::GridPoint &p = r.grid_points[u], &q = r.grid_points[v];
    r.points.push_back(exact::meet(p, exact::value(plane, p), q, exact::value(plane, q)));
    const auto id = static_cast<std::uint32_t>(r.vertex_count() - 1);
    crossings.push_back({u, v, id});
    return id;
  };

  const auto side = [&](std::uint32_t v) { return sides[v]; };
  const auto emit = [&](const exact::Plane& p, const Array<std::uint32_t>& loop) {
    r.planes.push_back(p);
    r.polygons.add_loop(loop);
    r.polygons.end_face();
  };

  // The cap's directed edges are the reverses of the clipped faces' edges that lie on the plane.
  Array<std::array<std::uint32_t, 2>> cap;
  for (std::size_t f = 0; f < 6; ++f) {
    const auto &t = box.triangles[2 * f], &s = box.triangles[2 * f + 1];
    const auto loop = clipped_loop({t[0], t[1], t[2], s[2]}, side, crossing);
    const bool solid = std::any_of(loop.begin(), loop.end(), [&](std::uint32_t v) { return v < 8 && sides[v] < 0; });
    if (!solid) continue;

    emit(box.plane(static_cast<std::uint32_t>(2 * f)), loop);
    const auto on = [&](std::uint32_t v) { return v >= 8 || sides[v] == 0; };
    grid::for_loop_edges(loop, [&](std::uint32_t u, std::uint32_t v) {
      if (on(u) && on(v)) cap.push_back({v, u});
    });
  }

  Array<std::uint32_t> loop{cap[0][0]};
  for (std::uint32_t at = cap[0][1]; at != loop[0];) {
    loop.push_back(at);
    at = (*std::find_if(cap.begin(), cap.end(), [&](const auto& e) { return e[0] == at; }))[1];
  }
  emit(plane, loop);
  return r;
}

}  // namespace quoin::booleans
