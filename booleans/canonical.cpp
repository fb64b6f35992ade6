#include "booleans/canonical.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <tuple>

#include "booleans/arrangement.h"
#include "booleans/triangle_pair.h"
#include "exact/rational.h"

namespace quoin::booleans {
namespace {

/// A directed boundary edge of a face of the body.
struct HalfEdge {
  std::uint32_t from, to, face;
  std::uint32_t run;  // the first of its undirected edge in the list of all
  bool boundary;      // of its merged face
};

class Canonizer {
 public:
  explicit Canonizer(const Body& body) : body_(body), groups_(body.face_count()) {}

  Canonical run() {
    form_.full_at_infinity = body_.full_at_infinity;
    collect_half_edges();
    merge_coplanar();
    find_needed_vertices();
    rank_vertices();
    group_half_edges();
    for (std::size_t g = 0; g + 1 < group_start_.size(); ++g)
      if (group_start_[g] < group_start_[g + 1]) trace(group_start_[g], group_start_[g + 1]);
    write_faces();
    return std::move(form_);
  }

 private:
  int compare_along(int k, std::uint32_t u, std::uint32_t v) const {
    const double a = body_.approximation(u)[static_cast<std::size_t>(k)],
                 b = body_.approximation(v)[static_cast<std::size_t>(k)];
    if (a != b) return a < b ? -1 : 1;
    if (u == v || (body_.is_grid(u) && body_.is_grid(v))) return 0;
    return exact::compare_along(k, body_.point(u), body_.point(v));
  }

  void collect_half_edges() {
    edges_.reserve(3 * body_.triangles.size() + body_.corners.size());
    for (std::uint32_t f = 0; f < body_.face_count(); ++f)
      body_.for_edges(f, [&](std::uint32_t u, std::uint32_t v) { edges_.push_back({u, v, f, 0, true}); });
    for (std::uint32_t p = 0; p < body_.polygon_count(); ++p)
      for (std::uint32_t j = body_.polygon_loops[p]; j < body_.polygon_loops[p + 1]; ++j)
        if (const auto loop = body_.loop(j); loop.size() == 1)
          isolated_.push_back({static_cast<std::uint32_t>(body_.triangles.size()) + p, loop[0]});
    // By undirected edge.
    sort_by(
        edges_, body_.vertex_count(), [](const HalfEdge& e) { return std::min(e.from, e.to); },
        [](const HalfEdge& a, const HalfEdge& b) {
          const std::uint32_t p = std::max(a.from, a.to), q = std::max(b.from, b.to);
          return std::tie(p, a.face, a.from) < std::tie(q, b.face, b.from);
        });
  }

  /// By a key below `bound`, then by `less`: a counting sort, and small sorts within. Returns where each key begins.
  template <class Key, class Less>
  static std::vector<std::uint32_t> sort_by(std::vector<HalfEdge>& edges, std::size_t bound, Key&& key, Less&& less) {
    std::vector<std::uint32_t> start(bound + 1);
    for (const HalfEdge& e : edges) ++start[key(e) + 1];
    std::partial_sum(start.begin(), start.end(), start.begin());
    std::vector<HalfEdge> sorted(edges.size());
    std::vector<std::uint32_t> at(start.begin(), start.end() - 1);
    for (const HalfEdge& e : edges) sorted[at[key(e)]++] = e;
    for (std::size_t i = 0; i < bound; ++i) std::sort(sorted.begin() + start[i], sorted.begin() + start[i + 1], less);
    edges.swap(sorted);
    return start;
  }

  template <class Visit>
  void for_edges(Visit&& visit) {
    for (std::size_t i = 0, j = 0; i < edges_.size(); i = j) {
      const auto key = std::minmax(edges_[i].from, edges_[i].to);
      while (j < edges_.size() && std::minmax(edges_[j].from, edges_[j].to) == key) ++j;
      visit(i, j);
    }
  }

  bool coplanar(std::uint32_t f, std::uint32_t g) const {
    const auto triangles = static_cast<std::uint32_t>(body_.triangles.size());
    if (f < triangles && g < triangles) {
      const auto &a = body_.triangles[f], &b = body_.triangles[g];
      const auto p = [&](std::uint32_t v) -> const exact::GridPoint& { return body_.grid_points[v]; };
      const auto normal = [&](const std::array<std::uint32_t, 3>& t) {
        return exact::plane_through(p(t[0]), p(t[1]), p(t[2]));
      };
      // Cheap rejection before the planes are reduced.
      for (std::uint32_t v : b)
        if (orientation(p(a[0]), p(a[1]), p(a[2]), p(v)) != 0) return false;
      return *normal(a) == *normal(b);
    }
    return body_.plane(f) == body_.plane(g);
  }

  /// An edge of exactly two faces on one oriented plane is no edge.
  void merge_coplanar() {
    for_edges([&](std::size_t i, std::size_t j) {
      if (j - i == 2 && edges_[i].from == edges_[i + 1].to && coplanar(edges_[i].face, edges_[i + 1].face)) {
        groups_.unite(edges_[i].face, edges_[i + 1].face);
        edges_[i].boundary = edges_[i + 1].boundary = false;
        return;
      }
      for (std::size_t k = i; k < j; ++k) edges_[k].run = static_cast<std::uint32_t>(i);
    });
  }

  /// Vertices with exactly two neighbours lie inside an edge.
  void find_needed_vertices() {
    std::vector<std::array<std::uint32_t, 2>> neighbours(body_.vertex_count(), {none, none});
    needed_.assign(body_.vertex_count(), 0);
    const auto add = [&](std::uint32_t v, std::uint32_t w) {
      auto& n = neighbours[v];
      if (n[0] == none || n[0] == w)
        n[0] = w;
      else if (n[1] == none || n[1] == w)
        n[1] = w;
      else
        needed_[v] = 1;
    };
    for (const HalfEdge& e : edges_) {
      if (!e.boundary) continue;
      add(e.from, e.to);
      add(e.to, e.from);
    }
    // Vertices inside merged triangles: they stay where the boundary of another face passes.
    std::vector<std::array<std::uint32_t, 2>> inside, on_boundary;  // (group, vertex)
    std::vector<std::uint8_t> in_some(body_.vertex_count());
    for (const HalfEdge& e : edges_) {
      if (e.boundary || !needed_[e.from]) continue;
      inside.push_back({groups_.find(e.face), e.from});
      in_some[e.from] = 1;
    }
    for (const HalfEdge& e : edges_)
      for (const std::uint32_t v : {e.from, e.to})
        if (e.boundary && in_some[v]) on_boundary.push_back({groups_.find(e.face), v});
    std::sort(on_boundary.begin(), on_boundary.end());
    std::sort(inside.begin(), inside.end());
    inside.erase(std::unique(inside.begin(), inside.end()), inside.end());
    std::set_difference(inside.begin(), inside.end(), on_boundary.begin(), on_boundary.end(),
                        std::back_inserter(isolated_));
    std::erase_if(isolated_, [&](const auto& x) { return !needed_[x[1]]; });
  }

  void rank_vertices() {
    std::vector<std::uint32_t> order;
    for (std::uint32_t v = 0; v < needed_.size(); ++v)
      if (needed_[v]) order.push_back(v);
    std::sort(order.begin(), order.end(), [&](std::uint32_t u, std::uint32_t v) {
      for (int k = 0; k < 3; ++k)
        if (const int c = compare_along(k, u, v)) return c < 0;
      return false;
    });
    rank_.assign(needed_.size(), none);
    form_.vertices.reserve(order.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) {
      rank_[order[i]] = i;
      form_.vertices.push_back(reduced(body_.point(order[i])));
    }
  }

  static exact::Point reduced(exact::Point p) {
    if (exact::compare(p.w, exact::Denominator(1)) == 0) return p;
    exact::Integer g = exact::to_integer(p.w);
    for (const auto& x : p.x) g = gcd(g, exact::to_integer(x));
    if (g == 1) return p;
    for (auto& x : p.x) x = *exact::to_int<exact::Numerator::bits>(exact::Integer(exact::to_integer(x) / g));
    p.w = *exact::to_int<exact::Denominator::bits>(exact::Integer(exact::to_integer(p.w) / g));
    return p;
  }

  void group_half_edges() {
    for (const HalfEdge& e : edges_) {
      if (!e.boundary) continue;
      half_edges_.push_back(e);
      half_edges_.back().face = groups_.find(e.face);
    }
    for (auto& x : isolated_) x[0] = groups_.find(x[0]);
    std::sort(isolated_.begin(), isolated_.end());
    group_start_ = sort_by(
        half_edges_, body_.face_count(), [](const HalfEdge& e) { return e.face; },
        [](const HalfEdge& a, const HalfEdge& b) { return std::tie(a.from, a.to) < std::tie(b.from, b.to); });
  }

  /// The direction of an edge from `from` to `to` on a face's plane: sign * (n_plane x n_line).
  struct Direction {
    exact::Plane line;
    int sign;
  };
  Direction direction(const exact::Plane& plane, const HalfEdge& e, bool reversed) const {
    const exact::Plane line = other_plane(plane, e);
    int k = 0, s = 0;
    for (; k < 3 && s == 0; ++k) s = exact::cross_sign(plane, line, k);
    const int forward = compare_along(k - 1, e.to, e.from);
    return {line, (reversed ? -1 : 1) * (forward == s ? 1 : -1)};
  }
  /// The plane of another face at the edge that is not parallel to this one.
  exact::Plane other_plane(const exact::Plane& plane, const HalfEdge& e) const {
    for (std::size_t i = e.run; i < edges_.size() && edges_[i].run == e.run; ++i) {
      const exact::Plane p = body_.plane(edges_[i].face);
      if (!exact::parallel(p, plane)) return p;
    }
    assert(false);
    return plane;
  }
  /// +1 when d lies left of c.
  static int turn(const exact::Plane& plane, const Direction& c, const Direction& d) {
    return c.sign * d.sign * exact::turn(plane, c.line, d.line);
  }
  static bool same_way(const exact::Plane& plane, const Direction& c, const Direction& d) {
    for (int k = 0; k < 3; ++k)
      if (const int s = exact::cross_sign(plane, c.line, k))
        return s * c.sign == exact::cross_sign(plane, d.line, k) * d.sign;
    return false;
  }

  /// The successor of every half-edge of a face: the first clockwise from the reversed one at its end.
  void find_successors(std::size_t begin, std::size_t end, const exact::Plane& plane) {
    next_.assign(end - begin, none);
    incoming_.clear();
    for (std::size_t i = begin; i < end; ++i) incoming_.push_back(static_cast<std::uint32_t>(i));
    std::sort(incoming_.begin(), incoming_.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::tie(half_edges_[a].to, half_edges_[a].from) < std::tie(half_edges_[b].to, half_edges_[b].from);
    });
    std::size_t out = begin;
    for (std::size_t i = 0; i < incoming_.size();) {
      const std::uint32_t v = half_edges_[incoming_[i]].to;
      std::size_t j = i, out_end = out;
      while (j < incoming_.size() && half_edges_[incoming_[j]].to == v) ++j;
      while (out_end < end && half_edges_[out_end].from == v) ++out_end;
      assert(out_end - out == j - i);
      if (j - i == 1)
        next_[incoming_[i] - begin] = static_cast<std::uint32_t>(out);
      else
        turn_at_pinch(begin, i, j, out, out_end, plane);
      i = j;
      out = out_end;
    }
  }

  void turn_at_pinch(std::size_t begin, std::size_t i, std::size_t j, std::size_t out, std::size_t out_end,
                     const exact::Plane& plane) {
    struct Spoke {
      Direction d;
      bool leaves;
      std::uint32_t edge;
    };
    std::vector<Spoke> spokes;
    for (std::size_t k = out; k < out_end; ++k)
      spokes.push_back({direction(plane, half_edges_[k], false), true, static_cast<std::uint32_t>(k)});
    for (std::size_t k = i; k < j; ++k)
      spokes.push_back({direction(plane, half_edges_[incoming_[k]], true), false, incoming_[k]});
    const Direction reference = spokes[0].d;
    const auto quarter = [&](const Spoke& s) {  // clockwise from the reference
      const int t = turn(plane, reference, s.d);
      if (t != 0) return t < 0 ? 1 : 3;
      return same_way(plane, reference, s.d) ? 0 : 2;
    };
    std::sort(spokes.begin(), spokes.end(), [&](const Spoke& a, const Spoke& b) {
      const int p = quarter(a), q = quarter(b);
      if (p != q) return p < q;
      const int t = turn(plane, a.d, b.d);
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
          next_[spokes[k].edge - begin] = following;
      }
  }

  void trace(std::size_t begin, std::size_t end) {
    const std::uint32_t group = half_edges_[begin].face;
    const exact::Plane plane = body_.plane(group);
    find_successors(begin, end, plane);
    const auto first = static_cast<std::uint32_t>(loops_.count());
    for (std::size_t h = begin; h < end; ++h) {
      if (next_[h - begin] == none) continue;
      for (std::size_t g = h; next_[g - begin] != none;) {
        if (rank_[half_edges_[g].from] != none) loops_.corners.push_back(rank_[half_edges_[g].from]);
        g = std::exchange(next_[g - begin], none);
      }
      loops_.end_loop();
      rotate_to_least(loops_.last());
    }
    auto at = std::lower_bound(isolated_.begin(), isolated_.end(), std::array<std::uint32_t, 2>{group, 0});
    for (; at != isolated_.end() && (*at)[0] == group; ++at) {
      loops_.corners.push_back(rank_[(*at)[1]]);
      loops_.end_loop();
    }
    const auto last = static_cast<std::uint32_t>(loops_.count());
    if (last - first > 1) sort_loops(first, last);
    faces_.push_back({plane, first, last});
  }

  /// The one with the smallest vertex of the face, which is on its outer loop and on no other; then by corners.
  void sort_loops(std::uint32_t first, std::uint32_t last) {
    std::vector<std::vector<std::uint32_t>> loops;
    for (std::uint32_t j = first; j < last; ++j) loops.emplace_back(loops_[j].begin(), loops_[j].end());
    std::sort(loops.begin(), loops.end(), [](const auto& a, const auto& b) {
      const auto x = *std::min_element(a.begin(), a.end()), y = *std::min_element(b.begin(), b.end());
      return x != y ? x < y : a < b;
    });
    std::sort(loops.begin() + 1, loops.end());
    loops_.cut(first);
    for (const auto& loop : loops) {
      loops_.corners.insert(loops_.corners.end(), loop.begin(), loop.end());
      loops_.end_loop();
    }
  }

  /// Rotates a loop so that it starts with its smallest half-edge, which is unique.
  static void rotate_to_least(std::span<std::uint32_t> loop) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < loop.size(); ++i) {
      const auto key = [&](std::size_t k) { return std::pair(loop[k], loop[(k + 1) % loop.size()]); };
      if (key(i) < key(best)) best = i;
    }
    std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(best), loop.end());
  }

  void write_faces() {
    std::sort(faces_.begin(), faces_.end(), [&](const Face& a, const Face& b) {
      if (const int c = exact::compare(a.plane, b.plane)) return c < 0;
      return loops_less(a, b);
    });
    form_.planes.reserve(faces_.size());
    form_.face_loops.reserve(faces_.size() + 1);
    form_.loop_corners.reserve(loops_.count() + 1);
    form_.corners.reserve(loops_.corners.size());
    for (const Face& f : faces_) {
      form_.planes.push_back(f.plane);
      for (std::uint32_t j = f.first; j < f.last; ++j) {
        const auto loop = loops_[j];
        form_.corners.insert(form_.corners.end(), loop.begin(), loop.end());
        form_.loop_corners.push_back(static_cast<std::uint32_t>(form_.corners.size()));
      }
      form_.face_loops.push_back(static_cast<std::uint32_t>(form_.loop_corners.size() - 1));
    }
  }

  /// Loops that follow each other in one list.
  struct Loops {
    std::vector<std::uint32_t> corners, start = {0};

    std::size_t count() const { return start.size() - 1; }
    std::span<std::uint32_t> operator[](std::size_t j) {
      return std::span(corners).subspan(start[j], start[j + 1] - start[j]);
    }
    std::span<std::uint32_t> last() { return (*this)[count() - 1]; }
    void end_loop() { start.push_back(static_cast<std::uint32_t>(corners.size())); }
    /// Only the first `n` stay.
    void cut(std::size_t n) {
      start.resize(n + 1);
      corners.resize(start[n]);
    }
  };

  struct Face {
    exact::Plane plane;
    std::uint32_t first, last;  // loops
  };

  /// Of faces on one plane: no two have a loop in common.
  bool loops_less(const Face& a, const Face& b) {
    const auto p = loops_[a.first], q = loops_[b.first];
    return std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end());
  }

  const Body& body_;
  Partition groups_;
  std::vector<HalfEdge> edges_;                         // all, by undirected edge
  std::vector<HalfEdge> half_edges_;                    // the boundary ones, by group
  std::vector<std::array<std::uint32_t, 2>> isolated_;  // (face or group, vertex)
  std::vector<std::uint8_t> needed_;
  std::vector<std::uint32_t> rank_;
  std::vector<std::uint32_t> group_start_;
  std::vector<std::uint32_t> next_, incoming_;
  std::vector<Face> faces_;
  Loops loops_;
  Canonical form_;
};

}  // namespace

Canonical canonical(const Body& body) { return body.is_packed ? Canonizer(body).run() : canonical(packed(body)); }

Body body_of(const Canonical& form) {
  Body body;
  body.full_at_infinity = form.full_at_infinity;
  std::vector<std::uint32_t> id(form.vertices.size());
  const auto is_grid = [&](std::size_t v) { return exact::compare(form.vertices[v].w, exact::Denominator(1)) == 0; };
  for (const bool grid : {true, false})
    for (std::size_t v = 0; v < id.size(); ++v) {
      if (is_grid(v) != grid) continue;
      id[v] = static_cast<std::uint32_t>(body.vertex_count());
      const auto& a = form.vertices[v].approximation;
      if (grid)
        body.grid_points.push_back({{std::int32_t(a[0]), std::int32_t(a[1]), std::int32_t(a[2])}});
      else
        body.points.push_back(form.vertices[v]);
    }
  for (std::size_t f = 0; f < form.face_count(); ++f) {
    const std::uint32_t first = form.face_loops[f], last = form.face_loops[f + 1];
    const std::uint32_t begin = form.loop_corners[first], end = form.loop_corners[last];
    if (last - first == 1 && end - begin == 3 && is_grid(form.corners[begin]) && is_grid(form.corners[begin + 1]) &&
        is_grid(form.corners[begin + 2])) {
      body.triangles.push_back({id[form.corners[begin]], id[form.corners[begin + 1]], id[form.corners[begin + 2]]});
      continue;
    }
    body.planes.push_back(form.planes[f]);
    for (std::uint32_t j = first; j < last; ++j) {
      for (std::uint32_t c = form.loop_corners[j]; c < form.loop_corners[j + 1]; ++c)
        body.corners.push_back(id[form.corners[c]]);
      body.loop_corners.push_back(static_cast<std::uint32_t>(body.corners.size()));
    }
    body.polygon_loops.push_back(static_cast<std::uint32_t>(body.loop_corners.size() - 1));
  }
  return body;
}

bool operator==(const Canonical& a, const Canonical& b) {
  const auto equal = [](const exact::Point& p, const exact::Point& q) { return p.x == q.x && p.w == q.w; };
  return a.full_at_infinity == b.full_at_infinity && a.planes == b.planes && a.face_loops == b.face_loops &&
         a.loop_corners == b.loop_corners && a.corners == b.corners &&
         std::equal(a.vertices.begin(), a.vertices.end(), b.vertices.begin(), b.vertices.end(), equal);
}

std::size_t edge_count(const Canonical& form) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (std::size_t j = 0; j + 1 < form.loop_corners.size(); ++j) {
    const std::uint32_t begin = form.loop_corners[j], end = form.loop_corners[j + 1];
    for (std::uint32_t c = begin; c < end && end - begin > 1; ++c)
      edges.push_back(std::minmax(form.corners[c], form.corners[c + 1 < end ? c + 1 : begin]));
  }
  std::sort(edges.begin(), edges.end());
  return static_cast<std::size_t>(std::unique(edges.begin(), edges.end()) - edges.begin());
}

}  // namespace quoin::booleans
