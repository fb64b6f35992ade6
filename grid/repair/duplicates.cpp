#include <algorithm>
#include <cstdlib>
#include <tuple>

#include "grid/lists/partition.h"
#include "grid/repair/cures.h"

namespace quoin::grid {

using Triangle = Surface::Triangle;

namespace {

/// A triangle by its corners, whichever way it looks.
struct Copy {
  Triangle corners;  // ascending
  std::uint32_t triangle;
  bool is_even;  // the permutation from the triangle's own corners
};

Copy copy_of(const Triangle& t, std::uint32_t index) {
  Triangle sorted = t;
  std::sort(sorted.begin(), sorted.end());
  const auto first = static_cast<std::size_t>(std::find(t.begin(), t.end(), sorted[0]) - t.begin());
  return {sorted, index, t[(first + 1) % 3] == sorted[1]};
}

/// What the edges of a mesh are open by.
class OpenEdges {
 public:
  explicit OpenEdges(std::span<const Triangle> triangles) {
    for_edges(edge_uses(triangles), [&](std::span<const EdgeUse> edge) {
      keys_.push_back({edge[0].low, edge[0].high});
      open_.push_back(excess(edge));
    });
  }

  /// The number of an edge, and how much more often it runs from a to b than back.
  std::size_t edge(std::uint32_t a, std::uint32_t b) const {
    const std::array<std::uint32_t, 2> key{std::min(a, b), std::max(a, b)};
    return static_cast<std::size_t>(std::lower_bound(keys_.begin(), keys_.end(), key) - keys_.begin());
  }
  std::int64_t open(std::uint32_t a, std::uint32_t b) const { return a < b ? open_[edge(a, b)] : -open_[edge(a, b)]; }
  std::size_t size() const { return keys_.size(); }
  std::int64_t open_low_to_high(std::size_t e) const { return open_[e]; }

 private:
  Array<std::array<std::uint32_t, 2>> keys_;
  Array<std::int64_t> open_;
};

/// All copies but one of each triangle. That one stays whose way the rest of the surface wants.
class Spares {
 public:
  explicit Spares(const Surface& surface) : surface_(surface), open_(surface.triangles) {
    Array<Copy> copies;
    for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) copies.push_back(copy_of(surface.triangles[t], t));
    std::sort(copies.begin(), copies.end(), [](const Copy& a, const Copy& b) {
      return std::tie(a.corners, a.triangle) < std::tie(b.corners, b.triangle);
    });
    for (std::size_t i = 0, j = 0; i < copies.size(); i = j) {
      while (j < copies.size() && copies[j].corners == copies[i].corners) ++j;
      if (j - i > 1) choose(std::span(copies).subspan(i, j - i));
    }
  }

  const Array<std::uint32_t>& triangles() const { return spares_; }
  const OpenEdges& open() const { return open_; }

 private:
  void choose(std::span<const Copy> copies) {
    std::int64_t even = 0;  // more copies that run as the sorted corners do
    for (const Copy& c : copies) even += c.is_even ? 1 : -1;
    const auto& [p, q, r] = copies[0].corners;
    // What the others run along the edges in that way: they want a face that runs back.
    const std::int64_t others = open_.open(p, q) + open_.open(q, r) + open_.open(r, p) - 3 * even;
    const bool keep_even = others < 0 || (others == 0 && even >= 0);

    bool is_kept = false;
    for (const Copy& c : copies) {
      const bool keep = !is_kept && c.is_even == keep_even;
      is_kept = is_kept || keep;
      if (!keep) spares_.push_back(c.triangle);
    }
    if (!is_kept) spares_.pop_back();
  }

  const Surface& surface_;
  OpenEdges open_;
  Array<std::uint32_t> spares_;
};

/// Spares that hang together over edges: they go together, or stay.
class Sheets {
 public:
  Sheets(const Surface& surface, const Spares& spares)
      : surface_(surface), spares_(spares), sheet_of_(spares.triangles().size()) {
    Array<std::pair<std::size_t, std::uint32_t>> at_edges;
    for (std::uint32_t i = 0; i < spares.triangles().size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) at_edges.emplace_back(spares.open().edge(corner(i, k), corner(i, k + 1)), i);
    std::sort(at_edges.begin(), at_edges.end());
    for (std::size_t e = 0; e + 1 < at_edges.size(); ++e)
      if (at_edges[e].first == at_edges[e + 1].first) sheet_of_.unite(at_edges[e].second, at_edges[e + 1].second);
  }

  /// The spares of sheets without which fewer edges are open.
  Array<std::uint32_t> superfluous() {
    Array<std::array<std::int64_t, 3>> runs;  // sheet, edge, way
    for (std::uint32_t i = 0; i < spares_.triangles().size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = corner(i, k), b = corner(i, k + 1);
        runs.push_back({sheet_of_.find(i), static_cast<std::int64_t>(spares_.open().edge(a, b)), a < b ? 1 : -1});
      }
    std::sort(runs.begin(), runs.end());

    Array<std::int64_t> gain(spares_.triangles().size());
    for (std::size_t i = 0, j = 0; i < runs.size(); i = j) {
      std::int64_t sum = 0;
      for (; j < runs.size() && runs[j][0] == runs[i][0] && runs[j][1] == runs[i][1]; ++j) sum += runs[j][2];
      const std::int64_t before = spares_.open().open_low_to_high(static_cast<std::size_t>(runs[i][1]));
      gain[static_cast<std::size_t>(runs[i][0])] += std::abs(before) - std::abs(before - sum);
    }

    Array<std::uint32_t> result;
    for (std::uint32_t i = 0; i < spares_.triangles().size(); ++i)
      if (gain[sheet_of_.find(i)] > 0) result.push_back(spares_.triangles()[i]);
    return result;
  }

 private:
  std::uint32_t corner(std::uint32_t spare, std::size_t k) const {
    return surface_.triangles[spares_.triangles()[spare]][k % 3];
  }

  const Surface& surface_;
  const Spares& spares_;
  Partition sheet_of_;
};

/// Removes triangles, and notes a place for each.
void drop(Surface& surface, const Array<std::uint32_t>& dropped, Damage& damage) {
  for (const std::uint32_t t : dropped) {
    damage.add(0, surface.points[surface.triangles[t][0]]);
    surface.triangles[t] = {0, 0, 0};
  }
  drop_triangles(surface.triangles, surface.sources, [](const Triangle& t) { return t[0] == t[1]; });
}

/// Parts of a surface that hang together over edges of two triangles.
class Patches {
 public:
  explicit Patches(const Surface& surface)
      : surface_(surface),
        uses_(edge_uses(surface.triangles)),
        patch_of_(surface.triangles.size()),
        piece_of_(surface.triangles.size()) {
    for_edges(uses_, [&](std::span<const EdgeUse> edge) {
      if (edge.size() == 2) patch_of_.unite(edge[0].triangle(), edge[1].triangle());
      for (const EdgeUse& use : edge) piece_of_.unite(edge[0].triangle(), use.triangle());
    });
  }

  /// At each edge that an odd number of patches meet at, the smallest of those that end elsewhere in nothing; where
  /// `careful`, of those alone that have at most half of the area of the rest of their piece.
  Array<std::uint32_t> flaps(bool careful) {
    Array<std::uint32_t> size(surface_.triangles.size());
    Array<exact::int128> area(surface_.triangles.size()), piece_area(surface_.triangles.size());
    Array<std::uint8_t> has_free_edge(surface_.triangles.size()), is_flap(surface_.triangles.size());
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t) {
      ++size[patch_of_.find(t)];
      area[patch_of_.find(t)] += surface_.area(surface_.triangles[t]);
      piece_area[piece_of_.find(t)] += surface_.area(surface_.triangles[t]);
    }
    for_edges(uses_, [&](std::span<const EdgeUse> edge) {
      if (edge.size() == 1) has_free_edge[patch_of_.find(edge[0].triangle())] = 1;
    });

    for_edges(uses_, [&](std::span<const EdgeUse> edge) {
      if (edge.size() == 1 || edge.size() % 2 == 0) return;
      Array<std::uint32_t> roots;
      for (const EdgeUse& use : edge) roots.push_back(patch_of_.find(use.triangle()));
      std::sort(roots.begin(), roots.end());

      std::optional<std::pair<std::uint32_t, std::uint32_t>> smallest;
      for (std::size_t i = 0, j = 0; i < roots.size(); i = j) {
        while (j < roots.size() && roots[j] == roots[i]) ++j;
        if ((j - i) % 2 == 0 || has_free_edge[roots[i]] == 0) continue;
        if (careful && 3 * area[roots[i]] > piece_area[piece_of_.find(roots[i])]) continue;
        const std::pair one{size[roots[i]], roots[i]};
        if (!smallest || one < *smallest) smallest = one;
      }
      if (smallest) is_flap[smallest->second] = 1;
    });
    return members(patch_of_, is_flap);
  }

  /// Pieces that hang on nothing, lie in one plane and have free edges; none where there is nothing else.
  Array<std::uint32_t> loose_pieces() {
    Array<std::uint8_t> is_loose(surface_.triangles.size());
    for_edges(uses_, [&](std::span<const EdgeUse> edge) {
      if (edge.size() == 1) is_loose[piece_of_.find(edge[0].triangle())] = 1;
    });
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t) {
      const std::uint32_t first = piece_of_.find(t);
      if (is_loose[first] != 0 && !is_coplanar(first, t)) is_loose[first] = 0;
    }
    Array<std::uint32_t> all = members(piece_of_, is_loose);
    if (all.size() == surface_.triangles.size()) all.clear();
    return all;
  }

 private:
  Array<std::uint32_t> members(Partition& parts, const Array<std::uint8_t>& wanted) {
    Array<std::uint32_t> result;
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t)
      if (wanted[parts.find(t)] != 0) result.push_back(t);
    return result;
  }

  bool is_coplanar(std::uint32_t first, std::uint32_t t) const {
    const auto& f = surface_.triangles[first];
    const auto at = [&](std::uint32_t v) { return surface_.points[v]; };
    const auto side = [&](std::uint32_t v) {
      std::array<std::array<exact::int128, 3>, 3> d{};
      for (std::size_t k = 0; k < 3; ++k) {
        d[0][k] = std::int64_t{at(f[1]).c[k]} - at(f[0]).c[k];
        d[1][k] = std::int64_t{at(f[2]).c[k]} - at(f[0]).c[k];
        d[2][k] = std::int64_t{at(v).c[k]} - at(f[0]).c[k];
      }
      exact::int128 sum = 0;
      for (std::size_t k = 0; k < 3; ++k)
        sum += d[2][k] * (d[0][(k + 1) % 3] * d[1][(k + 2) % 3] - d[0][(k + 2) % 3] * d[1][(k + 1) % 3]);
      return sum;
    };
    return std::all_of(surface_.triangles[t].begin(), surface_.triangles[t].end(),
                       [&](std::uint32_t v) { return side(v) == 0; });
  }

  const Surface& surface_;
  Array<EdgeUse> uses_;
  Partition patch_of_, piece_of_;
};

}  // namespace

Damage drop_duplicates(Surface& surface) {
  Damage damage{Defect::duplicate};
  const Spares spares(surface);
  if (!spares.triangles().empty()) drop(surface, Sheets(surface, spares).superfluous(), damage);
  return damage;
}

Damage drop_flaps(Surface& surface, bool careful) {
  Damage damage{Defect::flap};
  // A flap on a flap is one when that which it hangs on is gone.
  for (;;) {
    const Array<std::uint32_t> flaps = Patches(surface).flaps(careful);
    if (flaps.empty()) break;
    drop(surface, flaps, damage);
  }
  drop(surface, Patches(surface).loose_pieces(), damage);
  return damage;
}

Damage branches(const Surface& surface) {
  Damage damage{Defect::branch};
  for_edges(edge_uses(surface.triangles), [&](std::span<const EdgeUse> edge) {
    if (edge.size() > 1 && edge.size() % 2 == 1) damage.add(0, surface.points[edge[0].low]);
  });
  return damage;
}

}  // namespace quoin::grid
