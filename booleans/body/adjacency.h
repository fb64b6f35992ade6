/// \file
/// Which faces meet at an edge or a vertex of one body.
#pragma once

#include <algorithm>
#include <cassert>
#include <optional>
#include <span>
#include <vector>

#include "booleans/body/body.h"
#include "grid/lists/buckets.h"
#include "grid/lists/paged.h"

namespace quoin::booleans {

/// Incidence of one body: triangles by counting, polygon edges by sorting. The body must outlive it.
class Adjacency {
 public:
  /// Of all vertices.
  explicit Adjacency(const Body& body);
  /// Of those vertices only that have numbers, and of their edges. `where` holds all faces that have one.
  Adjacency(const Body& body, grid::Numbering known, std::span<const Chunk> where);

  bool is_complete() const { return is_complete_; }
  bool knows(std::uint32_t v) const { return is_complete_ || known_[v] != none; }

  /// visit(face, forward) for every face with the edge {u, v}, one end of which is known; forward: the face runs from u
  /// to v.
  template <class Visit>
  void faces_at_edge(std::uint32_t u, std::uint32_t v, Visit&& visit) const {
    assert(knows(u) || knows(v));
    // From the end with fewer triangles: the hub of a fan has them all.
    const auto of_u = triangles_at(u), of_v = triangles_at(v);
    const bool turned = !of_u || (of_v && of_v->size() < of_u->size());
    const std::uint32_t at = turned ? v : u, to = turned ? u : v;
    for (const std::uint32_t c : *(turned ? of_v : of_u)) {
      const std::uint32_t t = c / 3, k = c % 3;
      const auto& corners = body_.triangles[t];
      if (corners[k < 2 ? k + 1 : 0] == to) visit(t, !turned);
      if (corners[k > 0 ? k - 1 : 2] == to) visit(t, turned);
    }
    for_polygon_edges(at, [&](const PolygonEdge& e) {
      if (e.to == to) visit(e.face, e.forward != turned);
    });
  }

 private:
  void index(std::span<const Chunk> where);

  struct PolygonEdge {
    std::uint32_t from, to, face;
    bool forward;
  };

  /// The bucket of a vertex, none where it is not known.
  std::uint32_t bucket(std::uint32_t v) const { return is_complete_ ? v : known_[v]; }
  /// The corners of triangles there; nothing of a vertex that is not known.
  std::optional<std::span<const std::uint32_t>> triangles_at(std::uint32_t v) const {
    const std::uint32_t b = bucket(v);
    if (b == none) return std::nullopt;
    return body_.is_grid(v) ? corners_[b] : std::span<const std::uint32_t>();
  }
  template <class Visit>
  void for_polygon_edges(std::uint32_t u, Visit&& visit) const {
    auto at = std::lower_bound(edges_.begin(), edges_.end(), u,
                               [](const PolygonEdge& e, std::uint32_t w) { return e.from < w; });
    for (; at != edges_.end() && at->from == u; ++at) visit(*at);
  }

  const Body& body_;
  const bool is_complete_;
  grid::Numbering known_;     // of an incomplete one
  grid::Buckets<> corners_;   // of triangles (3 t + k), by bucket
  Array<PolygonEdge> edges_;  // both directions, sorted
};

}  // namespace quoin::booleans
