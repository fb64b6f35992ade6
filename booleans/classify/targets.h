/// \file
/// One view of every facet in space, whether cut or untouched.
#pragma once

#include <unordered_map>

#include "booleans/body/adjacency.h"
#include "booleans/classify/any_vertex.h"
#include "grid/lists/buckets.h"

namespace quoin::booleans {

/// A facet to shoot at: a facet of a sheet, or an untouched face.
struct Target {
  NodeId facet;  // none for untouched faces
  FaceId face;   // the untouched face
};

/// A vector along an edge; grid edges have components below 2^31, others are cross products of two normals, < 2^125.
using Direction = std::array<exact::Int<127>, 3>;

/// n . d: at most 3 * 2^62 * 2^125.
inline exact::Int<191> dot(const exact::Plane& plane, const Direction& d) {
  const auto n = [&](std::size_t k) { return exact::Coefficient(plane.n[k]); };
  return (n(0) * d[0] + n(1) * d[1]) + n(2) * d[2];
}

/// The start of a ray towards -y: s = v + t d - t^2 y - t^3 z + t^4 x for an infinitely small t > 0.
struct RayStart {
  exact::Point v;
  Direction d;  // d_x > 0, or d = (0, 0, d_z)
};

/// The targets of an arrangement whose boxes meet a given one; edges are indexed once.
class Targets {
 public:
  Targets(const Arrangement& a, const Box& region);

  std::size_t size() const { return targets_.size(); }
  /// Holds the target, exactly.
  const Box& box(std::uint32_t t) const { return boxes_[t]; }
  /// visit(vertex) for corners whose hull holds the target, some of them more than once.
  template <class Visit>
  void for_corners(std::uint32_t t, Visit&& visit) const;
  /// Facet or patch number.
  NodeId node(std::uint32_t t) const;
  /// The plane in its canonical orientation, not reduced, and whether a patch's outward normal is opposite to it.
  exact::Plane plane(std::uint32_t t, bool& turned) const;
  /// Makes ready to shoot at these.
  void prepare(std::span<const std::uint32_t> targets);
  /// Does the line through s in direction y pass through the target?
  /// Preconditions: it was prepared, and the plane's normal has a component along y.
  /// Facets of many edges are searched through a tree, made when the first ray comes.
  bool crossed(std::uint32_t t, const exact::Plane& plane, const RayStart& s);

 private:
  /// An edge of a facet and another plane through it, left out between grid points.
  struct Edge {
    exact::Point a, b;
    exact::Plane line;
  };
  struct Searchable {
    Array<Edge> edges;
    BoxTree tree;
  };
  /// visit(operand, loop) for the spared loops that lie in a facet.
  template <class Visit>
  void for_spared_loops(NodeId facet, Visit&& visit) const;
  template <class Visit>
  void for_edges(std::uint32_t t, const exact::Plane& plane, Visit&& visit);
  std::size_t edge_count(std::uint32_t t) const;
  const Searchable& searchable(std::uint32_t t, const exact::Plane& plane);

  const Arrangement& a_;
  Array<Target> targets_;
  Array<Box> boxes_;
  ById<SheetId, grid::Buckets<>> half_edges_;                 // of each sheet, by facet
  std::unordered_map<std::uint32_t, Searchable> searchable_;  // by target
  ById<OperandId, std::unique_ptr<Adjacency>> adjacency_;     // of the prepared polygons
};

template <class Visit>
void Targets::for_corners(std::uint32_t t, Visit&& visit) const {
  const Target& target = targets_[t];
  if (target.facet == none) {
    const auto [operand, face] = a_.operands.own(target.face);
    for (const std::uint32_t v : a_.operands[operand].corners_of(face)) visit(AnyVertex(a_.names, operand, v));
    return;
  }
  const SheetId s = a_.sheets.sheet_of(target.facet);
  for (const std::uint32_t h : half_edges_[s][a_.sheets.facet_of(target.facet).value])
    visit(AnyVertex(a_.sheets[s].origin(h)));
}

}  // namespace quoin::booleans
