#include "rounding/shapes/polyhedron.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "booleans/surface/triangulate.h"

namespace quoin::rounding {
namespace {

/// The points of a face by their places in a list, seen along its normal.
class FacePoints {
 public:
  FacePoints(const Polyhedron& p, std::size_t face, std::span<const std::uint32_t> ids) : points_(p.points), ids_(ids) {
    const auto& n = p.planes[face].n;
    const std::size_t k = longest_component(n);
    u_ = (k + 1) % 3;
    v_ = (k + 2) % 3;
    if (n[k] < 0) std::swap(u_, v_);
  }
  int compare(std::uint32_t a, std::uint32_t b) const {
    const Vector &p = point(a), &q = point(b);
    const int first = p[u_].compare(q[u_]), order = first != 0 ? first : p[v_].compare(q[v_]);
    return (order > 0) - (order < 0);
  }
  int orientation(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const Vector &p = point(a), &q = point(b), &r = point(c);
    return Rational((q[u_] - p[u_]) * (r[v_] - p[v_]) - (q[v_] - p[v_]) * (r[u_] - p[u_])).sign();
  }

 private:
  const Vector& point(std::uint32_t i) const { return points_[ids_[i]]; }
  const std::vector<Vector>& points_;
  std::span<const std::uint32_t> ids_;
  std::size_t u_, v_;
};

}  // namespace

std::uint32_t Polyhedron::add_point(Vector p) {
  points.push_back(std::move(p));
  return static_cast<std::uint32_t>(points.size() - 1);
}

void Polyhedron::add_loop(std::span<const std::uint32_t> loop) {
  faces.add_loop(loop);
  faces.face_start.back() = static_cast<std::uint32_t>(faces.loop_count());
}

void Polyhedron::add_face(std::initializer_list<std::span<const std::uint32_t>> loops) {
  const auto first = *loops.begin();
  const Vector &a = points[first[0]], &b = points[first[1]], &c = points[first[2]];
  const Vector normal = cross(b - a, c - a);
  planes.push_back(wide_plane(normal, -dot(normal, a)));

  faces.face_start.push_back(faces.face_start.back());
  for (const auto loop : loops) add_loop(loop);
}

AffineMap to_grid(const grid::Lattice& lattice) {
  AffineMap map;
  for (std::size_t k = 0; k < 3; ++k) {
    map.linear[k][k] = 1 / lattice.step;
    map.shift[k] = -lattice.origin[k] / lattice.step;
  }
  return map;
}

Polyhedron polyhedron_of(const booleans::Boundary& form) {
  assert(!form.full_at_infinity);
  Polyhedron p;
  p.points.reserve(form.vertices.size());
  const exact::Denominator one(1);
  for (const exact::Point& v : form.vertices) {
    Vector& q = p.points.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      // The approximation of a grid point is exact.
      if (v.w == one)
        q[k] = static_cast<std::int64_t>(v.approximation[k]);
      else
        q[k] = exact::coordinate(v, static_cast<int>(k));
    }
  }

  const auto wide = [](const exact::Plane& plane) -> WidePlane {
    return {{plane.n[0], plane.n[1], plane.n[2]}, exact::to_integer(plane.d)};
  };
  p.planes.reserve(form.planes.size());
  for (const exact::Plane& plane : form.planes) p.planes.push_back(wide(plane));
  p.faces = form.faces;

  p.origins = form.labels.origins;
  p.provenance.assign(form.labels.polygons.begin(), form.labels.polygons.end());
  for (const booleans::Border& b : form.labels.borders) p.borders.push_back({b.corner, wide(b.other)});
  return p;
}

Polyhedron carried(Polyhedron p, const AffineMap& map) {
  assert(determinant(map.linear) > 0);
  const IntegerMap back = inverse(IntegerMap(map));
  for (Vector& v : p.points) v = map(v);
  for (WidePlane& plane : p.planes) plane = moved(plane, back);
  for (Polyhedron::Border& b : p.borders) b.other = moved(b.other, back);
  return p;
}

std::optional<FaceTriangles> triangulated(const Polyhedron& p) {
  FaceTriangles triangles;
  std::vector<booleans::FaceTriangle> local;
  for (std::size_t f = 0; f < p.face_count(); ++f) {
    const auto corners = p.faces.corners_of(f);
    if (corners.size() == 3 && p.faces.loop_count(f) == 1) {
      triangles.corners.push_back({corners[0], corners[1], corners[2]});
      triangles.face.push_back(static_cast<std::uint32_t>(f));
      continue;
    }

    std::vector<std::uint32_t> ids(corners.begin(), corners.end());
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    const auto place = [&](std::uint32_t v) {
      return static_cast<std::uint32_t>(std::lower_bound(ids.begin(), ids.end(), v) - ids.begin());
    };

    std::vector<booleans::FaceEdge> edges;
    std::vector<std::uint32_t> isolated;
    p.faces.for_edges(f, [&](std::uint32_t u, std::uint32_t v) { edges.push_back({place(u), place(v)}); });
    p.faces.for_points(f, [&](std::uint32_t v) { isolated.push_back(place(v)); });

    local.clear();
    if (!booleans::triangulate(FacePoints(p, f, ids), static_cast<std::uint32_t>(ids.size()), edges, isolated, local))
      return std::nullopt;
    for (const auto& t : local) triangles.corners.push_back({ids[t[0]], ids[t[1]], ids[t[2]]});
    triangles.face.resize(triangles.corners.size(), static_cast<std::uint32_t>(f));
  }
  return triangles;
}

}  // namespace quoin::rounding
