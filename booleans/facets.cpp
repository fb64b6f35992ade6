#include "booleans/facets.h"

#include <numeric>

namespace quoin::booleans {

Targets::Targets(const Arrangement& a, const Box& region)
    : a_(a), sheet_edges_(a.sheets.size()), adjacency_(a.operands.bodies.size()) {
  for (const OperandChunk& c : a.operands.chunks) {
    if (!c.box.meets(region)) continue;
    for (std::uint32_t f = c.begin; f < c.end; ++f) {
      if (a.patch_of[f] == none) continue;
      const Box box = face_box(*a.operands.bodies[c.operand], f - a.operands.base[c.operand]);
      if (!box.meets(region)) continue;
      targets_.push_back({none, f});
      boxes_.push_back(box);
    }
  }
  for (std::uint32_t s = 0; s < a.sheets.size(); ++s) {
    const Sheet& sheet = a.sheets[s];
    SheetEdges& edges = sheet_edges_[s];
    edges.start.assign(sheet.facet_count() + 1, 0);
    for (std::uint32_t f : sheet.facet)
      if (f != none) ++edges.start[f + 1];
    std::partial_sum(edges.start.begin(), edges.start.end(), edges.start.begin());
    edges.half_edges.resize(edges.start.back());
    std::vector<std::uint32_t> at(edges.start.begin(), edges.start.end() - 1);
    const auto first = boxes_.size();
    boxes_.resize(first + sheet.facet_count());
    for (std::uint32_t f = 0; f < sheet.facet_count(); ++f) targets_.push_back({s, f});
    for (std::uint32_t h = 0; h < sheet.facet.size(); ++h) {
      const std::uint32_t f = sheet.facet[h];
      if (f == none) continue;
      edges.half_edges[at[f]++] = h;
      boxes_[first + f].add(a.vertices.approximation(sheet.origin(h)));
    }
  }
}

std::uint32_t Targets::node(std::uint32_t t) const {
  const Target& target = targets_[t];
  return target.sheet == none ? a_.patch_of[target.index] : a_.facet_base[target.sheet] + target.index;
}

exact::Plane Targets::plane(std::uint32_t t, bool& turned) const {
  const Target& target = targets_[t];
  turned = false;
  if (target.sheet != none) return a_.planes[a_.sheets[target.sheet].plane];
  const auto [operand, face] = a_.operands.local(target.index);
  const exact::Plane p = a_.operands.bodies[operand]->plane(face);
  turned = !exact::is_canonical(p);
  return turned ? p.opposite() : p;
}

namespace {

/// The plane through a grid edge parallel to the y axis: normal (dz, 0, -dx).
exact::Plane lifted_edge(const exact::GridPoint& a, const exact::GridPoint& b) {
  const std::int64_t dx = std::int64_t{b[0]} - a[0], dz = std::int64_t{b[2]} - a[2];
  return {{dz, 0, -dx}, exact::int128(dx) * a[2] - exact::int128(dz) * a[0]};
}

exact::GridPoint grid_point(const exact::Point& p) {
  return {{static_cast<std::int32_t>(p.approximation[0]), static_cast<std::int32_t>(p.approximation[1]),
           static_cast<std::int32_t>(p.approximation[2])}};
}

bool is_grid(const exact::Point& p) { return exact::compare(p.w, exact::Denominator(1)) == 0; }

/// Does the edge {a, b} cross the half line from s towards +z in the (x, z) plane?
/// Abscissas: s_x is v_x or a little more, so a point is beyond when its x > v_x. Let R contain the edge's line and be
/// parallel to y; at s_x the line's z exceeds s_z exactly when sign R(s) = -sign R_z, and R(s) is R(v), then R . d,
/// then -R_z.
bool edge_counts(const exact::Plane& plane, const exact::Point& a, const exact::Point& b, const exact::Plane& line,
                 const RayStart& s) {
  if ((exact::compare_along(0, a, s.v) > 0) == (exact::compare_along(0, b, s.v) > 0)) return false;
  int at_v = 0, rise = 0, slope = 0;
  if (is_grid(a) && is_grid(b)) {
    const exact::Plane r = lifted_edge(grid_point(a), grid_point(b));
    at_v = exact::side(r, s.v);
    rise = at_v == 0 ? dot(r, s.d).sign() : 0;
    slope = r.n[2] > 0 ? 1 : -1;  // not zero: the ends differ in x
  } else {
    // R = q_y P - p_y Q, degree 6 at v: 63 + 315 bits. R_z = q_y p_z - p_y q_z = -(n_p x n_q)_x.
    const exact::Coefficient py(plane.n[1]), qy(line.n[1]);
    ++exact::counters().fixed_width;
    at_v = (qy * exact::scaled_value(plane, s.v) - py * exact::scaled_value(line, s.v)).sign();
    rise = at_v == 0 ? (qy * dot(plane, s.d) - py * dot(line, s.d)).sign() : 0;
    slope = -exact::cross_sign(plane, line, 0);
  }
  const int at_s = at_v != 0 ? at_v : rise != 0 ? rise : -slope;
  return at_s == -slope;
}

}  // namespace

void Targets::prepare(std::span<const std::uint32_t> targets) {
  std::vector<std::vector<std::uint8_t>> marked(a_.operands.bodies.size());
  std::vector<Box> around(marked.size());
  for (const std::uint32_t t : targets) {
    if (targets_[t].sheet != none) continue;
    const auto [operand, face] = a_.operands.local(targets_[t].index);
    const Body& body = *a_.operands.bodies[operand];
    if (face < body.triangles.size()) continue;
    auto& marks = marked[operand];
    marks.resize(body.vertex_count());
    body.for_corners(face, [&](std::uint32_t v) { marks[v] = 1; });
    around[operand].add(boxes_[t]);
  }
  for (std::uint32_t o = 0; o < marked.size(); ++o)
    if (!marked[o].empty())
      adjacency_[o] = std::make_unique<Adjacency>(*a_.operands.bodies[o], std::move(marked[o]),
                                                  a_.operands.chunks_meeting(o, around[o]));
}

template <class Visit>
void Targets::for_edges(std::uint32_t t, const exact::Plane& plane, Visit&& visit) {
  const Target& target = targets_[t];
  if (target.sheet != none) {
    const Sheet& sheet = a_.sheets[target.sheet];
    const SheetEdges& edges = sheet_edges_[target.sheet];
    for (std::uint32_t i = edges.start[target.index]; i < edges.start[target.index + 1]; ++i) {
      const std::uint32_t h = edges.half_edges[i];
      visit(Edge{a_.vertices.point(sheet.origin(h)), a_.vertices.point(sheet.target(h)),
                 a_.planes[sheet.elements[h / 2].line]});
    }
    return;
  }
  const auto [operand, face] = a_.operands.local(target.index);
  const Body& body = *a_.operands.bodies[operand];
  body.for_edges(face, [&, operand = operand](std::uint32_t u, std::uint32_t w) {
    exact::Plane line{};
    if (!body.is_grid(u) || !body.is_grid(w))
      adjacency_[operand]->faces_at_edge(u, w, [&](std::uint32_t g, bool) {
        const exact::Plane q = body.plane(g);
        if (!exact::parallel(plane, q)) line = q;
      });
    visit(Edge{body.point(u), body.point(w), line});
  });
}

std::size_t Targets::edge_count(std::uint32_t t) const {
  const Target& target = targets_[t];
  if (target.sheet != none) {
    const auto& start = sheet_edges_[target.sheet].start;
    return start[target.index + 1] - start[target.index];
  }
  const auto [operand, face] = a_.operands.local(target.index);
  return a_.operands.bodies[operand]->corner_count(face);
}

const Targets::Searchable& Targets::searchable(std::uint32_t t, const exact::Plane& plane) {
  if (const auto at = searchable_.find(t); at != searchable_.end()) return at->second;
  std::vector<Edge> edges;
  for_edges(t, plane, [&](const Edge& e) { edges.push_back(e); });
  std::vector<BoxTree::Item> items(edges.size());
  for (std::uint32_t i = 0; i < items.size(); ++i) {
    items[i].id = items[i].group = i;
    items[i].box.add(edges[i].a.approximation);
    items[i].box.add(edges[i].b.approximation);
  }
  return searchable_.emplace(t, Searchable{std::move(edges), BoxTree(items)}).first->second;
}

bool Targets::crossed(std::uint32_t t, const exact::Plane& plane, const RayStart& s) {
  bool odd = false;
  const auto count = [&](const Edge& e) { odd ^= edge_counts(plane, e.a, e.b, e.line, s); };
  if (edge_count(t) <= TouchedFaces::large) {
    for_edges(t, plane, count);
    return odd;
  }
  // Only edges that reach v's x and lie beyond its z, at any y, can count.
  Box beyond;
  beyond.add(s.v.approximation);
  beyond.low[1] = INT32_MIN;
  beyond.high[1] = beyond.high[2] = INT32_MAX;
  const Searchable& all = searchable(t, plane);
  all.tree.meeting(beyond, [&](std::uint32_t i) { count(all.edges[i]); });
  return odd;
}

}  // namespace quoin::booleans
