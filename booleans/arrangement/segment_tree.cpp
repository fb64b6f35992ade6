#include "booleans/arrangement/segment_tree.h"

namespace quoin::booleans {
namespace {

BoxTree boxes_of(const Array<SegmentTree::Segment>& segments, const VertexTable& vertices) {
  Array<BoxTree::Item> items(segments.size());
  for (std::uint32_t i = 0; i < items.size(); ++i) {
    items[i].id = i;
    items[i].group = i;
    for (const VertexId v : {segments[i].a, segments[i].b}) vertices.add_to(items[i].box, v);
  }
  return BoxTree(items);
}

}  // namespace

SegmentTree::SegmentTree(const exact::Plane& plane, const Array<Segment>& segments, const VertexTable& vertices)
    : normal_(exact::approximation(plane).n), boxes_(boxes_of(segments, vertices)), number_(boxes_.level_count()) {
  segments_.reserve(segments.size());
  for (const std::uint32_t i : boxes_.ids()) segments_.push_back(segments[i]);
}

void SegmentTree::make_strips(const VertexTable& vertices) {
  for (std::size_t level = 1; level < boxes_.level_count(); ++level)
    for (std::uint32_t x = 0; x < boxes_.node_count(level); ++x)
      if (std::popcount(boxes_.part_pairs(level, x, x)) > grid::thresholds().crowded_nodes) node(level, x, vertices);
}

const SegmentTree::Node& SegmentTree::node(std::size_t level, std::uint32_t x, const VertexTable& vertices) {
  auto& numbers = number_[level];
  if (numbers.empty()) numbers.resize(boxes_.node_count(level), none);
  if (numbers[x] == none) {
    numbers[x] = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back(look_at(below(level, x), vertices));
  }
  return nodes_[numbers[x]];
}

void SegmentTree::add(const Direction& n, const Segment& segment, const VertexTable& vertices, Reach& reach) {
  for (const VertexId v : {segment.a, segment.b}) {
    Box box;
    vertices.add_to(box, v);
    reach.add(n, box);
  }
}

SegmentTree::Node SegmentTree::look_at(std::span<const Segment> segments, const VertexTable& vertices) const {
  std::array<double, 3> longest{};
  std::array<VertexId, 2> hubs{segments[0].a, segments[0].b};
  for (const Segment& s : segments) {
    const auto &a = vertices.approximation(s.a), &b = vertices.approximation(s.b);
    const std::array<double, 3> along{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    if (dot(along, along) > dot(longest, longest)) longest = along;
    for (VertexId& hub : hubs)
      if (hub != s.a && hub != s.b) hub = none;
  }

  Node node{scaled(cross(normal_, longest), (1 << 30) - 1), {}, hubs};
  for (const Segment& s : segments) add(node.across, s, vertices, node.strip);
  return node;
}

/// Does a node that somebody looked at have the hull beside its strip?
bool SegmentTree::beside(std::size_t level, std::uint32_t x, std::span<const Box> hull) const {
  if (number_[level].empty() || number_[level][x] == none) return false;
  const Node& node = nodes_[number_[level][x]];
  Reach reach;
  for (const Box& b : hull) reach.add(node.across, b);
  return !reach.meets(node.strip);
}

/// Are all the segments on one side of a node's strip?
bool SegmentTree::beside(const Node& node, std::span<const Segment> segments, const VertexTable& vertices) {
  Reach reach;
  for (const Segment& s : segments) {
    add(node.across, s, vertices, reach);
    if (reach.meets(node.strip)) return false;
  }
  return true;
}

/// An end that all segments below two nodes have, none if there is none.
VertexId SegmentTree::common_hub(const Node& a, const Node& b) {
  for (const VertexId hub : a.hubs)
    if (hub != none && (hub == b.hubs[0] || hub == b.hubs[1])) return hub;
  return none;
}

}  // namespace quoin::booleans
