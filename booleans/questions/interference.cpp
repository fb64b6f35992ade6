#include "booleans/questions/interference.h"

#include <algorithm>

#include "booleans/questions/along_line.h"
#include "booleans/questions/pierce.h"
#include "exact/predicates.h"
#include "grid/lists/partition.h"

namespace quoin::booleans {
namespace {

using exact::Rational;

RationalPoint rational_vertex(const Body& body, std::uint32_t v) {
  const exact::Point p = body.point(v);
  return {exact::coordinate(p, 0), exact::coordinate(p, 1), exact::coordinate(p, 2)};
}

/// Whether all corners of a triangle of a lie strictly on one side of a triangle of b.
bool is_beside(const Index& a, std::uint32_t t, const Index& b, std::uint32_t u) {
  const exact::Plane plane = b.plane(u);
  int sum = 0;
  for (const std::uint32_t v : a.corners(t)) {
    const Body& body = a.body();
    sum += body.is_grid(v) ? exact::side(plane, body.grid_points[v]) : exact::side(plane, body.derived(v));
  }
  return sum == 3 || sum == -3;
}

/// An edge of a against a triangle of b. Where its inside passes through the triangle's the boundary of a has points
/// inside b.
Meeting edge_meeting(const Index& a, std::uint32_t from, std::uint32_t to, const Index& b, std::uint32_t u) {
  const RationalPoint p = rational_vertex(a.body(), from), q = rational_vertex(a.body(), to);
  const Line line(QueryPoint(p), {Rational(q[0] - p[0]), Rational(q[1] - p[1]), Rational(q[2] - p[2])});
  const Piercing piercing = pierce(b, line, u);
  if (piercing.kind == Piercing::Kind::miss) return Meeting::apart;
  if (piercing.kind == Piercing::Kind::along) {
    const auto along = parameters_along(b, line, u);
    return along && (*along)[0] <= 1 && (*along)[1] >= 0 ? Meeting::contact : Meeting::apart;
  }

  const Rational t = parameter(b, line, u);
  if (t < 0 || t > 1) return Meeting::apart;
  return piercing.is_inside && t > 0 && t < 1 ? Meeting::overlapping : Meeting::contact;
}

/// Two closed triangles have a point in common where an edge of one has one with the other.
Meeting triangle_meeting(const Index& a, std::uint32_t t, const Index& b, std::uint32_t u) {
  if (is_beside(a, t, b, u) || is_beside(b, u, a, t)) return Meeting::apart;
  Meeting found = Meeting::apart;
  const auto ask = [&](const Index& edges, std::uint32_t s, const Index& triangles, std::uint32_t r) {
    grid::for_loop_edges(edges.corners(s), [&](std::uint32_t from, std::uint32_t to) {
      if (found != Meeting::overlapping) found = std::max(found, edge_meeting(edges, from, to, triangles, r));
    });
  };
  ask(a, t, b, u);
  ask(b, u, a, t);
  return found;
}

Meeting boundary_meeting(const Index& a, const Index& b) {
  if (a.triangle_count() > b.triangle_count()) return boundary_meeting(b, a);
  constexpr Box nowhere_left{};
  Meeting found = Meeting::apart;
  Box shared = b.box();
  const auto always = [](std::size_t, std::uint32_t, const Box&) { return true; };
  a.tree().meeting(shared, always, [&](std::uint32_t t) {
    Box box;
    for (const std::uint32_t v : a.corners(t)) a.body().add_to(box, v);
    b.tree().meeting(box, always, [&](std::uint32_t u) {
      found = std::max(found, triangle_meeting(a, t, b, u));
      if (found == Meeting::overlapping) shared = box = nowhere_left;
    });
  });
  return found;
}

/// Whether a part of the boundary of a that hangs together lies inside b. Precondition: the boundaries are apart.
bool reaches_into(const Index& a, const Index& b) {
  grid::Partition parts(a.body().vertex_count());
  for (std::uint32_t t = 0; t < a.triangle_count(); ++t) {
    parts.unite(a.corners(t)[0], a.corners(t)[1]);
    parts.unite(a.corners(t)[0], a.corners(t)[2]);
  }
  for (std::uint32_t v = 0; v < a.body().vertex_count(); ++v)
    if (parts.find(v) == v && locate(b, QueryPoint(rational_vertex(a.body(), v))) > 0) return true;
  return false;
}

}  // namespace

Meeting meeting(const Index& a, const Index& b) {
  if (a.body().full_at_infinity && b.body().full_at_infinity) return Meeting::overlapping;
  if (const Meeting found = boundary_meeting(a, b); found != Meeting::apart) return found;
  // With boundaries apart the interiors meet only where one boundary reaches into the other's interior.
  return reaches_into(a, b) || reaches_into(b, a) ? Meeting::overlapping : Meeting::apart;
}

}  // namespace quoin::booleans
