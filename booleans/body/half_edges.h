/// \file
/// The directed edges of faces, those of one undirected edge side by side.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <vector>

namespace quoin::booleans {

/// A directed edge of a face.
struct HalfEdge {
  std::uint32_t from, to, face;
  std::uint32_t run;  // the first of its undirected edge in the list of all
  bool kept;          // it bounds its merged face
};
using HalfEdges = std::vector<HalfEdge>;

/// By a key below `bound`, then by `less`: a counting sort, and small sorts within. Returns where each key begins.
template <class Key, class Less>
std::vector<std::uint32_t> sort_by(HalfEdges& edges, std::size_t bound, Key&& key, Less&& less) {
  std::vector<std::uint32_t> start(bound + 1);
  for (const HalfEdge& e : edges) ++start[key(e) + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());

  HalfEdges sorted(edges.size());
  std::vector<std::uint32_t> at(start.begin(), start.end() - 1);
  for (const HalfEdge& e : edges) sorted[at[key(e)]++] = e;

  for (std::size_t i = 0; i < bound; ++i) std::sort(sorted.begin() + start[i], sorted.begin() + start[i + 1], less);
  edges.swap(sorted);
  return start;
}

/// All half-edges of `face_count` faces, by undirected edge, then by face, then by direction.
/// for_edges(face, visit): visit(from, to) for the half-edges of a face, `most` of all faces together.
template <class ForEdges>
HalfEdges half_edges(std::size_t face_count, std::size_t vertex_count, std::size_t most, ForEdges&& for_edges) {
  HalfEdges edges;
  edges.reserve(most);
  for (std::uint32_t f = 0; f < face_count; ++f)
    for_edges(f, [&](std::uint32_t u, std::uint32_t v) { edges.push_back({u, v, f, 0, true}); });

  sort_by(
      edges, vertex_count, [](const HalfEdge& e) { return std::min(e.from, e.to); },
      [](const HalfEdge& a, const HalfEdge& b) {
        const std::uint32_t p = std::max(a.from, a.to), q = std::max(b.from, b.to);
        return std::tie(p, a.face, a.from) < std::tie(q, b.face, b.from);
      });
  return edges;
}

/// visit(begin, end) for the half-edges of every undirected edge. Stops where a visit returns false.
template <class Visit>
void for_undirected_edges(const HalfEdges& edges, Visit&& visit) {
  for (std::size_t i = 0, j = 0; i < edges.size(); i = j) {
    const auto ends = std::minmax(edges[i].from, edges[i].to);
    while (j < edges.size() && std::minmax(edges[j].from, edges[j].to) == ends) ++j;
    if (!visit(i, j)) return;
  }
}

}  // namespace quoin::booleans
