#include "rounding/shapes/hull.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <utility>
#include <vector>

namespace quoin::rounding {
namespace {

using Index = std::uint32_t;

/// A convex hull, point by point in random order, with lists of the points that see each facet (K. L. Clarkson and P.
/// W. Shor, 1989). Facets are triangles; those on one plane are merged at the end.
class Hull {
 public:
  explicit Hull(std::vector<Vector> points) : points_(std::move(points)) {}

  Result<Polyhedron> run() {
    if (!start()) return bad_primitive("the points of a convex hull lie in one plane");
    for (Index p = 0; p < points_.size(); ++p) insert(p);
    return merged();
  }

 private:
  static constexpr Index none = ~Index{0};
  struct Facet {
    std::array<Index, 3> corner;
    std::array<Index, 3> neighbour;  // over the edge from corner k to corner k + 1
    WidePlane plane;
    std::vector<Index> seen_by;
    bool gone = false;
  };

  int side(const Facet& f, Index p) const { return value(f.plane, points_[p]).sign(); }

  WidePlane plane_of(const std::array<Index, 3>& c) const {
    const Vector e = points_[c[1]] - points_[c[0]], f = points_[c[2]] - points_[c[0]];
    const Vector n = cross(e, f);
    return wide_plane(n, -dot(n, points_[c[0]]));
  }

  /// A tetrahedron of the first points that span one; they move to the front.
  bool start() {
    const auto bring = [&](Index place, auto&& fits) {
      for (Index i = place; i < points_.size(); ++i)
        if (fits(points_[i])) {
          std::swap(points_[place], points_[i]);
          return true;
        }
      return false;
    };
    if (points_.size() < 4) return false;

    const auto area = [&](const Vector& p) {
      const Vector e = points_[1] - points_[0], f = p - points_[0];
      return dot(e, e) * dot(f, f) - dot(e, f) * dot(e, f);
    };
    if (!bring(1, [&](const Vector& p) { return p != points_[0]; })) return false;
    if (!bring(2, [&](const Vector& p) { return area(p) != 0; })) return false;
    const WidePlane base = plane_of({0, 1, 2});
    if (!bring(3, [&](const Vector& p) { return value(base, p) != 0; })) return false;
    if (value(base, points_[3]) > 0) std::swap(points_[1], points_[2]);

    const std::array<std::array<Index, 3>, 4> corners{std::array<Index, 3>{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
    const std::array<std::array<Index, 3>, 4> neighbours{
        std::array<Index, 3>{1, 2, 3}, {3, 2, 0}, {1, 3, 0}, {2, 1, 0}};
    for (std::size_t i = 0; i < 4; ++i) facets_.push_back({corners[i], neighbours[i], plane_of(corners[i]), {}});

    sees_.resize(points_.size());
    for (Index p = 4; p < points_.size(); ++p)
      for (Index f = 0; f < 4; ++f) note(f, p);
    return true;
  }

  void note(Index f, Index p) {
    if (side(facets_[f], p) <= 0) return;
    facets_[f].seen_by.push_back(p);
    sees_[p].push_back(f);
  }

  /// The facets that see p go; p is joined to the horizon.
  void insert(Index p) {
    std::erase_if(sees_[p], [&](Index f) { return facets_[f].gone; });
    if (sees_[p].empty()) return;
    for (const Index f : sees_[p]) facets_[f].gone = true;

    struct Rim {
      Index from, to, inside, outside;
    };
    std::vector<Rim> rim;
    for (const Index f : sees_[p])
      for (std::size_t k = 0; k < 3; ++k) {
        const Index g = facets_[f].neighbour[k];
        if (!facets_[g].gone) rim.push_back({facets_[f].corner[k], facets_[f].corner[(k + 1) % 3], f, g});
      }
    std::sort(rim.begin(), rim.end(), [](const Rim& a, const Rim& b) { return a.from < b.from; });

    const auto first = static_cast<Index>(facets_.size());
    const auto leaving = [&](Index v) {
      const auto at = std::lower_bound(rim.begin(), rim.end(), v, [](const Rim& r, Index w) { return r.from < w; });
      return static_cast<Index>(at - rim.begin());
    };
    std::vector<Index> candidates;
    for (Index i = 0; i < rim.size(); ++i) {
      const Rim& r = rim[i];
      const Index after = first + leaving(r.to);
      facets_.push_back({{r.from, r.to, p}, {r.outside, after, none}, plane_of({r.from, r.to, p}), {}});
      auto& back = facets_[r.outside];
      for (std::size_t k = 0; k < 3; ++k)
        if (back.corner[k] == r.to && back.corner[(k + 1) % 3] == r.from) back.neighbour[k] = first + i;

      // Who sees the new facet saw one of the two at the rim.
      candidates.clear();
      for (const Index f : {r.inside, r.outside})
        candidates.insert(candidates.end(), facets_[f].seen_by.begin(), facets_[f].seen_by.end());
      std::sort(candidates.begin(), candidates.end());
      candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
      for (const Index q : candidates)
        if (q > p) note(first + i, q);
    }
    for (Index i = 0; i < rim.size(); ++i) facets_[facets_[first + i].neighbour[1]].neighbour[2] = first + i;
  }

  /// The facets of one plane become one face; corners on a straight edge go.
  Result<Polyhedron> merged() {
    Polyhedron out;
    std::vector<Index> id(points_.size(), none);
    std::vector<bool> done(facets_.size());

    for (Index f = 0; f < facets_.size(); ++f) {
      if (facets_[f].gone || done[f]) continue;

      std::vector<Index> face;
      const std::vector<Index> corners = outline(f, done);
      const std::size_t n = corners.size();
      for (std::size_t i = 0; i < n; ++i) {
        const Vector &a = points_[corners[grid::previous_in_loop(i, n)]], &b = points_[corners[i]],
                     &c = points_[corners[grid::next_in_loop(i, n)]];
        const Vector u = b - a, v = c - b;
        if (dot(u, u) * dot(v, v) == dot(u, v) * dot(u, v)) continue;
        Index& at = id[corners[i]];
        if (at == none) at = out.add_point(b);
        face.push_back(at);
      }
      out.add_face(face);
    }
    return out;
  }

  /// The boundary of the facets on the plane of one.
  std::vector<Index> outline(Index f, std::vector<bool>& done) {
    std::vector<Index> pending{f}, region;
    done[f] = true;
    while (!pending.empty()) {
      const Index g = pending.back();
      pending.pop_back();
      region.push_back(g);
      for (const Index h : facets_[g].neighbour)
        if (!done[h] && facets_[h].plane == facets_[f].plane) {
          done[h] = true;
          pending.push_back(h);
        }
    }

    std::vector<std::pair<Index, Index>> edges;
    for (const Index g : region)
      for (std::size_t k = 0; k < 3; ++k)
        if (!(facets_[facets_[g].neighbour[k]].plane == facets_[f].plane))
          edges.emplace_back(facets_[g].corner[k], facets_[g].corner[(k + 1) % 3]);
    std::sort(edges.begin(), edges.end());

    std::vector<Index> loop{edges.front().first};
    for (std::size_t i = 0; loop.size() < edges.size();) {
      loop.push_back(edges[i].second);
      i = static_cast<std::size_t>(std::lower_bound(edges.begin(), edges.end(), std::pair(loop.back(), Index{0})) -
                                   edges.begin());
    }
    return loop;
  }

  std::vector<Vector> points_;
  std::vector<Facet> facets_;
  std::vector<std::vector<Index>> sees_;  // by point: the facets it sees, perhaps gone
};

}  // namespace

Result<Polyhedron> convex_hull(std::span<const Vector> points) {
  std::vector<Vector> distinct(points.begin(), points.end());
  std::sort(distinct.begin(), distinct.end());
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());

  // The same shuffle for the same set, on any machine.
  std::uint64_t state = 0x9E3779B97F4A7C15u;
  for (std::size_t i = distinct.size(); i > 1; --i) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    std::swap(distinct[i - 1], distinct[static_cast<std::size_t>((state >> 33) % i)]);
  }
  return Hull(std::move(distinct)).run();
}

namespace {

/// The faces around each point of a convex polyhedron, counter-clockwise seen from outside.
std::vector<std::vector<Index>> faces_around_points(const Polyhedron& p) {
  using Pair = std::pair<Index, Index>;
  std::map<Pair, Index> face_of;  // by directed edge: that on its left
  for (Index f = 0; f < p.face_count(); ++f) p.faces.for_edges(f, [&](Index u, Index v) { face_of[{u, v}] = f; });

  // Around v the edge to u comes after the face left of (u, v), and before that left of (v, u).
  std::map<Pair, Index> next;  // by point and face
  std::vector<Index> first(p.points.size());
  for (const auto& [edge, f] : face_of) {
    next[{edge.second, f}] = face_of.at({edge.second, edge.first});
    first[edge.second] = f;
  }

  std::vector<std::vector<Index>> around(p.points.size());
  for (Index v = 0; v < p.points.size(); ++v) {
    Index f = first[v];
    do {
      around[v].push_back(f);
      f = next.at({v, f});
    } while (f != first[v]);
  }
  return around;
}

}  // namespace

// n . (x - c) <= e, e > 0, is y . (x - c) <= 1 for the dual point y = n / e. A facet m . y = k of their hull, k > 0, is
// the vertex c + m / k, and a point of the hull a face, whose vertices are the facets around it.
Result<Polyhedron> convex_polyhedron(std::span<const WidePlane> planes, const Vector& inside) {
  const Error unbounded{ErrorCode::unbounded, "the half-spaces enclose no bounded solid"};
  std::vector<Vector> dual;
  for (const WidePlane& p : planes) {
    const Rational e = -value(p, inside);
    assert(e > 0);
    dual.push_back({p.n[0] / e, p.n[1] / e, p.n[2] / e});
  }

  auto hull = convex_hull(dual);
  // Bounded if and only if the origin is inside the hull.
  if (!hull) return unbounded;

  Polyhedron p;
  for (const WidePlane& facet : hull.value().planes) {
    if (facet.d >= 0) return unbounded;
    const Integer k = -facet.d;
    p.add_point(inside + Vector{Rational(facet.n[0], k), Rational(facet.n[1], k), Rational(facet.n[2], k)});
  }
  for (const auto& face : faces_around_points(hull.value())) p.add_face(face);
  return p;
}

}  // namespace quoin::rounding
