/// \file
/// Random sets of tetrahedra of a lattice, which touch in edges and corners wherever they can, and the topology of what
/// they fill, by counting. Shared by the tests and the fuzz targets.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <map>
#include <set>
#include <unordered_map>
#include <vector>

#include "grid/lists/partition.h"
#include "tests/booleans/shapes.h"

namespace quoin::booleans::testing {

using Tetrahedron = std::array<Vector, 4>;

/// A block of cubic cells cut into tetrahedra that conform, with one layer of empty cells around it: every point that a
/// full tetrahedron has is inside. Not scaled: cells are unit cubes.
struct LatticeSet {
  std::vector<Tetrahedron> tetrahedra;  // of positive volume
  std::vector<std::uint8_t> full;       // by tetrahedron
};

/// The six tetrahedra of a unit cube around its diagonal. The first three fill the prism x >= y.
inline std::vector<Tetrahedron> six_tetrahedra(const Vector& cell) {
  static constexpr std::array<std::array<std::size_t, 3>, 6> paths{
      {{0, 1, 2}, {0, 2, 1}, {2, 0, 1}, {1, 0, 2}, {1, 2, 0}, {2, 1, 0}}};
  std::vector<Tetrahedron> all;
  for (const auto& path : paths) {
    Tetrahedron t{cell, cell, cell, cell};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = i; j < 3; ++j) ++t[j + 1][path[i]];
    all.push_back(t);
  }
  return all;
}

/// The regular tetrahedron of a unit cube, then the four at the other corners; mirrored in every other cell.
inline std::vector<Tetrahedron> five_tetrahedra(const Vector& cell) {
  const std::int64_t odd = (cell[0] + cell[1] + cell[2]) & 1;
  const auto corner = [&](std::int64_t x, std::int64_t y, std::int64_t z) {
    return cell + Vector{odd != 0 ? 1 - x : x, y, z};
  };
  const Tetrahedron regular{corner(0, 0, 0), corner(1, 1, 0), corner(1, 0, 1), corner(0, 1, 1)};
  const Tetrahedron others{corner(1, 1, 1), corner(0, 0, 1), corner(0, 1, 0), corner(1, 0, 0)};

  std::vector<Tetrahedron> all{regular};
  for (std::size_t i = 0; i < 4; ++i) {  // others[i] is opposite to regular[i], a neighbour of all the rest
    Tetrahedron t = regular;
    t[i] = others[i];
    all.push_back(t);
  }
  return all;
}

/// How a cell is filled: 0 not, 1 wholly, 2 its first tetrahedron (the regular one), 3 any one, 4 all but one, 5 three
/// in a row (a prism or the like), 6 any of them.
template <class Below>
std::vector<std::uint8_t> filling(std::uint64_t kind, std::uint64_t count, Below&& below) {
  std::vector<std::uint8_t> full(count, kind == 1 || kind == 4);
  const std::uint64_t one = kind > 2 ? below(count) : 0;
  if (kind == 2 || kind == 3) full[one] = 1;
  if (kind == 4) full[one] = 0;
  if (kind == 5)
    for (std::uint64_t i = 0; i < 3; ++i) full[(one + i) % count] = 1;
  if (kind == 6)
    for (std::uint8_t& f : full) f = below(2) == 0;
  return full;
}

/// A random set of 2 or 3 cells in every direction; `below(n)` is a random number below n.
template <class Below>
LatticeSet lattice_set(Below&& below) {
  LatticeSet set;
  const bool five = below(2) == 0;
  const std::uint64_t first = below(3) == 0 ? 6 : 0, kinds = first == 6 ? 1 : 2 + below(6);
  Vector size{};
  for (auto& n : size) n = 2 + static_cast<std::int64_t>(below(2));

  for (std::int64_t z = -1; z <= size[2]; ++z)
    for (std::int64_t y = -1; y <= size[1]; ++y)
      for (std::int64_t x = -1; x <= size[0]; ++x) {
        const auto cell = five ? five_tetrahedra({x, y, z}) : six_tetrahedra({x, y, z});
        const bool outside = x < 0 || y < 0 || z < 0 || x == size[0] || y == size[1] || z == size[2];
        const auto full = filling(outside ? 0 : first + below(kinds), cell.size(), below);
        set.full.insert(set.full.end(), full.begin(), full.end());
        for (Tetrahedron t : cell) {
          if (determinant(t[1] - t[0], t[2] - t[0], t[3] - t[0]) < 0) std::swap(t[0], t[1]);
          set.tetrahedra.push_back(t);
        }
      }
  return set;
}

/// The faces of a tetrahedron of positive volume, counter-clockwise from outside.
inline constexpr std::array<Triangle, 4> tetrahedron_faces{{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};

/// The full tetrahedra, one mesh each; cells have edges of `scale` steps.
inline std::vector<Body> solids(const LatticeSet& set, std::int64_t scale) {
  std::vector<Body> all;
  for (std::size_t i = 0; i < set.full.size(); ++i) {
    if (!set.full[i]) continue;
    Tetrahedron t = set.tetrahedra[i];
    for (Vector& p : t) p = scale * p;
    all.push_back(*tetrahedron(t));
  }
  return all;
}

/// What the full tetrahedra fill: the faces that only one of them has. A clean body of raw triangles.
inline Body boundary(const LatticeSet& set, std::int64_t scale) {
  std::map<std::array<Vector, 3>, std::array<Vector, 3>> open;  // by sorted corners
  for (std::size_t i = 0; i < set.full.size(); ++i) {
    if (!set.full[i]) continue;
    for (const Triangle& f : tetrahedron_faces) {
      const auto& t = set.tetrahedra[i];
      const std::array<Vector, 3> face{t[f[0]], t[f[1]], t[f[2]]};
      auto key = face;
      std::sort(key.begin(), key.end());
      if (!open.try_emplace(key, face).second) open.erase(key);
    }
  }

  std::vector<Vector> points;
  std::vector<Triangle> triangles;
  for (const auto& [key, face] : open) {
    const auto base = static_cast<std::uint32_t>(points.size());
    triangles.push_back({base, base + 1, base + 2});
    for (const Vector& p : face) points.push_back(scale * p);
  }
  return *mesh(points, triangles);
}

/// Some corners of a tetrahedron, bit by bit, as one number: equal for tetrahedra that have these corners in common.
inline std::uint64_t name_of(const Tetrahedron& t, unsigned corners) {
  std::vector<std::uint64_t> ids;
  for (std::size_t k = 0; k < 4; ++k)
    if (corners >> k & 1)
      ids.push_back(static_cast<std::uint64_t>(((t[k][0] + 1) * 8 + t[k][1] + 1) * 8 + t[k][2] + 2));
  std::sort(ids.begin(), ids.end());

  std::uint64_t name = 0;
  for (const std::uint64_t id : ids) name = name << 9 | id;
  return name;
}

/// A corner, edge, face or tetrahedron of the lattice.
struct Simplex {
  std::size_t corner_count = 0;
  std::vector<std::uint32_t> tetrahedra;  // that have it
  bool is_inner = true;                   // all of these are full
};
using Simplices = std::unordered_map<std::uint64_t, Simplex>;

inline Simplices simplices(const LatticeSet& set) {
  Simplices all;
  for (std::uint32_t i = 0; i < set.full.size(); ++i)
    for (unsigned corners = 1; corners < 16; ++corners) {
      Simplex& s = all[name_of(set.tetrahedra[i], corners)];
      s.corner_count = static_cast<std::size_t>(std::popcount(corners));
      s.tetrahedra.push_back(i);
      s.is_inner = s.is_inner && set.full[i];
    }
  return all;
}

/// How many parts the full or the empty tetrahedra form that hang together over simplices of so many corners.
inline std::uint64_t parts(const LatticeSet& set, const Simplices& all, bool full, std::size_t corner_count) {
  grid::Partition together(set.full.size());
  for (const auto& [name, simplex] : all) {
    if (simplex.corner_count != corner_count) continue;
    std::uint32_t first = none;
    for (const std::uint32_t i : simplex.tetrahedra) {
      if (bool(set.full[i]) != full) continue;
      if (first == none) first = i;
      together.unite(first, i);
    }
  }

  std::uint64_t count = 0;
  for (std::uint32_t i = 0; i < set.full.size(); ++i) count += bool(set.full[i]) == full && together.find(i) == i;
  return count;
}

/// What the full tetrahedra are, seen from a corner on the boundary: parts that hang together over faces, less their
/// Euler characteristic (tetrahedra less inner faces and more inner edges). A part with b boundary circles counts b
/// - 1.
inline std::int64_t spare_circles(const LatticeSet& set, const Simplices& all, const Simplex& corner,
                                  const Vector& at) {
  std::vector<std::uint32_t> own;
  for (const std::uint32_t i : corner.tetrahedra)
    if (set.full[i]) own.push_back(i);

  std::int64_t characteristic = static_cast<std::int64_t>(own.size());
  std::set<std::uint64_t> seen;
  grid::Partition together(set.full.size());
  for (const std::uint32_t i : own)
    for (unsigned corners = 1; corners < 15; ++corners) {
      const auto& t = set.tetrahedra[i];
      const auto k = static_cast<std::size_t>(std::find(t.begin(), t.end(), at) - t.begin());
      if ((corners >> k & 1) == 0 || std::popcount(corners) == 1) continue;
      const std::uint64_t name = name_of(t, corners);
      const Simplex& simplex = all.at(name);
      if (!simplex.is_inner || !seen.insert(name).second) continue;
      characteristic += simplex.corner_count == 3 ? -1 : 1;
      if (simplex.corner_count == 3) together.unite(simplex.tetrahedra[0], simplex.tetrahedra[1]);
    }

  std::int64_t count = 0;
  for (const std::uint32_t i : own) count += together.find(i) == i;
  return count - characteristic;
}

/// Components, and sum of genera, of the boundary with touching parts taken apart.
struct SeparatedTopology {
  std::uint64_t shells;
  std::int64_t genus;
};

/// By counting simplices, not surfaces. Shrunk a little, the solid retracts to the complex that is dual to its inner
/// simplices. Their alternating number is its Euler characteristic, half that of its boundary, which is the sum of
/// 2 - 2 g over the shells. At a corner where a part of the solid has b boundary circles, the shrunk boundary joins
/// them to a sphere with b holes (2 - b), while separation gives each fan a vertex of its own (b discs): b - 1 more for
/// the half. Then parts of the solid hang together over faces, parts of the complement over edges, and each shell cuts
/// space in two: there is one part more than shells.
inline SeparatedTopology separated_topology(const LatticeSet& set) {
  const Simplices all = simplices(set);
  std::int64_t half = 0;
  for (const auto& [name, simplex] : all)
    if (simplex.is_inner) half += simplex.corner_count % 2 == 0 ? 1 : -1;

  std::set<Vector> corners;
  for (const auto& t : set.tetrahedra) corners.insert(t.begin(), t.end());
  for (const Vector& v : corners) {
    const Simplex& corner = all.at(name_of({v, v, v, v}, 1));
    if (!corner.is_inner) half += spare_circles(set, all, corner, v);
  }

  const std::uint64_t shells = parts(set, all, true, 3) + parts(set, all, false, 2) - 1;
  return {shells, static_cast<std::int64_t>(shells) - half};
}

}  // namespace quoin::booleans::testing
