/// \file
/// How two triangles meet, looked at by themselves.
#pragma once

#include <algorithm>

#include "tests/booleans/pairs/fans.h"

namespace quoin::booleans::testing {

inline bool on_one_plane(const GridTriangle& s, const GridTriangle& t) {
  const auto plane = exact::plane_through(s[0], s[1], s[2]);
  return std::all_of(t.begin(), t.end(), [&](const exact::GridPoint& p) { return exact::side(*plane, p) == 0; });
}

/// Do they meet in nothing but common corners and edges?
inline bool meet_in_common_parts(const GridTriangle& s, const GridTriangle& t) {
  std::vector<exact::GridPoint> points(s.begin(), s.end());
  Triangle second{};
  for (std::size_t k = 0; k < 3; ++k) {
    second[k] = static_cast<std::uint32_t>(std::find(points.begin(), points.end(), t[k]) - points.begin());
    if (second[k] == points.size()) points.push_back(t[k]);
  }
  Body mesh;
  mesh.grid_points.append(points.begin(), points.end());
  mesh.triangles = {{0, 1, 2}, second};
  return !meets_improperly(mesh, 0, 1);
}

/// Pairs that a search found among those that meet: what is missing meets in common corners and edges, or lies on one
/// plane, and each face of it has a pair.
template <class TriangleOf>
void expect_all_but_parts(const FacePairs& found, const std::set<FacePair>& meeting, TriangleOf triangle_of) {
  const std::set<FacePair> distinct(found.begin(), found.end());
  std::set<FaceId> named;
  for (const FacePair& p : found) named.insert({p[0], p[1]});
  for (const auto& [f, g] : meeting) {
    if (distinct.contains({f, g})) continue;
    const GridTriangle s = triangle_of(f), t = triangle_of(g);
    EXPECT_TRUE(on_one_plane(s, t) || meet_in_common_parts(s, t));
    EXPECT_TRUE(named.contains(f) && named.contains(g));
  }
}

}  // namespace quoin::booleans::testing
