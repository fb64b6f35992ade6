#include "booleans/arrangement/outline.h"

#include <tuple>

namespace quoin::booleans {

void Outline::name_points(VertexTable& vertices) {
  std::vector<VertexId> names;
  names.reserve(new_points.size());
  for (const exact::Point& p : new_points) names.push_back(vertices.id(p));

  for (Split& s : splits)
    if (s.vertex.is_own()) s.vertex = names[s.vertex.index()];
  new_points.clear();
}

OutlineMaker::OutlineMaker(const Touched& touched, const Names& names, PlaneId plane, Outline& outline)
    : touched_(touched), names_(names), outline_(outline) {
  outline_.plane = plane;
  outline_.frame = Frame(names.planes[plane]);
  outline_.segments.clear();
  outline_.change_start.clear();
  outline_.changes.clear();
  outline_.points.clear();
  outline_.splits.clear();
  outline_.new_points.clear();
}

void OutlineMaker::add_face(TouchedId face) {
  const bool along = touched_.faces[face].along;
  for (const BoundaryEdge& e : touched_.edges_of(face)) {
    const bool forward = before(e.from, e.to);
    outline_.segments.push_back(
        {forward ? e.from : e.to, forward ? e.to : e.from, e.other, face, forward == along ? 1 : -1});
  }
  for (const VertexId v : touched_.isolated_of(face)) add_point(v);
}

void OutlineMaker::add_segment(const ContactSegment& s) {
  const bool forward = before(s.a, s.b);
  outline_.segments.push_back({forward ? s.a : s.b, forward ? s.b : s.a, s.line, none, 0});
}

void OutlineMaker::unite_equal_segments() {
  auto& segments = outline_.segments;
  std::sort(segments.begin(), segments.end(), [](const Segment& s, const Segment& t) {
    return std::tie(s.a, s.b, s.face, s.change, s.line) < std::tie(t.a, t.b, t.face, t.change, t.line);
  });

  auto& start = outline_.change_start;
  auto& changes = outline_.changes;
  start.reserve(segments.size() + 1);
  changes.reserve(segments.size());
  std::uint32_t n = 0;
  for (const Segment& s : segments) {
    if (n == 0 || segments[n - 1].a != s.a || segments[n - 1].b != s.b) {
      segments[n++] = s;
      start.push_back(static_cast<std::uint32_t>(changes.size()));
    }
    if (s.face != none) changes.push_back({s.face, s.change});
  }
  segments.resize(n);
  start.push_back(static_cast<std::uint32_t>(changes.size()));

  auto& points = outline_.points;
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
}

/// visit(i, j) for pairs of segments of different groups whose boxes meet, and visit(i, segment count + k) for points k
/// near segment i; from the given segment on.
template <class GroupOf, class Visit>
void OutlineMaker::close_pairs(std::uint32_t first, GroupOf group_of, Visit visit) const {
  struct Extent {
    double ul, uh, vl, vh;
  };
  const VertexTable& vertices = names_.vertices;
  const auto n = static_cast<std::uint32_t>(outline_.segments.size());
  const auto total = n + static_cast<std::uint32_t>(outline_.points.size());
  const auto ends = [&](std::uint32_t i) {
    return i < n ? std::pair(outline_.segments[i].a, outline_.segments[i].b)
                 : std::pair(outline_.points[i - n], outline_.points[i - n]);
  };

  constexpr std::uint32_t most = 24;
  if (total - first <= std::min(most, grid::thresholds().few_segments)) {
    // Approximations are monotone, so strictly separated ones prove that the segments are.
    std::array<Extent, most> box{};
    const auto u = static_cast<std::size_t>(outline_.frame.u()), v = static_cast<std::size_t>(outline_.frame.v());
    for (std::uint32_t i = first; i < total; ++i) {
      const auto [a, b] = ends(i);
      const auto &p = vertices.approximation(a), &q = vertices.approximation(b);
      box[i - first] = {p[u], q[u], std::min(p[v], q[v]), std::max(p[v], q[v])};
    }
    const auto meet = [](const Extent& x, const Extent& y) {
      return x.ul <= y.uh && y.ul <= x.uh && x.vl <= y.vh && y.vl <= x.vh;
    };
    for (std::uint32_t i = first; i < n; ++i)
      for (std::uint32_t j = i + 1; j < total; ++j)
        if (meet(box[i - first], box[j - first]) && group_of(i) != group_of(j)) visit(i, j);
    return;
  }

  Array<SegmentTree::Segment> items;
  items.reserve(total - first);
  for (std::uint32_t i = first; i < total; ++i) {
    const auto [a, b] = ends(i);
    items.push_back({a, b});
  }
  SegmentTree tree(names_.planes[outline_.plane], items, vertices);
  const auto hubs = tree.pairs(vertices, [&](std::uint32_t i, std::uint32_t j) {
    const std::uint32_t low = first + std::min(i, j), high = first + std::max(i, j);
    if (low < n) visit(low, high);
  });
  if (!hubs.empty()) pairs_at(hubs, first, visit);
}

/// visit(i, j) for pairs of segments, from the given one on, that run from one of some vertices in one direction.
template <class Visit>
void OutlineMaker::pairs_at(std::span<const VertexId> hubs, std::uint32_t first, Visit visit) const {
  struct Spoke {
    VertexId hub;
    bool forward;
    std::uint32_t segment;
  };
  std::vector<Spoke> spokes;
  for (std::uint32_t i = first; i < outline_.segments.size(); ++i)
    for (const bool forward : {true, false}) {
      const VertexId hub = forward ? outline_.segments[i].a : outline_.segments[i].b;
      if (std::binary_search(hubs.begin(), hubs.end(), hub)) spokes.push_back({hub, forward, i});
    }

  // On which side of a spoke's line another one of that hub ends that runs forward, or backward, too.
  const auto turn = [&](const Spoke& s, const Spoke& t) {
    const Segment &p = outline_.segments[s.segment], &q = outline_.segments[t.segment];
    const int side = names_.side(t.forward ? q.b : q.a, p.line);
    return side == 0 ? 0 : side * outline_.frame.direction(names_.planes[outline_.plane], names_.planes[p.line]);
  };
  const auto together = [&](const Spoke& s, const Spoke& t) { return s.hub == t.hub && s.forward == t.forward; };
  std::sort(spokes.begin(), spokes.end(), [&](const Spoke& s, const Spoke& t) {
    return together(s, t) ? turn(s, t) < 0 : std::pair(s.hub, s.forward) < std::pair(t.hub, t.forward);
  });

  for (std::size_t i = 0; i < spokes.size(); ++i)
    for (std::size_t j = i + 1; j < spokes.size() && together(spokes[i], spokes[j]) && turn(spokes[i], spokes[j]) == 0;
         ++j)
      visit(std::min(spokes[i].segment, spokes[j].segment), std::max(spokes[i].segment, spokes[j].segment));
}

void OutlineMaker::find_splits() {
  unite_equal_segments();

  const auto n = static_cast<std::uint32_t>(outline_.segments.size());
  const auto itself = [](std::uint32_t i) { return i; };
  close_pairs(0, itself, [&](std::uint32_t i, std::uint32_t j) {
    if (j < n)
      split_pair(i, j);
    else
      split_by_point(i, outline_.points[j - n]);
  });
}

void OutlineMaker::draw_lone_face(TouchedId face, std::span<const ContactSegment> all,
                                  std::span<const std::uint32_t> segments) {
  add_face(face);
  const auto edges = static_cast<std::uint32_t>(outline_.segments.size());
  const std::uint32_t first_edge = touched_.faces[face].edges_begin;
  for (const std::uint32_t i : segments) {
    const ContactSegment& s = all[i];
    add_segment(s);
    if (s.at_a != inside_face) outline_.splits.push_back({s.at_a - first_edge, s.a});
    if (s.at_b != inside_face) outline_.splits.push_back({s.at_b - first_edge, s.b});
  }

  outline_.change_start.resize(outline_.segments.size() + 1, edges);
  outline_.changes.resize(edges);
  for (std::uint32_t i = 0; i < edges; ++i) {
    outline_.change_start[i] = i;
    outline_.changes[i] = {face, outline_.segments[i].change};
  }

  const auto other = [&](std::uint32_t i) { return all[segments[i - edges]].other.value; };
  const bool is_one = std::all_of(segments.begin(), segments.end(),
                                  [&](std::uint32_t i) { return all[i].other == all[segments[0]].other; });
  if (!is_one) close_pairs(edges, other, [&](std::uint32_t i, std::uint32_t j) { split_pair(i, j); });
}

void OutlineMaker::split_by_point(std::uint32_t s, VertexId v) {
  const Segment& seg = outline_.segments[s];
  if (v != seg.a && v != seg.b && names_.side(v, seg.line) == 0 && strictly_inside(v, seg))
    outline_.splits.push_back({s, v});
}

void OutlineMaker::split_collinear(std::uint32_t s, std::uint32_t t) {
  const Segment &p = outline_.segments[s], &q = outline_.segments[t];
  for (const VertexId v : {q.a, q.b})
    if (v != p.a && v != p.b && strictly_inside(v, p)) outline_.splits.push_back({s, v});
  for (const VertexId v : {p.a, p.b})
    if (v != q.a && v != q.b && strictly_inside(v, q)) outline_.splits.push_back({t, v});
}

void OutlineMaker::split_pair(std::uint32_t s, std::uint32_t t) {
  const Segment &p = outline_.segments[s], &q = outline_.segments[t];
  if (p.a == q.a || p.a == q.b || p.b == q.a || p.b == q.b) {
    // Lines that share a point meet nowhere else unless they are one line.
    ++exact::counters().symbolic;
    const VertexId other = q.a == p.a || q.a == p.b ? q.b : q.a;
    if (names_.side(other, p.line) == 0) split_collinear(s, t);
    return;
  }

  const int qa = names_.side(q.a, p.line), qb = names_.side(q.b, p.line);
  if (qa * qb > 0) return;
  if (qa == 0 && qb == 0) return split_collinear(s, t);
  const int pa = names_.side(p.a, q.line), pb = names_.side(p.b, q.line);
  if (pa * pb > 0) return;
  if (pa * pb == 0) {
    if (qa * qb < 0) outline_.splits.push_back({t, pa == 0 ? p.a : p.b});
    return;  // both zero: two ends at one point would be one vertex, so nothing is inside
  }
  if (qa * qb == 0) {
    outline_.splits.push_back({s, qa == 0 ? q.a : q.b});
    return;
  }

  const auto crossing = exact::meet(names_.planes[outline_.plane], names_.planes[p.line], names_.planes[q.line]);
  assert(crossing);
  const NewVertex name = NewVertex::own(outline_.new_points.size());
  outline_.new_points.push_back(*crossing);
  outline_.splits.push_back({s, name});
  outline_.splits.push_back({t, name});
}

}  // namespace quoin::booleans
