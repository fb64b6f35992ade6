#include "booleans/arrangement/line_trace.h"

#include "booleans/arrangement/frame.h"

namespace quoin::booleans {
namespace {

bool contains(const Box& box, const std::array<double, 3>& p) {
  for (std::size_t k = 0; k < 3; ++k)
    if (p[k] < box.low[k] || p[k] > box.high[k]) return false;
  return true;
}

}  // namespace

void LineTracer::find_stops(const FaceLine& line, const Box& box, Trace& trace) {
  collect_stops(line, {&box, 1}, trace);
  if (touched_.edge_tree[line.face])
    std::erase_if(trace.stops, [&](const Stop& s) { return !contains(box, approximation(s.vertex)); });
  merge(line, trace.stops);
}

void LineTracer::find_stops_between(const FaceLine& line, const Array<Stop>& stops, Trace& trace) {
  const NewVertex first = stops.front().vertex, last = stops.back().vertex;
  collect_stops(line, std::array{box_around(first), box_around(last)}, trace);
  std::erase_if(trace.stops, [&](const Stop& s) {
    return compare(line.axis, s.vertex, first) * compare(line.axis, s.vertex, last) > 0;
  });
  merge(line, trace.stops);
}

/// Those of all edges; of a face with an edge tree, of those that may meet the line within the hull of the boxes.
void LineTracer::collect_stops(const FaceLine& line, std::span<const Box> hull, Trace& trace) {
  Array<Stop>& stops = trace.stops;
  stops.clear();
  trace.left = trace.right = 0;
  trace.runs_along = false;

  const TouchedFace& face = touched_.faces[line.face];
  if (const SegmentTree* tree = touched_.edge_tree[line.face].get())
    tree->meeting(names_.planes[line.other], hull,
                  [&](std::uint32_t i) { add_stops(line, face.edges_begin + i, trace); });
  else
    for (std::uint32_t e = face.edges_begin; e < face.edges_end; ++e) add_stops(line, e, trace);

  for (const VertexId v : touched_.isolated_of(line.face))
    if (names_.side(v, line.other) == 0) stops.push_back({v, 0, 0, false, none});
}

void LineTracer::add_stops(const FaceLine& line, std::uint32_t e, Trace& trace) {
  Array<Stop>& stops = trace.stops;
  const BoundaryEdge& edge = touched_.edges[e];
  // Boundary edges have the face on their left seen from its outward normal.
  const int turn = touched_.faces[line.face].along ? 1 : -1;
  const int su = names_.side(edge.from, line.other), sv = names_.side(edge.to, line.other);
  const int left = turn * ((su < 0 && sv >= 0) - (su >= 0 && sv < 0));
  const int right = turn * ((su <= 0 && sv > 0) - (su > 0 && sv <= 0));

  if (su * sv < 0) {
    stops.push_back({crossing(line, edge), left, right, false, e});
    return;
  }
  if (su == 0 && sv == 0) trace.runs_along = true;
  if (su == 0) stops.push_back({edge.from, left, right, false, none});
  if (sv == 0) stops.push_back({edge.to, su == 0 ? 0 : left, su == 0 ? 0 : right, false, none});
}

NewVertex LineTracer::crossing(const FaceLine& line, const BoundaryEdge& e) {
  const VertexId low = std::min(e.from, e.to), high = std::max(e.from, e.to);
  Crossing& known = crossings_[(low.value * 31 + high.value * 17 + line.other.value) % crossings_.size()];
  if (known.low == low && known.high == high && known.plane == line.other) return known.point;

  const VertexTable& vertices = names_.vertices;
  const exact::Plane& q = names_.planes[line.other];
  if (vertices.is_grid(low) && vertices.is_grid(high)) {
    const exact::GridPoint u = vertices.grid_point(low), v = vertices.grid_point(high);
    points.push_back(exact::meet(u, exact::value(q, u), v, exact::value(q, v)));
  } else {
    points.push_back(*exact::meet(names_.planes[line.own], names_.planes[e.other], q));
  }
  known = {low, high, line.other, NewVertex::own(points.size() - 1)};
  return known.point;
}

/// Sorts the stops along the line and joins equal ones.
void LineTracer::merge(const FaceLine& line, Array<Stop>& stops) const {
  const auto order = [&](const Stop& a, const Stop& b) {
    return compare(line.axis, a.vertex, b.vertex) * line.direction;
  };
  if (stops.size() == 2) {
    if (order(stops[0], stops[1]) > 0) std::swap(stops[0], stops[1]);
  } else {
    std::sort(stops.begin(), stops.end(), [&](const Stop& a, const Stop& b) { return order(a, b) < 0; });
  }

  std::size_t n = 0;
  for (const Stop& s : stops) {
    if (n > 0 && order(stops[n - 1], s) == 0) {
      stops[n - 1].left += s.left;
      stops[n - 1].right += s.right;
      stops[n - 1].edge = none;
      if (!s.vertex.is_own()) stops[n - 1].vertex = s.vertex;
    } else {
      stops[n++] = s;
    }
  }
  stops.resize(n);
}

/// How often a face with an edge tree covers the strips before its first stop. Where it covers its plane once at most,
/// the first net crossing of a strip tells: whoever leaves was inside. Else, and without a crossing, one point of the
/// line is asked: before the first stop a strip is as it is after it, but for what crosses there.
void LineTracer::anchor(const FaceLine& line, NewVertex at, Trace& trace) const {
  const auto before = [&](int Stop::*strip, int which) {
    if (touched_.cover_once)
      for (const Stop& s : trace.stops)
        if (s.*strip != 0) return s.*strip > 0 ? 0 : 1;
    if (trace.stops.empty()) return cover_after(line, at, which);
    return cover_after(line, trace.stops[0].vertex, which) - trace.stops[0].*strip;
  };
  trace.left = before(&Stop::left, 1);
  trace.right = before(&Stop::right, -1);
}

/// How often does the face cover the point at + t (n_own x n_other) + t^2 l, for an infinitely small t > 0 and l
/// pointing to the left (strip 1) or right (strip -1) of that line? Counts the boundary edges straight below, each with
/// the change of cover from below to above it.
int LineTracer::cover_after(const FaceLine& line, NewVertex at, int strip) const {
  const exact::Plane &p = names_.planes[line.own], &q = names_.planes[line.other];
  const Frame frame(p);
  const int forward_u = exact::cross_sign(p, q, frame.u()), forward_v = exact::cross_sign(p, q, frame.v());
  // Where the line runs straight up its left is towards smaller u.
  const int shift_u = forward_u != 0 ? forward_u : -forward_v * strip;

  Box below;
  below.add(approximation(at));
  for (int k = 0; k < 3; ++k) {
    const auto i = static_cast<std::size_t>(k);
    if (k == frame.u()) continue;
    below.low[i] = INT32_MIN;
    if (k != frame.v()) below.high[i] = INT32_MAX;
  }

  int count = 0;
  touched_.edge_tree[line.face]->boxes().meeting(below, [&](std::uint32_t i) {
    const BoundaryEdge& edge = touched_.edges_of(line.face)[i];
    const auto beyond = [&](VertexId v) {  // the vertex lies at larger u than the shifted point
      const int c = compare(frame.u(), v, at);
      return c != 0 ? c > 0 : shift_u < 0;
    };
    const bool from = beyond(edge.from), to = beyond(edge.to);
    if (from == to) return;

    const exact::Plane& other = names_.planes[edge.other];
    // Left of n_p x n_other is where that plane is negative; `rightward` turns that direction towards larger u.
    const int rightward = frame.direction(p, other);
    int above = -rightward * side(at, edge.other);
    if (above == 0) above = rightward * exact::turn(p, other, q);  // the line of the strips turns left of the edge's
    if (above == 0) above = frame.direction(p, q) * strip;         // the edge runs along the line
    if (above > 0) count += (to == touched_.faces[line.face].along) ? 1 : -1;
  });
  return count;
}

void LineTracer::find_open_segments(const FaceLine& line, NewVertex at, Trace& trace) {
  if (touched_.edge_tree[line.face]) anchor(line, at, trace);

  int left = trace.left, right = trace.right;
  trace.open = left > 0 || right > 0;
  for (Stop& s : trace.stops) {
    left += s.left;
    right += s.right;
    s.open = left > 0 || right > 0;
  }
}

void reverse(Trace& trace) {
  // The segment before a stop becomes the one after it.
  bool before = trace.open;
  for (Stop& s : trace.stops) std::swap(before, s.open);
  trace.open = before;
  std::reverse(trace.stops.begin(), trace.stops.end());
}

}  // namespace quoin::booleans
