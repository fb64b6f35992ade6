#include "booleans/edges.h"

#include <algorithm>

#include "booleans/body/around_edge.h"
#include "grid/lists/buckets.h"

namespace quoin::booleans {
namespace {

/// A half-edge at its lower vertex.
struct Half {
  std::uint32_t high, corner;
};

/// The faces and loops of all corners.
void number_corners(const Boundary& boundary, Edges& edges) {
  const auto& faces = boundary.faces;
  edges.face.resize(faces.corners.size());
  edges.loop.resize(faces.corners.size());
  for (std::uint32_t f = 0; f < boundary.face_count(); ++f)
    for (std::uint32_t j = faces.face_start[f]; j < faces.face_start[f + 1]; ++j)
      for (std::uint32_t c = faces.loop_start[j]; c < faces.loop_start[j + 1]; ++c) {
        edges.face[c] = f;
        edges.loop[c] = j;
      }
}

/// All half-edges by their lower vertex, those of an edge side by side, by corner.
grid::Buckets<Half> halves_of(const Boundary& boundary, const Edges& edges) {
  const auto& corners = boundary.faces.corners;
  grid::Buckets<Half> halves(boundary.vertices.size(), [&](auto&& visit) {
    for (std::uint32_t c = 0; c < corners.size(); ++c) {
      const std::uint32_t u = corners[c], v = corners[next_corner(boundary, edges, c)];
      if (u != v) visit(std::min(u, v), Half{std::max(u, v), c});
    }
  });
  for (std::size_t v = 0; v < halves.size(); ++v)
    std::sort(halves[v].begin(), halves[v].end(),
              [](const Half& a, const Half& b) { return a.high != b.high ? a.high < b.high : a.corner < b.corner; });
  return halves;
}

/// The axis in which a segment between two vertices in ascending order runs, upwards.
int axis_between(const exact::Point& low, const exact::Point& high) {
  for (int k = 0; k < 2; ++k)
    if (exact::compare_along(k, low, high) != 0) return k;
  return 2;
}

/// The half-edges of one edge in their order around it.
void turn(const Boundary& boundary, const Edges& edges, std::uint32_t low, std::uint32_t high,
          std::vector<std::uint32_t>& fan) {
  if (fan.size() == 2) return;
  sort_around(
      fan, axis_between(boundary.vertices[low], boundary.vertices[high]), 1,
      [&](std::uint32_t c) -> const exact::Plane& { return boundary.planes[edges.face[c]]; },
      [&](std::uint32_t c) { return is_forward(boundary, edges, c); });
}

/// The solid lies counter-clockwise after a half-edge that runs backward, and before one that runs forward. They are
/// paired as brackets are, since around an edge of a body that was trusted wrongly they need not alternate; then, too,
/// all have a pair.
void pair_by_wedges(const Boundary& boundary, std::span<const std::uint32_t> fan, std::vector<std::uint32_t>& open,
                    Edges& edges) {
  open.clear();
  for (int round = 0; round < 2; ++round)
    for (const std::uint32_t c : fan) {
      if (edges.opposite[c] != c) continue;
      if (!is_forward(boundary, edges, c)) {
        if (round == 0) open.push_back(c);
      } else if (!open.empty()) {
        edges.opposite[c] = open.back();
        edges.opposite[open.back()] = c;
        open.pop_back();
      }
    }
}

}  // namespace

Edges edges_of(const Boundary& boundary) {
  Edges edges;
  number_corners(boundary, edges);
  const grid::Buckets<Half> halves = halves_of(boundary, edges);

  const std::size_t corner_count = boundary.faces.corners.size();
  edges.edge.assign(corner_count, none);
  edges.opposite.resize(corner_count);
  for (std::uint32_t c = 0; c < corner_count; ++c) edges.opposite[c] = c;
  edges.fan.reserve(corner_count);

  std::vector<std::uint32_t> fan, open;
  for (std::uint32_t low = 0; low < halves.size(); ++low)
    for (std::size_t i = 0; i < halves[low].size();) {
      const std::uint32_t high = halves[low][i].high;
      fan.clear();
      for (; i < halves[low].size() && halves[low][i].high == high; ++i) fan.push_back(halves[low][i].corner);

      turn(boundary, edges, low, high, fan);
      for (const std::uint32_t c : fan) edges.edge[c] = static_cast<std::uint32_t>(edges.ends.size());
      pair_by_wedges(boundary, fan, open, edges);
      edges.ends.push_back({low, high});
      edges.fan.insert(edges.fan.end(), fan.begin(), fan.end());
      edges.fan_start.push_back(static_cast<std::uint32_t>(edges.fan.size()));
    }
  return edges;
}

}  // namespace quoin::booleans
