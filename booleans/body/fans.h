/// \file
/// The triangles around each vertex of a closed mesh, and whether they form one fan.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

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

/// The spokes of the vertices v for which wanted(v) holds, by vertex. Triangles are three corners each.
class Spokes {
 public:
  template <class Wanted>
  Spokes(std::span<const std::uint32_t> corners, std::size_t vertex_count, Wanted wanted)
      : Spokes(corners, 0, vertex_count, wanted) {}
  /// Of the vertices first .. last - 1 only.
  template <class Wanted>
  Spokes(std::span<const std::uint32_t> corners, std::size_t first, std::size_t last, Wanted wanted)
      : first_(first), at_(last - first + 2) {
    const auto is_in = [&](std::uint32_t v) { return std::size_t{v} - first < last - first && wanted(v); };
    for (const std::uint32_t v : corners)
      if (is_in(v)) ++at_[v - first + 2];
    for (std::size_t v = 2; v < at_.size(); ++v) at_[v] += at_[v - 1];
    spokes_ = std::make_unique_for_overwrite<Spoke[]>(at_.back());
    for (std::size_t c = 0; c < corners.size(); c += 3)
      for (std::size_t k = 0; k < 3; ++k)
        if (const std::uint32_t v = corners[c + k]; is_in(v))
          spokes_[at_[v - first + 1]++] = {corners[c + (k + 1) % 3], corners[c + (k + 2) % 3]};
  }
  std::span<Spoke> at(std::uint32_t v) {
    return {spokes_.get() + at_[v - first_], at_[v - first_ + 1] - at_[v - first_]};
  }

 private:
  std::size_t first_;
  std::vector<std::uint32_t> at_;
  std::unique_ptr<Spoke[]> spokes_;
};

}  // namespace quoin::booleans
