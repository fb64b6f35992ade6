#include "booleans/surface/triangulate.h"

#include <cassert>
#include <cmath>

#include "booleans/surface/corners.h"

namespace quoin::booleans {
namespace {

/// A permutation of 32-bit words that looks random (the finalizer of MurmurHash3).
std::uint32_t scrambled(std::uint32_t x) {
  x ^= x >> 16;
  x *= 0x85ebca6bU;
  x ^= x >> 13;
  x *= 0xc2b2ae35U;
  x ^= x >> 16;
  return x;
}

/// One number for both directions of an edge.
std::uint64_t undirected_key(std::uint32_t a, std::uint32_t b) {
  return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
}

}  // namespace

void SweepStatus::set_child_of_parent(Index parent, Index old, Index node) {
  if (parent == none) {
    root_ = node;
  } else {
    nodes_[parent].child[nodes_[parent].child[top] == old ? top : bottom] = node;
  }
}

void SweepStatus::link_neighbours(Index below, Index above) {
  if (below == none) {
    lowest_ = above;
  } else {
    nodes_[below].neighbour[top] = above;
  }
  if (above != none) nodes_[above].neighbour[bottom] = below;
}

void SweepStatus::rotate_up(Index node) {
  const Index parent = nodes_[node].parent;
  const Side side = nodes_[parent].child[top] == node ? top : bottom;
  const Side other = side == top ? bottom : top;
  const Index moved = nodes_[node].child[other];
  nodes_[parent].child[side] = moved;
  if (moved != none) nodes_[moved].parent = parent;
  const Index grandparent = nodes_[parent].parent;
  set_child_of_parent(grandparent, parent, node);
  nodes_[node].parent = grandparent;
  nodes_[node].child[other] = parent;
  nodes_[parent].parent = node;
}

void SweepStatus::insert_above(Index below, Index node) {
  const Index above = below == none ? lowest_ : nodes_[below].neighbour[top];
  nodes_[node] = Node{};
  nodes_[node].priority = scrambled(node + 1);
  link_neighbours(below, node);
  link_neighbours(node, above);
  // Of two neighbours in order, one has no child on the side of the other.
  if (below != none && nodes_[below].child[top] == none) {
    nodes_[below].child[top] = node;
    nodes_[node].parent = below;
  } else if (above != none) {
    nodes_[above].child[bottom] = node;
    nodes_[node].parent = above;
  } else {
    root_ = node;
  }
  while (nodes_[node].parent != none && nodes_[nodes_[node].parent].priority < nodes_[node].priority) rotate_up(node);
}

void SweepStatus::replace(Index old, Index node) {
  // The place keeps its priority, so that the heap stays one.
  nodes_[node] = nodes_[old];
  const Node& moved = nodes_[node];
  set_child_of_parent(moved.parent, old, node);
  for (const Index child : moved.child) {
    if (child != none) nodes_[child].parent = node;
  }
  link_neighbours(moved.neighbour[bottom], node);
  link_neighbours(node, moved.neighbour[top]);
}

void SweepStatus::erase(Index node) {
  for (;;) {
    const auto [lower, upper] = nodes_[node].child;
    if (lower == none || upper == none) {
      const Index only = lower == none ? upper : lower;
      set_child_of_parent(nodes_[node].parent, node, only);
      if (only != none) nodes_[only].parent = nodes_[node].parent;
      break;
    }
    rotate_up(nodes_[lower].priority > nodes_[upper].priority ? lower : upper);
  }
  link_neighbours(nodes_[node].neighbour[bottom], nodes_[node].neighbour[top]);
}

void SweepChains::link(Index lower, Index upper) {
  nodes_[lower].link[top] = upper;
  nodes_[upper].link[bottom] = lower;
}

SweepChains::Chain SweepChains::single(std::uint32_t vertex) {
  const Index node = static_cast<Index>(nodes_.size());
  nodes_.push_back({vertex});
  return {{node, node}, node};
}

std::pair<SweepChains::Chain, SweepChains::Chain> SweepChains::split_at_tip(const Chain& chain) {
  const Chain lower = {{chain.end[bottom], chain.tip}, chain.tip};
  Chain upper = single(vertex(chain.tip));
  if (chain.tip != chain.end[top]) {
    link(upper.tip, nodes_[chain.tip].link[top]);
    upper.end[top] = chain.end[top];
  }
  return {lower, upper};
}

void SweepChains::append(Chain& chain, Side side, Index keep, std::uint32_t vertex) {
  const Index node = static_cast<Index>(nodes_.size());
  nodes_.push_back({vertex});
  if (side == top) {
    link(keep, node);
  } else {
    link(node, keep);
  }
  chain.end[side] = chain.tip = node;
}

SweepChains::Chain SweepChains::join(const Chain& lower, const Chain& upper) {
  // The upper copy of the shared vertex goes; an appended vertex has a neighbour on the far side.
  assert(upper.end[bottom] != upper.end[top]);
  link(lower.tip, nodes_[upper.end[bottom]].link[top]);
  return {{lower.end[bottom], upper.end[top]}, lower.tip};
}

bool gather_segments(std::span<const FaceEdge> edges, const Scratch<std::uint32_t>& rank, std::size_t rank_count,
                     Scratch<SweepSegment>& segments) {
  for (const FaceEdge& edge : edges)
    if (edge[0] == edge[1]) return false;

  Scratch<std::uint32_t> start(rank_count + 2, 0);
  const auto for_segments = [&](auto&& visit) {
    for (const FaceEdge& edge : edges) {
      const std::uint32_t from = rank[edge[0]], to = rank[edge[1]];
      const bool rightward = from < to;
      const std::uint32_t left = rightward ? from : to, right = rightward ? to : from;
      visit(left, SweepSegment{left, right, !rightward, rightward});
    }
  };
  grid::counting_sort(std::span(start.data(), start.size()), for_segments, [&](std::size_t n) {
    segments.resize(n);
    return segments.data();
  });

  std::size_t kept = 0;
  for (std::size_t v = 0; v < rank_count; ++v) {
    const auto begin = segments.begin() + start[v], end = segments.begin() + start[v + 1];
    const auto by_right = [](const SweepSegment& a, const SweepSegment& b) { return a.right < b.right; };
    if (end - begin > 1) std::sort(begin, end, by_right);
    for (auto s = begin; s != end; ++s) {
      if (s == begin || segments[kept - 1].right != s->right) {
        segments[kept++] = *s;
        continue;
      }
      SweepSegment& slit = segments[kept - 1];
      if ((slit.inside_above && s->inside_above) || (slit.inside_below && s->inside_below)) return false;
      slit.inside_above = slit.inside_below = true;
    }
  }
  segments.resize(kept);
  return true;
}

bool single_loop(std::uint32_t vertex_count, std::span<const FaceEdge> edges, Scratch<std::uint32_t>& loop) {
  constexpr std::uint32_t no_end = UINT32_MAX;
  loop.clear();
  if (edges.size() < 3) return false;
  Scratch<std::uint32_t> next(vertex_count, no_end);
  for (const FaceEdge& edge : edges) {
    if (edge[0] >= vertex_count || edge[1] >= vertex_count || next[edge[0]] != no_end) return false;
    next[edge[0]] = edge[1];
  }
  const std::uint32_t start = edges[0][0];
  for (std::uint32_t v = start; loop.size() < edges.size(); v = next[v]) {
    if (v == no_end || (v == start && !loop.empty())) return false;
    loop.push_back(v);
  }
  return next[loop.back()] == start;
}

void FlipMesh::find_barriers(std::uint32_t vertex_count, std::span<const FaceEdge> constrained) {
  constrained_to_.assign(vertex_count, none);
  barriers_.clear();
  for (const FaceEdge& edge : constrained) {
    std::uint32_t& to = constrained_to_[edge[0]];
    if (to == none)
      to = edge[1];
    else
      barriers_.push_back(undirected_key(edge[0], edge[1]));
  }
  std::sort(barriers_.begin(), barriers_.end());
}

void FlipMesh::add_edge(std::uint32_t half, std::uint32_t twin) {
  const std::uint32_t edge = edge_count();
  half_of_.push_back(half);
  move(half, edge, twin);
}

template <class Visit>
void FlipMesh::for_halves(Visit&& visit) const {
  for (std::uint32_t half = 0; half < corners_.size(); half += 3) {
    const std::uint32_t a = corners_[half], b = corners_[half + 1], c = corners_[half + 2];
    visit(half, a, b);
    visit(half + 1, b, c);
    visit(half + 2, c, a);
  }
}

/// Edges in the order of their ends, by a matrix.
void FlipMesh::find_twins_of_few(std::uint32_t vertex_count, std::span<const FaceEdge> constrained) {
  constexpr std::uint8_t empty = 255, barrier = 254;
  std::fill_n(between_.begin(), vertex_count * vertex_count, empty);
  const auto between = [&](std::uint32_t a, std::uint32_t b) -> std::uint8_t& {
    return between_[vertex_count * a + b];
  };
  for (const FaceEdge& edge : constrained) between(edge[0], edge[1]) = between(edge[1], edge[0]) = barrier;
  for_halves([&](std::uint32_t half, std::uint32_t a, std::uint32_t b) {
    if (between(a, b) != barrier) between(a, b) = static_cast<std::uint8_t>(half);
  });

  for (std::uint32_t low = 0; low < vertex_count; ++low)
    for (std::uint32_t high = low + 1; high < vertex_count; ++high) {
      const std::uint8_t up = between(low, high), down = between(high, low);
      if (up < barrier && down < barrier) add_edge(std::min(up, down), std::max(up, down));
    }
}

/// The same by sorting. A half-edge that is left out leaves its twin, if it has one, alone.
void FlipMesh::find_twins_of_many(std::uint32_t vertex_count, std::span<const FaceEdge> constrained) {
  find_barriers(vertex_count, constrained);
  halves_.assign(vertex_count, [&](auto&& visit) {
    for_halves([&](std::uint32_t half, std::uint32_t a, std::uint32_t b) {
      if (constrained_to_[a] != b) visit(std::min(a, b), Half{std::max(a, b), half});
    });
  });
  for (std::uint32_t low = 0; low < vertex_count; ++low) {
    const auto own = halves_[low];
    if (own.size() < 2) continue;
    const auto less = [](const Half& a, const Half& b) { return a.high < b.high; };
    sort_by_few_comparisons(own.begin(), own.end(), less);
    for (std::size_t i = 0; i + 1 < own.size(); ++i) {
      if (own[i].high != own[i + 1].high) continue;
      if (std::binary_search(barriers_.begin(), barriers_.end(), undirected_key(low, own[i].high))) continue;
      add_edge(own[i].half, own[i + 1].half);
    }
  }
}

void FlipMesh::assign(std::uint32_t vertex_count, std::span<FaceTriangle> triangles,
                      std::span<const FaceEdge> constrained) {
  corners_ = {triangles.empty() ? nullptr : triangles[0].data(), 3 * triangles.size()};
  links_.assign(corners_.size(), Link{});
  half_of_.clear();
  // A triangulation of few vertices has less than six half-edges for each of them.
  if (vertex_count <= few_vertices && corners_.size() < 6 * few_vertices)
    find_twins_of_few(vertex_count, constrained);
  else
    find_twins_of_many(vertex_count, constrained);
}

void FlipMesh::move(std::uint32_t half, std::uint32_t edge, std::uint32_t twin) {
  links_[half] = {twin, edge};
  if (edge == none) return;
  links_[twin] = {half, edge};
  half_of_[edge] = half;
}

std::array<std::uint32_t, 4> FlipMesh::quadrilateral(std::uint32_t edge) const {
  const std::uint32_t half = half_of_[edge], twin = links_[half].twin;
  return {origin(half), origin(twin), origin(previous_corner(half)), origin(previous_corner(twin))};
}

void FlipMesh::flip(std::uint32_t edge) {
  const auto [a, b, c, d] = quadrilateral(edge);
  const std::uint32_t half = half_of_[edge], twin = links_[half].twin;
  const std::array<std::uint32_t, 4> old = {next_corner(half), previous_corner(half), next_corner(twin),
                                            previous_corner(twin)};
  std::array<std::uint32_t, 4> edges, twins;
  for (std::size_t i = 0; i < 4; ++i) {
    edges[i] = links_[old[i]].edge;
    twins[i] = links_[old[i]].twin;
  }
  const std::uint32_t first = half - half % 3, second = twin - twin % 3;
  const FaceTriangle left = {d, b, c}, right = {a, d, c};
  std::copy(left.begin(), left.end(), corners_.begin() + first);
  std::copy(right.begin(), right.end(), corners_.begin() + second);
  move(first + 1, edges[0], twins[0]);
  move(second + 2, edges[1], twins[1]);
  move(second + 0, edges[2], twins[2]);
  move(first + 0, edges[3], twins[3]);
  move(first + 2, edge, second + 1);
}

std::array<std::uint32_t, 4> FlipMesh::sides(std::uint32_t edge) const {
  const std::uint32_t half = half_of_[edge], twin = links_[half].twin;
  return {links_[next_corner(half)].edge, links_[previous_corner(half)].edge, links_[next_corner(twin)].edge,
          links_[previous_corner(twin)].edge};
}

bool prefers_other_diagonal(const std::array<double, 2>& a, const std::array<double, 2>& b,
                            const std::array<double, 2>& c, const std::array<double, 2>& d) {
  // The angles at c and d over the edge a b sum to more than 180 degrees: sin(c + d) < 0.
  const auto corner = [](const std::array<double, 2>& p, const std::array<double, 2>& from,
                         const std::array<double, 2>& to) {
    const double ux = from[0] - p[0], uy = from[1] - p[1], vx = to[0] - p[0], vy = to[1] - p[1];
    return std::array<double, 2>{ux * vy - uy * vx, ux * vx + uy * vy};
  };
  const auto [sin_c, cos_c] = corner(c, a, b);
  const auto [sin_d, cos_d] = corner(d, b, a);
  const double left = sin_c * cos_d, right = cos_c * sin_d;
  // The margin keeps rounding from flipping edges of cocircular points back and forth.
  return left + right < -1e-9 * (std::abs(left) + std::abs(right));
}

}  // namespace quoin::booleans
