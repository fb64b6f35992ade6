#include "booleans/classify/targets.h"

namespace quoin::booleans {

Targets::Targets(const Arrangement& a, const Box& region)
    : a_(a), half_edges_(a.sheets.size()), adjacency_(a.operands.bodies.size()) {
  for (const OperandChunk& c : a.operands.chunks) {
    if (!c.box.meets(region)) continue;
    for (const FaceId f : Ids<FaceId>(c.begin, c.end)) {
      if (a.patches().of[f] == none) continue;
      const Box box = face_box(a.operands[c.operand], a.operands.own(c.operand, f));
      if (!box.meets(region)) continue;
      targets_.push_back({none, f});
      boxes_.push_back(box);
    }
  }

  for (const SheetId s : a.sheets.ids()) {
    const Sheet& sheet = a.sheets[s];
    half_edges_[s] = grid::Buckets<>(sheet.facet_count(), [&](auto&& visit) {
      for (std::uint32_t h = 0; h < sheet.half_edges(); ++h)
        if (sheet.facet[h] != none) visit(sheet.facet[h].value, h);
    });
    for (const NodeId n : a.sheets.nodes(s)) {
      targets_.push_back({n, none});
      Box& box = boxes_.emplace_back();
      for (const std::uint32_t h : half_edges_[s][a.sheets.facet_of(n).value])
        a.names.vertices.add_to(box, sheet.origin(h));
    }
  }
}

NodeId Targets::node(std::uint32_t t) const {
  const Target& target = targets_[t];
  return target.facet != none ? target.facet : a_.patches().of[target.face];
}

exact::Plane Targets::plane(std::uint32_t t, bool& turned) const {
  const Target& target = targets_[t];
  turned = false;
  if (target.facet != none) return a_.names.planes[a_.sheets[a_.sheets.sheet_of(target.facet)].plane];

  const OwnFace f = a_.operands.own(target.face);
  const exact::Plane p = a_.operands[f.operand].sign_plane(f.face);
  turned = !exact::is_canonical(p);
  return turned ? p.opposite() : p;
}

namespace {

/// The plane through a grid edge parallel to the y axis: normal (dz, 0, -dx).
exact::Plane lifted_edge(const exact::GridPoint& a, const exact::GridPoint& b) {
  const std::int64_t dx = std::int64_t{b[0]} - a[0], dz = std::int64_t{b[2]} - a[2];
  return {{dz, 0, -dx}, exact::int128(dx) * a[2] - exact::int128(dz) * a[0]};
}

/// Does the edge {a, b} cross the half line from s towards +z in the (x, z) plane?
/// Abscissas: s_x is v_x or a little more, so a point is beyond when its x > v_x. Let R contain the edge's line and be
/// parallel to y; at s_x the line's z exceeds s_z exactly when sign R(s) = -sign R_z, and R(s) is R(v), then R . d,
/// then -R_z.
bool edge_counts(const exact::Plane& plane, const exact::Point& a, const exact::Point& b, const exact::Plane& line,
                 const RayStart& s) {
  if ((exact::compare_along(0, a, s.v) > 0) == (exact::compare_along(0, b, s.v) > 0)) return false;
  int at_v = 0, rise = 0, slope = 0;
  if (exact::is_grid(a) && exact::is_grid(b)) {
    const exact::Plane r = lifted_edge(exact::grid_point(a), exact::grid_point(b));
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
  ById<OperandId, grid::Numbering> corners(a_.operands.bodies.size());
  ById<OperandId, Box> around(corners.size());
  const auto add = [&](OperandId operand, std::span<const std::uint32_t> loop, const Box& box) {
    auto& own = corners[operand];
    if (own.size() == 0) own = grid::Numbering(a_.operands[operand].vertex_count());
    for (const std::uint32_t v : loop) own.add(v);
    around[operand].add(box);
  };
  for (const std::uint32_t t : targets) {
    if (targets_[t].facet != none) {
      for_spared_loops(targets_[t].facet, [&](OperandId o, auto loop) { add(o, loop, boxes_[t]); });
      continue;
    }
    const auto [operand, face] = a_.operands.own(targets_[t].face);
    const Body& body = a_.operands[operand];
    if (face >= body.triangles.size()) add(operand, body.corners_of(face), boxes_[t]);
  }

  for (const OperandId o : a_.operands.ids())
    if (corners[o].size() > 0)
      adjacency_[o] = std::make_unique<Adjacency>(a_.operands[o], std::move(corners[o]),
                                                  a_.operands.chunks_meeting(o, {&around[o], 1}));
}

template <class Visit>
void Targets::for_spared_loops(NodeId facet, Visit&& visit) const {
  for (const SparedFace& s : a_.sheets.spared(facet)) {
    const OperandId o = a_.touched.faces[s.face].operand;
    for (const std::uint32_t j : a_.touched.spared_of(s.face)) visit(o, a_.operands[o].polygons.loop(j));
  }
}

template <class Visit>
void Targets::for_edges(std::uint32_t t, const exact::Plane& plane, Visit&& visit) {
  const auto visit_own = [&](OperandId operand, std::uint32_t u, std::uint32_t w) {
    const Body& body = a_.operands[operand];
    exact::Plane line{};
    if (!body.is_grid(u) || !body.is_grid(w)) {
      assert(adjacency_[operand]);
      adjacency_[operand]->faces_at_edge(u, w, [&](std::uint32_t g, bool) {
        const exact::Plane q = body.plane(g);
        if (!exact::parallel(plane, q)) line = q;
      });
    }
    visit(Edge{body.point(u), body.point(w), line});
  };

  const Target& target = targets_[t];
  if (target.facet == none) {
    const OwnFace f = a_.operands.own(target.face);
    a_.operands[f.operand].for_edges(f.face, [&](std::uint32_t u, std::uint32_t w) { visit_own(f.operand, u, w); });
    return;
  }

  const SheetId s = a_.sheets.sheet_of(target.facet);
  const Sheet& sheet = a_.sheets[s];
  for (const std::uint32_t h : half_edges_[s][a_.sheets.facet_of(target.facet).value])
    visit(Edge{a_.names.vertices.point(sheet.origin(h)), a_.names.vertices.point(sheet.target(h)),
               a_.names.planes[sheet.elements[h / 2].line]});
  for_spared_loops(target.facet, [&](OperandId o, auto loop) {
    grid::for_loop_edges(loop, [&](std::uint32_t u, std::uint32_t w) { visit_own(o, u, w); });
  });
}

std::size_t Targets::edge_count(std::uint32_t t) const {
  const Target& target = targets_[t];
  if (target.facet != none) {
    std::size_t count = half_edges_[a_.sheets.sheet_of(target.facet)][a_.sheets.facet_of(target.facet).value].size();
    for_spared_loops(target.facet, [&](OperandId, auto loop) { count += loop.size(); });
    return count;
  }
  const OwnFace f = a_.operands.own(target.face);
  return a_.operands[f.operand].corner_count(f.face);
}

const Targets::Searchable& Targets::searchable(std::uint32_t t, const exact::Plane& plane) {
  if (const auto at = searchable_.find(t); at != searchable_.end()) return at->second;
  Array<Edge> edges;
  for_edges(t, plane, [&](const Edge& e) { edges.push_back(e); });
  Array<BoxTree::Item> items(edges.size());
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
  if (edge_count(t) <= grid::thresholds().large_face) {
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
