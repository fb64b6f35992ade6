#include <algorithm>
#include <tuple>

#include "grid/cut.h"
#include "grid/repair/cures.h"
#include "grid/repair/near_points.h"

namespace quoin::grid {

using exact::GridPoint;
using exact::int128;
using Triangle = Surface::Triangle;

namespace {

/// A vertex beside an edge.
struct Beside {
  std::int64_t along;  // times the edge's length
  double distance;     // for reports only
  std::uint32_t vertex;
};

/// A boundary edge as it might be: from its start over the vertices beside it to its end.
struct Chain {
  EdgeUse edge;
  Array<Beside> inner;

  std::uint32_t vertex(std::size_t i) const {
    return i == 0 ? edge.from() : i <= inner.size() ? inner[i - 1].vertex : edge.to();
  }
};

class Joiner {
 public:
  Joiner(Surface& surface, const Reach& reach)
      : surface_(surface), reach_(reach), boundary_(boundary_of(surface)), tree_(surface.points, boundary_.vertices) {}

  Damage run() {
    for (const EdgeUse& edge : boundary_.edges) chains_.push_back({edge, vertices_beside(edge)});
    keep_what_helps();
    cut_triangles();
    return damage_;
  }

 private:
  Array<Beside> vertices_beside(const EdgeUse& edge) const {
    const GridPoint &a = surface_.points[edge.from()], &b = surface_.points[edge.to()];
    const GridVector along = between(a, b);
    const auto squared_length = static_cast<std::int64_t>(dot(along, along));  // below 2^62
    NearPoints::Corner low{}, high{};
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(a.c[k], b.c[k]) - reach_.radius();
      high[k] = std::max(a.c[k], b.c[k]) + reach_.radius();
    }

    Array<Beside> found;
    tree_.in_box(low, high, [&](std::uint32_t v) {
      if (v == edge.low || v == edge.high) return;
      const GridVector to = between(a, surface_.points[v]);
      const auto place = static_cast<std::int64_t>(dot(along, to));
      if (place <= 0 || place >= squared_length) return;
      const GridVector normal = cross(along, to);
      const int128 squared = dot(normal, normal);
      if (!reach_.holds(squared, squared_length)) return;
      if (reach_.is_careful() && !is_clear(squared, squared_length, v)) return;
      const double distance = length_of(squared) / length_of(squared_length) * (1 + 0x1p-48);
      found.push_back({place, distance, v});
    });
    std::sort(found.begin(), found.end(), [](const Beside& v, const Beside& w) {
      return std::tie(v.along, v.vertex) < std::tie(w.along, w.vertex);
    });
    return found;
  }

  /// As of a weld, and of the edge itself; what is careful reaches so little that 64 times the square is below 2^127.
  bool is_clear(int128 squared, std::int64_t squared_length, std::uint32_t v) const {
    const int128 shortest = std::min(boundary_.shortest[boundary_.place[v]], int128(squared_length));
    return 64 * squared <= shortest * squared_length;
  }

  /// A chain stays where one of its pieces is a piece of another one.
  void keep_what_helps() {
    Array<std::array<std::uint32_t, 3>> pieces;  // low, high, chain
    for (std::uint32_t c = 0; c < chains_.size(); ++c)
      for (std::size_t i = 0; i <= chains_[c].inner.size(); ++i) {
        const auto [low, high] = std::minmax({chains_[c].vertex(i), chains_[c].vertex(i + 1)});
        pieces.push_back({low, high, c});
      }
    std::sort(pieces.begin(), pieces.end());

    Array<std::uint8_t> helps(chains_.size());
    for (std::size_t i = 0; i + 1 < pieces.size(); ++i)
      if (pieces[i][0] == pieces[i + 1][0] && pieces[i][1] == pieces[i + 1][1])
        helps[pieces[i][2]] = helps[pieces[i + 1][2]] = 1;
    for (std::size_t c = 0; c < chains_.size(); ++c)
      if (helps[c] == 0) chains_[c].inner.clear();
    std::erase_if(chains_, [](const Chain& c) { return c.inner.empty(); });
  }

  void cut_triangles() {
    std::sort(chains_.begin(), chains_.end(), [](const Chain& c, const Chain& d) { return c.edge.half < d.edge.half; });
    Cutter cutter(surface_.points);
    Array<std::uint32_t> loop;
    Array<Triangle> pieces;
    for (std::size_t c = 0; c < chains_.size();) {
      const std::uint32_t t = chains_[c].edge.triangle();
      loop.clear();
      pieces.clear();
      for (std::uint32_t k = 0; k < 3; ++k) {
        loop.push_back(surface_.triangles[t][k]);
        if (c == chains_.size() || chains_[c].edge.half != 3 * t + k) continue;
        for (const Beside& v : chains_[c].inner) {
          loop.push_back(v.vertex);
          damage_.add(v.distance, surface_.points[v.vertex]);
        }
        ++c;
      }
      cutter.cut(loop, pieces);
      replace_triangle(surface_.triangles, surface_.sources, t, pieces);
    }
  }

  Surface& surface_;
  const Reach& reach_;
  Boundary boundary_;
  NearPoints tree_;
  Array<Chain> chains_;
  Damage damage_{Defect::t_junction};
};

}  // namespace

Damage join_t_junctions(Surface& surface, const Reach& reach) { return Joiner(surface, reach).run(); }

}  // namespace quoin::grid
