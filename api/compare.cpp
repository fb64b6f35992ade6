#include "api/compare.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "api/access.h"
#include "booleans/body/canonical.h"
#include "booleans/body/locate.h"

namespace quoin {

using booleans::Body;
using booleans::Canonical;

bool equal_on_one_grid(const Body& a, const Body& b) {
  const auto p = booleans::bounds(a), q = booleans::bounds(b);
  if (p.has_value() != q.has_value()) return false;
  if (p && (p->low != q->low || p->high != q->high)) return false;
  return booleans::canonical(a) == booleans::canonical(b);
}

namespace {

/// The faces by their loops alone: on equal vertices these determine the planes, and no order of planes depends on the
/// grid then. Each face is the lengths and corners of its loops.
std::vector<std::vector<std::uint32_t>> sorted_faces(const Canonical& form) {
  std::vector<std::vector<std::uint32_t>> faces(form.face_count());
  for (std::size_t i = 0; i < faces.size(); ++i)
    form.faces.for_loops(i, [&](std::span<const std::uint32_t> loop) {
      faces[i].push_back(static_cast<std::uint32_t>(loop.size()));
      faces[i].insert(faces[i].end(), loop.begin(), loop.end());
    });
  std::sort(faces.begin(), faces.end());
  return faces;
}

}  // namespace

bool equal_across_grids(const Solid& a, const Solid& b) {
  const Canonical p = booleans::canonical(Access::body(a)), q = booleans::canonical(Access::body(b));
  if (p.vertices.size() != q.vertices.size() || p.face_count() != q.face_count() ||
      p.faces.corners.size() != q.faces.corners.size() || p.faces.loop_count() != q.faces.loop_count())
    return false;
  const grid::Lattice &s = Access::lattice(a), &t = Access::lattice(b);
  // Both are in lexicographic order, which no positive scaling and no shift changes.
  for (std::size_t v = 0; v < p.vertices.size(); ++v)
    for (int k = 0; k < 3; ++k)
      if (grid::model_coordinate(s, p.vertices[v], k) != grid::model_coordinate(t, q.vertices[v], k)) return false;
  return sorted_faces(p) == sorted_faces(q);
}

}  // namespace quoin
