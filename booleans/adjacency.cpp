#include "booleans/adjacency.h"

#include <tuple>

namespace quoin::booleans {

Adjacency::Adjacency(const Body& body) : Adjacency(body, std::vector<std::uint8_t>{}) {}

Adjacency::Adjacency(const Body& body, std::vector<std::uint8_t> marked)
    : body_(body), marked_(std::move(marked)), start_(body.grid_points.size() + 2) {
  for (const auto& t : body.triangles)
    for (std::uint32_t v : t) start_[v + 2] += knows(v);
  for (std::size_t v = 2; v < start_.size(); ++v) start_[v] += start_[v - 1];
  corner_.resize(start_.back());
  for (std::uint32_t t = 0; t < body.triangles.size(); ++t)
    for (std::uint32_t k = 0; k < 3; ++k)
      if (const std::uint32_t v = body.triangles[t][k]; knows(v)) corner_[start_[v + 1]++] = 3 * t + k;

  if (is_complete()) edges_.reserve(2 * body.corners.size());
  for (std::uint32_t p = 0; p < body.polygon_count(); ++p) {
    const auto face = static_cast<std::uint32_t>(body.triangles.size()) + p;
    for (std::uint32_t j = body.polygon_loops[p]; j < body.polygon_loops[p + 1]; ++j) {
      const auto loop = body.loop(j);
      for (std::size_t i = 0; i < loop.size() && loop.size() > 1; ++i) {
        const std::uint32_t u = loop[i], v = loop[i + 1 < loop.size() ? i + 1 : 0];
        if (knows(u)) edges_.push_back({u, v, face, true});
        if (knows(v)) edges_.push_back({v, u, face, false});
      }
    }
  }
  std::sort(edges_.begin(), edges_.end(), [](const PolygonEdge& a, const PolygonEdge& b) {
    return std::tie(a.from, a.to, a.face, a.forward) < std::tie(b.from, b.to, b.face, b.forward);
  });
}

}  // namespace quoin::booleans
