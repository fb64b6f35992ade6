#include "booleans/surface/detail.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "booleans/pairs/box_tree.h"
#include "grid/lists/loops.h"
#include "grid/lists/stretches.h"

namespace quoin::booleans {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Grid steps.
using Position = std::array<double, 3>;

double squared_distance(const Position& p, const Position& q) {
  const double x = p[0] - q[0], y = p[1] - q[1], z = p[2] - q[2];
  return x * x + y * y + z * z;
}

Array<Position> places_of(const Body& body, const Triangulated& mesh) {
  Array<Position> places(mesh.vertex_count());
  grid::in_stretches(places.size(), 4096, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      if (v < mesh.source.size()) {
        places[v] = body.approximation(mesh.source[v]);
        continue;
      }
      const RationalPoint& p = mesh.added[v - mesh.source.size()];
      places[v] = {exact::to_double(p[0]), exact::to_double(p[1]), exact::to_double(p[2])};
    }
  });
  return places;
}

/// Squared.
double shortest_edge(const Triangulated& mesh, const Array<Position>& places) {
  constexpr std::size_t length = 4096;
  Array<double> least(mesh.triangle_count() / length + 1, infinity);
  grid::in_stretches(mesh.triangle_count(), length, [&](std::size_t s, std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t)
      grid::for_loop_edges(mesh.triangle(t), [&](std::uint32_t u, std::uint32_t v) {
        // The triangle on the other side has the edge, too.
        if (u < v) least[s] = std::min(least[s], squared_distance(places[u], places[v]));
      });
  });
  return *std::min_element(least.begin(), least.end());
}

/// Counts points in cells by a hash of the cell. Each point is counted in all cells within `reach` of it, so two that
/// are that near to each other share one.
class HashedCells {
 public:
  HashedCells(std::size_t points, double reach) : reach_(reach), size_(8 * reach) {
    std::size_t cells = 1024;
    while (cells < 16 * points) cells *= 2;
    count_.resize(cells);
  }
  void add(const Position& p) {
    for_cells(p, [&](std::uint8_t& count) { count = static_cast<std::uint8_t>(std::min(count + 1, 2)); });
  }
  bool is_alone(const Position& p) {
    bool alone = true;
    for_cells(p, [&](const std::uint8_t& count) { alone = alone && count < 2; });
    return alone;
  }

 private:
  template <class Visit>
  void for_cells(const Position& p, Visit&& visit) {
    std::array<std::int64_t, 3> low{}, high{};
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = static_cast<std::int64_t>(std::floor((p[k] - reach_) / size_));
      high[k] = static_cast<std::int64_t>(std::floor((p[k] + reach_) / size_));
    }
    for (std::int64_t x = low[0]; x <= high[0]; ++x)
      for (std::int64_t y = low[1]; y <= high[1]; ++y)
        for (std::int64_t z = low[2]; z <= high[2]; ++z) visit(count_[hash(x, y, z)]);
  }
  std::size_t hash(std::int64_t x, std::int64_t y, std::int64_t z) const {
    std::uint64_t h = static_cast<std::uint64_t>(x) * 0x9E3779B97F4A7C15u;
    h = (h ^ h >> 29 ^ static_cast<std::uint64_t>(y)) * 0xBF58476D1CE4E5B9u;
    h = (h ^ h >> 32 ^ static_cast<std::uint64_t>(z)) * 0x94D049BB133111EBu;
    return (h ^ h >> 31) & (count_.size() - 1);
  }

  double reach_, size_;
  Array<std::uint8_t> count_;
};

/// The points that may have another one within `reach`, as items of a tree.
Array<BoxTree::Item> crowded(const Array<Position>& places, double reach) {
  HashedCells cells(places.size(), reach);
  for (const Position& p : places) cells.add(p);
  Array<BoxTree::Item> items;
  for (std::uint32_t i = 0; i < places.size(); ++i) {
    if (cells.is_alone(places[i])) continue;
    items.push_back({{}, i, 0});
    items.back().box.add(places[i]);
  }
  return items;
}

/// The least squared distance of two different places that is below `reach` squared, else infinity. Grid steps.
double least_gap(const Array<Position>& places, double reach) {
  if (!(reach < exact::world / 2)) return 0;
  // Cells are not finer than the rounding of places.
  const Array<BoxTree::Item> items = crowded(places, std::max(reach, 0x1p-16));
  const BoxTree tree(items);

  double least = reach * reach;
  for (const BoxTree::Item& item : items) {
    Box around;
    const auto look_near = [&] {
      around = item.box;
      const auto pad = static_cast<std::int32_t>(std::sqrt(least)) + 1;
      for (std::size_t k = 0; k < 3; ++k) {
        around.low[k] -= pad;
        around.high[k] += pad;
      }
    };
    look_near();
    tree.meeting(around, [&](std::uint32_t j) {
      const double gap = squared_distance(places[item.id], places[j]);
      if (j <= item.id || gap == 0 || gap >= least) return;
      least = gap;
      look_near();
    });
  }
  return least < reach * reach ? least : infinity;
}

}  // namespace

double least_detail(const Body& body, const Triangulated& mesh, const grid::Lattice& lattice, double reach) {
  const double step = exact::to_double(lattice.step), reach_in_steps = reach / step;
  const Array<Position> places = places_of(body, mesh);

  double least = shortest_edge(mesh, places);
  if (std::sqrt(least) > reach_in_steps) least = std::min(least, least_gap(places, reach_in_steps));
  return std::isfinite(least) ? std::sqrt(least) * step : 0;
}

}  // namespace quoin::booleans
