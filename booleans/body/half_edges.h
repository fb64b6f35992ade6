/// \file
/// The directed edges of faces, those of one undirected edge side by side.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>

#include "grid/lists/buckets.h"

namespace quoin::booleans {

/// A directed edge of a face.
struct HalfEdge {
  std::uint32_t from, to, face;
  std::uint32_t run;  // the first of its undirected edge in the list of all
  bool kept;          // it bounds its merged face
};
using HalfEdges = grid::Buckets<HalfEdge>;

/// All half-edges of `face_count` faces, in buckets by their lower vertex, in these by undirected edge, then by face,
/// then by direction. for_edges(face, visit): visit(from, to) for the half-edges of a face; it is called twice.
template <class ForEdges>
HalfEdges half_edges(std::size_t face_count, std::size_t vertex_count, ForEdges&& for_edges) {
  HalfEdges edges(vertex_count, [&](auto&& visit) {
    for (std::uint32_t f = 0; f < face_count; ++f)
      for_edges(f, [&](std::uint32_t u, std::uint32_t v) { visit(std::min(u, v), HalfEdge{u, v, f, 0, true}); });
  });
  edges.sort_each([](const HalfEdge& a, const HalfEdge& b) {
    const std::uint32_t p = std::max(a.from, a.to), q = std::max(b.from, b.to);
    return std::tie(p, a.face, a.from) < std::tie(q, b.face, b.from);
  });
  return edges;
}

/// visit(begin, end) for the half-edges of every undirected edge. Stops where a visit returns false.
template <class Visit>
void for_undirected_edges(std::span<const HalfEdge> edges, Visit&& visit) {
  for (std::size_t i = 0, j = 0; i < edges.size(); i = j) {
    const auto ends = std::minmax(edges[i].from, edges[i].to);
    while (j < edges.size() && std::minmax(edges[j].from, edges[j].to) == ends) ++j;
    if (!visit(i, j)) return;
  }
}

}  // namespace quoin::booleans
