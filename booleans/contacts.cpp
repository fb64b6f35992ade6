#include "booleans/contacts.h"

#include "booleans/sheet.h"
#include "grid/stretches.h"

namespace quoin::booleans {
namespace {

/// A place where the line of two planes meets the boundary of a face.
struct Stop {
  std::uint32_t vertex;
  int left, right;  // net boundary crossings of the strips just left and just right of the line: entering +1
  bool open;        // the segment from here to the next stop lies in the closed face
};

/// What a line does with a face.
struct Trace {
  std::vector<Stop> stops;
  int left = 0, right = 0;  // whether the strips lie in the face before the first stop
  bool open = false;        // the closed face holds the line before the first stop
};

/// Works through a range of pairs; owns the points it makes.
class Worker {
 public:
  Worker(const TouchedFaces& touched, const VertexTable& vertices, const PlaneTable& planes)
      : touched_(touched), vertices_(vertices), planes_(planes) {}

  Contacts contacts;
  std::vector<exact::Point> points;

  void meet(std::uint32_t i, std::uint32_t j) {
    const TouchedFace &f = touched_.faces[i], &g = touched_.faces[j];
    if (f.sheet == g.sheet) {
      ++exact::counters().symbolic;
      return;
    }
    const exact::Plane &p = planes_[f.sheet], &q = planes_[g.sheet];
    along_ = dominant_axis(p, q);
    if (along_ < 0) return;
    const int direction = exact::cross_sign(p, q, along_);  // of n_p x n_q along that axis
    const BoxTree *tree_f = touched_.edge_tree[i].get(), *tree_g = touched_.edge_tree[j].get();
    find_stops(f, g, tree_f, direction, on_f_);
    find_stops(g, f, tree_g, -direction, on_g_);
    if ((on_f_.stops.empty() && (!tree_f || on_g_.stops.empty())) || (on_g_.stops.empty() && !tree_g)) return;
    if (tree_f) anchor(f, g.sheet, *tree_f, on_f_, on_f_.stops.empty() ? on_g_.stops[0].vertex : on_f_.stops[0].vertex);
    if (tree_g) anchor(g, f.sheet, *tree_g, on_g_, on_g_.stops.empty() ? on_f_.stops[0].vertex : on_g_.stops[0].vertex);
    open_segments(on_f_);
    open_segments(on_g_);
    reverse(on_g_);
    overlap(direction, f.sheet, g.sheet);
  }

 private:
  /// An axis in which the line of the two planes runs, preferably the steepest; -1 for parallel planes.
  int dominant_axis(const exact::Plane& p, const exact::Plane& q) const {
    const auto a = exact::approximation(p).n, b = exact::approximation(q).n;
    std::array<double, 3> c{};
    for (std::size_t k = 0; k < 3; ++k)
      c[k] = std::fabs(a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3]);
    const int best = static_cast<int>(std::max_element(c.begin(), c.end()) - c.begin());
    for (int k = 0; k < 3; ++k)
      if (exact::cross_sign(p, q, (best + k) % 3) != 0) return (best + k) % 3;
    return -1;
  }

  const std::array<double, 3>& approximation(std::uint32_t v) const {
    return v & local_bit ? points[v & ~local_bit].approximation : vertices_.approximation(v);
  }
  exact::Point point(std::uint32_t v) const { return v & local_bit ? points[v & ~local_bit] : vertices_.point(v); }

  /// Order along the axis of the current line: equal exactly for equal points, both being on the line.
  int compare(std::uint32_t u, std::uint32_t v) const { return compare_in(along_, u, v); }

  /// The stops of face f on the plane of g, in the order of n_f x n_g (canonical normals).
  ///
  /// Left of that direction g's plane is negative: its value grows along n_g, and
  /// n_g . (n_f x (n_f x n_g)) = (n_f . n_g)^2 - |n_f|^2 |n_g|^2 < 0. So on the strip just left of the
  /// line a vertex on the plane counts as positive, on the strip just right of it as negative, and an edge that goes
  /// from negative to positive, having the face on its left (seen from +n_f), enters the face.
  ///
  /// Of a face with an edge tree only the stops within the other face's box are found, and all of those: the crossing
  /// of an edge lies in the edge's box.
  void find_stops(const TouchedFace& f, const TouchedFace& g, const BoxTree* tree, int direction, Trace& trace) {
    trace.stops.clear();
    trace.left = trace.right = 0;
    if (tree) {
      tree->meeting(g.box, [&](std::uint32_t e) { add_stops(f, touched_.edges[e], g.sheet, trace.stops); });
    } else {
      for (std::uint32_t e = f.edges_begin; e < f.edges_end; ++e) add_stops(f, touched_.edges[e], g.sheet, trace.stops);
    }
    for (std::uint32_t i = f.isolated_begin; i < f.isolated_end; ++i)
      if (side(touched_.isolated[i], g.sheet) == 0) trace.stops.push_back({touched_.isolated[i], 0, 0, false});
    if (tree) std::erase_if(trace.stops, [&](const Stop& s) { return !contains(g.box, approximation(s.vertex)); });
    merge(direction, trace.stops);
  }

  int side(std::uint32_t v, std::uint32_t plane) const {
    return vertices_.side(v, planes_[plane], planes_.approximation(plane));
  }

  static bool contains(const Box& box, const std::array<double, 3>& p) {
    for (std::size_t k = 0; k < 3; ++k)
      if (p[k] < box.low[k] || p[k] > box.high[k]) return false;
    return true;
  }

  void add_stops(const TouchedFace& f, const BoundaryEdge& edge, std::uint32_t sheet, std::vector<Stop>& stops) {
    const int turn = f.along ? 1 : -1;  // boundary edges have the face on their left seen from its outward normal
    const int su = side(edge.from, sheet), sv = side(edge.to, sheet);
    const int left = turn * ((su < 0 && sv >= 0) - (su >= 0 && sv < 0));
    const int right = turn * ((su <= 0 && sv > 0) - (su > 0 && sv <= 0));
    if (su * sv < 0) {
      stops.push_back({crossing(f, edge, sheet), left, right, false});
    } else {
      if (su == 0) stops.push_back({edge.from, left, right, false});
      if (sv == 0) stops.push_back({edge.to, su == 0 ? 0 : left, su == 0 ? 0 : right, false});
    }
  }

  /// Sorts the stops along the line and joins equal ones.
  void merge(int direction, std::vector<Stop>& stops) const {
    if (stops.size() == 2) {
      if (compare(stops[0].vertex, stops[1].vertex) * direction > 0) std::swap(stops[0], stops[1]);
    } else {
      std::sort(stops.begin(), stops.end(),
                [&](const Stop& a, const Stop& b) { return compare(a.vertex, b.vertex) * direction < 0; });
    }
    std::size_t n = 0;
    for (const Stop& s : stops) {
      if (n > 0 && compare(stops[n - 1].vertex, s.vertex) == 0) {
        stops[n - 1].left += s.left;
        stops[n - 1].right += s.right;
        if (!(s.vertex & local_bit)) stops[n - 1].vertex = s.vertex;
      } else {
        stops[n++] = s;
      }
    }
    stops.resize(n);
  }

  /// The states of a large face before its first stop. The first net crossing of a strip tells: whoever leaves was
  /// inside. Without one the strip's state is the same everywhere near, and is asked for at one point of the line.
  void anchor(const TouchedFace& f, std::uint32_t sheet, const BoxTree& tree, Trace& trace, std::uint32_t at) {
    const auto first = [&](int Stop::*strip) {
      for (const Stop& s : trace.stops)
        if (s.*strip != 0) return s.*strip > 0 ? 0 : 1;
      return -1;
    };
    trace.left = first(&Stop::left);
    trace.right = first(&Stop::right);
    if (trace.left < 0) trace.left = covered(f, sheet, tree, at, 1);
    if (trace.right < 0) trace.right = covered(f, sheet, tree, at, -1);
  }

  /// Does the face cover the point at + t (n_f x n_sheet) + t^2 l, for an infinitely small t > 0 and l pointing to the
  /// left (strip 1) or right (strip -1) of that line? Counts the boundary edges straight below, each with the change of
  /// coverage from below to above it.
  int covered(const TouchedFace& f, std::uint32_t sheet, const BoxTree& tree, std::uint32_t at, int strip) {
    const exact::Plane &p = planes_[f.sheet], &q = planes_[sheet];
    const Frame frame(p);
    const int forward_u = exact::cross_sign(p, q, frame.u()), forward_v = exact::cross_sign(p, q, frame.v());
    // Where the line runs straight up its left is towards smaller u.
    const int shift_u = forward_u != 0 ? forward_u : -forward_v * strip;
    const exact::Point x = point(at);
    Box below;
    below.add(x.approximation);
    for (int k = 0; k < 3; ++k) {
      const auto i = static_cast<std::size_t>(k);
      if (k == frame.u()) continue;
      below.low[i] = INT32_MIN;
      if (k != frame.v()) below.high[i] = INT32_MAX;
    }
    int count = 0;
    tree.meeting(below, [&](std::uint32_t e) {
      const BoundaryEdge& edge = touched_.edges[e];
      const auto beyond = [&](std::uint32_t v) {  // the vertex lies at larger u than the shifted point
        const int c = compare_in(frame.u(), v, at);
        return c != 0 ? c > 0 : shift_u < 0;
      };
      const bool from = beyond(edge.from), to = beyond(edge.to);
      if (from == to) return;
      const exact::Plane& line = planes_[edge.other];
      // Left of n_p x n_line is where the line's plane is negative; `rightward` turns that direction towards larger u.
      const int rightward = frame.direction(p, line);
      int above = -rightward * (at & local_bit ? exact::side(line, x) : side(at, edge.other));
      if (above == 0) above = rightward * exact::turn(p, line, q);  // the line of the strips turns left of the edge's
      if (above == 0) above = frame.direction(p, q) * strip;        // the edge runs along the line
      if (above > 0) count += (to == f.along) ? 1 : -1;
    });
    return count > 0 ? 1 : 0;
  }

  int compare_in(int axis, std::uint32_t u, std::uint32_t v) const {
    const auto k = static_cast<std::size_t>(axis);
    const double a = approximation(u)[k], b = approximation(v)[k];
    if (a != b) return a < b ? -1 : 1;
    return u == v ? 0 : exact::compare_along(axis, point(u), point(v));
  }

  static void open_segments(Trace& trace) {
    int left = trace.left, right = trace.right;
    trace.open = left > 0 || right > 0;
    for (Stop& s : trace.stops) {
      left += s.left;
      right += s.right;
      s.open = left > 0 || right > 0;
    }
  }

  static void reverse(Trace& trace) {
    // The segment before stop i becomes the one after it.
    bool before = trace.open;
    for (Stop& s : trace.stops) std::swap(before, s.open);
    trace.open = before;
    std::reverse(trace.stops.begin(), trace.stops.end());
  }

  /// Both faces at an edge ask for its crossing with a plane, mostly soon after each other.
  std::uint32_t crossing(const TouchedFace& f, const BoundaryEdge& e, std::uint32_t plane) {
    const std::uint32_t low = std::min(e.from, e.to), high = std::max(e.from, e.to);
    Crossing& known = crossings_[(low * 31 + high * 17 + plane) % crossings_.size()];
    if (known.low == low && known.high == high && known.plane == plane) return known.point;
    const exact::Plane& q = planes_[plane];
    if (vertices_.is_grid(low) && vertices_.is_grid(high)) {
      const exact::GridPoint u = vertices_.grid_point(low), v = vertices_.grid_point(high);
      points.push_back(exact::meet(u, exact::value(q, u), v, exact::value(q, v)));
    } else {
      points.push_back(*exact::meet(planes_[f.sheet], planes_[e.other], q));
    }
    known = {low, high, plane, static_cast<std::uint32_t>(points.size() - 1) | local_bit};
    return known.point;
  }

  /// Intersects the two closed sets on the line and posts what is left to both sheets.
  void overlap(int direction, std::uint32_t sheet_f, std::uint32_t sheet_g) {
    std::size_t i = 0, j = 0;
    const std::vector<Stop>&f = on_f_.stops, &g = on_g_.stops;
    bool in_f = on_f_.open, in_g = on_g_.open;
    std::uint32_t open_from = none;
    while (i < f.size() || j < g.size()) {
      const int order = i == f.size() ? 1 : j == g.size() ? -1 : compare(f[i].vertex, g[j].vertex) * direction;
      const bool at_f = order <= 0, at_g = order >= 0;
      // A vertex of the table is preferred as the name of the point.
      std::uint32_t v = at_f ? f[i].vertex : g[j].vertex;
      if (at_f && at_g && (v & local_bit)) v = g[j].vertex;
      const bool here = (at_f || in_f) && (at_g || in_g);
      if (at_f) in_f = f[i++].open;
      if (at_g) in_g = g[j++].open;
      if (!here) continue;
      const bool closes = open_from != none;
      if (closes) post(open_from, v, sheet_f, sheet_g);
      open_from = in_f && in_g ? v : none;
      if (!closes && open_from == none) post(v, sheet_f, sheet_g);
    }
  }

  void post(std::uint32_t a, std::uint32_t b, std::uint32_t sheet_f, std::uint32_t sheet_g) {
    contacts.segments.push_back({sheet_f, a, b, sheet_g});
    contacts.segments.push_back({sheet_g, a, b, sheet_f});
  }
  void post(std::uint32_t v, std::uint32_t sheet_f, std::uint32_t sheet_g) {
    contacts.points.push_back({sheet_f, v});
    contacts.points.push_back({sheet_g, v});
  }

  struct Crossing {
    std::uint32_t low = none, high = none, plane = none, point = none;
  };

  const TouchedFaces& touched_;
  const VertexTable& vertices_;
  const PlaneTable& planes_;
  std::array<Crossing, 256> crossings_;  // the last ones, by a hash
  int along_ = 0;
  Trace on_f_, on_g_;
};

}  // namespace

std::vector<FacePair> touched_pairs(const TouchedFaces& touched, const std::vector<FaceIdPair>& near) {
  std::vector<FacePair> pairs;
  pairs.reserve(near.size());
  for (const FaceIdPair& p : near) {
    const std::uint32_t f = touched.face_of[p[0]], g = touched.face_of[p[1]];
    if (f != g) pairs.push_back({std::min(f, g), std::max(f, g)});
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

Contacts find_contacts(const TouchedFaces& touched, const std::vector<FacePair>& pairs, VertexTable& vertices,
                       const PlaneTable& planes) {
  // Fixed chunks, results in slots, points named in chunk order: the same ids for any number of threads.
  constexpr std::size_t chunk = 512;
  std::vector<Worker> workers((pairs.size() + chunk - 1) / chunk, Worker(touched, vertices, planes));
  grid::in_stretches(pairs.size(), chunk, [&](std::size_t c, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) workers[c].meet(pairs[i][0], pairs[i][1]);
  });
  Contacts all;
  for (Worker& w : workers) {
    std::vector<std::uint32_t> names(w.points.size(), none);
    const auto named = [&](std::uint32_t v) {
      if (!(v & local_bit)) return v;
      std::uint32_t& name = names[v & ~local_bit];
      if (name == none) name = vertices.id(w.points[v & ~local_bit]);
      return name;
    };
    for (SheetSegment s : w.contacts.segments) {
      s.a = named(s.a);
      s.b = named(s.b);
      all.segments.push_back(s);
    }
    for (const SheetPoint& p : w.contacts.points) all.points.push_back({p.sheet, named(p.vertex)});
    w.points = {};
    w.contacts = {};
  }
  return all;
}

}  // namespace quoin::booleans
