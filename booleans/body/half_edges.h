/// \file
/// The directed edges of faces, those of one undirected edge side by side.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>

#include "grid/lists/buckets.h"
#include "grid/lists/stretches.h"

namespace quoin::booleans {

/// A directed edge of a face.
struct HalfEdge {
  std::uint32_t from, to, face;
  std::uint32_t run;  // the first of its undirected edge in the list of all
  bool kept;          // it bounds its merged face
  bool flat = false;  // it does so alone with another face on its plane, which carries something else
};
using HalfEdges = grid::Buckets<HalfEdge>;

/// Sorts the half-edges of each bucket, no two of which are equal.
template <class Less>
void sort_each(HalfEdges& edges, Less less) {
  grid::in_stretches(edges.size(), grid::stretch(std::size_t{1} << 13),
                     [&](std::size_t, std::size_t begin, std::size_t end) {
                       for (std::size_t k = begin; k < end; ++k) std::sort(edges[k].begin(), edges[k].end(), less);
                     });
}

/// All half-edges of `face_count` faces, in buckets by their lower vertex, in these by undirected edge, then by face,
/// then by direction. for_edges(face, visit): visit(from, to) for the half-edges of a face; it is called twice.
template <class ForEdges>
HalfEdges half_edges(std::size_t face_count, std::size_t vertex_count, ForEdges&& for_edges) {
  HalfEdges edges(vertex_count, [&](auto&& visit) {
    for (std::uint32_t f = 0; f < face_count; ++f)
      for_edges(f, [&](std::uint32_t u, std::uint32_t v) { visit(std::min(u, v), HalfEdge{u, v, f, 0, true}); });
  });
  sort_each(edges, [](const HalfEdge& a, const HalfEdge& b) {
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
