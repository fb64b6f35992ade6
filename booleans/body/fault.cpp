#include "booleans/body/fault.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "exact/predicates.h"
#include "grid/balance.h"

namespace quoin::booleans {
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

  if (body.polygons.loop_count(p) == 0) return name + " has no loop";
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
  Array<std::array<std::uint32_t, 2>> edges;
  for (std::uint32_t f = 0; f < body.face_count(); ++f)
    body.for_edges(f, [&](std::uint32_t u, std::uint32_t v) { edges.push_back({u, v}); });
  const Array<grid::OpenEdge> open = grid::open_edges(std::move(edges));
  if (open.empty()) return std::nullopt;

  const auto [low, high] = std::minmax(open[0].from, open[0].to);
  return "the edge from vertex " + std::to_string(low) + " to vertex " + std::to_string(high) +
         " is not balanced by its reverse";
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
