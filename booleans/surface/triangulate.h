/// \file
/// Exact triangulation of a planar face with holes, over abstract predicates.
///
/// Method: plane sweep in lexicographic order (Hertel & Mehlhorn 1983). Between two neighbouring active segments lies
/// an interval, inside or outside the face; an inside one keeps the chain of vertices that bounds its triangles so far.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "grid/lists/buckets.h"
#include "grid/lists/loops.h"
#include "grid/lists/thresholds.h"

namespace quoin::booleans {

/// A boundary edge (from, to); the face's interior is on its left. A slit is present in both directions.
using FaceEdge = std::array<std::uint32_t, 2>;
/// Three vertex ids, counter-clockwise.
using FaceTriangle = std::array<std::uint32_t, 3>;

/// A list that is filled again for each face.
template <class T>
using Scratch = grid::Array<T>;

/// Stable. Insertion for short lists, else merging, which takes the fewest comparisons of the standard sorts.
template <class Iterator, class Less>
void sort_by_few_comparisons(Iterator begin, Iterator end, Less less) {
  if (end - begin > grid::thresholds().few_sorted) return std::stable_sort(begin, end, less);
  for (Iterator i = begin; i != end; ++i)
    for (Iterator j = i; j != begin && less(*j, *(j - 1)); --j) std::iter_swap(j, j - 1);
}

/// Exact predicates on points of a plane that are known by ids.
/// `compare`: lexicographic order by (x, y), -1, 0 or +1.
/// `orientation`: +1 where a, b, c turn left, 0 where they are collinear, -1 where they turn right.
template <class Points>
concept PlanarPoints = requires(const Points& points, std::uint32_t id) {
  { points.compare(id, id) } -> std::convertible_to<int>;
  { points.orientation(id, id, id) } -> std::convertible_to<int>;
};

/// The segments that cross the sweep line, bottom to top: a threaded treap of segment indices.
/// Priorities are a hash of the index, so the shape, and with it the number of predicates asked, is reproducible.
/// Insertion, replacement and removal ask no predicate: the place is given by a neighbour.
class SweepStatus {
 public:
  using Index = std::uint32_t;
  static constexpr Index none = UINT32_MAX;
  enum Side : unsigned { bottom = 0, top = 1 };

  /// For segments 0 .. capacity - 1, none of them active.
  void reset(std::size_t capacity) {
    nodes_.resize(capacity);
    root_ = lowest_ = none;
  }

  Index root() const { return root_; }
  Index child(Index node, Side side) const { return nodes_[node].child[side]; }
  /// The next active segment on that side, or `none`.
  Index neighbour(Index node, Side side) const { return nodes_[node].neighbour[side]; }
  Index lowest() const { return lowest_; }

  /// Puts `node` right above `below`, or lowest when `below` is `none`.
  void insert_above(Index below, Index node);
  /// Puts the inactive `node` in the place of the active `old`.
  void replace(Index old, Index node);
  void erase(Index node);

 private:
  struct Node {
    std::array<Index, 2> child = {none, none};
    std::array<Index, 2> neighbour = {none, none};
    Index parent = none;
    std::uint32_t priority = 0;
  };

  void set_child_of_parent(Index parent, Index old, Index node);
  void link_neighbours(Index below, Index above);
  void rotate_up(Index node);

  Scratch<Node> nodes_;
  Index root_ = none;
  Index lowest_ = none;
};

/// The chains of the inside intervals: doubly linked vertices, bottom to top, the untriangulated part on the right.
/// Law: a chain nowhere turns right, so what a new vertex sees of it is contiguous and contains the tip.
class SweepChains {
 public:
  using Index = std::uint32_t;
  static constexpr Index none = UINT32_MAX;
  using Side = SweepStatus::Side;
  static constexpr Side bottom = SweepStatus::bottom;
  static constexpr Side top = SweepStatus::top;

  /// `end`: the outermost nodes. `tip`: the node that was added last, the lexicographically greatest.
  struct Chain {
    std::array<Index, 2> end = {none, none};
    Index tip = none;
    bool exists() const { return tip != none; }
  };

  /// Without a chain.
  void reset() { nodes_.clear(); }
  std::uint32_t vertex(Index node) const { return nodes_[node].vertex; }
  Index neighbour(Index node, Side side) const { return nodes_[node].link[side]; }
  /// A chain of one vertex.
  Chain single(std::uint32_t vertex);
  /// Cuts at the tip, which both parts keep: {lower, upper}.
  std::pair<Chain, Chain> split_at_tip(const Chain& chain);
  /// Drops what lies beyond `keep` on `side` and appends a vertex there, which becomes the tip.
  void append(Chain& chain, Side side, Index keep, std::uint32_t vertex);
  /// Joins two chains that share the vertex where they meet, the tip of both.
  Chain join(const Chain& lower, const Chain& upper);

 private:
  struct Node {
    std::uint32_t vertex;
    std::array<Index, 2> link = {none, none};
  };
  void link(Index lower, Index upper);
  Scratch<Node> nodes_;
};

/// An undirected segment, from the lexicographically smaller vertex to the greater one, and where the face is.
struct SweepSegment {
  std::uint32_t left;
  std::uint32_t right;
  bool inside_below = false;
  bool inside_above = false;
};

/// The segments of directed edges, sorted by left end; `rank` maps vertex ids to their place in lexicographic order,
/// below `rank_count`. False when an edge is a loop or is there twice.
bool gather_segments(std::span<const FaceEdge> edges, const Scratch<std::uint32_t>& rank, std::size_t rank_count,
                     Scratch<SweepSegment>& segments);

/// The vertices of the edges, when they are one loop without a repeated vertex; else false.
bool single_loop(std::uint32_t vertex_count, std::span<const FaceEdge> edges, Scratch<std::uint32_t>& loop);

/// What the sweeps have in common: chains, and the triangles between them and the vertex that is visited. Inside,
/// vertices are known by their rank in lexicographic order.
template <PlanarPoints Points>
class Sweep {
 public:
  Sweep(const Points& points, std::vector<FaceTriangle>& triangles) : points_(points), triangles_(triangles) {}

 protected:
  using Chain = SweepChains::Chain;
  using Side = SweepStatus::Side;
  static constexpr Side bottom = SweepStatus::bottom;
  static constexpr Side top = SweepStatus::top;
  static constexpr std::uint32_t none = SweepStatus::none;

  int orientation(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return points_.orientation(ids_[a], ids_[b], ids_[c]);
  }

  template <class Iterator, class IdOf>
  void sort(Iterator begin, Iterator end, IdOf id_of) {
    sort_by_few_comparisons(begin, end,
                            [&](std::uint32_t a, std::uint32_t b) { return points_.compare(id_of(a), id_of(b)) < 0; });
  }

  /// Appends v at one end of a chain, with triangles to the edges that it sees from there on.
  /// Bound: one orientation for each edge seen, and one more.
  /// Precondition: v sees that end, and either the end is the tip or a segment of the boundary joins it to v.
  void extend(Chain& chain, Side side, std::uint32_t v) {
    const Side inward = side == top ? bottom : top;
    std::uint32_t node = chain.end[side];
    // Edges between the end and the tip are seen: the chain is convex and the segment from the end to v supports it.
    bool beyond_tip = node == chain.tip;
    while (node != chain.end[inward]) {
      const std::uint32_t next = chains_.neighbour(node, inward);
      const std::uint32_t lower = chains_.vertex(side == top ? next : node);
      const std::uint32_t upper = chains_.vertex(side == top ? node : next);
      if (beyond_tip && orientation(lower, upper, v) >= 0) break;
      emit(lower, v, upper);
      node = next;
      if (node == chain.tip) beyond_tip = true;
    }
    chains_.append(chain, side, node, v);
  }

  /// Triangles from v to the whole chain of an interval whose two segments end in v. None is collinear: all chain
  /// vertices but the two ends lie strictly between the two segments.
  void close(const Chain& chain, std::uint32_t v) {
    if (!chain.exists()) return;
    for (std::uint32_t node = chain.end[bottom]; node != chain.end[top];) {
      const std::uint32_t next = chains_.neighbour(node, top);
      emit(chains_.vertex(node), v, chains_.vertex(next));
      node = next;
    }
  }

  /// Vertex ids by rank.
  Scratch<std::uint32_t> ids_;
  SweepChains chains_;

 private:
  void emit(std::uint32_t a, std::uint32_t b, std::uint32_t c) { triangles_.push_back({ids_[a], ids_[b], ids_[c]}); }

  const Points& points_;
  std::vector<FaceTriangle>& triangles_;
};

/// Triangulations of any faces by sweep, each with the memory of those before.
template <PlanarPoints Points>
class FaceSweep : private Sweep<Points> {
 public:
  using Sweep<Points>::Sweep;

  /// See `triangulate`; on false some triangles may have been appended.
  bool run(std::uint32_t vertex_count, std::span<const FaceEdge> edges, std::span<const std::uint32_t> isolated) {
    if (!sort_vertices(vertex_count, edges, isolated)) return false;
    if (!gather_segments(edges, rank_, ids_.size(), segments_)) return false;
    ending_count_.assign(ids_.size(), 0);
    ending_.assign(ids_.size(), SweepStatus::none);
    for (const SweepSegment& segment : segments_) ++ending_count_[segment.right];
    status_.reset(segments_.size());
    chains_.reset();
    interval_.resize(segments_.size());
    first_out_ = end_out_ = 0;
    for (std::uint32_t v = 0; v < ids_.size(); ++v) {
      if (!visit(v)) return false;
    }
    return true;
  }

 private:
  using Base = Sweep<Points>;
  using Base::bottom, Base::top, Base::none;
  using Base::chains_, Base::close, Base::extend, Base::ids_, Base::orientation;
  using typename Base::Chain;

  bool sort_vertices(std::uint32_t vertex_count, std::span<const FaceEdge> edges,
                     std::span<const std::uint32_t> isolated) {
    rank_.assign(vertex_count, none);
    for (const FaceEdge& edge : edges) {
      if (edge[0] >= vertex_count || edge[1] >= vertex_count) return false;
      rank_[edge[0]] = rank_[edge[1]] = 0;
    }
    for (const std::uint32_t id : isolated) {
      if (id >= vertex_count) return false;
      rank_[id] = 0;
    }
    ids_.resize(vertex_count);
    std::size_t used = 0;
    for (std::uint32_t id = 0; id < vertex_count; ++id)
      if (rank_[id] != none) ids_[used++] = id;
    ids_.resize(used);
    this->sort(ids_.begin(), ids_.end(), [](std::uint32_t id) { return id; });
    for (std::uint32_t place = 0; place < ids_.size(); ++place) rank_[ids_[place]] = place;
    return true;
  }

  bool visit(std::uint32_t v) {
    sort_outgoing(v);
    ended_.clear();
    if (!(ending_count_[v] > 0 ? end_segments(v) : enter_interval(v))) return false;
    if (!assign_chains(v)) return false;
    update_status();
    return true;
  }

  /// Sets the range of segments that start in v and sorts it bottom to top.
  void sort_outgoing(std::uint32_t v) {
    first_out_ = end_out_;
    while (end_out_ < segments_.size() && segments_[end_out_].left == v) ++end_out_;
    if (end_out_ - first_out_ < 2) return;
    sort_by_few_comparisons(
        segments_.begin() + first_out_, segments_.begin() + end_out_,
        [this, v](const SweepSegment& a, const SweepSegment& b) { return orientation(v, a.right, b.right) > 0; });
  }

  /// Closes the intervals between the segments that end in v and extends those below and above.
  bool end_segments(std::uint32_t v) {
    std::uint32_t lowest = ending_[v];
    if (lowest == none) return false;
    const auto ends_here = [this, v](std::uint32_t s) { return s != none && segments_[s].right == v; };
    while (ends_here(status_.neighbour(lowest, bottom))) lowest = status_.neighbour(lowest, bottom);
    for (std::uint32_t s = lowest; ends_here(s); s = status_.neighbour(s, top)) ended_.push_back(s);
    if (ended_.size() != ending_count_[v]) return false;
    for (std::size_t i = 0; i + 1 < ended_.size(); ++i) close(interval_[ended_[i]], v);
    below_ = status_.neighbour(lowest, bottom);
    lower_ = below_ == none ? Chain{} : interval_[below_];
    upper_ = interval_[ended_.back()];
    if (lower_.exists()) extend(lower_, top, v);
    if (upper_.exists()) extend(upper_, bottom, v);
    return true;
  }

  /// Finds the interval that contains v; an inside one is split, with triangles to all that v sees.
  bool enter_interval(std::uint32_t v) {
    below_ = none;
    for (std::uint32_t s = status_.root(); s != none;) {
      const int sign = orientation(segments_[s].left, segments_[s].right, v);
      if (sign == 0) return false;
      if (sign > 0) below_ = s;
      s = status_.child(s, sign > 0 ? top : bottom);
    }
    lower_ = upper_ = Chain{};
    if (below_ == none || !interval_[below_].exists()) return first_out_ != end_out_;
    std::tie(lower_, upper_) = chains_.split_at_tip(interval_[below_]);
    extend(lower_, top, v);
    extend(upper_, bottom, v);
    return true;
  }

  /// Hands the chains below and above v to the intervals that begin in v.
  /// False when the sides that segments declare inside do not match.
  bool assign_chains(std::uint32_t v) {
    if (first_out_ == end_out_) {
      if (lower_.exists() != upper_.exists()) return false;
      if (lower_.exists()) interval_[below_] = chains_.join(lower_, upper_);
      return true;
    }
    if (segments_[first_out_].inside_below != lower_.exists()) return false;
    if (segments_[end_out_ - 1].inside_above != upper_.exists()) return false;
    if (lower_.exists()) interval_[below_] = lower_;
    for (std::uint32_t s = first_out_; s + 1 < end_out_; ++s) {
      if (segments_[s].inside_above != segments_[s + 1].inside_below) return false;
      interval_[s] = segments_[s].inside_above ? chains_.single(v) : Chain{};
    }
    interval_[end_out_ - 1] = upper_;
    return true;
  }

  /// Puts the outgoing segments where the ended ones were.
  void update_status() {
    std::uint32_t place = below_;
    std::uint32_t s = first_out_;
    for (const std::uint32_t old : ended_) {
      if (s == end_out_) {
        status_.erase(old);
      } else {
        status_.replace(old, s);
        place = s++;
      }
    }
    for (; s < end_out_; ++s) {
      status_.insert_above(place, s);
      place = s;
    }
    for (s = first_out_; s < end_out_; ++s) ending_[segments_[s].right] = s;
  }

  /// By vertex id; `none` for ids that are not used.
  Scratch<std::uint32_t> rank_;
  Scratch<SweepSegment> segments_;
  SweepStatus status_;
  /// By segment: the chain of the interval right above an active segment; none when outside.
  Scratch<Chain> interval_;
  /// By rank: how many segments end there, and one of them that is or was active.
  Scratch<std::uint32_t> ending_count_, ending_;
  /// The vertex being visited: segments that end and start there, the active one below, the chains on both sides.
  Scratch<std::uint32_t> ended_;
  std::uint32_t first_out_ = 0, end_out_ = 0;
  std::uint32_t below_ = none;
  Chain lower_, upper_;
};

/// The same triangles for one loop of few corners, none twice. There the inside intervals are all there is to know:
/// each lies between an edge that runs rightward and one that runs leftward.
template <PlanarPoints Points>
class LoopSweep : private Sweep<Points> {
 public:
  using Sweep<Points>::Sweep;
  /// Which interval a vertex is in is asked one interval after the other.
  static constexpr std::size_t most_corners = 16;

  /// False, perhaps with triangles appended, when the loop is seen not to bound a face.
  bool run(std::span<const std::uint32_t> loop) {
    assert(loop.size() <= most_corners);
    const auto count = static_cast<std::uint32_t>(loop.size());
    std::iota(corner_.begin(), corner_.begin() + count, 0u);
    this->sort(corner_.begin(), corner_.begin() + count, [&](std::uint32_t corner) { return loop[corner]; });
    ids_.resize(count);
    for (std::uint32_t v = 0; v < count; ++v) {
      ids_[v] = loop[corner_[v]];
      rank_[corner_[v]] = v;
      ending_[v] = {none, none};
    }
    chains_.reset();
    intervals_.clear();
    for (std::uint32_t v = 0; v < ids_.size(); ++v)
      if (!visit(v)) return false;
    return true;
  }

 private:
  using Base = Sweep<Points>;
  using Base::bottom, Base::top, Base::none;
  using Base::chains_, Base::close, Base::extend, Base::ids_, Base::orientation;
  using typename Base::Chain, typename Base::Side;

  /// From its left end to its right one.
  using Edge = std::array<std::uint32_t, 2>;
  struct Interval {
    std::array<Edge, 2> side;  // bottom, top
    Chain chain;
  };

  bool visit(std::uint32_t v) {
    const std::size_t at = corner_[v], count = ids_.size();
    const std::uint32_t from = rank_[grid::previous_in_loop(at, count)], to = rank_[grid::next_in_loop(at, count)];
    if (from > v && to > v) return begin(v, from, to);
    if (from < v && to < v) return end(v);
    return from < v ? pass(bottom, v, to) : pass(top, v, from);
  }

  /// A side of the interval ends in v and goes on to `next`.
  bool pass(Side side, std::uint32_t v, std::uint32_t next) {
    const std::uint32_t interval = ending_[v][side];
    if (interval == none) return false;
    extend(intervals_[interval].chain, side, v);
    set_side(interval, side, {v, next});
    return true;
  }

  /// An interval ends in v, or the outside between two that become one.
  bool end(std::uint32_t v) {
    const auto [above, below] = ending_[v];
    if (above == none || below == none) return false;
    if (above == below) {
      close(intervals_[above].chain, v);
      intervals_[above].chain = {};
      return true;
    }
    extend(intervals_[below].chain, top, v);
    extend(intervals_[above].chain, bottom, v);
    intervals_[below].chain = chains_.join(intervals_[below].chain, intervals_[above].chain);
    intervals_[above].chain = {};
    set_side(below, top, intervals_[above].side[top]);
    return true;
  }

  /// An interval begins in v, or the outside within one.
  bool begin(std::uint32_t v, std::uint32_t from, std::uint32_t to) {
    const int turn = orientation(v, to, from);
    if (turn == 0) return false;
    const auto fresh = static_cast<std::uint32_t>(intervals_.size());
    if (turn > 0) {
      intervals_.push_back({{}, chains_.single(v)});
      set_side(fresh, top, {v, from});
    } else {
      const std::uint32_t around = interval_around(v);
      if (around == none) return false;
      const auto [lower, upper] = chains_.split_at_tip(intervals_[around].chain);
      intervals_.push_back({{}, upper});
      intervals_[around].chain = lower;
      extend(intervals_[around].chain, top, v);
      extend(intervals_[fresh].chain, bottom, v);
      set_side(fresh, top, intervals_[around].side[top]);
      set_side(around, top, {v, from});
    }
    set_side(fresh, bottom, {v, to});
    return true;
  }

  std::uint32_t interval_around(std::uint32_t v) const {
    for (std::uint32_t i = 0; i < intervals_.size(); ++i) {
      if (!intervals_[i].chain.exists()) continue;
      const auto& [lower, upper] = intervals_[i].side;
      if (orientation(lower[0], lower[1], v) > 0 && orientation(upper[0], upper[1], v) < 0) return i;
    }
    return none;
  }

  void set_side(std::uint32_t interval, Side side, const Edge& edge) {
    intervals_[interval].side[side] = edge;
    ending_[edge[1]][side] = interval;
  }

  /// The corner of each vertex and the vertex of each corner.
  std::array<std::uint32_t, most_corners> corner_, rank_;
  /// Those without a chain have ended.
  Scratch<Interval> intervals_;
  /// By vertex: the intervals whose bottom and whose top end there.
  std::array<std::array<std::uint32_t, 2>, most_corners> ending_;
};

/// Triangles of a strictly convex loop in zigzag. False, with nothing appended, when a corner is not strictly convex.
template <PlanarPoints Points>
bool triangulate_convex(const Points& points, std::span<const std::uint32_t> loop,
                        std::vector<FaceTriangle>& triangles) {
  const std::size_t count = loop.size();
  if (count < 3) return false;
  for (std::size_t i = 0; count > 3 && i < count; ++i) {
    const std::size_t next = grid::next_in_loop(i, count), last = grid::next_in_loop(next, count);
    if (points.orientation(loop[i], loop[next], loop[last]) <= 0) return false;
  }
  std::size_t low = 0, high = count - 1;
  for (bool from_low = true; high - low > 1; from_low = !from_low) {
    if (from_low) {
      triangles.push_back({loop[low], loop[low + 1], loop[high]});
      ++low;
    } else {
      triangles.push_back({loop[low], loop[high - 1], loop[high]});
      --high;
    }
  }
  return true;
}

/// The triangles of a face with their neighbours, for flipping. Half-edge 3 t + i goes from corner i of triangle t.
class FlipMesh {
 public:
  static constexpr std::uint32_t none = UINT32_MAX;

  /// Other triangles, in the memory of those before. Vertices are below `vertex_count`.
  /// `constrained`: edges, in either direction, that must stay.
  void assign(std::uint32_t vertex_count, std::span<FaceTriangle> triangles, std::span<const FaceEdge> constrained);

  /// Edges 0 .. edge_count() - 1 are those between two triangles that may be flipped.
  std::uint32_t edge_count() const { return static_cast<std::uint32_t>(half_of_.size()); }
  /// The ends of an edge, then the corner on its left and the one on its right.
  std::array<std::uint32_t, 4> quadrilateral(std::uint32_t edge) const;
  /// Replaces the edge by the other diagonal of its quadrilateral.
  void flip(std::uint32_t edge);
  /// The four sides of the edge's quadrilateral; `none` for those that must stay.
  std::array<std::uint32_t, 4> sides(std::uint32_t edge) const;

 private:
  std::uint32_t origin(std::uint32_t half) const { return corners_[half]; }
  void move(std::uint32_t half, std::uint32_t edge, std::uint32_t twin);

  /// A half-edge at the lower one of its ends.
  struct Half {
    std::uint32_t high, half;
  };
  void find_twins_of_few(std::uint32_t vertex_count, std::span<const FaceEdge> constrained);
  void find_twins_of_many(std::uint32_t vertex_count, std::span<const FaceEdge> constrained);
  void find_barriers(std::uint32_t vertex_count, std::span<const FaceEdge> constrained);
  void add_edge(std::uint32_t half, std::uint32_t twin);
  /// visit(half-edge, from, to).
  template <class Visit>
  void for_halves(Visit&& visit) const;

  std::span<std::uint32_t> corners_;  // three a triangle
  /// Of a half-edge; `none` for edges that must stay.
  struct Link {
    std::uint32_t twin = none, edge = none;
  };
  Scratch<Link> links_;
  /// By edge: one of its two half-edges.
  Scratch<std::uint32_t> half_of_;
  /// By vertex: where one constrained edge leads; the other ones, undirected and in order.
  Scratch<std::uint32_t> constrained_to_;
  Scratch<std::uint64_t> barriers_;
  grid::Buckets<Half> halves_;
  /// By two vertices of few: the half-edge from the first one to the second.
  static constexpr std::uint32_t few_vertices = 16;
  std::array<std::uint8_t, few_vertices * few_vertices> between_;
};

/// Whether the other diagonal of the quadrilateral a, d, b, c is clearly better than a b, by the Delaunay criterion in
/// doubles. An opinion, not a proof: close calls are "no".
bool prefers_other_diagonal(const std::array<double, 2>& a, const std::array<double, 2>& b,
                            const std::array<double, 2>& c, const std::array<double, 2>& d);

/// Cuts faces into triangles, each with the memory of those before.
template <PlanarPoints Points>
class FaceCutter {
 public:
  /// What `points` and `triangles` hold may change from face to face.
  FaceCutter(const Points& points, std::vector<FaceTriangle>& triangles)
      : points_(points), triangles_(triangles), loop_sweep_(points, triangles), sweep_(points, triangles) {}
  FaceCutter(const FaceCutter&) = delete;
  FaceCutter& operator=(const FaceCutter&) = delete;

  /// Appends triangles, counter-clockwise and none collinear, that cover exactly the interior of a face.
  /// `edges`: directed boundary edges in any order, ids below `vertex_count`, interior on the left. They meet only in
  /// vertices; loops may touch, slits are present in both directions, and there may be several regions.
  /// `isolated`: vertices in the interior that no edge uses. Ids that are in neither are ignored.
  /// The mesh is conforming: each directed boundary edge is in exactly one triangle, any other edge of a triangle in
  /// exactly two, in opposite directions, and every vertex of `edges` and `isolated` is a corner.
  /// Time O(n log n). Predicates: about n log2 n comparisons for the order; orientations: at most two for each vertex
  /// and one for each triangle, and O(log n) to place each vertex where no edge ends and to sort the edges around one.
  /// False, with nothing appended, when the edges are seen not to bound a face (a loop is open, sides do not match, an
  /// index is out of range). Edges that cross may go unseen; the triangles are then unspecified.
  [[nodiscard]] bool cut(std::uint32_t vertex_count, std::span<const FaceEdge> edges,
                         std::span<const std::uint32_t> isolated) {
    const std::size_t before = triangles_.size();
    if (sweep_.run(vertex_count, edges, isolated)) return true;
    triangles_.resize(before);
    return false;
  }

  /// The same for one loop without a repeated vertex. False, with nothing appended, also when it has many corners and
  /// is not strictly convex.
  [[nodiscard]] bool cut_loop(std::span<const std::uint32_t> loop) {
    const std::size_t before = triangles_.size();
    if (triangulate_convex(points_, loop, triangles_)) return true;
    if (loop.size() <= LoopSweep<Points>::most_corners && loop_sweep_.run(loop)) return true;
    triangles_.resize(before);
    return false;
  }

  /// Flips edges between the triangles where that avoids slivers; the mesh stays as exact as it was.
  /// `edges`: the boundary edges, none of which is flipped. `approximate`: coordinates by vertex id, in any orthonormal
  /// frame; they only guide. A flip is done only where `orientation` finds both new triangles proper.
  /// Work: O(n log n), each edge is flipped at most 8 times, two orientations for each flip or refusal of one.
  void improve(std::span<const FaceEdge> edges, std::span<const std::array<double, 2>> approximate) {
    constexpr unsigned char max_flips = 8;
    mesh_.assign(static_cast<std::uint32_t>(approximate.size()), triangles_, edges);
    states_.assign(mesh_.edge_count(), State{});
    queue_.resize(mesh_.edge_count());
    std::iota(queue_.begin(), queue_.end(), 0u);
    for (std::size_t head = 0; head < queue_.size(); ++head) {
      const std::uint32_t edge = queue_[head];
      State& state = states_[edge];
      state.waiting = false;
      if (state.flips == max_flips) continue;
      const auto [a, b, c, d] = mesh_.quadrilateral(edge);
      if (!prefers_other_diagonal(approximate[a], approximate[b], approximate[c], approximate[d])) continue;
      if (points_.orientation(a, d, c) <= 0 || points_.orientation(d, b, c) <= 0) continue;
      mesh_.flip(edge);
      ++state.flips;
      for (const std::uint32_t side : mesh_.sides(edge)) {
        if (side == FlipMesh::none || states_[side].waiting) continue;
        states_[side].waiting = true;
        queue_.push_back(side);
      }
    }
  }

 private:
  /// Of an edge of the mesh.
  struct State {
    unsigned char flips = 0;
    bool waiting = true;  // in the queue
  };

  const Points& points_;
  std::vector<FaceTriangle>& triangles_;
  LoopSweep<Points> loop_sweep_;
  FaceSweep<Points> sweep_;
  FlipMesh mesh_;
  Scratch<State> states_;
  Scratch<std::uint32_t> queue_;
};

/// Appends the triangles of one face; see `FaceCutter::cut`.
template <PlanarPoints Points>
[[nodiscard]] bool triangulate(const Points& points, std::uint32_t vertex_count, std::span<const FaceEdge> edges,
                               std::span<const std::uint32_t> isolated, std::vector<FaceTriangle>& triangles) {
  FaceCutter<Points> cutter(points, triangles);
  Scratch<std::uint32_t> loop;
  if (isolated.empty() && single_loop(vertex_count, edges, loop) && cutter.cut_loop({loop.data(), loop.size()}))
    return true;
  return cutter.cut(vertex_count, edges, isolated);
}

}  // namespace quoin::booleans
