#include "booleans/surface/separated.h"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <numeric>

#include "booleans/body/around_edge.h"
#include "booleans/body/fans.h"
#include "booleans/surface/corners.h"
#include "grid/lists/buckets.h"
#include "grid/lists/loops.h"
#include "grid/lists/partition.h"
#include "grid/lists/stretches.h"

namespace quoin::booleans {

using exact::Rational;

namespace {

/// As `is_one_fan`, for a closed mesh: where a triangle ends at a neighbour, one begins. So a walk needs no search:
/// `next` holds where the triangle that begins at a neighbour ends, of two that begin there one. The walk comes back to
/// its start after as many steps as there are triangles, not earlier, exactly when it has met all of them.
bool is_one_fan_of_closed(std::span<const Spoke> star, Array<std::uint32_t>& next) {
  if (star.empty()) return true;
  for (const Spoke& s : star) next[s.a] = s.b;
  std::uint32_t at = star[0].a;
  std::size_t steps = 0;
  do {
    at = next[at];
    ++steps;
  } while (at != none && at != star[0].a && steps <= star.size());
  for (const Spoke& s : star) next[s.a] = none;  // where a mesh is not closed, no other star's steps are taken
  return at == star[0].a && steps == star.size();
}

/// By vertex: do its triangles form several fans? Empty when those of no vertex do.
Array<std::uint8_t> with_several_fans(const Triangulated& mesh) {
  Array<std::uint8_t> several(mesh.vertex_count());
  std::atomic<bool> any = false;
  grid::in_shares(several.size(), [&](std::size_t begin, std::size_t end) {
    const grid::Buckets<Spoke> spokes_of = spokes(mesh.corners, begin, end, [](std::uint32_t) { return true; });
    Array<std::uint32_t> next(several.size(), none);
    for (auto v = static_cast<std::uint32_t>(begin); v < end; ++v)
      if (!is_one_fan_of_closed(spokes_of[v - begin], next)) several[v] = any = true;
  });

  if (!any) several.clear();
  return several;
}

/// The triangles at the vertices of several fans, as a mesh of their own: only these take part.
class ManyFans {
 public:
  ManyFans(const Triangulated& mesh, const Array<std::uint8_t>& several) : mesh_(mesh) {
    for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t) {
      const auto c = mesh.triangle(t);
      if (several[c[0]] || several[c[1]] || several[c[2]]) triangles_.push_back(t);
    }
  }

  std::uint32_t corner_count() const { return 3 * static_cast<std::uint32_t>(triangles_.size()); }
  /// The whole mesh's number of a corner of this part.
  std::uint32_t whole(std::uint32_t c) const { return 3 * triangles_[c / 3] + c % 3; }
  std::uint32_t vertex(std::uint32_t c) const { return mesh_.corners[whole(c)]; }
  std::uint32_t face(std::uint32_t c) const { return mesh_.face[triangles_[c / 3]]; }
  std::uint32_t body_vertex(std::uint32_t c) const { return mesh_.source[vertex(c)]; }
  /// Whether the edge that begins at a corner runs to the greater vertex.
  bool is_forward(std::uint32_t c) const { return vertex(c) < vertex(next_corner(c)); }

 private:
  const Triangulated& mesh_;
  std::vector<std::uint32_t> triangles_;  // ascending
};

/// Two triangles that hang together over an edge, by the corners where it begins in them.
using Joint = std::array<std::uint32_t, 2>;

/// All joints of a part.
struct Joints {
  std::vector<Joint> at_edges;                  // of two triangles
  std::vector<std::vector<Joint>> at_contacts;  // the same of each edge of more triangles
};

/// Corners of a part whose edges are one edge of the mesh, counter-clockwise around it.
std::vector<std::uint32_t> around_edge(const Body& body, const ManyFans& part,
                                       const std::vector<std::uint32_t>& corners) {
  std::vector<exact::Plane> planes;
  for (const std::uint32_t c : corners) planes.push_back(body.plane(part.face(c)));
  const std::uint32_t first = corners[0], last = next_corner(first);
  const exact::Point from = body.point(part.body_vertex(first)), to = body.point(part.body_vertex(last));
  int axis = -1, direction = 0;  // of the edge from its lower vertex to its higher one
  while (direction == 0) direction = exact::compare_along(++axis, to, from);
  if (!part.is_forward(first)) direction = -direction;

  std::vector<std::uint32_t> order(corners.size());
  std::iota(order.begin(), order.end(), 0u);
  sort_around(
      order, axis, direction, [&](std::uint32_t i) -> const exact::Plane& { return planes[i]; },
      [&](std::uint32_t i) { return part.is_forward(corners[i]); });
  for (std::uint32_t& i : order) i = corners[i];
  return order;
}

/// The pairs at one edge that bound one wedge of the solid each. The solid lies counter-clockwise after a triangle that
/// runs backward, and before one that runs forward.
std::vector<Joint> joints_by_wedges(const ManyFans& part, const std::vector<std::uint32_t>& around) {
  std::vector<Joint> joints;
  grid::for_loop_edges(around, [&](std::uint32_t a, std::uint32_t b) {
    if (!part.is_forward(a) && part.is_forward(b)) joints.push_back({a, b});
  });
  return joints;
}

/// Edges of which only one triangle has a part in this stay open: no fan of a vertex of several ends there.
Joints joints_of(const Body& body, const ManyFans& part, std::size_t vertex_count) {
  struct Edge {
    std::uint32_t high, corner;
  };
  grid::Buckets<Edge> edges(vertex_count, [&](auto&& visit) {
    for (std::uint32_t c = 0; c < part.corner_count(); ++c) {
      const std::uint32_t u = part.vertex(c), v = part.vertex(next_corner(c));
      visit(std::min(u, v), Edge{std::max(u, v), c});
    }
  });

  Joints all;
  std::vector<std::uint32_t> corners;
  for (std::size_t low = 0; low < edges.size(); ++low) {
    const auto own = edges[low];
    std::sort(own.begin(), own.end(),
              [](const Edge& a, const Edge& b) { return a.high != b.high ? a.high < b.high : a.corner < b.corner; });
    for (std::size_t i = 0, j = 0; i < own.size(); i = j) {
      corners.clear();
      for (; j < own.size() && own[j].high == own[i].high; ++j) corners.push_back(own[j].corner);
      if (corners.size() == 2) all.at_edges.push_back({corners[0], corners[1]});
      if (corners.size() > 2) all.at_contacts.push_back(joints_by_wedges(part, around_edge(body, part, corners)));
    }
  }
  return all;
}

/// The corners of the part that are one vertex of the separated mesh.
grid::Partition fans(const ManyFans& part, const Joints& joints) {
  grid::Partition corners(part.corner_count());
  const auto unite = [&](const Joint& j) {
    corners.unite(j[0], next_corner(j[1]));
    corners.unite(next_corner(j[0]), j[1]);
  };
  for (const Joint& j : joints.at_edges) unite(j);
  for (const auto& contact : joints.at_contacts)
    for (const Joint& j : contact) unite(j);
  return corners;
}

/// The mesh with each fan's vertex its own. Vertices keep their order; the fans of one follow each other in the order
/// of their first corners.
Triangulated with_split_vertices(const Triangulated& mesh, const Array<std::uint8_t>& several, const ManyFans& part,
                                 grid::Partition& fan) {
  std::vector<std::array<std::uint32_t, 2>> split;  // (vertex, first corner)
  for (std::uint32_t c = 0; c < part.corner_count(); ++c)
    if (several[part.vertex(c)] && fan.find(c) == c) split.push_back({part.vertex(c), c});
  std::sort(split.begin(), split.end());

  Triangulated apart;
  std::vector<std::uint32_t> id_of_vertex(mesh.source.size()), id_of_corner(part.corner_count());
  for (std::uint32_t v = 0, f = 0; v < mesh.source.size(); ++v) {
    id_of_vertex[v] = static_cast<std::uint32_t>(apart.source.size());
    if (!several[v]) apart.source.push_back(mesh.source[v]);
    for (; f < split.size() && split[f][0] == v; ++f) {
      id_of_corner[split[f][1]] = static_cast<std::uint32_t>(apart.source.size());
      apart.source.push_back(mesh.source[v]);
    }
  }

  apart.face = mesh.face;
  apart.corners = mesh.corners;
  for (std::uint32_t& v : apart.corners) v = id_of_vertex[v];
  for (std::uint32_t c = 0; c < part.corner_count(); ++c)
    if (several[part.vertex(c)]) apart.corners[part.whole(c)] = id_of_corner[fan.find(c)];
  return apart;
}

/// Whether two of the joints, in corners of the mesh, join the same two vertices.
bool share_an_edge(const Triangulated& mesh, const std::vector<Joint>& contact) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;
  for (const Joint& j : contact) ends.push_back(std::minmax(mesh.corners[j[0]], mesh.corners[next_corner(j[0])]));
  std::sort(ends.begin(), ends.end());
  return std::adjacent_find(ends.begin(), ends.end()) != ends.end();
}

/// How far along an edge between grid points a vertex goes into it: to the grid point in the middle or next to it, or,
/// if the edge meets none, so near to its beginning that this is the nearest one.
Rational share_between(const exact::GridPoint& p, const exact::GridPoint& q) {
  std::int64_t steps = 0, largest = 0;  // q - p is so many times the shortest grid vector
  for (int k = 0; k < 3; ++k) {
    const std::int64_t d = std::int64_t{q[k]} - p[k];
    steps = std::gcd(steps, d);
    largest = std::max(largest, std::abs(d));
  }
  if (steps > 1) return Rational(steps / 2, steps);

  std::int64_t parts = 4;
  while (parts <= 2 * largest) parts *= 2;
  return Rational(1, parts);
}

/// A point inside the edge between two body vertices.
RationalPoint point_inside(const Body& body, std::uint32_t u, std::uint32_t v) {
  const exact::Point p = body.point(u), q = body.point(v);
  const bool on_grid = body.is_grid(u) && body.is_grid(v);
  const Rational share = on_grid ? share_between(body.grid_points[u], body.grid_points[v]) : Rational(1, 2);
  RationalPoint inside;
  for (int k = 0; k < 3; ++k) {
    const Rational from = exact::coordinate(p, k), to = exact::coordinate(q, k);
    inside[static_cast<std::size_t>(k)] = from + share * (to - from);
  }
  return inside;
}

/// An edge that begins at a corner of the mesh, and the vertex inside it.
struct Cut {
  std::uint32_t corner, vertex;
};

/// Appends the pieces of a triangle; `inside`: the vertex inside each side, from corner k to the next, or none.
void add_pieces(const std::array<std::uint32_t, 3>& t, const std::array<std::uint32_t, 3>& inside,
                std::vector<std::uint32_t>& out) {
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    const std::uint32_t m = inside[k];
    if (m == none) continue;
    add_pieces({t[k], m, t[j]}, {none, none, inside[j]}, out);
    add_pieces({m, t[i], t[j]}, {none, inside[i], none}, out);
    return;
  }
  out.insert(out.end(), t.begin(), t.end());
}

/// Cuts the triangles of a mesh at vertices inside their sides; pieces take the place of their triangle.
void cut_triangles(Triangulated& mesh, std::vector<Cut> cuts) {
  std::sort(cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b) { return a.corner < b.corner; });
  std::vector<std::uint32_t> corners;
  Array<std::uint32_t> face;
  auto cut = cuts.begin();
  for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t) {
    std::array<std::uint32_t, 3> inside{none, none, none};
    for (; cut != cuts.end() && cut->corner / 3 == t; ++cut) inside[cut->corner % 3] = cut->vertex;
    add_pieces(mesh.triangle(t), inside, corners);
    face.resize(corners.size() / 3, mesh.face[t]);
  }
  mesh.corners = std::move(corners);
  mesh.face = std::move(face);
}

/// Splits, or counts, the edges where joints, in corners of the mesh, join the same two vertices.
void split_shared_edges(const Body& body, const std::vector<std::vector<Joint>>& contacts, SharedEdges shared,
                        Triangulated& mesh) {
  std::vector<Cut> cuts;
  for (const auto& contact : contacts) {
    if (!share_an_edge(mesh, contact)) continue;
    if (shared == SharedEdges::kept) {
      ++mesh.shared_edges;
      continue;
    }

    const auto end = [&](std::uint32_t c) { return mesh.source[mesh.corners[c]]; };
    const std::uint32_t u = end(contact[0][0]), v = end(next_corner(contact[0][0]));
    const RationalPoint inside = point_inside(body, std::min(u, v), std::max(u, v));
    ++mesh.split_edges;
    for (const Joint& j : contact) {
      const auto copy = static_cast<std::uint32_t>(mesh.vertex_count());
      mesh.added.push_back(inside);
      for (const std::uint32_t corner : j) cuts.push_back({corner, copy});
    }
  }
  if (!cuts.empty()) cut_triangles(mesh, std::move(cuts));
}

}  // namespace

Triangulated separated(const Body& body, Triangulated mesh, SharedEdges shared) {
  const Array<std::uint8_t> several = with_several_fans(mesh);
  if (several.empty()) return mesh;

  const ManyFans part(mesh, several);
  Joints joints = joints_of(body, part, mesh.vertex_count());
  grid::Partition fan = fans(part, joints);
  Triangulated apart = with_split_vertices(mesh, several, part, fan);

  for (auto& contact : joints.at_contacts)
    for (Joint& j : contact) j = {part.whole(j[0]), part.whole(j[1])};
  split_shared_edges(body, joints.at_contacts, shared, apart);
  return apart;
}

}  // namespace quoin::booleans
