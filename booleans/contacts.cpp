#include "booleans/contacts.h"

#include <tbb/parallel_for.h>

namespace quoin::booleans {
namespace {

/// Ids with this bit name a point of the worker's own, not yet in the table.
constexpr std::uint32_t local_bit = 0x80000000u;

/// A place where the line of two planes meets the boundary of a face.
struct Stop {
  std::uint32_t vertex;
  int left, right;  // net boundary crossings of the strips just left and just right of the line: entering +1
  bool open;        // the segment from here to the next stop lies in the closed face
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
    if (f.sheet == g.sheet) return;
    const exact::Plane &p = planes_[f.sheet], &q = planes_[g.sheet];
    along_ = dominant_axis(p, q);
    if (along_ < 0) return;
    const int direction = exact::cross_sign(p, q, along_);  // of n_p x n_q along that axis
    if (!trace(f, g.sheet, direction, on_f_) || !trace(g, f.sheet, -direction, on_g_)) return;
    reverse(on_g_);
    overlap(direction, f.sheet, g.sheet);
  }

 private:
  /// An axis in which the line of the two planes runs, preferably the steepest; -1 for parallel planes.
  int dominant_axis(const exact::Plane& p, const exact::Plane& q) const {
    const auto a = exact::approximation(p).n, b = exact::approximation(q).n;
    std::array<double, 3> c{};
    for (std::size_t k = 0; k < 3; ++k) c[k] = std::fabs(a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3]);
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
  int compare(std::uint32_t u, std::uint32_t v) const {
    const auto k = static_cast<std::size_t>(along_);
    const double a = approximation(u)[k], b = approximation(v)[k];
    if (a != b) return a < b ? -1 : 1;
    return u == v ? 0 : exact::compare_along(along_, point(u), point(v));
  }

  /// The stops of face f on the plane of a sheet, in the order of n_f x n_sheet (canonical normals).
  ///
  /// Left of that direction the sheet's plane is negative: its value grows along n_sheet, and
  /// n_sheet . (n_f x (n_f x n_sheet)) = (n_f . n_sheet)^2 - |n_f|^2 |n_sheet|^2 < 0. So on the strip just left of the
  /// line a vertex on the plane counts as positive, on the strip just right of it as negative, and an edge that goes
  /// from negative to positive, having the face on its left (seen from +n_f), enters the face.
  bool trace(const TouchedFace& f, std::uint32_t sheet, int direction, std::vector<Stop>& stops) {
    stops.clear();
    const exact::Plane& q = planes_[sheet];
    const exact::PlaneApproximation& qa = planes_.approximation(sheet);
    const int turn = f.along ? 1 : -1;  // boundary edges have the face on their left seen from its outward normal
    for (std::uint32_t e = f.edges_begin; e < f.edges_end; ++e) {
      const BoundaryEdge& edge = touched_.edges[e];
      const int su = vertices_.side(edge.from, q, qa), sv = vertices_.side(edge.to, q, qa);
      const int left = turn * ((su < 0 && sv >= 0) - (su >= 0 && sv < 0));
      const int right = turn * ((su <= 0 && sv > 0) - (su > 0 && sv <= 0));
      if (su * sv < 0) {
        stops.push_back({crossing(f, edge, q), left, right, false});
      } else {
        if (su == 0) stops.push_back({edge.from, left, right, false});
        if (sv == 0) stops.push_back({edge.to, su == 0 ? 0 : left, su == 0 ? 0 : right, false});
      }
    }
    for (std::uint32_t i = f.isolated_begin; i < f.isolated_end; ++i)
      if (vertices_.side(touched_.isolated[i], q, qa) == 0) stops.push_back({touched_.isolated[i], 0, 0, false});
    if (stops.empty()) return false;
    merge(direction, stops);
    return true;
  }

  /// Sorts the stops along the line, joins equal ones and finds the open segments.
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
    int left = 0, right = 0;
    for (Stop& s : stops) {
      left += s.left;
      right += s.right;
      s.open = left > 0 || right > 0;
    }
  }

  static void reverse(std::vector<Stop>& stops) {
    std::reverse(stops.begin(), stops.end());
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) stops[i].open = stops[i + 1].open;
    stops.back().open = false;
  }

  std::uint32_t crossing(const TouchedFace& f, const BoundaryEdge& e, const exact::Plane& q) {
    if (vertices_.is_grid(e.from) && vertices_.is_grid(e.to)) {
      const exact::GridPoint u = vertices_.grid_point(e.from), v = vertices_.grid_point(e.to);
      points.push_back(exact::meet(u, exact::value(q, u), v, exact::value(q, v)));
    } else {
      points.push_back(*exact::meet(planes_[f.sheet], planes_[e.other], q));
    }
    return static_cast<std::uint32_t>(points.size() - 1) | local_bit;
  }

  /// Intersects the two closed sets on the line and posts what is left to both sheets.
  void overlap(int direction, std::uint32_t sheet_f, std::uint32_t sheet_g) {
    std::size_t i = 0, j = 0;
    bool in_f = false, in_g = false;
    std::uint32_t open_from = none;
    while (i < on_f_.size() || j < on_g_.size()) {
      const int order = i == on_f_.size()   ? 1
                        : j == on_g_.size() ? -1
                                            : compare(on_f_[i].vertex, on_g_[j].vertex) * direction;
      const bool at_f = order <= 0, at_g = order >= 0;
      // A vertex of the table is preferred as the name of the point.
      std::uint32_t v = at_f ? on_f_[i].vertex : on_g_[j].vertex;
      if (at_f && at_g && (v & local_bit)) v = on_g_[j].vertex;
      const bool here = (at_f || in_f) && (at_g || in_g);
      if (at_f) in_f = on_f_[i++].open;
      if (at_g) in_g = on_g_[j++].open;
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

  const TouchedFaces& touched_;
  const VertexTable& vertices_;
  const PlaneTable& planes_;
  int along_ = 0;
  std::vector<Stop> on_f_, on_g_;
};

}  // namespace

Contacts find_contacts(const TouchedFaces& touched, const std::vector<FacePair>& pairs, VertexTable& vertices,
                       const PlaneTable& planes) {
  // Fixed chunks, results in slots, points named in chunk order: the same ids for any number of threads.
  constexpr std::size_t chunk = 512;
  std::vector<Worker> workers((pairs.size() + chunk - 1) / chunk, Worker(touched, vertices, planes));
  tbb::parallel_for(std::size_t{0}, workers.size(), [&](std::size_t c) {
    for (std::size_t i = c * chunk; i < std::min(pairs.size(), (c + 1) * chunk); ++i) workers[c].meet(pairs[i][0], pairs[i][1]);
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
