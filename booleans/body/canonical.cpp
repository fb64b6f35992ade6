#include "booleans/body/canonical.h"

#include <algorithm>
#include <cassert>
#include <compare>
#include <iterator>
#include <numeric>
#include <tuple>
#include <utility>

#include "booleans/body/half_edges.h"
#include "exact/lowest_terms.h"
#include "exact/predicates.h"
#include "grid/lists/partition.h"
#include "grid/lists/stretches.h"

namespace quoin::booleans {
namespace {

/// A face and a vertex inside it.
using PointInFace = std::array<std::uint32_t, 2>;

// 1. Half-edges

HalfEdges half_edges_of(const Body& body) {
  return booleans::half_edges(body.face_count(), body.vertex_count(),
                              [&](std::uint32_t f, auto&& visit) { body.for_edges(f, visit); });
}

// 2. Merged faces

bool coplanar(const Body& body, std::uint32_t f, std::uint32_t g) {
  const auto triangles = static_cast<std::uint32_t>(body.triangles.size());
  if (f >= triangles || g >= triangles) return body.plane(f) == body.plane(g);

  const auto &a = body.triangles[f], &b = body.triangles[g];
  const auto p = [&](std::uint32_t v) -> const exact::GridPoint& { return body.grid_points[v]; };
  // Cheap rejection before the planes are reduced.
  for (std::uint32_t v : b)
    if (exact::orientation(p(a[0]), p(a[1]), p(a[2]), p(v)) != 0) return false;
  return *exact::plane_through(p(a[0]), p(a[1]), p(a[2])) == *exact::plane_through(p(b[0]), p(b[1]), p(b[2]));
}

/// The maximal faces, as sets of faces: an edge of exactly two faces on one oriented plane is no edge. Marks the
/// half-edges that stay, and where their undirected edges begin. `with_labels`: faces that carry something different
/// stay apart.
grid::Partition merged_faces(const Body& body, std::span<HalfEdge> edges, bool with_labels) {
  grid::Partition merged(body.face_count());
  for_undirected_edges(edges, [&](std::size_t i, std::size_t j) {
    const bool flat =
        j - i == 2 && edges[i].from == edges[i + 1].to && coplanar(body, edges[i].face, edges[i + 1].face);
    if (flat && (!with_labels || body.is_same_surface(edges[i].face, edges[i + 1].face))) {
      merged.unite(edges[i].face, edges[i + 1].face);
      edges[i].kept = edges[i + 1].kept = false;
    } else {
      for (std::size_t k = i; k < j; ++k) {
        edges[k].run = static_cast<std::uint32_t>(i);
        edges[k].flat = flat;
      }
    }
    return true;
  });
  return merged;
}

// 3. Needed vertices

/// The vertices that must be: those with more than two neighbours along kept edges. One with two lies inside an edge,
/// unless a border on one plane bends there.
Array<std::uint8_t> needed_vertices(const Body& body, std::span<const HalfEdge> edges) {
  Array<std::array<std::uint32_t, 2>> neighbours(body.vertex_count(), {none, none});
  Array<std::uint8_t> needed(body.vertex_count());
  const auto add = [&](std::uint32_t v, std::uint32_t w) {
    auto& n = neighbours[v];
    if (n[0] == none || n[0] == w)
      n[0] = w;
    else if (n[1] == none || n[1] == w)
      n[1] = w;
    else
      needed[v] = 1;
  };
  for (const HalfEdge& e : edges) {
    if (!e.kept) continue;
    add(e.from, e.to);
    add(e.to, e.from);
  }
  for (const HalfEdge& e : edges) {
    if (!e.flat || needed[e.from]) continue;
    const auto& [u, w] = neighbours[e.from];
    if (w == none || exact::orientation_in_plane(body.plane(e.face), body.point(u), body.point(e.from), body.point(w)))
      needed[e.from] = 1;
  }
  return needed;
}

/// Needed vertices where edges between merged faces have gone and none of the merged face's own has stayed.
Array<PointInFace> points_inside(std::span<const HalfEdge> edges, grid::Partition& merged,
                                 const Array<std::uint8_t>& needed) {
  Array<PointInFace> inside, on_boundary;
  Array<std::uint8_t> in_some(needed.size());
  for (const HalfEdge& e : edges) {
    if (e.kept || !needed[e.from]) continue;
    inside.push_back({merged.find(e.face), e.from});
    in_some[e.from] = 1;
  }
  for (const HalfEdge& e : edges)
    for (const std::uint32_t v : {e.from, e.to})
      if (e.kept && in_some[v]) on_boundary.push_back({merged.find(e.face), v});

  std::sort(on_boundary.begin(), on_boundary.end());
  std::sort(inside.begin(), inside.end());
  inside.erase(std::unique(inside.begin(), inside.end()), inside.end());

  Array<PointInFace> r;
  std::set_difference(inside.begin(), inside.end(), on_boundary.begin(), on_boundary.end(), std::back_inserter(r));
  return r;
}

/// The needed vertices inside merged faces, by face: those that the body lists, and those that come with merging.
Array<PointInFace> touching_points(const Body& body, std::span<const HalfEdge> edges, grid::Partition& merged,
                                   const Array<std::uint8_t>& needed) {
  Array<PointInFace> points = points_inside(edges, merged, needed);
  for (std::uint32_t p = 0; p < body.polygon_count(); ++p)
    body.polygons.for_points(p, [&](std::uint32_t v) {
      if (needed[v]) points.push_back({merged.find(static_cast<std::uint32_t>(body.triangles.size()) + p), v});
    });
  std::sort(points.begin(), points.end());
  return points;
}

// 4. Order of the vertices

int compare_along(const Body& body, int k, std::uint32_t u, std::uint32_t v) {
  const auto i = static_cast<std::size_t>(k);
  return exact::compare_rounded(body.approximation(u)[i], body.approximation(v)[i], [&] {
    return u == v || (body.is_grid(u) && body.is_grid(v)) ? 0 : exact::compare_along(k, body.point(u), body.point(v));
  });
}

/// The needed vertices by exact position, by their numbers where a body that was trusted wrongly has one point twice.
Array<std::uint32_t> ordered_vertices(const Body& body, const Array<std::uint8_t>& needed) {
  struct Key {
    double x;
    std::uint32_t vertex;
  };
  Array<Key> keys;
  for (std::uint32_t v = 0; v < needed.size(); ++v)
    if (needed[v]) keys.push_back({body.approximation(v)[0], v});
  grid::sort_side_by_side(keys.begin(), keys.end(), [&](const Key& a, const Key& b) {
    if (a.x != b.x) return a.x < b.x;
    for (int k = 0; k < 3; ++k)
      if (const int c = compare_along(body, k, a.vertex, b.vertex)) return c < 0;
    return a.vertex < b.vertex;
  });

  Array<std::uint32_t> order;
  order.reserve(keys.size());
  for (const Key& k : keys) order.push_back(k.vertex);
  return order;
}

// 5. Loops

/// The kept half-edges by merged face, within a face by (from, to).
HalfEdges face_edges(std::span<const HalfEdge> all, grid::Partition& merged, std::size_t face_count) {
  HalfEdges by_face(face_count, [&](auto&& visit) {
    for (const HalfEdge& e : all) {
      if (!e.kept) continue;
      const std::uint32_t face = merged.find(e.face);
      visit(face, HalfEdge{e.from, e.to, face, e.run, true, e.flat});
    }
  });
  sort_each(by_face,
            [](const HalfEdge& a, const HalfEdge& b) { return std::tie(a.from, a.to) < std::tie(b.from, b.to); });
  return by_face;
}

/// The directions of edges on the plane of one face.
class Directions {
 public:
  /// The direction of an edge, sign * (n_plane x n_line).
  struct Direction {
    exact::Plane line;
    int sign;
  };

  /// `all`: the half-edges of the body, by undirected edge.
  Directions(const Body& body, std::span<const HalfEdge> all, const exact::Plane& plane)
      : body_(body), all_(all), plane_(plane) {}

  /// From its beginning to its end, or back.
  Direction of(const HalfEdge& e, bool reversed) const {
    const exact::Plane line = other_plane(e);
    int k = 0, s = 0;
    for (; k < 3 && s == 0; ++k) s = exact::cross_sign(plane_, line, k);
    const int forward = compare_along(body_, k - 1, e.to, e.from);
    return {line, (reversed ? -1 : 1) * (forward == s ? 1 : -1)};
  }
  /// +1 when d lies left of c.
  int turn(const Direction& c, const Direction& d) const {
    return c.sign * d.sign * exact::turn(plane_, c.line, d.line);
  }
  /// Of two directions along one line.
  bool same_way(const Direction& c, const Direction& d) const {
    for (int k = 0; k < 3; ++k)
      if (const int s = exact::cross_sign(plane_, c.line, k))
        return s * c.sign == exact::cross_sign(plane_, d.line, k) * d.sign;
    return false;
  }

  /// The plane of another face at the edge that is not parallel to this one; of a border, or of an edge that a body
  /// which was trusted wrongly folds onto one plane, another plane through it.
  exact::Plane other_plane(const HalfEdge& e) const {
    for (std::size_t i = e.run; i < all_.size() && all_[i].run == e.run; ++i) {
      const exact::Plane p = body_.plane(all_[i].face);
      if (!exact::parallel(p, plane_)) return p;
      const exact::Plane* border = body_.border(all_[i].face, all_[i].from, all_[i].to);
      if (border && !exact::parallel(*border, plane_)) return *border;
    }
    if (!body_.is_grid(e.from) || !body_.is_grid(e.to)) return plane_;
    return exact::upright_plane(body_.grid_points[e.from], body_.grid_points[e.to], plane_);
  }

 private:
  const Body& body_;
  const std::span<const HalfEdge> all_;
  const exact::Plane& plane_;
};

/// Lists that are used again for every face. All are places among the half-edges of the face.
struct DividingDesk {
  Array<std::uint32_t> incoming;  // by their ends
  Array<std::uint32_t> next;      // the successor in its loop
};

/// The successors of the half-edges `arriving` at a vertex of a face that others leave from `out` to `out_end`.
void turn_at_pinch(std::span<const HalfEdge> face, std::span<const std::uint32_t> arriving, std::size_t out,
                   std::size_t out_end, const Directions& directions, Array<std::uint32_t>& next) {
  struct Spoke {
    Directions::Direction d;
    bool leaves;
    std::uint32_t edge;
  };
  Array<Spoke> spokes;
  for (std::size_t k = out; k < out_end; ++k)
    spokes.push_back({directions.of(face[k], false), true, static_cast<std::uint32_t>(k)});
  for (const std::uint32_t k : arriving) spokes.push_back({directions.of(face[k], true), false, k});

  const Directions::Direction reference = spokes[0].d;
  const auto quarter = [&](const Spoke& s) {  // clockwise from the reference
    const int t = directions.turn(reference, s.d);
    if (t != 0) return t < 0 ? 1 : 3;
    return directions.same_way(reference, s.d) ? 0 : 2;
  };
  std::sort(spokes.begin(), spokes.end(), [&](const Spoke& a, const Spoke& b) {
    const int p = quarter(a), q = quarter(b);
    if (p != q) return p < q;
    const int t = directions.turn(a.d, b.d);
    if (t != 0) return t < 0;
    return a.leaves && !b.leaves;  // a slit's way back comes last, clockwise all round
  });

  // The first leaving spoke clockwise after each arriving one.
  std::uint32_t following = none;
  for (std::size_t round = 0; round < 2; ++round)
    for (std::size_t k = spokes.size(); k-- > 0;) {
      if (spokes[k].leaves)
        following = spokes[k].edge;
      else
        next[spokes[k].edge] = following;
    }
}

/// The successor of every half-edge of a face: the first clockwise from the reversed one at its end.
void find_successors(std::span<const HalfEdge> face, const Directions& directions, DividingDesk& desk) {
  auto& [incoming, next] = desk;
  next.assign(face.size(), none);
  incoming.resize(face.size());
  std::iota(incoming.begin(), incoming.end(), 0u);
  std::sort(incoming.begin(), incoming.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::tie(face[a].to, face[a].from) < std::tie(face[b].to, face[b].from);
  });

  std::size_t out = 0;
  for (std::size_t i = 0; i < incoming.size();) {
    const std::uint32_t v = face[incoming[i]].to;
    std::size_t j = i, out_end = out;
    while (j < incoming.size() && face[incoming[j]].to == v) ++j;
    while (out_end < face.size() && face[out_end].from == v) ++out_end;
    assert(out_end - out == j - i);

    if (j - i == 1)
      next[incoming[i]] = static_cast<std::uint32_t>(out);
    else
      turn_at_pinch(face, std::span(incoming).subspan(i, j - i), out, out_end, directions, next);
    i = j;
    out = out_end;
  }
}

/// Rotates a loop so that it starts with its smallest half-edge, which is unique.
void rotate_to_least(std::span<std::uint32_t> loop) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < loop.size(); ++i) {
    const auto key = [&](std::size_t k) { return std::pair(loop[k], loop[grid::next_in_loop(k, loop.size())]); };
    if (key(i) < key(best)) best = i;
  }
  std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(best), loop.end());
}

/// Puts the loops from `first` on in order: the one with the smallest vertex of the face, which is on its outer loop
/// and on no other; then by corners.
void sort_loops(grid::Loops<std::uint32_t>& faces, std::size_t first) {
  Array<Array<std::uint32_t>> loops;
  for (std::size_t j = first; j < faces.loop_count(); ++j)
    loops.emplace_back(faces.loop(j).begin(), faces.loop(j).end());
  const auto outer = std::min_element(loops.begin(), loops.end(), [](const auto& a, const auto& b) {
    const std::uint32_t x = *std::min_element(a.begin(), a.end()), y = *std::min_element(b.begin(), b.end());
    return x != y ? x < y : a < b;
  });
  std::iter_swap(loops.begin(), outer);
  std::sort(loops.begin() + 1, loops.end());

  faces.loop_start.resize(first + 1);
  faces.corners.resize(faces.loop_start.back());
  for (const auto& loop : loops) faces.add_loop(loop);
}

/// An edge of a merged face by the ranks of its ends, and a half-edge on it.
struct FlatEdge {
  std::array<std::uint32_t, 2> ends;
  std::uint32_t half_edge;
};

/// Adds the loops of a face, found by following the successors; its vertices by rank, without those that are not
/// needed. Lists the flat ones among their edges.
void add_loops(std::span<const HalfEdge> face, Array<std::uint32_t>& next, const Array<std::uint32_t>& rank,
               grid::Loops<std::uint32_t>& faces, Array<FlatEdge>& flat) {
  for (std::size_t h = 0; h < face.size(); ++h) {
    if (next[h] == none) continue;
    const std::size_t first_flat = flat.size();
    for (std::size_t g = h; next[g] != none;) {
      if (rank[face[g].from] != none) {
        faces.corners.push_back(rank[face[g].from]);
        if (face[g].flat)
          flat.push_back({{static_cast<std::uint32_t>(faces.corners.size() - 1), 0}, static_cast<std::uint32_t>(g)});
      }
      g = std::exchange(next[g], none);
    }
    // Of a body that was trusted wrongly a loop may need no vertex.
    if (faces.corners.size() == faces.loop_start.back()) continue;
    faces.end_loop();
    for (std::size_t i = first_flat; i < flat.size(); ++i) {
      const std::uint32_t corner = flat[i].ends[0], begin = faces.loop_start[faces.loop_count() - 1];
      const std::uint32_t after = corner + 1 < faces.corners.size() ? corner + 1 : begin;
      flat[i].ends = {faces.corners[corner], faces.corners[after]};
    }
    rotate_to_least(std::span(faces.corners).subspan(faces.loop_start[faces.loop_count() - 1]));
  }
}

/// Lists the borders among the edges of the last face.
void add_borders(std::span<const HalfEdge> face, Array<FlatEdge>& flat, const Directions& directions, Boundary& r) {
  if (flat.empty()) return;
  std::sort(flat.begin(), flat.end(), [](const FlatEdge& a, const FlatEdge& b) { return a.ends < b.ends; });
  for (std::size_t j = r.faces.face_start[r.faces.face_start.size() - 2]; j < r.faces.loop_count(); ++j) {
    const auto loop = r.faces.loop(j);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::array ends{loop[i], loop[grid::next_in_loop(i, loop.size())]};
      const auto at = std::lower_bound(flat.begin(), flat.end(), ends,
                                       [](const FlatEdge& e, const auto& wanted) { return e.ends < wanted; });
      if (at == flat.end() || at->ends != ends) continue;
      r.labels.borders.push_back(
          {r.faces.loop_start[j] + static_cast<std::uint32_t>(i), directions.other_plane(face[at->half_edge])});
    }
  }
}

/// Faces in the order of their smallest members.
struct Traced : Boundary {
  Array<std::uint32_t> smallest;  // of each face
};

/// The merged faces of which begin .. end - 1 are the smallest members, in this order.
Traced traced_faces(const Body& body, std::span<const HalfEdge> all, const HalfEdges& by_face,
                    std::span<const PointInFace> points, const Array<std::uint32_t>& rank,
                    const Array<Provenance>& names, std::uint32_t begin, std::uint32_t end) {
  Traced r;
  DividingDesk desk;
  Array<FlatEdge> flat;
  for (std::uint32_t f = begin; f < end; ++f) {
    const std::span<const HalfEdge> face = by_face[f];
    if (face.empty()) continue;

    const exact::Plane plane = body.plane(f);
    const std::size_t first = r.faces.loop_count();
    const Directions directions(body, all, plane);
    find_successors(face, directions, desk);
    flat.clear();
    add_loops(face, desk.next, rank, r.faces, flat);

    const auto own = std::lower_bound(points.begin(), points.end(), PointInFace{f, 0});
    for (auto at = own; at != points.end() && (*at)[0] == f; ++at) r.faces.add_loop(std::array{rank[(*at)[1]]});

    if (r.faces.loop_count() == first) continue;
    if (r.faces.loop_count() - first > 1) sort_loops(r.faces, first);
    r.planes.push_back(plane);
    r.smallest.push_back(f);
    r.faces.end_face();
    if (!names.empty()) r.labels.polygons.push_back(names[f]);
    add_borders(face, flat, directions, r);
  }
  return r;
}

/// Adds the labels of faces whose loops are to be added.
void append_labels(Boundary& r, const Boundary& more) {
  r.labels.polygons.append(more.labels.polygons.begin(), more.labels.polygons.end());
  r.labels.append_borders(more.labels, 0, static_cast<std::uint32_t>(more.faces.corners.size()),
                          static_cast<std::uint32_t>(r.faces.corners.size()));
}

/// All merged faces.
Traced traced_faces(const Body& body, std::span<const HalfEdge> all, const HalfEdges& by_face,
                    std::span<const PointInFace> points, const Array<std::uint32_t>& rank,
                    const Array<Provenance>& names) {
  const std::size_t length = grid::long_stretch(body.face_count(), std::size_t{1} << 12);
  std::vector<Traced> parts(body.face_count() / length + 1);
  grid::in_stretches(body.face_count(), length, [&](std::size_t s, std::size_t begin, std::size_t end) {
    parts[s] = traced_faces(body, all, by_face, points, rank, names, static_cast<std::uint32_t>(begin),
                            static_cast<std::uint32_t>(end));
  });

  Traced r = std::move(parts[0]);
  for (std::size_t s = 1; s < parts.size(); ++s) {
    r.planes.insert(r.planes.end(), parts[s].planes.begin(), parts[s].planes.end());
    r.smallest.insert(r.smallest.end(), parts[s].smallest.begin(), parts[s].smallest.end());
    append_labels(r, parts[s]);
    r.faces.append(parts[s].faces);
  }
  return r;
}

// 6. Order of the faces

/// Faces by plane, those on one plane by their loops: no two have a loop in common, so the first decides; of a body
/// that was trusted wrongly, in the end by their numbers.
Array<std::uint32_t> ordered_faces(const Boundary& traced) {
  struct Key {
    std::int64_t a;
    std::uint32_t face;
  };
  Array<Key> keys(traced.face_count());
  for (std::uint32_t f = 0; f < keys.size(); ++f) keys[f] = {traced.planes[f].n[0], f};
  grid::sort_side_by_side(keys.begin(), keys.end(), [&](const Key& x, const Key& y) {
    if (x.a != y.a) return x.a < y.a;
    if (const int c = exact::compare(traced.planes[x.face], traced.planes[y.face])) return c < 0;
    const auto loop = [&](const Key& k) { return traced.faces.loop(traced.faces.face_start[k.face]); };
    const auto p = loop(x), q = loop(y);
    const auto c = std::lexicographical_compare_three_way(p.begin(), p.end(), q.begin(), q.end());
    return c != 0 ? c < 0 : x.face < y.face;
  });

  Array<std::uint32_t> order;
  order.reserve(keys.size());
  for (const Key& k : keys) order.push_back(k.face);
  return order;
}

Boundary in_order(const Boundary& traced, const Array<std::uint32_t>& order) {
  Boundary r;
  r.planes.reserve(order.size());
  r.faces.reserve(order.size(), traced.faces.loop_count(), traced.faces.corners.size());
  for (const std::uint32_t f : order) {
    r.planes.push_back(traced.planes[f]);
    if (!traced.labels.polygons.empty()) {
      const auto [begin, end] = traced.faces.corner_range(f);
      r.labels.polygons.push_back(traced.labels.polygons[f]);
      r.labels.append_borders(traced.labels, begin, end, static_cast<std::uint32_t>(r.faces.corners.size()));
    }
    traced.faces.for_loops(f, [&](std::span<const std::uint32_t> loop) { r.faces.add_loop(loop); });
    r.faces.end_face();
  }
  return r;
}

/// The number in that order of the merged face that each face of the body is a part of.
Array<std::uint32_t> numbers(grid::Partition& merged, const Traced& traced, const Array<std::uint32_t>& order,
                             std::size_t face_count) {
  Array<std::uint32_t> number(face_count, none);
  for (std::uint32_t i = 0; i < order.size(); ++i) number[traced.smallest[order[i]]] = i;
  for (std::uint32_t f = 0; f < face_count; ++f) number[f] = number[merged.find(f)];
  return number;
}

// 7. What faces carry

/// By the smallest member of a merged face: the first of what its members carry.
Array<Provenance> merged_names(const Body& body, grid::Partition& merged) {
  Array<Provenance> names(body.face_count());
  for (std::uint32_t f = 0; f < names.size(); ++f) {
    names[f] = body.provenance(f);
    Provenance& first = names[merged.find(f)];
    if (body.labels.origins->comes_before(names[f], first)) first = names[f];
  }
  return names;
}

/// All steps. `number`, when given, receives the face of the form that each face of the body is a part of, none where
/// it is part of none. Precondition: the body is packed.
Boundary boundary_of(const Body& body, bool with_labels, Array<std::uint32_t>* number = nullptr) {
  HalfEdges by_lower_vertex = half_edges_of(body);
  const std::span<HalfEdge> edges = by_lower_vertex.items();
  grid::Partition merged = merged_faces(body, edges, with_labels);
  const Array<std::uint8_t> needed = needed_vertices(body, edges);
  const Array<PointInFace> points = touching_points(body, edges, merged, needed);

  const Array<std::uint32_t> order = ordered_vertices(body, needed);
  Array<std::uint32_t> rank(body.vertex_count(), none);
  for (std::uint32_t i = 0; i < order.size(); ++i) rank[order[i]] = i;

  Array<Provenance> names;
  if (with_labels) names = merged_names(body, merged);
  const HalfEdges by_face = face_edges(edges, merged, body.face_count());
  const Traced traced = traced_faces(body, edges, by_face, points, rank, names);
  const Array<std::uint32_t> order_of_faces = ordered_faces(traced);
  Boundary form = in_order(traced, order_of_faces);
  if (number) *number = numbers(merged, traced, order_of_faces, body.face_count());
  form.full_at_infinity = body.full_at_infinity;
  if (with_labels) form.labels.origins = body.labels.origins;
  form.vertices.resize(order.size());
  grid::in_stretches(order.size(), grid::stretch(std::size_t{1} << 12),
                     [&](std::size_t, std::size_t begin, std::size_t end) {
                       for (std::size_t i = begin; i < end; ++i)
                         form.vertices[i] = exact::reduced(body.point(order[i]));
                     });
  return form;
}

}  // namespace

Canonical canonical(const Body& body) {
  return Canonical(body.is_packed ? boundary_of(body, false) : boundary_of(packed(body), false));
}

Boundary labelled_boundary(const Body& body) {
  if (!body.is_packed) return labelled_boundary(packed(body));
  return boundary_of(body, static_cast<bool>(body.labels));
}

LabelledForm labelled_form(const Body& body) {
  if (!body.is_packed) return labelled_form(packed(body));
  Array<std::uint32_t> own, whole;
  LabelledForm form{boundary_of(body, static_cast<bool>(body.labels), &own), {}};
  boundary_of(body, false, &whole);

  form.whole.resize(form.boundary.face_count());
  for (std::size_t f = 0; f < own.size(); ++f)
    if (own[f] != none) form.whole[own[f]] = whole[f];
  return form;
}

CanonicalCounts canonical_counts(const Body& body) {
  if (!body.is_packed) return canonical_counts(packed(body));

  HalfEdges by_lower_vertex = half_edges_of(body);
  const std::span<HalfEdge> edges = by_lower_vertex.items();
  grid::Partition merged = merged_faces(body, edges, false);
  const Array<std::uint8_t> needed = needed_vertices(body, edges);

  CanonicalCounts r{static_cast<std::size_t>(std::count(needed.begin(), needed.end(), 1)), 0, 0};
  Array<std::uint8_t> has_edge(body.vertex_count()), has_boundary(body.face_count());
  for_undirected_edges(edges, [&](std::size_t i, std::size_t j) {
    if (!edges[i].kept) return true;
    ++r.edges;
    has_edge[edges[i].from] = has_edge[edges[i].to] = 1;
    for (std::size_t k = i; k < j; ++k) has_boundary[merged.find(edges[k].face)] = 1;
    return true;
  });
  r.faces = static_cast<std::size_t>(std::count(has_boundary.begin(), has_boundary.end(), 1));
  // Two edges become one at a vertex that is not needed.
  for (std::size_t v = 0; v < needed.size(); ++v)
    if (has_edge[v] && !needed[v] && r.edges > 0) --r.edges;
  return r;
}

}  // namespace quoin::booleans
