// A judge of written meshes that shares no code with the exporter: doubles are integers over a power of two, all pairs
// of triangles are tried, and what two of them have in common is found as the hull of its extreme points.
#pragma once

#include <algorithm>
#include <array>
#include <boost/multiprecision/gmp.hpp>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "quoin/triangles.h"

namespace quoin::exact_mesh {

using Whole = boost::multiprecision::mpz_int;
using V3 = std::array<Whole, 3>;
/// x / w, with w > 0.
struct Quotient {
  V3 x;
  Whole w = 1;
};
using Triangle = std::array<V3, 3>;

inline V3 minus(const V3& a, const V3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline V3 cross(const V3& a, const V3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Whole dot(const V3& a, const V3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline V3 normal(const Triangle& t) { return cross(minus(t[1], t[0]), minus(t[2], t[0])); }

/// All coordinates, times one power of two.
inline std::vector<V3> whole_points(const std::vector<double>& points) {
  int least = 0;
  for (const double x : points) {
    int e = 0;
    std::frexp(x, &e);
    if (x != 0) least = std::min(least, e - 53);
  }
  std::vector<V3> r(points.size() / 3);
  for (std::size_t i = 0; i < points.size(); ++i) {
    int e = 0;
    const double f = std::frexp(points[i], &e);
    Whole v = static_cast<long long>(std::ldexp(f, 53));
    if (v != 0) v <<= static_cast<unsigned>(e - 53 - least);
    r[i / 3][i % 3] = v;
  }
  return r;
}

/// Is a point of the triangle's plane in the closed triangle?
inline bool holds(const Triangle& t, const V3& n, const Quotient& p) {
  for (std::size_t i = 0; i < 3; ++i) {
    const V3 inward = cross(n, minus(t[(i + 1) % 3], t[i]));
    if (dot(inward, p.x) < dot(inward, t[i]) * p.w) return false;
  }
  return true;
}

/// Where a segment meets the plane n x = c in one point.
inline std::optional<Quotient> piercing(const V3& p, const V3& q, const V3& n, const Whole& c) {
  const Whole a = dot(n, p) - c, b = dot(n, q) - c;
  if (a == b || (a > 0 && b > 0) || (a < 0 && b < 0)) return std::nullopt;
  Quotient r;  // (p b - q a) / (b - a)
  r.w = b - a;
  for (std::size_t k = 0; k < 3; ++k) r.x[k] = p[k] * b - q[k] * a;
  if (r.w < 0) {
    r.w = -r.w;
    for (auto& x : r.x) x = -x;
  }
  return r;
}

/// Points whose hull is what two triangles have in common, on the sides of the first one.
inline void add_common(const Triangle& t, const Triangle& u, std::vector<Quotient>& out) {
  const V3 n = normal(u);
  const Whole c = dot(n, u[0]);
  for (std::size_t i = 0; i < 3; ++i) {
    const V3 &p = t[i], &q = t[(i + 1) % 3];
    if (dot(n, p) == c && holds(u, n, {p, 1})) out.push_back({p, 1});
    if (const auto x = piercing(p, q, n, c); x && holds(u, n, *x)) out.push_back(*x);
    if (dot(n, p) != c || dot(n, q) != c) continue;
    // In its plane: with the lines of its sides.
    for (std::size_t j = 0; j < 3; ++j) {
      const V3 side = cross(n, minus(u[(j + 1) % 3], u[j]));
      if (const auto x = piercing(p, q, side, dot(side, u[j])); x && holds(u, n, *x)) out.push_back(*x);
    }
  }
}

inline bool equal(const Quotient& p, const V3& q) {
  return p.x[0] == q[0] * p.w && p.x[1] == q[1] * p.w && p.x[2] == q[2] * p.w;
}

/// Is the point on the closed segment?
inline bool on_segment(const Quotient& p, const V3& a, const V3& b) {
  const V3 d = minus(b, a), e{p.x[0] - a[0] * p.w, p.x[1] - a[1] * p.w, p.x[2] - a[2] * p.w};
  if (cross(d, e) != V3{0, 0, 0}) return false;
  const Whole along = dot(d, e);
  return along >= 0 && along <= dot(d, d) * p.w;
}

/// Do two triangles meet in common corners and edges only?
inline bool meet_properly(const Triangle& t, const Triangle& u) {
  std::vector<V3> shared;
  for (const V3& p : t)
    if (std::find(u.begin(), u.end(), p) != u.end()) shared.push_back(p);
  if (shared.size() == 3) return false;
  std::vector<Quotient> common;
  add_common(t, u, common);
  add_common(u, t, common);
  return std::all_of(common.begin(), common.end(), [&](const Quotient& p) {
    if (shared.empty()) return false;
    return shared.size() == 1 ? equal(p, shared[0]) : on_segment(p, shared[0], shared[1]);
  });
}

/// 1 where a ray leaves through a triangle, -1 where it enters, 0 where it misses; nothing where it meets its edge.
inline std::optional<int> passage(const Quotient& from, const V3& way, const Triangle& t) {
  const V3 n = normal(t);
  const Whole slope = dot(n, way), height = dot(n, t[0]) * from.w - dot(n, from.x);
  // From its plane a ray starts beside it: what meets properly does not hold a point inside another triangle.
  if (height == 0) return holds(t, n, from) || slope == 0 ? std::nullopt : std::optional(0);
  if (slope == 0) return 0;
  if ((height > 0) != (slope > 0)) return 0;
  bool inside = true, on_edge = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const V3 &a = t[i], &b = t[(i + 1) % 3];
    // The sign of det(a - from, b - from, way), by the side that the third corner is on.
    const V3 pa{a[0] * from.w - from.x[0], a[1] * from.w - from.x[1], a[2] * from.w - from.x[2]};
    const V3 pb{b[0] * from.w - from.x[0], b[1] * from.w - from.x[1], b[2] * from.w - from.x[2]};
    const Whole turn = slope > 0 ? dot(cross(pa, pb), way) : Whole(-dot(cross(pa, pb), way));
    inside = inside && turn >= 0;
    on_edge = on_edge || turn == 0;
  }
  if (!inside) return 0;
  if (on_edge) return std::nullopt;
  return slope > 0 ? 1 : -1;
}

/// The winding number just in front of a triangle.
inline std::optional<int> winding_before(const std::vector<Triangle>& mesh, std::size_t of) {
  const Triangle& own = mesh[of];
  const V3 n = normal(own);
  const Whole size = abs(n[0]) + abs(n[1]) + abs(n[2]);
  for (int attempt = 1; attempt < 50; ++attempt) {
    Quotient from;
    from.w = 100 + 7 * attempt;
    const std::array<int, 3> weights{31 + attempt, 29 + 2 * attempt, 40 + 4 * attempt};
    for (std::size_t k = 0; k < 3; ++k)
      from.x[k] = own[0][k] * weights[0] + own[1][k] * weights[1] + own[2][k] * weights[2];
    // Along the normal, a little turned.
    const V3 way{n[0] * 1000 + size * (17 * attempt) / 7 % 100, n[1] * 1000 - size * attempt / 3 % 100, n[2] * 1000};
    if (dot(way, n) <= 0) continue;
    int winding = 0;
    bool clear = true;
    for (std::size_t u = 0; u < mesh.size() && clear; ++u) {
      if (u == of) continue;
      const auto step = passage(from, way, mesh[u]);
      clear = step.has_value();
      winding += step.value_or(0);
    }
    if (clear) return winding;
  }
  return std::nullopt;
}

/// What is wrong with a mesh, read as exact numbers; empty for a valid one.
inline std::string fault(const Mesh& mesh) {
  const std::vector<V3> points = whole_points(mesh.points);
  std::vector<Triangle> triangles;
  std::map<std::array<V3, 2>, int> edges;
  for (std::size_t t = 0; t + 2 < mesh.triangles.size(); t += 3) {
    triangles.push_back({points[mesh.triangles[t]], points[mesh.triangles[t + 1]], points[mesh.triangles[t + 2]]});
    const Triangle& own = triangles.back();
    if (normal(own) == V3{0, 0, 0}) return "triangle " + std::to_string(t / 3) + " has no area";
    for (std::size_t i = 0; i < 3; ++i) {
      ++edges[{own[i], own[(i + 1) % 3]}];
      --edges[{own[(i + 1) % 3], own[i]}];
    }
  }
  for (const auto& [edge, uses] : edges)
    if (uses != 0) return "an edge is not balanced";

  const auto boxes_meet = [&](const Triangle& t, const Triangle& u) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax({t[0][k], t[1][k], t[2][k]});
      const auto [c, d] = std::minmax({u[0][k], u[1][k], u[2][k]});
      if (b < c || d < a) return false;
    }
    return true;
  };
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t u = t + 1; u < triangles.size(); ++u)
      if (boxes_meet(triangles[t], triangles[u]) && !meet_properly(triangles[t], triangles[u]))
        return "triangles " + std::to_string(t) + " and " + std::to_string(u) + " meet out of place";

  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto winding = winding_before(triangles, t);
    if (!winding) return "no ray from triangle " + std::to_string(t);
    if (*winding != 0) return "triangle " + std::to_string(t) + " does not look outside";
  }
  return {};
}

/// The distance of a point from a triangle, about.
inline double distance(const std::array<double, 3>& p, const std::array<std::array<double, 3>, 3>& t) {
  // In long doubles: the nearest point by the regions of the triangle (Ericson 2005, 5.1.5).
  using L = long double;
  using P = std::array<L, 3>;
  const auto sub = [](const P& a, const P& b) { return P{a[0] - b[0], a[1] - b[1], a[2] - b[2]}; };
  const auto in = [](const P& a, const P& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  const auto to = [](const std::array<double, 3>& a) { return P{a[0], a[1], a[2]}; };
  const P x = to(p), a = to(t[0]), b = to(t[1]), c = to(t[2]);
  const auto far = [&](const P& q) {
    const P d = sub(x, q);
    return static_cast<double>(std::sqrt(in(d, d)));
  };
  const auto on_segment_at = [&](const P& u, const P& v) {
    const P d = sub(v, u);
    const L s = std::clamp<L>(in(d, d) > 0 ? in(sub(x, u), d) / in(d, d) : 0, 0, 1);
    return far({u[0] + s * d[0], u[1] + s * d[1], u[2] + s * d[2]});
  };
  double least = std::min({on_segment_at(a, b), on_segment_at(b, c), on_segment_at(c, a)});
  const P ab = sub(b, a), ac = sub(c, a), ax = sub(x, a);
  const L d11 = in(ab, ab), d12 = in(ab, ac), d22 = in(ac, ac), e1 = in(ax, ab), e2 = in(ax, ac);
  const L det = d11 * d22 - d12 * d12;
  if (det > 0) {
    const L v = (d22 * e1 - d12 * e2) / det, w = (d11 * e2 - d12 * e1) / det;
    if (v >= 0 && w >= 0 && v + w <= 1)
      least = std::min(least,
                       far({a[0] + v * ab[0] + w * ac[0], a[1] + v * ab[1] + w * ac[1], a[2] + v * ab[2] + w * ac[2]}));
  }
  return least;
}

/// The largest distance of a point of one mesh from the triangles of another one.
inline double farthest(const Mesh& mesh, const Mesh& from) {
  const auto point = [](const Mesh& m, std::size_t v) {
    return std::array<double, 3>{m.points[3 * v], m.points[3 * v + 1], m.points[3 * v + 2]};
  };
  double most = 0;
  for (std::size_t v = 0; v < mesh.points.size() / 3; ++v) {
    double least = INFINITY;
    for (std::size_t t = 0; t + 2 < from.triangles.size(); t += 3)
      least =
          std::min(least, distance(point(mesh, v), {point(from, from.triangles[t]), point(from, from.triangles[t + 1]),
                                                    point(from, from.triangles[t + 2])}));
    most = std::max(most, least);
  }
  return most;
}

}  // namespace quoin::exact_mesh
