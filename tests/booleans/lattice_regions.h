/// \file
/// Regions of space between sets of one lattice, by counting tetrahedra: what cells and seeds have to find.
#pragma once

#include "booleans/classify/sides.h"
#include "tests/booleans/lattice_sets.h"
#include "tests/booleans/support.h"

namespace quoin::booleans::testing {

/// How the tetrahedra of a set are filled.
enum class Filling {
  cells,      // cell by cell, wholly or in part
  scattered,  // one in some
  pierced,    // all but one in some
  all,        // all
  single      // one
};

/// Sets of one lattice of so many cells.
inline std::vector<LatticeSet> lattice_sets(Random& random, const Vector& size, const std::vector<Filling>& fillings) {
  const auto below = [&](std::uint64_t n) { return random.below(n); };
  const bool five = random.one_in(2);
  std::vector<LatticeSet> sets(fillings.size());
  std::vector<std::uint64_t> some;
  for (std::size_t i = 0; i < sets.size(); ++i) some.push_back(2 + random.below(60));

  std::vector<std::size_t> inner;
  for (std::int64_t x = -1; x <= size[0]; ++x)
    for (std::int64_t y = -1; y <= size[1]; ++y)
      for (std::int64_t z = -1; z <= size[2]; ++z) {
        auto cell = five ? five_tetrahedra({x, y, z}) : six_tetrahedra({x, y, z});
        for (Tetrahedron& t : cell)
          if (determinant(t[1] - t[0], t[2] - t[0], t[3] - t[0]) < 0) std::swap(t[0], t[1]);

        const bool is_inner = std::min({x, y, z}) >= 0 && x < size[0] && y < size[1] && z < size[2];
        for (std::size_t i = 0; is_inner && i < cell.size(); ++i) inner.push_back(sets[0].tetrahedra.size() + i);

        for (std::size_t i = 0; i < sets.size(); ++i) {
          const Filling how = is_inner ? fillings[i] : Filling::single;
          auto full = filling(how == Filling::cells ? random.below(7) : how == Filling::all, cell.size(), below);
          if (how == Filling::scattered || how == Filling::pierced)
            for (auto& f : full) f = random.one_in(some[i]) == (how == Filling::scattered);
          sets[i].tetrahedra.insert(sets[i].tetrahedra.end(), cell.begin(), cell.end());
          sets[i].full.insert(sets[i].full.end(), full.begin(), full.end());
        }
      }

  for (std::size_t i = 0; i < sets.size(); ++i)
    if (fillings[i] == Filling::single) sets[i].full[inner[random.below(inner.size())]] = 1;
  return sets;
}

inline std::vector<Body> boundaries(const std::vector<LatticeSet>& sets) {
  std::vector<Body> bodies;
  for (const LatticeSet& set : sets) bodies.push_back(boundary(set, 1));
  return bodies;
}

/// The regions that the surfaces of `boundaries(sets)` leave, and which of them the sides of their arrangement see.
class LatticeRegions {
 public:
  LatticeRegions(const std::vector<LatticeSet>& sets, const Arrangement& a)
      : sets_(sets), together_(sets[0].tetrahedra.size() + 1), seen_(2 * a.node_count()) {
    index();
    for (const auto& [triangle, at] : tetrahedra_at_)
      if (labels(at[0]) == labels(at[1])) together_.unite(at[0], at[1]);

    for (const NodeId n : Ids<NodeId>(a.sheets.facet_count())) see_facet(a, n);
    a.for_untouched([&](FaceId f, NodeId) { see_untouched(a, f); });
  }

  /// The regions that a side sees: of a facet one, of a patch perhaps many.
  const std::set<std::uint32_t>& seen_by(SideId s) const { return seen_[s]; }
  std::uint32_t infinity() { return together_.find(outside()); }
  /// By operand: does it fill the region?
  std::vector<bool> label(std::uint32_t region) const { return labels(region); }

 private:
  using Corners = std::array<Vector, 3>;

  std::uint32_t outside() const { return static_cast<std::uint32_t>(sets_[0].tetrahedra.size()); }

  std::vector<bool> labels(std::uint32_t tetrahedron) const {
    std::vector<bool> all;
    for (const LatticeSet& set : sets_) all.push_back(tetrahedron != outside() && set.full[tetrahedron]);
    return all;
  }

  static Corners sorted(Corners t) {
    std::sort(t.begin(), t.end());
    return t;
  }
  static Vector cross(const Vector& u, const Vector& v) {
    return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  }
  static std::int64_t dot(const Vector& u, const Vector& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

  void index() {
    for (std::uint32_t i = 0; i < outside(); ++i)
      for (const Triangle& f : tetrahedron_faces) {
        const Tetrahedron& t = sets_[0].tetrahedra[i];
        const auto [at, is_first] = tetrahedra_at_.try_emplace(sorted({t[f[0]], t[f[1]], t[f[2]]}), Pair{i, outside()});
        if (!is_first) at->second[1] = i;
        for (std::size_t k = 0; is_first && k < 3; ++k)
          thirds_[std::minmax(t[f[k]], t[f[(k + 1) % 3]])].push_back(t[f[(k + 2) % 3]]);
      }
  }

  /// What is on both sides of a triangle of the lattice; it looks in the direction of its front.
  void see(NodeId n, const Corners& triangle, const Vector& front) {
    for (const std::uint32_t i : tetrahedra_at_.at(sorted(triangle))) {
      const Tetrahedron& t = sets_[0].tetrahedra.at(i);
      std::int64_t height = 0;  // of the corner off the triangle
      for (const Vector& p : t) height += dot(front, p - triangle[0]);
      seen_[height > 0 ? front_of(n) : back_of(n)].insert(together_.find(i));
    }
  }

  void see_untouched(const Arrangement& a, FaceId f) {
    const OwnFace own = a.operands.own(f);
    const auto points = points_of(a.operands[own.operand]);
    const Triangle& t = a.operands[own.operand].triangles[own.face];
    const Corners triangle{points[t[0]], points[t[1]], points[t[2]]};
    see(a.patches().of[f], triangle, cross(triangle[1] - triangle[0], triangle[2] - triangle[0]));
  }

  /// By the triangle on the left of the first step of each of the facet's half-edges.
  void see_facet(const Arrangement& a, NodeId n) {
    const Sheet& sheet = a.sheets[a.sheets.sheet_of(n)];
    const Vector front = a.names.planes[sheet.plane].n;
    for (std::uint32_t h = 0; h < sheet.half_edges(); ++h) {
      if (sheet.facet[h] != a.sheets.facet_of(n)) continue;
      const Vector from = vector(a.names.vertices.grid_point(sheet.origin(h)));
      Vector step = vector(a.names.vertices.grid_point(sheet.target(h))) - from;
      for (auto& x : step) x = (x > 0) - (x < 0);
      for (const Vector& p : thirds_.at(std::minmax(from, from + step)))
        if (dot(front, p - from) == 0 && dot(front, cross(step, p - from)) > 0) see(n, {from, from + step, p}, front);
    }
  }

  using Pair = std::array<std::uint32_t, 2>;
  const std::vector<LatticeSet>& sets_;
  std::map<Corners, Pair> tetrahedra_at_;                            // the two of each triangle
  std::map<std::pair<Vector, Vector>, std::vector<Vector>> thirds_;  // of the triangles at each edge
  grid::Partition together_;                                         // tetrahedra, then what is outside of them
  ById<SideId, std::set<std::uint32_t>> seen_;
};

}  // namespace quoin::booleans::testing
