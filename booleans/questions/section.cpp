#include "booleans/questions/section.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <optional>
#include <utility>

#include "booleans/questions/line.h"
#include "booleans/questions/planar_region.h"

namespace quoin::booleans {
namespace {

using exact::Integer;
using exact::Rational;

/// What lies on which side of the plane.
class Cutter {
 public:
  Cutter(const Body& body, const IntegerPlane& plane) : body_(body), plane_(plane) {
    for (std::size_t k = 0; k < 4; ++k) near_[k] = enclosure(Rational(plane[k]));
    is_tame_ =
        std::all_of(near_.begin(), near_.end(), [](const Interval& x) { return x.low > -0x1p900 && x.high < 0x1p900; });
  }

  /// False only where the plane misses the box.
  bool may_meet(const Box& box) const {
    if (!is_tame_) return true;
    const auto x = [&](std::size_t k) { return Interval(box.low[k], box.high[k]); };
    const Interval at = near_value(x(0), x(1), x(2));
    return at.low <= 0 && at.high >= 0;
  }

  int side(std::uint32_t v) const {
    if (is_tame_) {
      const auto p = body_.approximation(v);
      const auto x = [&](std::size_t k) { return body_.is_grid(v) ? Interval(p[k]) : Interval::around(p[k]); };
      const Interval at = near_value(x(0), x(1), x(2));
      if (at.low > 0) return 1;
      if (at.high < 0) return -1;
    }
    return value(homogeneous(body_.point(v))).sign();
  }

  /// Of a face on the plane: whether its outward normal points to the plane's negative side.
  bool looks_down(const exact::Plane& face) const {
    return Integer(plane_[0] * face.n[0] + plane_[1] * face.n[1] + plane_[2] * face.n[2]) < 0;
  }

  RationalPoint vertex(std::uint32_t v) const {
    const exact::Point p = body_.point(v);
    return {exact::coordinate(p, 0), exact::coordinate(p, 1), exact::coordinate(p, 2)};
  }
  /// Where the segment between two vertices on different sides meets the plane.
  RationalPoint crossing(std::uint32_t u, std::uint32_t v) const {
    const Homogeneous p = homogeneous(body_.point(u)), q = homogeneous(body_.point(v));
    const Integer at_p = value(p), at_q = value(q), w = q.w * at_p - p.w * at_q;
    RationalPoint r;
    for (std::size_t k = 0; k < 3; ++k) r[k] = Rational(Integer(q.x[k] * at_p - p.x[k] * at_q), w);
    return r;
  }

 private:
  Interval near_value(const Interval& x, const Interval& y, const Interval& z) const {
    return near_[0] * x + near_[1] * y + near_[2] * z + near_[3];
  }
  Integer value(const Homogeneous& p) const {
    return plane_[0] * p.x[0] + plane_[1] * p.x[1] + plane_[2] * p.x[2] + plane_[3] * p.w;
  }

  const Body& body_;
  const IntegerPlane& plane_;
  std::array<Interval, 4> near_{0, 0, 0, 0};
  bool is_tame_ = false;
};

/// A vertex on the plane, twice, or the ends of an edge that crosses it, in order.
using Node = std::array<std::uint32_t, 2>;
struct Arc {
  Node from, to;
};

/// Where a triangle's edge crosses the plane; a vertex on it counts as below.
Node node_between(std::uint32_t above, std::uint32_t below, int side_below) {
  return side_below == 0 ? Node{below, below} : Node{std::min(above, below), std::max(above, below)};
}

/// Adds the arcs of a triangle.
///
/// Just above the plane a triangle is cut along an arc with the triangle's part above on its left, seen from outside:
/// from where its boundary goes down to where it comes up. Seen from above that has the solid on its left.
void add_arcs(const Index& index, const Cutter& cutter, std::uint32_t t, std::vector<Arc>& arcs) {
  const auto& c = index.corners(t);
  const std::array<int, 3> side{cutter.side(c[0]), cutter.side(c[1]), cutter.side(c[2])};
  if (side == std::array<int, 3>{0, 0, 0}) {
    if (!cutter.looks_down(index.plane(t))) return;
    return grid::for_loop_edges(c, [&](std::uint32_t u, std::uint32_t v) { arcs.push_back({{u, u}, {v, v}}); });
  }

  std::optional<Node> from, to;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = i < 2 ? i + 1 : 0;
    if (side[i] > 0 && side[j] <= 0) from = node_between(c[i], c[j], side[j]);
    if (side[i] <= 0 && side[j] > 0) to = node_between(c[j], c[i], side[i]);
  }
  if (from && *from != *to) arcs.push_back({*from, *to});
}

/// The boundary of the section, which lies on its left.
///
/// The limit of sections from above has the boundary that the arcs of cut triangles make. It is the section and those
/// faces on the plane that have the solid above them alone: their boundary, which their own edges run along the other
/// way round seen from above, is taken away. Arcs that overlap run along one edge of the mesh, so they have equal ends.
std::vector<Arc> boundary_arcs(const Index& index, const Cutter& cutter) {
  std::vector<Arc> arcs;
  const auto of_interest = [&](std::size_t, std::uint32_t, const Box& box) { return cutter.may_meet(box); };
  index.tree().meeting(index.box(), of_interest, [&](std::uint32_t t) { add_arcs(index, cutter, t, arcs); });

  const auto ends = [](const Arc& a) { return a.from < a.to ? std::pair(a.from, a.to) : std::pair(a.to, a.from); };
  std::sort(arcs.begin(), arcs.end(), [&](const Arc& a, const Arc& b) { return ends(a) < ends(b); });
  std::vector<Arc> left;
  for (std::size_t i = 0, j = 0; i < arcs.size(); i = j) {
    const auto [low, high] = ends(arcs[i]);
    int net = 0;
    for (; j < arcs.size() && ends(arcs[j]) == std::pair(low, high); ++j) net += arcs[j].from == low ? 1 : -1;
    if (net != 0) left.push_back(net > 0 ? Arc{low, high} : Arc{high, low});
  }
  return left;
}

/// The nodes of arcs, each once, in order.
std::vector<Node> nodes_of(const std::vector<Arc>& arcs) {
  std::vector<Node> nodes;
  for (const Arc& a : arcs) nodes.insert(nodes.end(), {a.from, a.to});
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

}  // namespace

std::optional<Section> section(const Index& index, const IntegerPlane& plane) {
  assert(!index.body().full_at_infinity);
  const Cutter cutter(index.body(), plane);
  const std::vector<Arc> arcs = boundary_arcs(index, cutter);
  const std::vector<Node> nodes = nodes_of(arcs);

  // Points in order of their coordinates.
  std::vector<RationalPoint> points;
  for (const auto& [u, v] : nodes) points.push_back(u == v ? cutter.vertex(u) : cutter.crossing(u, v));
  std::vector<std::uint32_t> order(nodes.size()), rank(nodes.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return points[a] < points[b]; });
  for (std::uint32_t i = 0; i < order.size(); ++i) rank[order[i]] = i;

  const std::array<Integer, 3> normal{plane[0], plane[1], plane[2]};
  const std::size_t k = exact::longest_component(normal);
  std::size_t first = (k + 1) % 3, second = (k + 2) % 3;
  if (normal[k] < 0) std::swap(first, second);
  std::vector<PlanarPoint> planar;
  for (const std::uint32_t v : order) planar.push_back({points[v][first], points[v][second]});
  const auto number = [&](const Node& n) {
    return rank[static_cast<std::size_t>(std::lower_bound(nodes.begin(), nodes.end(), n) - nodes.begin())];
  };
  std::vector<PlanarArc> numbered;
  for (const Arc& a : arcs) numbered.push_back({number(a.from), number(a.to)});

  auto region = planar_region(planar, numbered);
  if (!region) return std::nullopt;
  Section r;
  for (const std::uint32_t v : region->points) r.vertices.push_back(points[order[v]]);
  r.polygons = std::move(region->polygons);
  r.projected_area = std::move(region->area);
  return r;
}

}  // namespace quoin::booleans
