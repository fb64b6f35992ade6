#include "booleans/pairs/triangle_pair.h"

#include <algorithm>

#include "exact/predicates.h"

namespace quoin::booleans {

using exact::GridPoint;
using exact::orientation;

namespace {

/// Orientation of three points projected along axis k; products of differences are below 2^61.
int projected(const GridPoint& a, const GridPoint& b, const GridPoint& c, std::size_t k) {
  const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
  const std::int64_t det = (std::int64_t{b.c[i]} - a.c[i]) * (std::int64_t{c.c[j]} - a.c[j]) -
                           (std::int64_t{b.c[j]} - a.c[j]) * (std::int64_t{c.c[i]} - a.c[i]);
  return det > 0 ? 1 : det < 0 ? -1 : 0;
}

bool in_projected_triangle(const GridPoint& p, const GridTriangle& t, std::size_t k) {
  const int a = projected(t[0], t[1], p, k), b = projected(t[1], t[2], p, k), c = projected(t[2], t[0], p, k);
  return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
}

bool on_projected_segment(const GridPoint& p, const GridPoint& a, const GridPoint& b, std::size_t k) {
  for (const std::size_t i : {(k + 1) % 3, (k + 2) % 3})
    if (p.c[i] < std::min(a.c[i], b.c[i]) || p.c[i] > std::max(a.c[i], b.c[i])) return false;
  return true;
}

bool segments_meet(const GridPoint& p, const GridPoint& q, const GridPoint& a, const GridPoint& b, std::size_t k) {
  const int pa = projected(a, b, p, k), qa = projected(a, b, q, k), ap = projected(p, q, a, k),
            bp = projected(p, q, b, k);
  if (pa * qa < 0 && ap * bp < 0) return true;
  return (pa == 0 && on_projected_segment(p, a, b, k)) || (qa == 0 && on_projected_segment(q, a, b, k)) ||
         (ap == 0 && on_projected_segment(a, p, q, k)) || (bp == 0 && on_projected_segment(b, p, q, k));
}

bool meet_in_plane(const GridPoint& p, const GridPoint& q, const GridTriangle& t) {
  std::size_t k = 0;
  while (projected(t[0], t[1], t[2], k) == 0) ++k;
  if (in_projected_triangle(p, t, k) || in_projected_triangle(q, t, k)) return true;
  for (std::size_t i = 0; i < 3; ++i)
    if (segments_meet(p, q, t[i], t[(i + 1) % 3], k)) return true;
  return false;
}

/// The signs of the corners of q against the plane of p.
std::array<int, 3> sides(const GridTriangle& p, const GridTriangle& q) {
  std::array<std::int64_t, 3> u{}, v{}, n{};
  for (std::size_t k = 0; k < 3; ++k) {
    u[k] = std::int64_t{p[1].c[k]} - p[0].c[k];
    v[k] = std::int64_t{p[2].c[k]} - p[0].c[k];
  }
  for (std::size_t k = 0; k < 3; ++k) n[k] = u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3];
  std::array<int, 3> r{};
  for (std::size_t i = 0; i < 3; ++i) {
    exact::int128 value = 0;
    for (std::size_t k = 0; k < 3; ++k) value += exact::int128(n[k]) * (std::int64_t{q[i].c[k]} - p[0].c[k]);
    r[i] = value > 0 ? 1 : value < 0 ? -1 : 0;
  }
  return r;
}

/// The corner that the other plane cuts off, alone on its closed side: the first one strictly on a side that has none
/// of the others, else the only one on the plane. `side` becomes the side on which it counts as lying.
/// Precondition: not all signs are equal.
std::size_t apex(const std::array<int, 3>& s, int& side) {
  for (const bool on_plane : {false, true})
    for (std::size_t i = 0; i < 3; ++i) {
      const int j = s[(i + 1) % 3], k = s[(i + 2) % 3];
      side = on_plane ? -j : s[i];
      if (on_plane ? s[i] == 0 && j * k > 0 : side != 0 && side * j <= 0 && side * k <= 0) return i;
    }
  return 0;  // not reached
}

/// Does the line of an edge of p have q strictly on the other side than p? k: an axis along which p keeps its area.
bool edge_separates(const GridTriangle& p, const GridTriangle& q, std::size_t k) {
  const int inside = projected(p[0], p[1], p[2], k);
  for (std::size_t i = 0; i < 3; ++i) {
    bool outside = true;
    for (std::size_t j = 0; j < 3 && outside; ++j) outside = projected(p[i], p[(i + 1) % 3], q[j], k) * inside < 0;
    if (outside) return true;
  }
  return false;
}

/// Disjoint convex sets in a plane are separated by the line of an edge.
bool meet_in_plane(const GridTriangle& p, const GridTriangle& q) {
  std::size_t k = 0;
  while (projected(p[0], p[1], p[2], k) == 0) ++k;
  return !edge_separates(p, q, k) && !edge_separates(q, p, k);
}

bool all_equal(const std::array<int, 3>& s) { return s[0] == s[1] && s[0] == s[2]; }

}  // namespace

/// Where both planes cut the other triangle, each meets the common line in an interval between the two edges at the
/// corner that is cut off; the intervals are compared by the orientations of those edges.
bool meet(const GridTriangle& p, const GridTriangle& q) {
  const std::array<int, 3> sq = sides(p, q);
  if (all_equal(sq)) return sq[0] == 0 && meet_in_plane(p, q);
  const std::array<int, 3> sp = sides(q, p);
  if (all_equal(sp)) return false;
  int side_p = 0, side_q = 0;
  const std::size_t i = apex(sp, side_p), j = apex(sq, side_q);
  // Turned so that each cut-off corner lies on the other's positive side.
  const GridPoint &p0 = p[i], &q0 = q[j];
  const GridPoint &p1 = p[(i + (side_q > 0 ? 1 : 2)) % 3], &p2 = p[(i + (side_q > 0 ? 2 : 1)) % 3];
  const GridPoint &q1 = q[(j + (side_p > 0 ? 1 : 2)) % 3], &q2 = q[(j + (side_p > 0 ? 2 : 1)) % 3];
  return orientation(p0, p1, q0, q1) <= 0 && orientation(p0, p2, q2, q0) <= 0;
}

bool meet(const GridPoint& p, const GridPoint& q, const GridTriangle& t) {
  const int sp = orientation(t[0], t[1], t[2], p), sq = orientation(t[0], t[1], t[2], q);
  if (sp * sq > 0) return false;
  if (sp == 0 && sq == 0) return meet_in_plane(p, q, t);
  const int a = orientation(p, q, t[0], t[1]), b = orientation(p, q, t[1], t[2]), c = orientation(p, q, t[2], t[0]);
  return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
}

bool meet_out_of_place(const Body& mesh, std::uint32_t s, std::uint32_t t) {
  const GridTriangle p = triangle(mesh, s), q = triangle(mesh, t);
  const auto &a = mesh.triangles[s], &b = mesh.triangles[t];
  std::array<std::size_t, 3> shared_a{}, shared_b{};
  std::size_t shared = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (a[i] == b[j]) shared_a[shared] = i, shared_b[shared++] = j;
  if (shared == 3) return true;
  if (shared == 2) {
    // Coplanar with both third corners on one side of the common edge: an overlap.
    const std::size_t i = 3 - shared_a[0] - shared_a[1], j = 3 - shared_b[0] - shared_b[1];
    if (exact::orientation(p[0], p[1], p[2], q[j]) != 0) return false;
    const auto n = exact::plane_through(p[0], p[1], p[2]),
               m = exact::plane_through(p[shared_a[0]], p[shared_a[1]], q[j]);
    const auto own = exact::plane_through(p[shared_a[0]], p[shared_a[1]], p[i]);
    return n && m && own && exact::dot_sign(*m, *own) > 0;
  }
  if (shared == 1) {
    // What they share besides the corner reaches the opposite side of one of them.
    const std::size_t i = shared_a[0], j = shared_b[0];
    return meet(p[(i + 1) % 3], p[(i + 2) % 3], q) || meet(q[(j + 1) % 3], q[(j + 2) % 3], p);
  }
  return meet(p, q);
}

}  // namespace quoin::booleans
