#include "rounding/polyhedron.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <utility>

#include "booleans/triangulate.h"

namespace quoin::rounding {
namespace {

Integer determinant(const WidePlane& p, const WidePlane& q, const WidePlane& r) {
  const auto &a = p.n, &b = q.n, &c = r.n;
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// The points of a face by their places in a list, seen along its normal.
class FacePoints {
 public:
  FacePoints(const Polyhedron& p, std::size_t face, std::span<const std::uint32_t> ids) : points_(p.points), ids_(ids) {
    const auto& n = p.planes[face].n;
    const std::size_t k = largest_component(n);
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
  corners.insert(corners.end(), loop.begin(), loop.end());
  loop_corners.push_back(static_cast<std::uint32_t>(corners.size()));
  face_loops.back() = static_cast<std::uint32_t>(loop_corners.size() - 1);
}

void Polyhedron::add_face(std::initializer_list<std::span<const std::uint32_t>> loops) {
  const auto first = *loops.begin();
  const Vector &a = points[first[0]], &b = points[first[1]], &c = points[first[2]];
  const Vector normal = cross(b - a, c - a);
  planes.push_back(wide_plane(normal, -dot(normal, a)));
  face_loops.push_back(face_loops.back());
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

Polyhedron polyhedron_of(const booleans::Canonical& form) {
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
  p.planes.reserve(form.planes.size());
  for (const exact::Plane& plane : form.planes)
    p.planes.push_back({{plane.n[0], plane.n[1], plane.n[2]}, exact::to_integer(plane.d)});
  p.face_loops = form.face_loops;
  p.loop_corners = form.loop_corners;
  p.corners = form.corners;
  return p;
}

Polyhedron carried(Polyhedron p, const AffineMap& map) {
  assert(determinant(map.linear) > 0);
  const IntegerMap back = inverse(IntegerMap(map));
  for (Vector& v : p.points) v = map(v);
  for (WidePlane& plane : p.planes) plane = moved(plane, back);
  return p;
}

Rational sixfold_volume(const Polyhedron& p) {
  Rational sum = 0;
  for (std::size_t f = 0; f < p.face_count(); ++f) {
    // A fan about the face's first corner, signed.
    const Vector& apex = p.points[p.corners[p.loop_corners[p.face_loops[f]]]];
    p.for_edges(f, [&](std::uint32_t u, std::uint32_t v) { sum += dot(apex, cross(p.points[u], p.points[v])); });
  }
  return sum;
}

std::optional<std::vector<std::array<std::uint32_t, 3>>> triangulated(const Polyhedron& p) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<booleans::FaceTriangle> local;
  for (std::size_t f = 0; f < p.face_count(); ++f) {
    const std::uint32_t begin = p.loop_corners[p.face_loops[f]], end = p.loop_corners[p.face_loops[f + 1]];
    if (end - begin == 3 && p.face_loops[f + 1] - p.face_loops[f] == 1) {
      triangles.push_back({p.corners[begin], p.corners[begin + 1], p.corners[begin + 2]});
      continue;
    }
    std::vector<std::uint32_t> ids(p.corners.begin() + begin, p.corners.begin() + end);
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    const auto place = [&](std::uint32_t v) {
      return static_cast<std::uint32_t>(std::lower_bound(ids.begin(), ids.end(), v) - ids.begin());
    };
    std::vector<booleans::FaceEdge> edges;
    std::vector<std::uint32_t> isolated;
    p.for_edges(f, [&](std::uint32_t u, std::uint32_t v) { edges.push_back({place(u), place(v)}); });
    for (std::uint32_t j = p.face_loops[f]; j < p.face_loops[f + 1]; ++j)
      if (p.loop(j).size() == 1) isolated.push_back(place(p.loop(j)[0]));
    local.clear();
    if (!booleans::triangulate(FacePoints(p, f, ids), static_cast<std::uint32_t>(ids.size()), edges, isolated, local))
      return std::nullopt;
    for (const auto& t : local) triangles.push_back({ids[t[0]], ids[t[1]], ids[t[2]]});
  }
  return triangles;
}

namespace {

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

/// Faces of different planes at each vertex, `none` for those that lack; nothing as soon as a vertex has more than
/// three.
std::optional<std::vector<std::array<std::uint32_t, 3>>> faces_at_vertices(const Polyhedron& p) {
  using booleans::none;
  std::vector<std::array<std::uint32_t, 3>> at(p.points.size(), {none, none, none});
  for (std::uint32_t f = 0; f < p.face_count(); ++f)
    for (std::uint32_t c = p.loop_corners[p.face_loops[f]]; c < p.loop_corners[p.face_loops[f + 1]]; ++c) {
      auto& faces = at[p.corners[c]];
      const auto place = std::find_if(faces.begin(), faces.end(), [&](std::uint32_t g) {
        return g == none || on_one_plane(p.planes[f], p.planes[g]);
      });
      if (place == faces.end()) return std::nullopt;
      if (*place == none) *place = f;
    }
  return at;
}

}  // namespace

std::optional<Trihedral> trihedral(const Polyhedron& p) {
  const auto faces = faces_at_vertices(p);
  if (!faces) return std::nullopt;
  const auto& at = *faces;
  Trihedral t;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> face_of;  // by directed edge
  for (std::uint32_t f = 0; f < p.face_count(); ++f) {
    for (std::uint32_t j = p.face_loops[f]; j < p.face_loops[f + 1]; ++j)
      if (p.loop(j).size() < 3) return std::nullopt;
    bool simple = true;
    p.for_edges(f, [&](std::uint32_t u, std::uint32_t v) { simple = simple && face_of.try_emplace({u, v}, f).second; });
    if (!simple) return std::nullopt;
  }
  for (std::size_t v = 0; v < at.size(); ++v) {
    if (at[v][2] == booleans::none) return std::nullopt;
    t.faces.push_back(at[v]);
    t.sign.push_back(determinant(p.planes[at[v][0]], p.planes[at[v][1]], p.planes[at[v][2]]).sign());
    if (t.sign.back() == 0) return std::nullopt;
  }
  for (const auto& [edge, f] : face_of) {
    const auto other = face_of.find({edge.second, edge.first});
    if (other == face_of.end()) return std::nullopt;
    for (const std::uint32_t h : t.faces[edge.second])
      if (!on_one_plane(p.planes[h], p.planes[f]) && !on_one_plane(p.planes[h], p.planes[other->second]))
        t.orders.push_back({edge.first, edge.second, h, value(p.planes[h], p.points[edge.first]).sign()});
  }
  return t;
}

}  // namespace quoin::rounding
