#include "booleans/query.h"

#include <algorithm>
#include <numeric>

#include "exact/predicates.h"

namespace quoin::booleans {
namespace {

using exact::Rational;
using RationalPoint = std::array<Rational, 3>;

RationalPoint rational(const exact::Point& p) {
  return {exact::coordinate(p, 0), exact::coordinate(p, 1), exact::coordinate(p, 2)};
}

Rational value(const exact::Plane& plane, const RationalPoint& p) {
  ++exact::counters().rational;
  Rational r = exact::to_integer(plane.d);
  for (std::size_t k = 0; k < 3; ++k) r += plane.n[k] * p[k];
  return r;
}

/// Does the projection of the face along axis k cover the point, shifted by (-eps, -eps^2) in the two other axes (u,
/// v)? `on_edge` tells whether the point lies on the projection of an edge.
bool covers(const Body& body, std::uint32_t face, const RationalPoint& p, std::size_t k, bool& on_edge) {
  const std::size_t u = (k + 1) % 3, v = (k + 2) % 3;
  bool odd = false;
  on_edge = false;
  body.for_edges(face, [&](std::uint32_t i, std::uint32_t j) {
    const RationalPoint a = rational(body.point(i)), b = rational(body.point(j));
    const Rational turn = (b[u] - a[u]) * (p[v] - a[v]) - (b[v] - a[v]) * (p[u] - a[u]);
    if (turn == 0 && p[u] >= std::min(a[u], b[u]) && p[u] <= std::max(a[u], b[u]) && p[v] >= std::min(a[v], b[v]) &&
        p[v] <= std::max(a[v], b[v]))
      on_edge = true;
    if ((a[v] >= p[v]) == (b[v] >= p[v])) return;
    // The edge's u at height p_v is at least p_u: left of an upward edge, right of a downward one, or on it.
    if (b[v] > a[v] ? turn >= 0 : turn <= 0) odd = !odd;
  });
  return odd;
}

bool in_range(const Rational& x, std::int32_t low, std::int32_t high) { return x >= low && x <= high; }

}  // namespace

int locate(const Body& body, const RationalPoint& point) {
  if (!body.is_packed) return locate(packed(body), point);
  int winding = body.full_at_infinity ? 1 : 0;
  for (std::uint32_t f = 0; f < body.face_count(); ++f) {
    const Box box = face_box(body, f);
    if (!in_range(point[1], box.low[1], box.high[1]) || !in_range(point[2], box.low[2], box.high[2]) ||
        point[0] < box.low[0])
      continue;
    const exact::Plane plane = body.plane(f);
    const Rational at = value(plane, point);
    bool on_edge = false;
    if (at == 0) {
      std::size_t k = 0;
      for (std::size_t i = 1; i < 3; ++i)
        if (std::abs(plane.n[i]) > std::abs(plane.n[k])) k = i;
      if (covers(body, f, point, k, on_edge) || on_edge) return 0;
      continue;
    }
    // The face lies towards -x of the point when its plane's value and its normal's x have one sign.
    const std::int64_t nx = plane.n[0];
    if (nx == 0 || (at > 0) != (nx > 0) || !covers(body, f, point, 0, on_edge)) continue;
    winding += nx < 0 ? 1 : -1;  // coming from -x: entering through a face that looks towards -x
  }
  return winding > 0 ? 1 : -1;
}

std::optional<Box> bounds(const Body& body) {
  if (body.face_count() == 0) return std::nullopt;
  Box box;
  body.for_runs([&](std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t f = begin; f < end; ++f) box.add(face_box(body, f));
  });
  return box;
}

namespace {

/// A triangle's or polygon's own faults.
std::optional<std::string> face_fault(const Body& body, std::uint32_t f) {
  const std::string name = "face " + std::to_string(f);
  bool bad_index = false, short_edge = false;
  body.for_edges(f, [&](std::uint32_t u, std::uint32_t v) {
    bad_index = bad_index || u >= body.vertex_count() || v >= body.vertex_count();
    short_edge = short_edge || u == v;
  });
  if (bad_index) return name + " names a vertex that does not exist";
  if (short_edge) return name + " has an edge of length zero";
  if (f < body.triangles.size()) {
    const auto& t = body.triangles[f];
    for (std::uint32_t v : t)
      if (!body.is_grid(v)) return name + " is a raw triangle with a derived vertex";
    if (!exact::plane_through(body.grid_points[t[0]], body.grid_points[t[1]], body.grid_points[t[2]]))
      return name + " has no area";
    return std::nullopt;
  }
  const auto p = f - static_cast<std::uint32_t>(body.triangles.size());
  const exact::Plane& plane = body.planes[p];
  exact::int128 largest = plane.d < 0 ? -plane.d : plane.d;
  if (largest > exact::offset_limit) return name + " has an offset out of range";
  if (plane.n[0] == 0 && plane.n[1] == 0 && plane.n[2] == 0) return name + " has no normal";
  for (std::int64_t n : plane.n)
    if (n > exact::coefficient_limit || n < -exact::coefficient_limit) return name + " has a coefficient out of range";
  if (!(exact::reduced_plane(plane.n, plane.d) == plane)) return name + " has a plane that is not reduced";
  if (body.polygon_loops[p] == body.polygon_loops[p + 1]) return name + " has no loop";
  std::optional<std::string> message;
  body.for_corners(f, [&](std::uint32_t v) {
    if (message) return;
    if (v >= body.vertex_count())
      message = name + " names a vertex that does not exist";
    else if (exact::side(plane, body.point(v)) != 0)
      message = name + " has a corner off its plane: vertex " + std::to_string(v);
  });
  return message;
}

std::optional<std::string> balance_fault(const Body& body) {
  std::vector<std::array<std::uint32_t, 3>> edges;  // low, high, forward
  for (std::uint32_t f = 0; f < body.face_count(); ++f)
    body.for_edges(f, [&](std::uint32_t u, std::uint32_t v) {
      edges.push_back({std::min(u, v), std::max(u, v), u < v});
    });
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 0, j = 0; i < edges.size(); i = j) {
    std::int64_t balance = 0;
    for (; j < edges.size() && edges[j][0] == edges[i][0] && edges[j][1] == edges[i][1]; ++j)
      balance += edges[j][2] ? 1 : -1;
    if (balance != 0)
      return "the edge from vertex " + std::to_string(edges[i][0]) + " to vertex " + std::to_string(edges[i][1]) +
             " is not balanced by its reverse";
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> fault(const Body& body, std::int32_t world) {
  if (!body.is_packed) return fault(packed(body), world);
  for (std::uint32_t v = 0; v < body.vertex_count(); ++v) {
    const auto a = body.approximation(v);
    for (double x : a)
      if (std::fabs(x) > double(world))
        return "vertex " + std::to_string(v) + " lies outside the world of +-2^29 grid steps";
  }
  for (std::uint32_t f = 0; f < body.face_count(); ++f)
    if (auto message = face_fault(body, f)) return message;
  return balance_fault(body);
}

}  // namespace quoin::booleans
