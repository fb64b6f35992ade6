#include "booleans/body/adjacency.h"

#include <algorithm>
#include <tuple>

namespace quoin::booleans {

Adjacency::Adjacency(const Body& body) : body_(body), start_(body.grid_points.size() + 2) {
  edges_.reserve(2 * body.polygons.corners.size());
  const Chunk all{0, static_cast<std::uint32_t>(body.face_count()), {}};
  index(body.is_packed ? std::span(&all, 1) : std::span<const Chunk>(body.chunks));
}

Adjacency::Adjacency(const Body& body, std::vector<std::uint8_t> marked, std::span<const Chunk> where)
    : body_(body), marked_(std::move(marked)), start_(body.grid_points.size() + 2) {
  index(where);
}

void Adjacency::index(std::span<const Chunk> where) {
  const auto triangles = static_cast<std::uint32_t>(body_.triangles.size());
  const auto for_corners = [&](auto&& visit) {
    for (const Chunk& c : where)
      for (std::uint32_t t = c.begin; t < std::min(c.end, triangles); ++t)
        for (std::uint32_t k = 0; k < 3; ++k)
          if (const std::uint32_t v = body_.triangles[t][k]; knows(v)) visit(v, 3 * t + k);
  };

  // Triangles, by counting.
  for_corners([&](std::uint32_t v, std::uint32_t) { ++start_[v + 2]; });
  for (std::size_t v = 2; v < start_.size(); ++v) start_[v] += start_[v - 1];
  corner_.resize(start_.back());
  for_corners([&](std::uint32_t v, std::uint32_t corner) { corner_[start_[v + 1]++] = corner; });

  // Edges of polygons, by sorting.
  for (const Chunk& c : where)
    for (std::uint32_t face = std::max(c.begin, triangles); face < c.end; ++face)
      body_.for_edges(face, [&](std::uint32_t u, std::uint32_t v) {
        if (knows(u)) edges_.push_back({u, v, face, true});
        if (knows(v)) edges_.push_back({v, u, face, false});
      });
  std::sort(edges_.begin(), edges_.end(), [](const PolygonEdge& a, const PolygonEdge& b) {
    return std::tie(a.from, a.to, a.face, a.forward) < std::tie(b.from, b.to, b.face, b.forward);
  });
}

}  // namespace quoin::booleans
