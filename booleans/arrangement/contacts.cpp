#include "booleans/arrangement/contacts.h"

#include "booleans/arrangement/line_trace.h"
#include "booleans/pairs/directions.h"
#include "grid/lists/buckets.h"
#include "grid/lists/stretches.h"

namespace quoin::booleans {
namespace {

/// The faces of clean operands that coincide with a face of another one, edge by edge. What meets such a face of the
/// other's own faces meets it in common edges and vertices, which are drawn with either: it makes no contacts.
class Twins {
 public:
  Twins(const Touched& touched, const Array<TouchedPair>& pairs) : touched_(touched) {
    if (!touched.cover_once) return;
    for (const auto& [f, g] : pairs) {
      if (touched.faces[f].plane != touched.faces[g].plane || !coincide(f, g)) continue;
      if (twin_in_.empty()) twin_in_.assign(touched.faces.size(), none);
      twin_in_[f] = touched.faces[g].operand;
      twin_in_[g] = touched.faces[f].operand;
    }
  }

  /// Is one of two faces of different operands the twin of a face of the other's operand?
  bool has(const TouchedPair& pair) const {
    if (twin_in_.empty()) return false;
    const auto operand = [&](TouchedId t) { return touched_.faces[t].operand; };
    return twin_in_[pair[0]] == operand(pair[1]) || twin_in_[pair[1]] == operand(pair[0]);
  }

 private:
  using Edges = std::vector<std::array<VertexId, 2>>;

  bool coincide(TouchedId f, TouchedId g) {
    const auto is_plain = [&](TouchedId t) { return touched_.isolated_of(t).empty() && touched_.spared_of(t).empty(); };
    if (touched_.faces[f].edge_count() != touched_.faces[g].edge_count() || !is_plain(f) || !is_plain(g)) return false;
    list_edges(f, edges_[0]);
    list_edges(g, edges_[1]);
    return edges_[0] == edges_[1];
  }
  void list_edges(TouchedId t, Edges& list) const {
    list.clear();
    for (const BoundaryEdge& e : touched_.edges_of(t)) list.push_back({std::min(e.from, e.to), std::max(e.from, e.to)});
    std::sort(list.begin(), list.end());
  }

  const Touched& touched_;
  std::array<Edges, 2> edges_;
  ById<TouchedId, OperandId> twin_in_;  // one that the face has a twin in, none without one; empty: no face has
};

/// Works through a range of pairs; keeps the points that it makes.
class Worker {
 public:
  Worker(const Touched& touched, const Names& names) : touched_(touched), names_(names), tracer_(touched, names) {
    constexpr std::size_t usual = 16;
    segments.reserve(usual);
    tracer_.points.reserve(usual);
  }

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
    if (meet_simply(pair)) return;

    const int axis = axis_of_line(names_.planes[f.plane], names_.planes[g.plane]);
    if (axis < 0) return;
    const int direction = exact::cross_sign(names_.planes[f.plane], names_.planes[g.plane], axis);
    const FaceLine in_f{pair[0], f.plane, g.plane, axis, direction}, in_g{pair[1], g.plane, f.plane, axis, -direction};

    if (!find_stops(in_f, in_g)) return;

    const NewVertex at = (on_f_.stops.empty() ? on_g_ : on_f_).stops[0].vertex;
    tracer_.find_open_segments(in_f, at, on_f_);
    tracer_.find_open_segments(in_g, at, on_g_);
    reverse(on_g_);
    overlap(in_f, in_g);
  }

 private:
  /// The stops of both faces, as far as they matter. False where they tell that the faces do not meet.
  bool find_stops(const FaceLine& in_f, const FaceLine& in_g) {
    const bool large_f = touched_.edge_tree[in_f.face] != nullptr, large_g = touched_.edge_tree[in_g.face] != nullptr;
    if (large_f && !large_g) return find_stops_of_large(in_f, on_f_, in_g, on_g_);
    if (large_g && !large_f) return find_stops_of_large(in_g, on_g_, in_f, on_f_);

    tracer_.find_stops(in_f, touched_.faces[in_g.face].box, on_f_);
    if (!large_f && on_f_.stops.empty()) return false;
    tracer_.find_stops(in_g, touched_.faces[in_f.face].box, on_g_);
    return !on_g_.stops.empty() || (large_f && !on_f_.stops.empty());
  }
  /// What a small face has on the line lies between its stops.
  bool find_stops_of_large(const FaceLine& in_large, Trace& on_large, const FaceLine& in_small, Trace& on_small) {
    tracer_.find_stops(in_small, touched_.faces[in_large.face].box, on_small);
    if (on_small.stops.empty()) return false;
    tracer_.find_stops_between(in_large, on_small.stops, on_large);
    return true;
  }

  /// An edge between grid points at which a line enters or leaves a face.
  struct Gate {
    std::uint32_t edge = none;
    int from_side = 0;  // of its beginning to the other plane
    std::array<exact::GridPoint, 2> ends = {};
  };

  /// The edges at which the line in which a face's plane meets another one enters and leaves the face. False where that
  /// is not one each, between grid points, or a corner lies on the other plane.
  bool find_gates(const TouchedFace& f, PlaneId other, Gate& enter, Gate& leave) const {
    if (f.isolated_begin != f.isolated_end || f.edge_count() > grid::thresholds().large_face) return false;
    enter.edge = leave.edge = none;
    VertexId last = none;
    int last_side = 0;
    for (std::uint32_t i = f.edges_begin; i < f.edges_end; ++i) {
      const BoundaryEdge& e = touched_.edges[i];
      const int from = e.from == last ? last_side : names_.side(e.from, other), to = names_.side(e.to, other);
      if (from == 0 || to == 0) return false;
      last = e.to;
      last_side = to;
      if (from == to) continue;

      Gate& gate = (from < 0) == f.along ? enter : leave;
      if (gate.edge != none || !names_.vertices.is_grid(e.from) || !names_.vertices.is_grid(e.to)) return false;
      gate = {i, from, {names_.vertices.grid_point(e.from), names_.vertices.grid_point(e.to)}};
    }
    return true;
  }

  /// Posts the contact of two faces whose planes' line passes through each once, by signs alone; false for others.
  ///
  /// With P where edge e of f meets the line, Q where edge h of g does, (e x h) . (n_f x n_g) = -(e . n_g) (h . n_f),
  /// and the orientation of the two edges' ends is the sign of -(e x h) . (Q - P): it tells whether Q comes after P.
  bool meet_simply(const TouchedPair& pair) {
    const TouchedFace &f = touched_.faces[pair[0]], &g = touched_.faces[pair[1]];
    Gate f_in, f_out, g_in, g_out;
    if (!find_gates(f, g.plane, f_in, f_out) || !find_gates(g, f.plane, g_out, g_in)) return false;
    if (f_in.edge == none || g_in.edge == none) return true;

    const auto order = [](const Gate& e, const Gate& h) {  // +1: the gate h of g comes after e of f
      const int o = exact::orientation(e.ends[0], e.ends[1], h.ends[0], h.ends[1]);
      return e.from_side == h.from_side ? o : -o;
    };
    const int begin = order(f_in, g_out), end = order(f_out, g_in);
    if (begin == 0 || end == 0) return false;
    if (begin < 0 || end > 0) return true;
    const int first = order(f_in, g_in), last = order(f_out, g_out);
    if (first == 0 || last == 0) return false;

    const FaceLine in_f{pair[0], f.plane, g.plane, 0, 0}, in_g{pair[1], g.plane, f.plane, 0, 0};
    const std::uint32_t from_f = first < 0 ? f_in.edge : none, from_g = first > 0 ? g_in.edge : none;
    const std::uint32_t to_f = last > 0 ? f_out.edge : none, to_g = last < 0 ? g_out.edge : none;
    const auto crossing = [&](std::uint32_t on_f, std::uint32_t on_g) {
      return on_f != none ? tracer_.crossing(in_f, touched_.edges[on_f]) : tracer_.crossing(in_g, touched_.edges[on_g]);
    };
    const auto place = [](std::uint32_t edge) { return edge != none ? edge : inside_face; };
    const NewVertex from = crossing(from_f, from_g), to = crossing(to_f, to_g);
    post(in_f, {from, place(from_f)}, {to, place(to_f)}, in_g);
    post(in_g, {from, place(from_g)}, {to, place(to_g)}, in_f);
    return true;
  }

  /// Intersects the two closed sets on the line and posts what is left to both planes.
  void overlap(const FaceLine& line_f, const FaceLine& line_g) {
    const Array<Stop>&f = on_f_.stops, &g = on_g_.stops;
    const bool is_plain = on_f_.is_plain() && on_g_.is_plain();
    const auto place = [&](bool at_stop, const Array<Stop>& stops, std::size_t stop) {
      return !is_plain ? unknown_place : at_stop ? stops[stop].edge : inside_face;
    };
    bool in_f = on_f_.open, in_g = on_g_.open;
    bool is_open = false;
    std::array<End, 2> open_from{};  // on either plane
    for (std::size_t i = 0, j = 0; i < f.size() || j < g.size();) {
      const int order = i == f.size()   ? 1
                        : j == g.size() ? -1
                                        : tracer_.compare(line_f.axis, f[i].vertex, g[j].vertex) * line_f.direction;
      const bool at_f = order <= 0, at_g = order >= 0;
      // A vertex of the table is preferred as the name of the point.
      NewVertex v = at_f ? f[i].vertex : g[j].vertex;
      if (at_f && at_g && v.is_own()) v = g[j].vertex;
      const std::array<End, 2> here{End{v, place(at_f, f, i)}, End{v, place(at_g, g, j)}};

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
  const auto visit_all = [&](auto&& visit) {
    for (const FacePair& p : pairs) {
      const TouchedId f = touched.touched_of[p[0]], g = touched.touched_of[p[1]];
      if (f != g) visit(std::min(f, g), std::max(f, g));
    }
  };

  if (pairs.size() < grid::thresholds().few_keys) {
    visit_all([&](TouchedId f, TouchedId g) { found.push_back({f, g}); });
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

  grid::Buckets<TouchedId> others(
      touched.faces.size(), [&](auto&& visit) { visit_all([&](TouchedId f, TouchedId g) { visit(f.value, g); }); });
  for (const TouchedId f : Ids<TouchedId>(touched.faces.size())) {
    const std::span<TouchedId> list = others[f.value];
    std::sort(list.begin(), list.end());
    const auto end = std::unique(list.begin(), list.end());
    for (auto g = list.begin(); g != end; ++g) found.push_back({f, *g});
  }
  return found;
}

Contacts find_contacts(const Touched& touched, const Array<TouchedPair>& pairs, Names& names) {
  const Twins twins(touched, pairs);

  // Fixed stretches, results in slots, points named in their order: the same ids for any number of threads.
  const std::size_t length = grid::long_stretch(pairs.size(), 512);
  std::vector<Worker> workers;
  workers.reserve((pairs.size() + length - 1) / length);
  for (std::size_t i = 0; i < pairs.size(); i += length) workers.emplace_back(touched, names);
  grid::in_stretches(pairs.size(), length, [&](std::size_t s, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (!twins.has(pairs[i])) workers[s].meet(pairs[i]);
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
