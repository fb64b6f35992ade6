#include "booleans/body/adjacency.h"

#include <algorithm>
#include <tuple>

namespace quoin::booleans {

Adjacency::Adjacency(const Body& body) : body_(body), is_complete_(true) {
  const Chunk all{0, static_cast<std::uint32_t>(body.face_count()), {}};
  index(body.is_packed ? std::span(&all, 1) : std::span<const Chunk>(body.chunks));
}

Adjacency::Adjacency(const Body& body, grid::Numbering known, std::span<const Chunk> where)
    : body_(body), is_complete_(false), known_(std::move(known)) {
  index(where);
}

void Adjacency::index(std::span<const Chunk> where) {
  // Triangles, by counting.
  const auto triangles = static_cast<std::uint32_t>(body_.triangles.size());
  corners_.assign(is_complete_ ? body_.grid_points.size() : known_.size(), [&](auto&& visit) {
    for (const Chunk& c : where)
      for (std::uint32_t t = c.begin; t < std::min(c.end, triangles); ++t)
        for (std::uint32_t k = 0; k < 3; ++k)
          if (const std::uint32_t v = body_.triangles[t][k]; knows(v)) visit(bucket(v), 3 * t + k);
  });

  // Edges of polygons, by sorting; of a complete one those of a vertex by counting.
  const auto for_edges = [&](auto&& visit) {
    for (const Chunk& c : where)
      for (std::uint32_t face = std::max(c.begin, triangles); face < c.end; ++face)
        body_.for_edges(face, [&](std::uint32_t u, std::uint32_t v) {
          if (knows(u)) visit(u, PolygonEdge{u, v, face, true});
          if (knows(v)) visit(v, PolygonEdge{v, u, face, false});
        });
  };
  const auto less = [](const PolygonEdge& a, const PolygonEdge& b) {
    return std::tie(a.from, a.to, a.face, a.forward) < std::tie(b.from, b.to, b.face, b.forward);
  };
  if (!is_complete_) {
    for_edges([&](std::uint32_t, const PolygonEdge& e) { edges_.push_back(e); });
    std::sort(edges_.begin(), edges_.end(), less);
    return;
  }

  if (body_.polygons.corners.empty()) return;
  Array<std::uint32_t> start(body_.vertex_count() + 2);
  grid::counting_sort(std::span(start), for_edges, [&](std::size_t n) {
    edges_.resize(n);
    return edges_.data();
  });
  for (std::size_t v = 0; v + 2 < start.size(); ++v)
    std::sort(edges_.begin() + start[v], edges_.begin() + start[v + 1], less);
}

}  // namespace quoin::booleans
