#include "booleans/arrangement/contacts.h"

#include <optional>

#include "booleans/arrangement/line_trace.h"
#include "booleans/pairs/triangle_pair.h"
#include "grid/lists/stretches.h"

namespace quoin::booleans {
namespace {

/// An axis in which the line of two planes runs, preferably the steepest; -1 for parallel planes.
int axis_of_line(const exact::Plane& p, const exact::Plane& q) {
  const auto a = exact::approximation(p).n, b = exact::approximation(q).n;
  std::array<double, 3> c{};
  for (std::size_t k = 0; k < 3; ++k) c[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
  const int best = static_cast<int>(exact::longest_component(c));

  for (int k = 0; k < 3; ++k)
    if (exact::cross_sign(p, q, (best + k) % 3) != 0) return (best + k) % 3;
  return -1;
}

/// Works through a range of pairs; keeps the points that it makes.
class Worker {
 public:
  Worker(const Touched& touched, const Names& names) : touched_(touched), names_(names), tracer_(touched, names) {}

  struct End {
    NewVertex vertex;
    std::uint32_t at;  // a place
  };
  struct Segment {
    PlaneId plane;
    End a, b;
    PlaneId line;
    OperandId other;
  };
  struct Point {
    PlaneId plane;
    NewVertex vertex;
  };
  Array<Segment> segments;
  Array<Point> isolated;
  const Array<exact::Point>& points() const { return tracer_.points; }
  /// Large lists are not kept longer than needed.
  void clear() {
    segments = {};
    isolated = {};
    tracer_.points = {};
  }

  void meet(const TouchedPair& pair) {
    const TouchedFace &f = touched_.faces[pair[0]], &g = touched_.faces[pair[1]];
    if (f.plane == g.plane) {
      ++exact::counters().symbolic;
      return;
    }
    if (meet_triangles(pair)) return;

    const int axis = axis_of_line(names_.planes[f.plane], names_.planes[g.plane]);
    if (axis < 0) return;
    const int direction = exact::cross_sign(names_.planes[f.plane], names_.planes[g.plane], axis);
    const FaceLine in_f{pair[0], f.plane, g.plane, axis, direction}, in_g{pair[1], g.plane, f.plane, axis, -direction};

    tracer_.find_stops(in_f, g.box, on_f_);
    tracer_.find_stops(in_g, f.box, on_g_);
    const bool large_f = touched_.edge_tree[in_f.face] != nullptr, large_g = touched_.edge_tree[in_g.face] != nullptr;
    const auto &stops_f = on_f_.stops, &stops_g = on_g_.stops;
    if (stops_f.empty() && (!large_f || stops_g.empty())) return;
    if (stops_g.empty() && !large_g) return;

    const NewVertex at = stops_f.empty() ? stops_g[0].vertex : stops_f[0].vertex;
    tracer_.find_open_segments(in_f, at, on_f_);
    tracer_.find_open_segments(in_g, at, on_g_);
    reverse(on_g_);
    overlap(in_f, in_g);
  }

 private:
  /// The face as a triangle between grid points; nothing if it is none.
  std::optional<GridTriangle> triangle(const TouchedFace& f) const {
    if (f.edge_count() != 3 || f.isolated_begin != f.isolated_end) return std::nullopt;
    GridTriangle corners;
    for (std::uint32_t k = 0; k < 3; ++k) {
      const BoundaryEdge &e = touched_.edges[f.edges_begin + k], &next = touched_.edges[f.edges_begin + (k + 1) % 3];
      if (e.to != next.from || !names_.vertices.is_grid(e.from)) return std::nullopt;
      corners[k] = names_.vertices.grid_point(e.from);
    }
    return corners;
  }

  /// Posts the contact of two triangles between grid points in general position; false for others.
  bool meet_triangles(const TouchedPair& pair) {
    const std::array<const TouchedFace*, 2> face{&touched_.faces[pair[0]], &touched_.faces[pair[1]]};
    const auto f = triangle(*face[0]), g = f ? triangle(*face[1]) : std::nullopt;
    if (!g) return false;
    const auto crossing = cross(*f, *g);
    if (!crossing) return false;
    if (!crossing->meet) return true;

    const auto end = [&](const TriangleCrossing::End& e) {
      const FaceLine line{pair[e.triangle], face[e.triangle]->plane, face[1 - e.triangle]->plane, 0, 0};
      return tracer_.crossing(line, touched_.edges[face[e.triangle]->edges_begin + e.edge]);
    };
    const NewVertex from = end(crossing->from), to = end(crossing->to);
    for (const std::size_t own : {0u, 1u}) {
      const auto place = [&](const TriangleCrossing::End& e) {
        return e.triangle == own ? face[own]->edges_begin + e.edge : inside_face;
      };
      segments.push_back({face[own]->plane,
                          {from, place(crossing->from)},
                          {to, place(crossing->to)},
                          face[1 - own]->plane,
                          face[1 - own]->operand});
    }
    return true;
  }

  /// Intersects the two closed sets on the line and posts what is left to both planes.
  void overlap(const FaceLine& line_f, const FaceLine& line_g) {
    const Array<Stop>&f = on_f_.stops, &g = on_g_.stops;
    const bool is_plain = on_f_.is_plain() && on_g_.is_plain();
    bool in_f = on_f_.open, in_g = on_g_.open;
    bool is_open = false;
    std::array<End, 2> open_from;  // on either plane
    for (std::size_t i = 0, j = 0; i < f.size() || j < g.size();) {
      const int order = i == f.size()   ? 1
                        : j == g.size() ? -1
                                        : tracer_.compare(line_f.axis, f[i].vertex, g[j].vertex) * line_f.direction;
      const bool at_f = order <= 0, at_g = order >= 0;
      // A vertex of the table is preferred as the name of the point.
      NewVertex v = at_f ? f[i].vertex : g[j].vertex;
      if (at_f && at_g && v.is_own()) v = g[j].vertex;
      const std::array<End, 2> here{End{v, !is_plain ? unknown_place
                                           : at_f    ? f[i].edge
                                                     : inside_face},
                                    End{v, !is_plain ? unknown_place
                                           : at_g    ? g[j].edge
                                                     : inside_face}};

      const bool is_here = (at_f || in_f) && (at_g || in_g);
      if (at_f) in_f = f[i++].open;
      if (at_g) in_g = g[j++].open;
      if (!is_here) continue;

      const bool closes = is_open;
      if (closes) {
        post(line_f, open_from[0], here[0], line_g);
        post(line_g, open_from[1], here[1], line_f);
      }
      is_open = in_f && in_g;
      open_from = here;
      if (!closes && !is_open) post(v, line_f);
    }
  }

  void post(const FaceLine& line, End a, End b, const FaceLine& other) {
    segments.push_back({line.own, a, b, line.other, touched_.faces[other.face].operand});
  }
  void post(NewVertex v, const FaceLine& line) {
    isolated.push_back({line.own, v});
    isolated.push_back({line.other, v});
  }

  const Touched& touched_;
  const Names& names_;
  LineTracer tracer_;
  Trace on_f_, on_g_;
};

/// Names the worker's points that contacts have, and adds those contacts.
void add_contacts(const Worker& worker, VertexTable& vertices, Contacts& all) {
  Array<VertexId> names(worker.points().size(), none);
  const auto named = [&](NewVertex v) {
    if (!v.is_own()) return v.named();
    VertexId& name = names[v.index()];
    if (name == none) name = vertices.id(worker.points()[v.index()]);
    return name;
  };

  for (const Worker::Segment& s : worker.segments) {
    const VertexId a = named(s.a.vertex), b = named(s.b.vertex);
    all.segments.push_back({s.plane, a, b, s.line, s.other, s.a.at, s.b.at});
  }
  for (const Worker::Point& p : worker.isolated) all.points.push_back({p.plane, named(p.vertex)});
}

}  // namespace

Array<TouchedPair> touched_pairs(const Touched& touched, const FacePairs& pairs) {
  Array<TouchedPair> found;
  found.reserve(pairs.size());
  for (const FacePair& p : pairs) {
    const TouchedId f = touched.touched_of[p[0]], g = touched.touched_of[p[1]];
    if (f != g) found.push_back({std::min(f, g), std::max(f, g)});
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

Contacts find_contacts(const Touched& touched, const Array<TouchedPair>& pairs, Names& names) {
  // Fixed stretches, results in slots, points named in their order: the same ids for any number of threads.
  const std::size_t length = grid::stretch(512);
  Array<Worker> workers((pairs.size() + length - 1) / length, Worker(touched, names));
  grid::in_stretches(pairs.size(), length, [&](std::size_t s, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) workers[s].meet(pairs[i]);
  });

  Contacts all;
  std::size_t points = 0, segments = 0;
  for (const Worker& w : workers) points += w.points().size(), segments += w.segments.size();
  names.vertices.reserve(points, points);
  all.segments.reserve(segments);
  for (Worker& w : workers) {
    add_contacts(w, names.vertices, all);
    w.clear();
  }
  return all;
}

}  // namespace quoin::booleans
