#include "booleans/body/validity.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "booleans/body/half_edges.h"
#include "exact/filter_bounds.h"
#include "exact/predicates.h"
#include "exact/rational.h"
#include "grid/lists/stretches.h"

namespace quoin::booleans {
namespace {

Fault at_vertex(std::size_t v, std::string message) { return {std::move(message), "vertex " + std::to_string(v)}; }
Fault at_face(std::size_t f, std::string message) { return {std::move(message), "face " + std::to_string(f)}; }

std::string edge_name(const HalfEdge& e) {
  return "the edge between the vertices " + std::to_string(std::min(e.from, e.to)) + " and " +
         std::to_string(std::max(e.from, e.to));
}

/// Two vertices at one point. In canonical order they would follow each other; any other order is sorted first.
std::optional<Fault> vertex_fault(const std::vector<exact::Point>& vertices) {
  const auto order = [&](std::uint32_t u, std::uint32_t v) {
    return exact::compare_lexicographic(vertices[u], vertices[v]);
  };
  std::vector<std::uint32_t> sorted(vertices.size());
  std::iota(sorted.begin(), sorted.end(), 0u);
  const auto less = [&](std::uint32_t u, std::uint32_t v) { return order(u, v) < 0; };
  if (!std::is_sorted(sorted.begin(), sorted.end(), less)) std::stable_sort(sorted.begin(), sorted.end(), less);

  for (std::size_t i = 1; i < sorted.size(); ++i)
    if (order(sorted[i - 1], sorted[i]) == 0)
      return at_vertex(sorted[i], "vertex " + std::to_string(sorted[i - 1]) + " is the same point");
  return std::nullopt;
}

/// On which side of a plane a vertex lies; grid points, as most are, in 128 bits.
int side_of(const exact::Plane& plane, const exact::Point& p) {
  return exact::is_grid(p) ? exact::side(plane, exact::grid_point(p)) : exact::side(plane, p);
}

/// The sign of the face's area, counter-clockwise seen from outside being positive.
int area_sign(const Boundary& boundary, std::size_t f) {
  const auto& n = boundary.planes[f].n;
  const std::size_t k = exact::longest_component(n), u = (k + 1) % 3, v = (k + 2) % 3;
  const int turned = n[k] < 0 ? -1 : 1;

  // In doubles first: a term has an error of four roundings at most (two coordinates, a product, the difference), and
  // of m - 1 more in the sum, so with u the unit roundoff and S the sum of the terms' sizes the error is below
  // 1.01 (m + 3) u S, and so is that of S. Coordinates are 0 or at least 2^-188: no underflow. Proved by
  // docs/proofs/area_filter.g.
  double sum = 0, size = 0;
  std::size_t terms = 0;
  boundary.faces.for_edges(f, [&](std::uint32_t i, std::uint32_t j) {
    const auto &a = boundary.vertices[i].approximation, &b = boundary.vertices[j].approximation;
    const double x = a[u] * b[v], y = b[u] * a[v];
    sum += x - y;
    size += std::fabs(x) + std::fabs(y);
    ++terms;
  });
  const double roundings = static_cast<double>(terms) + exact::area_roundings;
  const double bound = exact::area_bound * roundings * exact::unit_roundoff * size;
  if (std::fabs(sum) > bound) return sum > 0 ? turned : -turned;

  exact::Rational area = 0;
  boundary.faces.for_edges(f, [&](std::uint32_t i, std::uint32_t j) {
    const auto &a = boundary.vertices[i], &b = boundary.vertices[j];
    area += exact::Rational(exact::to_integer(a.x[u] * b.x[v] - b.x[u] * a.x[v]),
                            exact::Integer(exact::to_integer(a.w) * exact::to_integer(b.w)));
  });
  return area > 0 ? turned : area < 0 ? -turned : 0;
}

/// A vertex that is a point inside the face and occurs in it again.
std::optional<std::uint32_t> repeated_point(const grid::Loops<std::uint32_t>& faces, std::size_t f) {
  std::vector<std::uint32_t> points;
  faces.for_points(f, [&](std::uint32_t v) { points.push_back(v); });
  if (points.empty()) return std::nullopt;

  const auto corners = faces.corners_of(f);
  std::vector<std::uint32_t> all(corners.begin(), corners.end());
  std::sort(all.begin(), all.end());
  for (const std::uint32_t v : points) {
    const auto [begin, end] = std::equal_range(all.begin(), all.end(), v);
    if (end - begin > 1) return v;
  }
  return std::nullopt;
}

std::optional<Fault> face_fault(const Boundary& boundary, std::size_t f) {
  const auto& faces = boundary.faces;
  for (const std::uint32_t v : faces.corners_of(f))
    if (side_of(boundary.planes[f], boundary.vertices[v]) != 0)
      return at_face(f, "vertex " + std::to_string(v) + " does not lie on the plane of the face");

  bool short_edge = false;
  faces.for_edges(f, [&](std::uint32_t u, std::uint32_t v) { short_edge = short_edge || u == v; });
  if (short_edge) return at_face(f, "an edge of the face has length zero");

  const int sign = area_sign(boundary, f);
  if (sign == 0) return at_face(f, "the face has no area");
  if (sign < 0) return at_face(f, "the loops of the face do not run counter-clockwise seen from outside");

  if (const auto v = repeated_point(faces, f))
    return at_face(f, "vertex " + std::to_string(*v) + " is a point inside the face and occurs in it again");
  return std::nullopt;
}

/// Of the first face that has one.
std::optional<Fault> face_fault(const Boundary& boundary) {
  const std::size_t length = grid::long_stretch(boundary.face_count(), std::size_t{1} << 12);
  std::vector<std::optional<Fault>> found(boundary.face_count() / length + 1);
  grid::in_stretches(boundary.face_count(), length, [&](std::size_t s, std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end && !found[s]; ++f) found[s] = face_fault(boundary, f);
  });

  const auto first = std::find_if(found.begin(), found.end(), [](const auto& fault) { return fault.has_value(); });
  return first != found.end() ? *first : std::nullopt;
}

/// Faults of the half-edges begin .. end - 1, which are those of one undirected edge.
std::optional<Fault> edge_fault(const Boundary& boundary, std::span<const HalfEdge> edges, std::size_t begin,
                                std::size_t end) {
  std::int64_t balance = 0;
  bool flat = true;
  for (std::size_t i = begin; i < end; ++i) {
    const HalfEdge& e = edges[i];
    if (i > begin && e.face == edges[i - 1].face && e.from == edges[i - 1].from)
      return at_face(e.face, edge_name(e) + " occurs twice in one direction");
    balance += e.from < e.to ? 1 : -1;
    flat = flat && exact::parallel(boundary.planes[edges[begin].face], boundary.planes[e.face]);
  }

  if (balance != 0) return at_face(edges[begin].face, edge_name(edges[begin]) + " is not balanced by its reverse");
  if (flat)
    return at_face(edges[end - 1].face, "all faces at " + edge_name(edges[begin]) + " lie on one plane: it is no edge");
  return std::nullopt;
}

/// Of edges, and of vertices that have none.
std::optional<Fault> edge_fault(const Boundary& boundary) {
  const HalfEdges by_lower_vertex =
      half_edges(boundary.face_count(), boundary.vertices.size(),
                 [&](std::uint32_t f, auto&& visit) { boundary.faces.for_edges(f, visit); });
  const std::span<const HalfEdge> edges = by_lower_vertex.items();

  std::optional<Fault> fault;
  std::vector<std::uint8_t> has_edge(boundary.vertices.size());
  for_undirected_edges(edges, [&](std::size_t begin, std::size_t end) {
    fault = edge_fault(boundary, edges, begin, end);
    has_edge[edges[begin].from] = has_edge[edges[begin].to] = 1;
    return !fault;
  });
  if (fault) return fault;

  const auto bare = std::find(has_edge.begin(), has_edge.end(), 0);
  if (bare == has_edge.end()) return std::nullopt;
  return at_vertex(static_cast<std::size_t>(bare - has_edge.begin()), "no edge ends in the vertex");
}

}  // namespace

std::optional<Fault> fault(const Boundary& boundary) {
  if (auto fault = vertex_fault(boundary.vertices)) return fault;
  if (auto fault = face_fault(boundary)) return fault;
  return edge_fault(boundary);
}

}  // namespace quoin::booleans
