/// \file
/// Segments of one plane in a tree: those that a piece of a line may meet, and those that may meet each other.
#pragma once

#include "booleans/arrangement/names.h"
#include "booleans/pairs/box_tree.h"
#include "booleans/pairs/directions.h"

namespace quoin::booleans {

/// The boxes of segments that run diagonally beside each other, or from one point, overlap by the square of their
/// number. Where they do, a node of the tree also has a strip around its segments, along the longest of them, and knows
/// the ends that all of them have. The strip's direction comes from doubles, what lies along it is exact: any direction
/// is right, a good one makes the strip narrow.
class SegmentTree {
 public:
  /// Or a point: its ends are equal.
  struct Segment {
    VertexId a, b;
  };

  SegmentTree(const exact::Plane& plane, const Array<Segment>& segments, const VertexTable& vertices);
  /// Looks at the nodes whose parts' boxes overlap; those of others are enough.
  void make_strips(const VertexTable& vertices);

  /// Items are indices into the given segments.
  const BoxTree& boxes() const { return boxes_; }

  /// visit(i) for segments, among them all that meet another plane within the convex hull of some boxes. Few others are
  /// visited once there are strips.
  template <class Visit>
  void meeting(const exact::Plane& other, std::span<const Box> hull, Visit&& visit) const {
    Box all;
    for (const Box& b : hull) all.add(b);
    const auto may_meet = [&](std::size_t level, std::uint32_t x, const Box& box) {
      return !strictly_on_one_side(other, box) && !beside(level, x, hull);
    };
    boxes_.meeting(all, may_meet, visit);
  }

  /// visit(i, j) for pairs of segments, each pair once; among them are all that meet, but for pairs that have one of
  /// the ends in common that are returned, in ascending order.
  template <class Visit>
  Array<VertexId> pairs(const VertexTable& vertices, Visit&& visit) {
    Array<VertexId> hubs;
    const auto pass = [&](std::size_t level, std::uint32_t x, std::uint32_t y) {
      const Node a = node(level, x, vertices), b = node(level, y, vertices);
      const VertexId hub = common_hub(a, b);
      if (hub != none) hubs.push_back(hub);
      return hub != none || beside(a, below(level, y), vertices) || beside(b, below(level, x), vertices);
    };
    boxes_.block_pairs(BoxTree::Pairs::all, pass, [&](std::uint32_t x, std::uint32_t y) {
      const LanePairs left = boxes_.lane_pairs(BoxTree::Pairs::all, x, y);
      if (x != y && std::popcount(left) > grid::thresholds().crowded_blocks && pass(1, x, y)) return;
      BoxTree::for_lane_pairs(left, x, y,
                              [&](std::uint32_t i, std::uint32_t j) { visit(boxes_.ids()[i], boxes_.ids()[j]); });
    });
    std::sort(hubs.begin(), hubs.end());
    hubs.erase(std::unique(hubs.begin(), hubs.end()), hubs.end());
    return hubs;
  }

 private:
  // Components below 2^30 and coordinates up to 2^29 + 2 make values below 2^61: all exact.
  using Direction = std::array<std::int64_t, 3>;
  struct Reach {
    std::int64_t low = INT64_MAX, high = INT64_MIN;
    void add(const Direction& n, const Box& box) {
      const auto [lowest, highest] = ends_along(n, box);
      low = std::min(low, value(n, lowest));
      high = std::max(high, value(n, highest));
    }
    bool meets(const Reach& r) const { return low <= r.high && r.low <= high; }
  };
  struct Node {
    Direction across;
    Reach strip;
    std::array<VertexId, 2> hubs;  // ends of all its segments; none for those that are missing
  };

  static void add(const Direction& n, const Segment& segment, const VertexTable& vertices, Reach& reach);
  std::span<const Segment> below(std::size_t level, std::uint32_t x) const {
    const std::size_t begin = std::size_t{x} << (3 * level);
    return std::span(segments_).subspan(begin, std::min(segments_.size() - begin, std::size_t{1} << (3 * level)));
  }
  const Node& node(std::size_t level, std::uint32_t x, const VertexTable& vertices);
  Node look_at(std::span<const Segment> segments, const VertexTable& vertices) const;
  bool beside(std::size_t level, std::uint32_t x, std::span<const Box> hull) const;
  static bool beside(const Node& node, std::span<const Segment> segments, const VertexTable& vertices);
  static VertexId common_hub(const Node& a, const Node& b);

  std::array<double, 3> normal_;
  BoxTree boxes_;
  Array<Segment> segments_;             // in the tree's order
  Array<Array<std::uint32_t>> number_;  // by level and node, if any was looked at: into nodes_, none for the others
  Array<Node> nodes_;
};

}  // namespace quoin::booleans
