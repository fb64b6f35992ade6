#include "booleans/export.h"

#include <atomic>
#include <numeric>

#include "booleans/around_edge.h"
#include "booleans/arrangement.h"
#include "booleans/fans.h"
#include "booleans/triangulate.h"
#include "grid/balance.h"
#include "grid/stretches.h"

namespace quoin::booleans {
namespace {

/// The corners of one polygon seen in its own plane, by local ids.
class PlanePoints {
 public:
  PlanePoints(const Body& body, const exact::Plane& plane, const std::vector<std::uint32_t>& ids)
      : plane_(plane), frame_(plane) {
    points_.reserve(ids.size());
    for (std::uint32_t v : ids) {
      points_.push_back(body.point(v));
      all_grid_ = all_grid_ && body.is_grid(v);
    }
  }
  int compare(std::uint32_t a, std::uint32_t b) const {
    if (a == b) return 0;
    if (const int c = exact::compare_along(frame_.u(), points_[a], points_[b])) return c;
    return exact::compare_along(frame_.v(), points_[a], points_[b]);
  }
  int orientation(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    if (!all_grid_) return exact::orientation_in_plane(plane_, points_[a], points_[b], points_[c]);
    const auto p = planar(a), q = planar(b), r = planar(c);
    const std::int64_t det = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);  // below 2^61
    return det > 0 ? 1 : det < 0 ? -1 : 0;
  }
  /// Approximate coordinates for shape decisions.
  std::array<double, 2> approximate(std::uint32_t a) const {
    const auto& p = points_[a].approximation;
    return {p[static_cast<std::size_t>(frame_.u())], p[static_cast<std::size_t>(frame_.v())]};
  }

 private:
  std::array<std::int64_t, 2> planar(std::uint32_t a) const {
    const auto p = approximate(a);
    return {static_cast<std::int64_t>(p[0]), static_cast<std::int64_t>(p[1])};
  }
  exact::Plane plane_;
  Frame frame_;
  Scratch<exact::Point> points_;
  bool all_grid_ = true;
};

/// Triangulates polygons of a body, each with the memory of those before.
class Triangulator {
 public:
  explicit Triangulator(const Body& body) : body_(body) {}

  /// Appends the corners of the triangles of polygon p.
  void add(std::uint32_t p, std::vector<std::uint32_t>& out) {
    const std::uint32_t first = body_.polygon_loops[p], last = body_.polygon_loops[p + 1];
    if (const auto loop = body_.loop(first); last == first + 1 && loop.size() == 3) {
      out.insert(out.end(), loop.begin(), loop.end());
      return;
    }
    ids_.assign(body_.corners.begin() + body_.loop_corners[first], body_.corners.begin() + body_.loop_corners[last]);
    std::sort(ids_.begin(), ids_.end());
    ids_.erase(std::unique(ids_.begin(), ids_.end()), ids_.end());
    edges_.clear();
    isolated_.clear();
    for (std::uint32_t j = first; j < last; ++j) {
      const auto loop = body_.loop(j);
      if (loop.size() == 1) isolated_.push_back(local(loop[0]));
      for (std::size_t i = 0; i < loop.size() && loop.size() > 1; ++i)
        edges_.push_back({local(loop[i]), local(loop[i + 1 < loop.size() ? i + 1 : 0])});
    }
    const PlanePoints points(body_, body_.planes[p], ids_);
    triangles_.clear();
    if (!(edges_.size() == 4 && ids_.size() == 4 && isolated_.empty() && last == first + 1 &&
          cut_quadrilateral(points))) {
      [[maybe_unused]] const bool closed =
          triangulate(points, static_cast<std::uint32_t>(ids_.size()), edges_, isolated_, triangles_);
      assert(closed);
      if (triangles_.size() > 1) {
        shape_.resize(ids_.size());
        for (std::uint32_t i = 0; i < shape_.size(); ++i) shape_[i] = points.approximate(i);
        improve_triangles(points, edges_, shape_, triangles_);
      }
    }
    for (const FaceTriangle& t : triangles_)
      for (const std::uint32_t corner : t) out.push_back(ids_[corner]);
  }

 private:
  std::uint32_t local(std::uint32_t v) const {
    return static_cast<std::uint32_t>(std::lower_bound(ids_.begin(), ids_.end(), v) - ids_.begin());
  }

  /// Two triangles for a loop of four corners; false when neither diagonal leaves two proper ones.
  bool cut_quadrilateral(const PlanePoints& points) {
    // From the first corner in the plane's own order, wherever the loop begins.
    std::array<std::uint32_t, 4> c{};
    std::size_t first = 0;
    for (std::size_t i = 1; i < 4; ++i)
      if (points.compare(edges_[i][0], edges_[first][0]) < 0) first = i;
    for (std::size_t i = 0; i < 4; ++i) c[i] = edges_[(first + i) % 4][0];
    const auto proper = [&](std::size_t i) {  // the diagonal from corner i
      return points.orientation(c[i], c[i + 1], c[i + 2]) > 0 && points.orientation(c[i + 2], c[(i + 3) % 4], c[i]) > 0;
    };
    const bool even = proper(0), odd = proper(1);
    if (!even && !odd) return false;
    const auto at = [&](std::size_t i) { return points.approximate(c[i]); };
    if (even && !(odd && prefers_other_diagonal(at(2), at(0), at(1), at(3))))
      triangles_ = {{c[0], c[1], c[2]}, {c[2], c[3], c[0]}};
    else
      triangles_ = {{c[1], c[2], c[3]}, {c[3], c[0], c[1]}};
    return true;
  }

  const Body& body_;
  std::vector<std::uint32_t> ids_, isolated_;
  std::vector<FaceEdge> edges_;
  std::vector<FaceTriangle> triangles_;
  std::vector<std::array<double, 2>> shape_;
};

/// The triangles of some polygons, in order.
struct Pieces {
  std::vector<std::uint32_t> corners, face;
};

void add_polygons(const Body& body, const std::vector<std::uint32_t>& polygons, Triangulated& mesh) {
  constexpr std::size_t batch = 64;
  std::vector<Pieces> batches((polygons.size() + batch - 1) / batch);
  grid::in_stretches(polygons.size(), batch, [&](std::size_t b, std::size_t begin, std::size_t end) {
    Triangulator triangulator(body);
    Pieces& pieces = batches[b];
    for (std::size_t i = begin; i < end; ++i) {
      triangulator.add(polygons[i] - static_cast<std::uint32_t>(body.triangles.size()), pieces.corners);
      pieces.face.resize(pieces.corners.size() / 3, polygons[i]);
    }
  });
  std::size_t total = mesh.triangle_count();
  for (const Pieces& p : batches) total += p.face.size();
  mesh.corners.reserve(3 * total);
  mesh.face.reserve(total);
  for (const Pieces& p : batches) {
    mesh.corners.insert(mesh.corners.end(), p.corners.begin(), p.corners.end());
    mesh.face.insert(mesh.face.end(), p.face.begin(), p.face.end());
  }
}

/// The next corner of the same triangle.
std::uint32_t next_corner(std::uint32_t c) { return c % 3 == 2 ? c - 2 : c + 1; }

/// All directed edges of a mesh, triangle by triangle, sorted by their undirected edge.
struct EdgeList {
  struct Entry {
    std::uint32_t low, high, corner;  // corner 3 t + k: the edge from corner k to the next
  };
  std::vector<Entry> entries;

  explicit EdgeList(const Triangulated& mesh) {
    std::uint32_t n = 0;
    for (const std::uint32_t v : mesh.corners) n = std::max(n, v + 1);
    std::vector<std::uint32_t> start(n + 1);
    const auto for_edges = [&](auto&& visit) {
      for (std::uint32_t c = 0; c < mesh.corners.size(); ++c) {
        const std::uint32_t u = mesh.corners[c], v = mesh.corners[next_corner(c)];
        visit(Entry{std::min(u, v), std::max(u, v), c});
      }
    };
    for_edges([&](const Entry& e) { ++start[e.low + 1]; });
    std::partial_sum(start.begin(), start.end(), start.begin());
    entries.resize(start.back());
    std::vector<std::uint32_t> at(start.begin(), start.end() - 1);
    for_edges([&](const Entry& e) { entries[at[e.low]++] = e; });
    for (std::uint32_t v = 0; v < n; ++v)
      std::sort(entries.begin() + start[v], entries.begin() + start[v + 1], [](const Entry& a, const Entry& b) {
        return a.high != b.high ? a.high < b.high : a.corner < b.corner;
      });
  }
  template <class Visit>
  void for_runs(Visit&& visit) const {
    for (std::size_t i = 0, j = 0; i < entries.size(); i = j) {
      while (j < entries.size() && entries[j].low == entries[i].low && entries[j].high == entries[i].high) ++j;
      visit(std::span(entries).subspan(i, j - i));
    }
  }
};

}  // namespace

Triangulated triangulated(const Body& body) {
  Triangulated mesh;
  const auto raw = static_cast<std::uint32_t>(body.triangles.size());
  mesh.corners.reserve(3 * std::size_t{raw});
  mesh.face.reserve(raw);
  std::vector<std::uint32_t> polygons;
  const auto append = [](std::vector<std::uint32_t>& list, std::uint32_t begin, std::uint32_t end) {
    const std::size_t size = list.size();
    list.resize(size + (end - begin));
    std::iota(list.begin() + static_cast<std::ptrdiff_t>(size), list.end(), begin);
  };
  body.for_runs([&](std::uint32_t begin, std::uint32_t end) {
    const std::uint32_t middle = std::clamp(raw, begin, end);
    append(mesh.face, begin, middle);
    append(polygons, middle, end);
    const auto own = grid::corners_of(std::span(body.triangles).subspan(begin, middle - begin));
    mesh.corners.insert(mesh.corners.end(), own.begin(), own.end());
  });
  add_polygons(body, polygons, mesh);
  std::vector<std::uint8_t> used(body.vertex_count());
  for (const std::uint32_t v : mesh.corners) used[v] = 1;
  const auto count = static_cast<std::size_t>(std::count(used.begin(), used.end(), 1));
  mesh.source.resize(count);
  if (count == used.size()) {
    std::iota(mesh.source.begin(), mesh.source.end(), 0u);
    return mesh;
  }
  std::vector<std::uint32_t> id(used.size());
  for (std::uint32_t v = 0, i = 0; v < used.size(); ++v)
    if (used[v]) mesh.source[i] = v, id[v] = i++;
  for (std::uint32_t& v : mesh.corners) v = id[v];
  return mesh;
}

namespace {

/// Glues the triangles of a mesh in pairs over its edges.
class Separator {
 public:
  Separator(const Body& body, const Triangulated& mesh) : mesh_(mesh), edges_(mesh) {
    edges_.for_runs([&](std::span<const EdgeList::Entry> run) {
      if (run.size() == 1) return;  // its other triangle has no part in this
      if (run.size() == 2)
        pairs_.push_back({run[0].corner, run[1].corner});
      else
        crowded_.push_back({around(body, run), false});
    });
  }

  /// The corners of each vertex of the separated mesh.
  Partition glued() const {
    Partition corners(mesh_.corners.size());
    const auto glue = [&](const Pair& p) {
      corners.unite(p[0], next_corner(p[1]));
      corners.unite(next_corner(p[0]), p[1]);
    };
    for (const Pair& p : pairs_) glue(p);
    for (const Crowd& c : crowded_)
      for (const Pair& p : paired(c)) glue(p);
    return corners;
  }

  /// Turns the pairing at edges where two pairs have the same two vertices; false when there are none to turn.
  bool turn_equal_edges(Partition& corners) {
    bool any = false;
    for (Crowd& c : crowded_) {
      std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;
      for (const Pair& p : paired(c)) ends.push_back(std::minmax(corners.find(p[0]), corners.find(next_corner(p[0]))));
      std::sort(ends.begin(), ends.end());
      if (c.outside || std::adjacent_find(ends.begin(), ends.end()) == ends.end()) continue;
      c.outside = any = true;
    }
    return any;
  }

 private:
  using Pair = std::array<std::uint32_t, 2>;  // corners whose edges are glued
  struct Crowd {
    std::vector<std::uint32_t> corners;  // counter-clockwise around the edge
    bool outside;                        // paired over the outside's wedges
  };

  bool forward(std::uint32_t c) const { return mesh_.corners[c] < mesh_.corners[next_corner(c)]; }

  std::vector<std::uint32_t> around(const Body& body, std::span<const EdgeList::Entry> run) const {
    std::vector<std::uint32_t> order(run.size());
    std::iota(order.begin(), order.end(), 0u);
    std::vector<exact::Plane> planes;
    for (const auto& e : run) planes.push_back(body.plane(mesh_.face[e.corner / 3]));
    const exact::Point low = body.point(mesh_.source[run[0].low]), high = body.point(mesh_.source[run[0].high]);
    int axis = -1, direction = 0;
    while (direction == 0) direction = exact::compare_along(++axis, high, low);
    sort_around(
        order, axis, direction, [&](std::uint32_t i) -> const exact::Plane& { return planes[i]; },
        [&](std::uint32_t i) { return forward(run[i].corner); });
    for (std::uint32_t& i : order) i = run[i].corner;
    return order;
  }

  /// The solid lies counter-clockwise after a triangle that runs backward, and before one that runs forward.
  std::vector<Pair> paired(const Crowd& c) const {
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < c.corners.size(); ++i) {
      const std::uint32_t a = c.corners[i], b = c.corners[i + 1 < c.corners.size() ? i + 1 : 0];
      if (forward(a) == c.outside && forward(b) != c.outside) pairs.push_back({a, b});
    }
    return pairs;
  }

  const Triangulated& mesh_;
  const EdgeList edges_;
  std::vector<Pair> pairs_;
  std::vector<Crowd> crowded_;
};

}  // namespace

Triangulated separated(const Body& body, Triangulated mesh, Pairing pairing) {
  // Only vertices of several fans are split, so only their triangles take part.
  std::vector<std::uint8_t> several(mesh.source.size());
  std::atomic<bool> any = false;
  grid::in_shares(several.size(), [&](std::size_t begin, std::size_t end) {
    Spokes spokes(mesh.corners, begin, end, [](std::uint32_t) { return true; });
    for (auto v = static_cast<std::uint32_t>(begin); v < end; ++v)
      if (!is_one_fan(spokes.at(v))) several[v] = any = true;
  });
  if (!any) return mesh;
  Triangulated part;
  part.source = mesh.source;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto c = mesh.triangle(t);
    if (!several[c[0]] && !several[c[1]] && !several[c[2]]) continue;
    part.corners.insert(part.corners.end(), c.begin(), c.end());
    part.face.push_back(mesh.face[t]);
  }

  Separator separator(body, part);
  Partition corners = separator.glued();
  // An edge is turned once, for good; turning may make others equal, so a few rounds follow.
  for (int round = 0; round < 4 && pairing == Pairing::by_distinct_edges; ++round) {
    if (!separator.turn_equal_edges(corners)) break;
    corners = separator.glued();
  }
  // Vertices keep their order; the fans of one vertex follow each other in the order of their first corners.
  std::vector<std::array<std::uint32_t, 2>> fans;  // (vertex, first corner)
  for (std::uint32_t c = 0; c < part.corners.size(); ++c)
    if (several[part.corners[c]] && corners.find(c) == c) fans.push_back({part.corners[c], c});
  std::sort(fans.begin(), fans.end());
  std::vector<std::uint32_t> id_of_vertex(mesh.source.size()), id_of_corner(part.corners.size());
  std::vector<std::uint32_t> source;
  for (std::uint32_t v = 0, f = 0; v < mesh.source.size(); ++v) {
    id_of_vertex[v] = static_cast<std::uint32_t>(source.size());
    if (!several[v]) source.push_back(mesh.source[v]);
    for (; f < fans.size() && fans[f][0] == v; ++f) {
      id_of_corner[fans[f][1]] = static_cast<std::uint32_t>(source.size());
      source.push_back(mesh.source[v]);
    }
  }
  std::uint32_t c = 0;  // corners of part come in the mesh's order
  for (std::size_t t = 0; t < mesh.corners.size(); t += 3) {
    const auto own = std::span(mesh.corners).subspan(t, 3);
    const bool in_part = several[own[0]] || several[own[1]] || several[own[2]];
    for (std::uint32_t& v : own) {
      v = several[v] ? id_of_corner[corners.find(c)] : id_of_vertex[v];
      c += in_part ? 1 : 0;
    }
  }
  mesh.source = std::move(source);
  return mesh;
}

Shells shells(const Triangulated& mesh) {
  Partition parts(mesh.source.size());
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    const auto t = mesh.triangle(i);
    parts.unite(t[0], t[1]);
    parts.unite(t[0], t[2]);
  }
  Shells r;
  for (std::uint32_t v = 0; v < mesh.source.size(); ++v) r.count += parts.find(v) == v;
  // V - E + F = 2 (shells - genus), E = 3 F / 2.
  const auto v = static_cast<std::int64_t>(mesh.source.size()), f = static_cast<std::int64_t>(mesh.triangle_count());
  r.genus = static_cast<std::int64_t>(r.count) - (v - f / 2) / 2;
  return r;
}

}  // namespace quoin::booleans
