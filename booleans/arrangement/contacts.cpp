#include "booleans/arrangement/contacts.h"

#include "booleans/arrangement/line_trace.h"
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

  struct Segment {
    PlaneId plane;
    NewVertex a, b;
    PlaneId line;
  };
  struct Point {
    PlaneId plane;
    NewVertex vertex;
  };
  std::vector<Segment> segments;
  std::vector<Point> isolated;
  const std::vector<exact::Point>& points() const { return tracer_.points; }
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
    overlap(in_f);
  }

 private:
  /// Intersects the two closed sets on the line and posts what is left to both planes.
  void overlap(const FaceLine& line) {
    const std::vector<Stop>&f = on_f_.stops, &g = on_g_.stops;
    bool in_f = on_f_.open, in_g = on_g_.open;
    bool is_open = false;
    NewVertex open_from;
    for (std::size_t i = 0, j = 0; i < f.size() || j < g.size();) {
      const int order = i == f.size()   ? 1
                        : j == g.size() ? -1
                                        : tracer_.compare(line.axis, f[i].vertex, g[j].vertex) * line.direction;
      const bool at_f = order <= 0, at_g = order >= 0;
      // A vertex of the table is preferred as the name of the point.
      NewVertex v = at_f ? f[i].vertex : g[j].vertex;
      if (at_f && at_g && v.is_own()) v = g[j].vertex;

      const bool here = (at_f || in_f) && (at_g || in_g);
      if (at_f) in_f = f[i++].open;
      if (at_g) in_g = g[j++].open;
      if (!here) continue;

      const bool closes = is_open;
      if (closes) post(open_from, v, line);
      is_open = in_f && in_g;
      open_from = v;
      if (!closes && !is_open) post(v, line);
    }
  }

  void post(NewVertex a, NewVertex b, const FaceLine& line) {
    segments.push_back({line.own, a, b, line.other});
    segments.push_back({line.other, a, b, line.own});
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
  std::vector<VertexId> names(worker.points().size(), none);
  const auto named = [&](NewVertex v) {
    if (!v.is_own()) return v.named();
    VertexId& name = names[v.index()];
    if (name == none) name = vertices.id(worker.points()[v.index()]);
    return name;
  };

  for (const Worker::Segment& s : worker.segments) {
    const VertexId a = named(s.a), b = named(s.b);
    all.segments.push_back({s.plane, a, b, s.line});
  }
  for (const Worker::Point& p : worker.isolated) all.points.push_back({p.plane, named(p.vertex)});
}

}  // namespace

std::vector<TouchedPair> touched_pairs(const Touched& touched, const FacePairs& pairs) {
  std::vector<TouchedPair> found;
  found.reserve(pairs.size());
  for (const FacePair& p : pairs) {
    const TouchedId f = touched.touched_of[p[0]], g = touched.touched_of[p[1]];
    if (f != g) found.push_back({std::min(f, g), std::max(f, g)});
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

Contacts find_contacts(const Touched& touched, const std::vector<TouchedPair>& pairs, Names& names) {
  // Fixed stretches, results in slots, points named in their order: the same ids for any number of threads.
  const std::size_t length = grid::stretch(512);
  std::vector<Worker> workers((pairs.size() + length - 1) / length, Worker(touched, names));
  grid::in_stretches(pairs.size(), length, [&](std::size_t s, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) workers[s].meet(pairs[i]);
  });

  Contacts all;
  for (Worker& w : workers) {
    add_contacts(w, names.vertices, all);
    w.clear();
  }
  return all;
}

}  // namespace quoin::booleans
