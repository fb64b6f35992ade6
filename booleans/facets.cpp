#include "booleans/facets.h"

#include <numeric>

namespace quoin::booleans {

Targets::Targets(const Arrangement& a) : a_(a), sheet_edges_(a.sheets.size()) {
  for (std::uint32_t f = 0; f < a.operands.face_count(); ++f) {
    if (a.patch_of[f] == none) continue;
    const auto [operand, face] = a.operands.local(f);
    targets_.push_back({none, f});
    boxes_.push_back(face_box(*a.operands.bodies[operand], face));
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

/// The plane through a grid edge parallel to the x axis: normal (0, -dz, dy).
exact::Plane lifted_edge(const exact::GridPoint& a, const exact::GridPoint& b) {
  const std::int64_t dy = std::int64_t{b[1]} - a[1], dz = std::int64_t{b[2]} - a[2];
  return {{0, -dz, dy}, exact::int128(dz) * a[1] - exact::int128(dy) * a[2]};
}

exact::GridPoint grid_point(const exact::Point& p) {
  return {{static_cast<std::int32_t>(p.approximation[0]), static_cast<std::int32_t>(p.approximation[1]),
           static_cast<std::int32_t>(p.approximation[2])}};
}

bool is_grid(const exact::Point& p) { return exact::compare(p.w, exact::Denominator(1)) == 0; }

}  // namespace

/// Does the edge cross the half line from (v_y - eps, v_z - eps^2) towards +y in the (y, z) plane?
/// Heights: a point is above when its z >= v_z, because the line runs eps^2 lower. At that height the edge's line lies
/// at larger y than the shifted point exactly when its y at height v_z is >= v_y.
bool Targets::edge_counts(const exact::Plane& plane, const exact::Point& a, const exact::Point& b, const exact::Plane* line,
                          const exact::Point& v) const {
  if ((exact::compare_along(2, a, v) >= 0) == (exact::compare_along(2, b, v) >= 0)) return false;
  // R contains the edge's line and is parallel to x; its zero at v's height lies at y >= v_y exactly when
  // R(v) = 0 or sign R(v) = -sign R_y.
  int at_v = 0, slope = 0;
  if (is_grid(a) && is_grid(b)) {
    const exact::Plane r = lifted_edge(grid_point(a), grid_point(b));
    at_v = exact::side(r, v);
    slope = r.n[1] > 0 ? 1 : -1;  // not zero: the edge spans heights
  } else {
    // R = q_x P - p_x Q, degree 6 at v: 63 + 315 bits. R_y = q_x p_y - p_x q_y = -(n_p x n_q)_z.
    const auto r = exact::Coefficient(line->n[0]) * exact::scaled_value(plane, v) -
                   exact::Coefficient(plane.n[0]) * exact::scaled_value(*line, v);
    ++exact::counters().fixed_width;
    at_v = r.sign();
    slope = -exact::cross_sign(plane, *line, 2);
  }
  return at_v == 0 || at_v == -slope;
}

bool Targets::crossed(std::uint32_t t, const exact::Plane& plane, const exact::Point& v) const {
  const Target& target = targets_[t];
  bool odd = false;
  if (target.sheet != none) {
    const Sheet& sheet = a_.sheets[target.sheet];
    const SheetEdges& edges = sheet_edges_[target.sheet];
    for (std::uint32_t i = edges.start[target.index]; i < edges.start[target.index + 1]; ++i) {
      const std::uint32_t h = edges.half_edges[i];
      odd ^= edge_counts(plane, a_.vertices.point(sheet.origin(h)), a_.vertices.point(sheet.target(h)),
                         &a_.planes[sheet.elements[h / 2].line], v);
    }
    return odd;
  }
  const auto [operand, face] = a_.operands.local(target.index);
  const Body& body = *a_.operands.bodies[operand];
  if (face < body.triangles.size()) {
    const auto& c = body.triangles[face];
    for (std::size_t k = 0; k < 3; ++k)
      odd ^= edge_counts(plane, exact::point(body.grid_points[c[k]]), exact::point(body.grid_points[c[(k + 1) % 3]]), nullptr, v);
    return odd;
  }
  const auto p = face - static_cast<std::uint32_t>(body.triangles.size());
  for (std::uint32_t j = body.polygon_loops[p]; j < body.polygon_loops[p + 1]; ++j) {
    const auto loop = body.loop(j);
    for (std::size_t i = 0; i < loop.size() && loop.size() > 1; ++i) {
      const std::uint32_t u = loop[i], w = loop[i + 1 < loop.size() ? i + 1 : 0];
      exact::Plane line{};
      if (!body.is_grid(u) || !body.is_grid(w))
        a_.touched.adjacency[operand]->faces_at_edge(u, w, [&](std::uint32_t g, bool) {
          const exact::Plane q = body.plane(g);
          if (!exact::parallel(plane, q)) line = q;
        });
      odd ^= edge_counts(plane, body.point(u), body.point(w), &line, v);
    }
  }
  return odd;
}

}  // namespace quoin::booleans
