#include "booleans/dropped_shells.h"

#include <algorithm>
#include <utility>

#include "booleans/pairs/box_tree.h"
#include "booleans/surface/triangulated.h"
#include "exact/rational.h"
#include "grid/lists/loops.h"
#include "grid/shells.h"

namespace quoin::booleans {

using exact::Rational;

namespace {

using Triangle = std::array<std::uint32_t, 3>;

using FlatPoint = std::array<Rational, 2>;
/// Convex, counter-clockwise.
using FlatPolygon = std::vector<FlatPoint>;

/// A triangle seen along an axis from in front of its plane.
FlatPolygon flattened(const Body& body, const Triangle& corners, const exact::Plane& plane) {
  int axis = 0;
  while (plane.n[static_cast<std::size_t>(axis)] == 0) ++axis;
  int x = (axis + 1) % 3, y = (axis + 2) % 3;
  if (plane.n[static_cast<std::size_t>(axis)] < 0) std::swap(x, y);

  FlatPolygon flat;
  for (const std::uint32_t v : corners) {
    const exact::Point p = body.point(v);
    flat.push_back({exact::coordinate(p, x), exact::coordinate(p, y)});
  }
  return flat;
}

/// Twice the area of a, b, c: positive when c lies on the left of the line from a to b.
Rational turn(const FlatPoint& a, const FlatPoint& b, const FlatPoint& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

bool has_area(const FlatPolygon& polygon) {
  for (std::size_t i = 2; i < polygon.size(); ++i)
    if (turn(polygon[0], polygon[i - 1], polygon[i]) > 0) return true;
  return false;
}

/// What of a polygon lies on the left of the line from a to b, or on it.
FlatPolygon left_part(const FlatPolygon& polygon, const FlatPoint& a, const FlatPoint& b) {
  FlatPolygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const FlatPoint &p = polygon[i], &q = polygon[grid::next_in_loop(i, polygon.size())];
    const Rational at_p = turn(a, b, p), at_q = turn(a, b, q);
    if (at_p >= 0) kept.push_back(p);
    if (at_p.sign() * at_q.sign() >= 0) continue;
    const Rational share = at_p / (at_p - at_q);
    kept.push_back({p[0] + share * (q[0] - p[0]), p[1] + share * (q[1] - p[1])});
  }
  return kept;
}

FlatPolygon common_part(const FlatPolygon& t, const FlatPolygon& u) {
  FlatPolygon common = t;
  grid::for_loop_edges(u, [&](const FlatPoint& a, const FlatPoint& b) { common = left_part(common, a, b); });
  return common;
}

/// Takes a polygon away from others, which fall into convex pieces.
void subtract(std::vector<FlatPolygon>& pieces, const FlatPolygon& t) {
  std::vector<FlatPolygon> left;
  for (FlatPolygon& piece : pieces)
    for (std::size_t i = 0; i < t.size() && has_area(piece); ++i) {
      const FlatPoint &a = t[i], &b = t[grid::next_in_loop(i, t.size())];
      if (FlatPolygon outside = left_part(piece, b, a); has_area(outside)) left.push_back(std::move(outside));
      piece = left_part(piece, a, b);
    }
  pieces = std::move(left);
}

Box box_of(const Body& body, const Triangle& corners) {
  Box box;
  for (const std::uint32_t v : corners) box.add(body.approximation(v));
  return box;
}

/// A mesh and its shells.
struct ShellMesh {
  const Body& body;
  grid::Shells shells = grid::shells({body.grid_points.begin(), body.grid_points.size()},
                                     {body.triangles.begin(), body.triangles.size()});

  bool looks_inwards(std::uint32_t shell) const { return shells.six_volumes[shell] < 0; }
  exact::GridPoint lowest_corner(std::uint32_t shell) const {
    return grid::lowest_corner(shells, shell, {body.grid_points.begin(), body.grid_points.size()},
                               {body.triangles.begin(), body.triangles.size()});
  }
};

/// The triangles of shells that look inwards, or of the others.
Array<BoxTree::Item> triangles_looking(bool inwards, const ShellMesh& mesh) {
  Array<BoxTree::Item> items;
  for (std::uint32_t t = 0; t < mesh.body.triangles.size(); ++t)
    if (mesh.looks_inwards(mesh.shells.of_triangle[t]) == inwards)
      items.push_back({box_of(mesh.body, mesh.body.triangles[t]), t, 0});
  return items;
}

/// Finds shells that bound the result: some part of them lies on its boundary and faces the same way. Where a shell
/// that looks outwards faces the same way too, this is no evidence: a body that touches another one from outside, and
/// is inside out, has such parts.
class Evidence {
 public:
  Evidence(const ShellMesh& mesh, const Body& result) : mesh_(mesh), result_(result), surface_(triangulated(result)) {}

  /// For every shell that looks inwards whether there is some; false for the others.
  std::vector<bool> find() const {
    Array<BoxTree::Item> items = triangles_looking(true, mesh_);
    add_boundary_near(items);
    const BoxTree others(triangles_looking(false, mesh_));

    std::vector<bool> found(mesh_.shells.six_volumes.size());
    const auto visit = [&](std::uint32_t one, std::uint32_t other) {
      const auto [t, behind] = std::minmax(one, other);
      const std::uint32_t shell = mesh_.shells.of_triangle[t];
      if (!found[shell]) found[shell] = is_evidence(t, behind - behind_mesh(), others);
    };
    BoxTree(items).pairs(visit, BoxTree::Pairs::foreign);
    return found;
  }

 private:
  /// The number of the boundary's first triangle among the items.
  std::uint32_t behind_mesh() const { return static_cast<std::uint32_t>(mesh_.body.triangles.size()); }

  Triangle boundary_triangle(std::uint32_t i) const {
    Triangle t = surface_.triangle(i);
    for (std::uint32_t& v : t) v = surface_.source[v];
    return t;
  }

  void add_boundary_near(Array<BoxTree::Item>& items) const {
    Box all;
    for (const BoxTree::Item& item : items) all.add(item.box);

    for (std::uint32_t i = 0; i < surface_.triangle_count(); ++i) {
      const Box box = box_of(result_, boundary_triangle(i));
      if (box.meets(all)) items.push_back({box, behind_mesh() + i, 1});
    }
  }

  bool is_evidence(std::uint32_t t, std::uint32_t i, const BoxTree& others) const {
    const Triangle& corners = mesh_.body.triangles[t];
    const exact::Plane plane = mesh_.body.plane(t);
    if (result_.plane(surface_.face[i]) != plane) return false;
    std::vector<FlatPolygon> pieces = {
        common_part(flattened(mesh_.body, corners, plane), flattened(result_, boundary_triangle(i), plane))};
    if (!has_area(pieces[0])) return false;

    others.meeting(box_of(mesh_.body, corners), [&](std::uint32_t other) {
      if (mesh_.body.plane(other) == plane) subtract(pieces, flattened(mesh_.body, mesh_.body.triangles[other], plane));
    });
    return !pieces.empty();
  }

  const ShellMesh& mesh_;
  const Body& result_;
  Triangulated surface_;
};

}  // namespace

DroppedShells dropped_shells(const Body& mesh, const Body& result) {
  // A mesh that was taken as it is has lost nothing.
  if (result.is_packed && result.planes.empty() && result.triangles == mesh.triangles &&
      result.grid_points == mesh.grid_points)
    return {};

  const ShellMesh parted{mesh};
  const auto shell_count = static_cast<std::uint32_t>(parted.shells.six_volumes.size());
  bool some_inwards = false;
  for (std::uint32_t shell = 0; shell < shell_count; ++shell)
    some_inwards = some_inwards || parted.looks_inwards(shell);
  if (!some_inwards) return {};

  const std::vector<bool> bounds = Evidence(parted, result).find();
  DroppedShells dropped;
  for (std::uint32_t shell = 0; shell < shell_count; ++shell) {
    if (!parted.looks_inwards(shell) || bounds[shell]) continue;
    if (dropped.count++ == 0) dropped.lowest_corner = parted.lowest_corner(shell);
  }
  return dropped;
}

}  // namespace quoin::booleans
