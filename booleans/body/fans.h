/// \file
/// The triangles around each vertex of a closed mesh, and whether they form one fan.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "grid/lists/buckets.h"
#include "grid/lists/thresholds.h"

namespace quoin::booleans {

/// A triangle (v, a, b) seen from its corner v.
struct Spoke {
  std::uint32_t a, b;
};

/// Do the triangles around a vertex form one closed fan: every neighbour begins one triangle and ends one, and walking
/// from triangle to triangle meets all? Sorts the spokes of crowded vertices.
inline bool is_one_fan(std::span<Spoke> star) {
  const bool sorted = star.size() > grid::thresholds().few_spokes;
  if (sorted) std::sort(star.begin(), star.end(), [](const Spoke& s, const Spoke& t) { return s.a < t.a; });
  const auto beginning_at = [&](std::uint32_t a) {
    if (sorted)
      return std::lower_bound(star.begin(), star.end(), a, [](const Spoke& s, std::uint32_t w) { return s.a < w; });
    return std::find_if(star.begin(), star.end(), [&](const Spoke& s) { return s.a == a; });
  };
  // The walk a -> b is a cycle of all spokes exactly when it comes back to its start after as many steps, not earlier:
  // then no spoke is met twice, so all beginnings differ.
  std::uint32_t at = star[0].a;
  for (std::size_t steps = 1; steps <= star.size(); ++steps) {
    const auto spoke = beginning_at(at);
    if (spoke == star.end() || spoke->a != at) return false;
    at = spoke->b;
    if (at == star[0].a) return steps == star.size();
  }
  return false;
}

/// visit(v, spoke) for the three corners v of every triangle, three corners each.
template <class Visit>
void for_spokes(std::span<const std::uint32_t> corners, Visit&& visit) {
  for (std::size_t c = 0; c < corners.size(); c += 3)
    for (std::size_t k = 0; k < 3; ++k)
      visit(corners[c + k], Spoke{corners[c + (k + 1) % 3], corners[c + (k + 2) % 3]});
}

/// The spokes of the vertices first .. last - 1, from bucket 0 on; wanted(v) says which have theirs. Triangles are
/// three corners each.
template <class Wanted>
grid::Buckets<Spoke> spokes(std::span<const std::uint32_t> corners, std::size_t first, std::size_t last,
                            Wanted wanted) {
  return grid::Buckets<Spoke>(last - first, [&](auto&& visit) {
    for_spokes(corners, [&](std::uint32_t v, const Spoke& s) {
      if (std::size_t{v} - first < last - first && wanted(v)) visit(v - first, s);
    });
  });
}

}  // namespace quoin::booleans
