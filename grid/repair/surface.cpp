#include "grid/repair/surface.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <tuple>

#include "grid/lists/stretches.h"

namespace quoin::grid {

using exact::GridPoint;
using exact::int128;
using exact::Integer;
using exact::Rational;

void Surface::sort() {
  Array<std::uint32_t> order, id(points.size(), UINT32_MAX);
  for (const Triangle& t : triangles)
    for (const std::uint32_t v : t)
      if (id[v] == UINT32_MAX) {
        id[v] = 0;
        order.push_back(v);
      }
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) { return points[i] < points[j]; });

  Array<GridPoint> sorted;
  sorted.reserve(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    id[order[i]] = i;
    sorted.push_back(points[order[i]]);
  }
  points = std::move(sorted);

  for (Triangle& t : triangles) {
    t = {id[t[0]], id[t[1]], id[t[2]]};
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  }
  if (sources.empty()) return std::sort(triangles.begin(), triangles.end());

  Array<std::pair<Triangle, std::uint32_t>> both;
  for (std::size_t t = 0; t < triangles.size(); ++t) both.emplace_back(triangles[t], sources[t]);
  std::sort(both.begin(), both.end());
  for (std::size_t t = 0; t < triangles.size(); ++t) std::tie(triangles[t], sources[t]) = both[t];
}

void Surface::add(const Array<Triangle>& more) {
  triangles.insert(triangles.end(), more.begin(), more.end());
  if (!sources.empty()) sources.resize(triangles.size(), no_source);
}

std::int64_t Surface::area(const Triangle& t) const {
  const GridVector v = cross(between(points[t[0]], points[t[1]]), between(points[t[0]], points[t[2]]));
  return std::abs(v[0]) + std::abs(v[1]) + std::abs(v[2]);
}

void Surface::drop_flat() {
  drop_triangles(triangles, sources,
                 [&](const Triangle& t) { return collinear(points[t[0]], points[t[1]], points[t[2]]); });
}

std::uint64_t Surface::seal() {
  const std::uint64_t directed = seal_t_junctions(points, triangles, sources, Pairing::opposite);
  return directed + seal_t_junctions(points, triangles, sources, Pairing::any);
}

Array<EdgeUse> edge_uses(std::span<const Surface::Triangle> triangles) {
  Array<EdgeUse> uses;
  uses.reserve(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t a = triangles[t][k], b = triangles[t][(k + 1) % 3];
      uses.push_back({std::min(a, b), std::max(a, b), 3 * t + k, a < b ? 1 : -1});
    }
  sort_side_by_side(uses.begin(), uses.end(), [](const EdgeUse& a, const EdgeUse& b) {
    return std::tie(a.low, a.high, a.half) < std::tie(b.low, b.high, b.half);
  });
  return uses;
}

double length_of(int128 squared) { return std::sqrt(static_cast<double>(squared)) * (1 + 0x1p-50); }

Reach::Reach(const Rational& distance) : squared_(distance * distance) {
  // No two points of the world are as far apart as this.
  const Rational longest = Rational(Integer(1) << 32);
  if (distance > longest) squared_ = longest * longest;
  const Integer whole = numerator(squared_) / denominator(squared_);
  floor_ = static_cast<int128>(whole.convert_to<std::uint64_t>());
  if (whole > Integer(UINT64_MAX)) floor_ = static_cast<int128>(UINT64_MAX);
  const Rational bounded = std::min(distance, longest);
  radius_ = Integer(numerator(bounded) / denominator(bounded)).convert_to<std::int64_t>() + 1;
}

Reach Reach::careful(std::span<const GridPoint> points) {
  std::int64_t extent = 0;
  for (int k = 0; k < 3 && !points.empty(); ++k) {
    const auto less = [&](const GridPoint& p, const GridPoint& q) { return p[k] < q[k]; };
    const auto [low, high] = std::minmax_element(points.begin(), points.end(), less);
    extent = std::max(extent, std::int64_t{(*high)[k]} - (*low)[k]);
  }
  Reach reach(Rational(extent, 128));
  reach.is_careful_ = true;
  return reach;
}

bool Reach::holds(int128 value, int128 scale) const {
  if (value <= floor_ * scale) return true;
  if (value >= (floor_ + 1) * scale) return false;
  return Rational(exact::to_integer(value)) <= squared_ * Rational(exact::to_integer(scale));
}

Boundary boundary_of(const Surface& surface) {
  Boundary boundary;
  boundary.place.assign(surface.points.size(), Boundary::absent);
  const Array<EdgeUse> uses = edge_uses(surface.triangles);
  for_edges(uses, [&](std::span<const EdgeUse> edge) {
    if (edge.size() % 2 == 0) return;
    // One that runs the way in which there are too many.
    const std::int32_t way = excess(edge) > 0 ? 1 : -1;
    boundary.edges.push_back(*std::find_if(edge.begin(), edge.end(), [&](const EdgeUse& u) { return u.way == way; }));
    boundary.place[edge[0].low] = boundary.place[edge[0].high] = 0;
  });
  for (std::uint32_t v = 0; v < boundary.place.size(); ++v)
    if (boundary.place[v] == 0) {
      boundary.place[v] = static_cast<std::uint32_t>(boundary.vertices.size());
      boundary.vertices.push_back(v);
    }

  Array<std::array<std::uint32_t, 2>> pairs;  // place, neighbour
  for_edges(uses, [&](std::span<const EdgeUse> edge) {
    const std::uint32_t a = edge[0].low, b = edge[0].high;
    if (boundary.place[a] != Boundary::absent) pairs.push_back({boundary.place[a], b});
    if (boundary.place[b] != Boundary::absent) pairs.push_back({boundary.place[b], a});
  });
  std::sort(pairs.begin(), pairs.end());
  boundary.starts.assign(boundary.vertices.size() + 1, 0);
  boundary.shortest.assign(boundary.vertices.size(), int128(1) << 100);
  for (const auto& [i, neighbour] : pairs) {
    ++boundary.starts[i + 1];
    boundary.neighbours.push_back(neighbour);
    const GridPoint &p = surface.points[boundary.vertices[i]], &q = surface.points[neighbour];
    boundary.shortest[i] = std::min(boundary.shortest[i], squared_distance(p, q));
  }
  std::partial_sum(boundary.starts.begin(), boundary.starts.end(), boundary.starts.begin());
  return boundary;
}

}  // namespace quoin::grid
