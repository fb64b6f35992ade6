#include <algorithm>
#include <cstdlib>
#include <tuple>

#include "grid/cut.h"
#include "grid/lists/partition.h"
#include "grid/repair/cures.h"

namespace quoin::grid {

using exact::GridPoint;
using exact::int128;
using exact::Integer;
using Triangle = Surface::Triangle;

namespace {

using AreaVector = std::array<int128, 3>;

/// How far from a plane the corners of a planar hole may lie, squared grid steps; and of a flat one, by the square of
/// the hole's size.
constexpr int planar_squared = 16, flat_squared = 32 * 32;

void add_cross(AreaVector& sum, const GridPoint& p, const GridPoint& q, const GridPoint& r) {
  const GridVector area = cross(between(p, q), between(p, r));
  for (std::size_t k = 0; k < 3; ++k) sum[k] += area[k];
}
Integer inner_product(const AreaVector& v, const AreaVector& w) {
  Integer sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += exact::to_integer(v[k]) * exact::to_integer(w[k]);
  return sum;
}

struct Box {
  GridPoint low{{INT32_MAX, INT32_MAX, INT32_MAX}}, high{{INT32_MIN, INT32_MIN, INT32_MIN}};
  void add(const GridPoint& p) {
    for (std::size_t k = 0; k < 3; ++k) {
      low.c[k] = std::min(low.c[k], p.c[k]);
      high.c[k] = std::max(high.c[k], p.c[k]);
    }
  }
};

/// A loop of boundary edges, as the missing faces run along it.
struct Hole {
  Array<std::uint32_t> corners;
  AreaVector normal{};  // twice the area of the cap
  Box box;
  bool is_planar = false, is_flat = false;

  int128 squared_size() const { return squared_distance(box.low, box.high); }
};

/// Boundary edges, to be walked backwards: from an edge's end to its start.
class HoleFinder {
 public:
  explicit HoleFinder(const Surface& surface) : points_(surface.points) {
    for_edges(edge_uses(surface.triangles), [&](std::span<const EdgeUse> edge) {
      const std::int64_t open = excess(edge);
      if (open == 1) ways_.push_back({edge[0].high, edge[0].low});
      if (open == -1) ways_.push_back({edge[0].low, edge[0].high});
    });
    std::sort(ways_.begin(), ways_.end());
    is_used_.assign(ways_.size(), 0);
    used_at_.assign(points_.size(), 0);
  }

  /// Simple loops: where a way comes back to a vertex, what lies between is one.
  Array<Hole> find() {
    Array<Hole> holes;
    Array<std::uint32_t> place(points_.size(), absent);  // of a vertex on the way
    for (std::uint32_t first = 0; first < ways_.size(); ++first) {
      Array<std::uint32_t> way;
      for (std::uint32_t e = first; e != absent && is_used_[e] == 0; e = next(ways_[e][1])) {
        is_used_[e] = 1;
        if (way.empty()) push(ways_[e][0], way, place);
        const std::uint32_t to = ways_[e][1];
        if (place[to] == absent) {
          push(to, way, place);
          continue;
        }
        holes.push_back(cut_off(place[to], way, place));
      }
      for (const std::uint32_t v : way) place[v] = absent;
    }
    return holes;
  }

 private:
  static constexpr std::uint32_t absent = UINT32_MAX;

  static void push(std::uint32_t v, Array<std::uint32_t>& way, Array<std::uint32_t>& place) {
    place[v] = static_cast<std::uint32_t>(way.size());
    way.push_back(v);
  }

  Hole cut_off(std::uint32_t begin, Array<std::uint32_t>& way, Array<std::uint32_t>& place) const {
    Hole hole;
    hole.corners.assign(way.begin() + begin, way.end());
    for (std::size_t i = begin + 1; i < way.size(); ++i) place[way[i]] = absent;
    way.resize(std::size_t{begin} + 1);
    measure(hole);
    return hole;
  }

  void measure(Hole& hole) const {
    const GridPoint& p = points_[hole.corners[0]];
    for (std::size_t i = 2; i < hole.corners.size(); ++i)
      add_cross(hole.normal, p, points_[hole.corners[i - 1]], points_[hole.corners[i]]);
    for (const std::uint32_t v : hole.corners) hole.box.add(points_[v]);

    if (hole.normal == AreaVector{}) return;
    Integer most = 0;  // the square of the height over the plane, times that of the normal's length
    for (const std::uint32_t v : hole.corners) {
      const GridPoint& q = points_[v];
      const Integer height =
          inner_product(hole.normal, {q[0] - int128(p[0]), q[1] - int128(p[1]), q[2] - int128(p[2])});
      most = std::max<Integer>(most, height * height);
    }
    const Integer squared_normal = inner_product(hole.normal, hole.normal);
    hole.is_planar = most <= planar_squared * squared_normal;
    hole.is_flat = flat_squared * most <= exact::to_integer(hole.squared_size()) * squared_normal;
  }

  /// An edge that is not used yet and begins at a vertex.
  std::uint32_t next(std::uint32_t v) {
    const auto at = std::lower_bound(ways_.begin(), ways_.end(), std::array<std::uint32_t, 2>{v, 0});
    const auto begin = static_cast<std::uint32_t>(at - ways_.begin());
    // Many loops may meet in a vertex: what is used there is passed over once.
    for (std::uint32_t& skipped = used_at_[v]; begin + skipped < ways_.size() && ways_[begin + skipped][0] == v;
         ++skipped)
      if (is_used_[begin + skipped] == 0) return begin + skipped;
    return absent;
  }

  const Array<GridPoint>& points_;
  Array<std::array<std::uint32_t, 2>> ways_;
  Array<std::uint8_t> is_used_;
  Array<std::uint32_t> used_at_;  // of a vertex: how many of its edges, from the first, are known to be used
};

/// What surrounds holes: the pieces of a surface that hang together over edges.
class Pieces {
 public:
  explicit Pieces(const Surface& surface)
      : surface_(surface),
        piece_of_(surface.triangles.size()),
        areas_(surface.triangles.size()),
        triangle_at_(surface.points.size()) {
    for_edges(edge_uses(surface.triangles), [&](std::span<const EdgeUse> edge) {
      for (const EdgeUse& use : edge) piece_of_.unite(edge[0].triangle(), use.triangle());
      if (excess(edge) != 0) triangle_at_[edge[0].low] = triangle_at_[edge[0].high] = edge[0].triangle();
    });
    for (std::uint32_t t = 0; t < surface.triangles.size(); ++t)
      areas_[piece_of_.find(t)] += surface.area(surface.triangles[t]);
  }

  /// Whether a hole with this cap is small beside the surface around it.
  bool is_small(const Hole& hole, std::span<const Triangle> cap) {
    int128 area = 0;
    for (const Triangle& t : cap) area += surface_.area(t);
    const std::uint32_t piece = piece_of_.find(triangle_at_[hole.corners[0]]);
    return (hole.is_planar || hole.is_flat ? 2 : 64) * area <= areas_[piece] &&
           (256 * area <= areas_[piece] || !is_terrain(piece, hole));
  }

 private:
  /// Whether all of a piece lies over its hole, seen along the cap's normal: no triangle looks as the cap does, or
  /// sidewise. Asked of caps of a 256th of the piece and more alone, of which it has few.
  bool is_terrain(std::uint32_t piece, const Hole& hole) {
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t) {
      if (piece_of_.find(t) != piece) continue;
      const auto& [a, b, c] = surface_.triangles[t];
      AreaVector normal{};
      add_cross(normal, surface_.points[a], surface_.points[b], surface_.points[c]);
      if (inner_product(normal, hole.normal) >= 0) return false;
    }
    return true;
  }

  const Surface& surface_;
  Partition piece_of_;
  Array<int128> areas_;
  Array<std::uint32_t> triangle_at_;  // of a boundary vertex
};

}  // namespace

std::array<Damage, 2> close_holes(Surface& surface, const Caps& caps, bool look) {
  std::array<Damage, 2> damage{Damage{Defect::hole}, Damage{Defect::hole}};
  damage[0].is_planar = true;
  const Array<Hole> holes = HoleFinder(surface).find();
  if (holes.empty()) return damage;

  Pieces pieces(surface);
  Cutter cutter(surface.points);
  Array<Triangle> lids;
  for (const Hole& hole : holes) {
    const std::size_t before = lids.size();
    if (!look && hole.corners.size() > 2) cutter.cut(hole.corners, lids);
    const bool is_asked = (caps.planar && hole.is_planar) || (caps.up_to && caps.up_to->holds(hole.squared_size())) ||
                          (caps.careful && pieces.is_small(hole, std::span(lids).subspan(before)));
    if (!is_asked) lids.resize(before);
    if (is_asked || look)
      damage[hole.is_planar ? 0 : 1].add(length_of(hole.squared_size()), surface.points[hole.corners[0]]);
  }
  surface.add(lids);
  return damage;
}

}  // namespace quoin::grid
