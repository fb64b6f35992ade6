#include "booleans/shell_forest.h"

#include <algorithm>
#include <map>
#include <optional>

#include "booleans/body/locate.h"
#include "booleans/body/measure.h"
#include "booleans/pairs/box_tree.h"
#include "exact/rational.h"
#include "grid/lists/partition.h"
#include "grid/lists/stretches.h"

namespace quoin::booleans {
namespace {

using exact::Rational;

// 1. Shells

/// The corners that are one vertex of the boundary with touching parts taken apart.
grid::Partition fans_of_corners(const Boundary& boundary, const Edges& edges) {
  grid::Partition fans(edges.face.size());
  for (std::uint32_t c = 0; c < edges.opposite.size(); ++c)
    if (edges.edge[c] != none) fans.unite(c, next_corner(boundary, edges, edges.opposite[c]));
  return fans;
}

/// Each shell's V - E + F - (L - F), which is 2 - 2 genus: a face of L loops is a sphere with L holes, whose
/// characteristic is 2 - L.
std::vector<std::int64_t> genera(const Boundary& boundary, const Edges& edges, const ShellsOfFaces& shells) {
  grid::Partition fans = fans_of_corners(boundary, edges);
  std::vector<std::int64_t> sum(shells.faces.size());
  for (std::uint32_t c = 0; c < edges.face.size(); ++c) {
    std::int64_t& own = sum[shells.of_face[edges.face[c]]];
    own += fans.find(c) == c;
    own -= c < edges.opposite[c];
  }
  for (std::uint32_t f = 0; f < boundary.face_count(); ++f)
    sum[shells.of_face[f]] += 2 - static_cast<std::int64_t>(boundary.faces.loop_count(f));

  for (std::int64_t& s : sum) s = 1 - s / 2;
  return sum;
}

// 2. A point inside a face

using RationalPoint = std::array<Rational, 3>;

RationalPoint rational(const exact::Point& p) {
  return {exact::coordinate(p, 0), exact::coordinate(p, 1), exact::coordinate(p, 2)};
}

/// From the middle of the face's first edge to its left, half way to what bounds the face there.
class PointInside {
 public:
  PointInside(const Boundary& boundary, std::uint32_t face)
      : plane_(boundary.planes[face]), k_(exact::longest_component(plane_.n)) {
    const auto& faces = boundary.faces;
    const auto outer = faces.loop(faces.face_start[face]);
    begin(rational(boundary.vertices[outer.front()]),
          rational(boundary.vertices[outer[grid::next_in_loop(std::size_t{0}, outer.size())]]));
    // The first edge of a body that was trusted wrongly may have no length.
    if (left_[0] == 0 && left_[1] == 0) return;

    faces.for_edges(face, [&](std::uint32_t a, std::uint32_t b) {
      meet(rational(boundary.vertices[a]), rational(boundary.vertices[b]));
    });
    faces.for_points(face, [&](std::uint32_t v) {
      const RationalPoint p = rational(boundary.vertices[v]);
      meet(p, p);
    });
  }

  RationalPoint point() const {
    const Rational way = nearest_.value_or(1) / 2;
    RationalPoint p;
    p[u_] = middle_[0] + way * left_[0];
    p[v_] = middle_[1] + way * left_[1];
    p[k_] = -(plane_.n[u_] * p[u_] + plane_.n[v_] * p[v_] + Rational(exact::to_integer(plane_.d))) / plane_.n[k_];
    return p;
  }

 private:
  /// Seen along axis k the face lies on the left of the edge or, where its normal looks the other way, on the right.
  void begin(const RationalPoint& a, const RationalPoint& b) {
    const int turned = plane_.n[k_] < 0 ? -1 : 1;
    middle_ = {(a[u_] + b[u_]) / 2, (a[v_] + b[v_]) / 2};
    left_ = {turned * (a[v_] - b[v_]), turned * (b[u_] - a[u_])};
  }

  /// Shortens the way where it meets the segment.
  void meet(const RationalPoint& a, const RationalPoint& b) {
    const Rational at_a = beside(a), at_b = beside(b);
    if (at_a == 0) shorten(along(a));
    if (at_b == 0) shorten(along(b));
    if ((at_a < 0 && at_b > 0) || (at_a > 0 && at_b < 0)) shorten((along(a) * at_b - along(b) * at_a) / (at_b - at_a));
  }
  Rational beside(const RationalPoint& p) const {
    return left_[0] * (p[v_] - middle_[1]) - left_[1] * (p[u_] - middle_[0]);
  }
  /// In units of the way's direction.
  Rational along(const RationalPoint& p) const {
    return (left_[0] * (p[u_] - middle_[0]) + left_[1] * (p[v_] - middle_[1])) /
           (left_[0] * left_[0] + left_[1] * left_[1]);
  }
  void shorten(const Rational& way) {
    if (way > 0 && (!nearest_ || way < *nearest_)) nearest_ = way;
  }

  const exact::Plane& plane_;
  const std::size_t k_, u_ = (k_ + 1) % 3, v_ = (k_ + 2) % 3;
  std::array<Rational, 2> middle_, left_;
  std::optional<Rational> nearest_;
};

// 3. Nesting

/// Holds the face, exactly.
Box box_of(const Boundary& boundary, std::uint32_t face) {
  Box box;
  for (const std::uint32_t v : boundary.faces.corners_of(face)) box.add_around(boundary.vertices[v].approximation);
  return box;
}

BoxTree tree_of(const Boundary& boundary, const ShellsOfFaces& shells) {
  Array<BoxTree::Item> items(boundary.face_count());
  for (std::uint32_t f = 0; f < items.size(); ++f) items[f] = {box_of(boundary, f), f, shells.of_face[f]};
  return BoxTree(items);
}

/// What a ray towards -x can meet.
Box way_from(const RationalPoint& p) {
  Box box;
  box.add_around({exact::to_double(p[0]), exact::to_double(p[1]), exact::to_double(p[2])});
  box.low[0] = -exact::world - 1;
  return box;
}

/// The shells around each shell, ascending.
std::vector<std::vector<std::uint32_t>> shells_around(const Boundary& boundary, const ShellsOfFaces& shells,
                                                      const std::vector<std::uint8_t>& is_void) {
  const BoxTree tree = tree_of(boundary, shells);
  std::vector<std::vector<std::uint32_t>> around(shells.count());
  for (std::uint32_t s = 0; s < shells.count(); ++s) {
    const RationalPoint p = PointInside(boundary, shells.faces[s][0]).point();
    std::map<std::uint32_t, std::vector<std::uint32_t>> on_the_way;  // faces by shell
    tree.meeting(way_from(p), [&](std::uint32_t f) {
      if (shells.of_face[f] != s) on_the_way[shells.of_face[f]].push_back(f);
    });

    for (const auto& [other, faces] : on_the_way) {
      // Of a void the complement, which is full outside.
      Body body = body_of(part_of(boundary, faces));
      body.full_at_infinity = is_void[other] != 0;
      if (locate(body, p) == (is_void[other] ? -1 : 1)) around[s].push_back(other);
    }
  }
  return around;
}

/// Shells around one shell lie in each other, and of these the innermost has the most around it.
std::vector<std::uint32_t> innermost(const std::vector<std::vector<std::uint32_t>>& around) {
  std::vector<std::uint32_t> parent;
  for (const auto& outer : around) {
    const auto deepest = std::max_element(outer.begin(), outer.end(), [&](std::uint32_t a, std::uint32_t b) {
      return around[a].size() < around[b].size();
    });
    parent.push_back(deepest == outer.end() ? none : *deepest);
  }
  return parent;
}

/// A void bounds the part of what is around it, or the unbounded one; any other shell a part of its own.
void number_parts(ShellForest& forest) {
  const auto count = static_cast<std::uint32_t>(forest.parent.size()), unbounded = count;
  std::uint32_t parts = 0;
  std::vector<std::uint32_t> number(count + 1, none);
  for (std::uint32_t s = 0; s < count; ++s) {
    const std::uint32_t outer = !forest.is_void[s] ? s : forest.parent[s] == none ? unbounded : forest.parent[s];
    if (number[outer] == none) number[outer] = parts++;
    forest.part.push_back(number[outer]);
  }
  forest.shells = grid::in_buckets(count, parts, [&](std::uint32_t s) { return forest.part[s]; });
}

}  // namespace

ShellsOfFaces shells_of_faces(const Boundary& boundary, const Edges& edges) {
  grid::Partition together(boundary.face_count());
  for (std::uint32_t c = 0; c < edges.face.size(); ++c) together.unite(edges.face[c], edges.face[edges.opposite[c]]);

  ShellsOfFaces shells;
  std::uint32_t count = 0;
  for (std::uint32_t f = 0; f < boundary.face_count(); ++f) {
    const std::uint32_t first = together.find(f);
    shells.of_face.push_back(first == f ? count++ : shells.of_face[first]);
  }
  shells.faces = grid::in_buckets(boundary.face_count(), count, [&](std::uint32_t f) { return shells.of_face[f]; });
  shells.genus = genera(boundary, edges, shells);
  return shells;
}

Boundary part_of(const Boundary& boundary, std::span<const std::uint32_t> faces) {
  std::vector<std::uint32_t> vertices;
  for (const std::uint32_t f : faces)
    boundary.faces.for_edges(f, [&](std::uint32_t u, std::uint32_t) { vertices.push_back(u); });
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());

  Boundary part;
  part.labels.origins = boundary.labels.origins;
  for (const std::uint32_t v : vertices) part.vertices.push_back(boundary.vertices[v]);
  for (const std::uint32_t f : faces) {
    if (boundary.labels) part.labels.polygons.push_back(boundary.labels.polygons[f]);
    boundary.faces.for_loops(f, [&](std::span<const std::uint32_t> loop) {
      if (loop.size() == 1 && !std::binary_search(vertices.begin(), vertices.end(), loop[0])) return;
      const auto begin = static_cast<std::uint32_t>(loop.data() - boundary.faces.corners.data());
      part.labels.append_borders(boundary.labels, begin, begin + static_cast<std::uint32_t>(loop.size()),
                                 static_cast<std::uint32_t>(part.faces.corners.size()));
      for (const std::uint32_t v : loop) {
        const auto at = std::lower_bound(vertices.begin(), vertices.end(), v);
        part.faces.corners.push_back(static_cast<std::uint32_t>(at - vertices.begin()));
      }
      part.faces.end_loop();
    });
    part.faces.end_face();
    part.planes.push_back(boundary.planes[f]);
  }
  return part;
}

ShellForest shell_forest(const Boundary& boundary, const ShellsOfFaces& shells) {
  ShellForest forest;
  for (std::uint32_t s = 0; s < shells.count(); ++s)
    forest.is_void.push_back(rounded_volume(body_of(part_of(boundary, shells.faces[s])), 1) < 0);
  forest.parent = innermost(shells_around(boundary, shells, forest.is_void));
  number_parts(forest);
  return forest;
}

}  // namespace quoin::booleans
