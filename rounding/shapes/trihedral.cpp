#include "rounding/shapes/trihedral.h"

#include <algorithm>
#include <map>
#include <utility>

namespace quoin::rounding {
namespace {

using Index = std::uint32_t;
using booleans::none;
using Edge = std::pair<Index, Index>;  // directed

Integer determinant(const WidePlane& p, const WidePlane& q, const WidePlane& r) {
  const auto &a = p.n, &b = q.n, &c = r.n;
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// Equal or opposite.
bool on_one_plane(const WidePlane& p, const WidePlane& q) {
  int sign = 0;
  const auto agree = [&](const Integer& a, const Integer& b) {
    const int s = a.sign() * b.sign();
    if (sign == 0) sign = s;
    return mpz_cmpabs(a.backend().data(), b.backend().data()) == 0 && (s == 0 || s == sign);
  };
  return agree(p.n[0], q.n[0]) && agree(p.n[1], q.n[1]) && agree(p.n[2], q.n[2]) && agree(p.d, q.d);
}

/// Three faces with different planes at each vertex, ascending; nothing where one has more or fewer.
std::optional<std::vector<std::array<Index, 3>>> faces_at_vertices(const Polyhedron& p) {
  std::vector<std::array<Index, 3>> at(p.points.size(), {none, none, none});
  for (Index f = 0; f < p.face_count(); ++f)
    for (const Index v : p.faces.corners_of(f)) {
      auto& faces = at[v];
      const auto place = std::find_if(faces.begin(), faces.end(),
                                      [&](Index g) { return g == none || on_one_plane(p.planes[f], p.planes[g]); });
      if (place == faces.end()) return std::nullopt;
      if (*place == none) *place = f;
    }

  const bool complete = std::all_of(at.begin(), at.end(), [](const auto& faces) { return faces[2] != none; });
  return complete ? std::optional(std::move(at)) : std::nullopt;
}

/// By directed edge the face on its left; nothing where an edge has two, or a loop fewer than three corners.
std::optional<std::map<Edge, Index>> faces_of_edges(const Polyhedron& p) {
  std::map<Edge, Index> face_of;
  bool simple = true;
  for (Index f = 0; f < p.face_count() && simple; ++f) {
    p.faces.for_loops(f, [&](std::span<const Index> loop) { simple = simple && loop.size() >= 3; });
    if (!simple) break;
    p.faces.for_edges(f, [&](Index u, Index v) { simple = simple && face_of.try_emplace({u, v}, f).second; });
  }
  return simple ? std::optional(std::move(face_of)) : std::nullopt;
}

}  // namespace

std::optional<Trihedral> trihedral(const Polyhedron& p) {
  auto at_vertices = faces_at_vertices(p);
  if (!at_vertices) return std::nullopt;
  const auto face_of = faces_of_edges(p);
  if (!face_of) return std::nullopt;

  Trihedral t;
  t.faces = std::move(*at_vertices);
  for (const auto& [f, g, h] : t.faces) {
    t.sign.push_back(determinant(p.planes[f], p.planes[g], p.planes[h]).sign());
    if (t.sign.back() == 0) return std::nullopt;
  }

  for (const auto& [edge, f] : *face_of) {
    const auto other = face_of->find({edge.second, edge.first});
    if (other == face_of->end()) return std::nullopt;
    for (const Index h : t.faces[edge.second])
      if (!on_one_plane(p.planes[h], p.planes[f]) && !on_one_plane(p.planes[h], p.planes[other->second]))
        t.orders.push_back({edge.first, edge.second, h, value(p.planes[h], p.points[edge.first]).sign()});
  }
  return t;
}

}  // namespace quoin::rounding
