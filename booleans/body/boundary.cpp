#include "booleans/body/boundary.h"

#include <algorithm>
#include <numeric>

namespace quoin::booleans {
namespace {

/// Adds the vertices, grid points first. Returns their ids in the body.
std::vector<std::uint32_t> add_vertices(const std::vector<exact::Point>& vertices, Body& body) {
  std::vector<std::uint32_t> id(vertices.size());
  for (const bool grid : {true, false})
    for (std::size_t v = 0; v < id.size(); ++v) {
      const exact::Point& p = vertices[v];
      if (exact::is_grid(p) != grid) continue;

      id[v] = static_cast<std::uint32_t>(body.vertex_count());
      if (grid)
        body.grid_points.push_back(exact::grid_point(p));
      else
        body.points.push_back(p);
    }
  return id;
}

}  // namespace

bool is_raw(const Boundary& boundary, std::size_t face) {
  if (boundary.faces.loop_count(face) != 1 || boundary.faces.corner_count(face) != 3) return false;
  const auto corners = boundary.faces.corners_of(face);
  return std::all_of(corners.begin(), corners.end(),
                     [&](std::uint32_t v) { return exact::is_grid(boundary.vertices[v]); });
}

Body body_of(const Boundary& boundary) {
  Body body;
  body.full_at_infinity = boundary.full_at_infinity;
  body.labels.origins = boundary.labels.origins;
  const std::vector<std::uint32_t> id = add_vertices(boundary.vertices, body);

  for (std::size_t f = 0; f < boundary.face_count(); ++f) {
    if (is_raw(boundary, f)) {
      const auto corners = boundary.faces.corners_of(f);
      body.triangles.push_back({id[corners[0]], id[corners[1]], id[corners[2]]});
      if (boundary.labels) body.labels.triangles.push_back(boundary.labels.polygons[f]);
      continue;
    }

    body.planes.push_back(boundary.planes[f]);
    if (boundary.labels) {
      const auto [begin, end] = boundary.faces.corner_range(f);
      body.labels.polygons.push_back(boundary.labels.polygons[f]);
      body.labels.append_borders(boundary.labels, begin, end, static_cast<std::uint32_t>(body.polygons.corners.size()));
    }
    boundary.faces.for_loops(f, [&](std::span<const std::uint32_t> loop) {
      for (const std::uint32_t v : loop) body.polygons.corners.push_back(id[v]);
      body.polygons.end_loop();
    });
    body.polygons.end_face();
  }
  return body;
}

std::vector<std::uint32_t> faces_in_order_of_body(const Boundary& boundary) {
  std::vector<std::uint32_t> order(boundary.face_count());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_partition(order.begin(), order.end(), [&](std::uint32_t f) { return is_raw(boundary, f); });
  return order;
}

bool operator==(const Boundary& a, const Boundary& b) {
  return a.full_at_infinity == b.full_at_infinity && a.planes == b.planes && a.faces == b.faces &&
         std::equal(a.vertices.begin(), a.vertices.end(), b.vertices.begin(), b.vertices.end(), is_same);
}

std::size_t edge_count(const Boundary& boundary) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (std::size_t f = 0; f < boundary.face_count(); ++f)
    boundary.faces.for_edges(f, [&](std::uint32_t u, std::uint32_t v) { edges.push_back(std::minmax(u, v)); });

  std::sort(edges.begin(), edges.end());
  return static_cast<std::size_t>(std::unique(edges.begin(), edges.end()) - edges.begin());
}

}  // namespace quoin::booleans
