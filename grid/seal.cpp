#include "grid/seal.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "grid/balance.h"
#include "grid/cut.h"

namespace quoin::grid {

using exact::GridPoint;

namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// A line: its primitive direction, first non-zero component positive, and the moment of its points, below 2^61.
using Line = std::array<std::int64_t, 6>;

Line line_through(const GridPoint& p, const GridPoint& q) {
  std::array<std::int64_t, 3> d{std::int64_t{q[0]} - p[0], std::int64_t{q[1]} - p[1], std::int64_t{q[2]} - p[2]};
  std::int64_t g = std::gcd(std::gcd(d[0], d[1]), d[2]);
  if (d < std::array<std::int64_t, 3>{}) g = -g;
  for (std::int64_t& c : d) c /= g;
  return {d[0], d[1], d[2], p[1] * d[2] - p[2] * d[1], p[2] * d[0] - p[0] * d[2], p[0] * d[1] - p[1] * d[0]};
}

/// The sides of all slivers that do not cancel among themselves are segments, on each line a closed chain: over every
/// point of the line as many run forward as backward. A sweep along the line keeps each forward segment paired with a
/// backward one; where one of a pair ends and the other does not, the other is split and paired anew. So all pieces
/// cancel, and there are no more splits than segments. The neighbours' edges, the segments reversed, are split alike.
class Sealer {
 public:
  Sealer(const Array<GridPoint>& points, Array<Triangle>& triangles, const Array<std::uint32_t>& slivers)
      : points_(points), triangles_(triangles), slivers_(slivers) {}

  bool run() {
    find_segments();
    if (!find_neighbours()) return false;
    sweep_all_lines();
    for (std::uint32_t t : slivers_) triangles_[t] = {0, 0, 0};
    cut_neighbours();
    const auto is_dead = [](const Triangle& t) { return t[0] == t[1]; };
    triangles_.erase(std::remove_if(triangles_.begin(), triangles_.end(), is_dead), triangles_.end());
    return true;
  }

 private:
  struct Segment {
    std::uint32_t from, to;
    std::uint32_t neighbour = 0;  // 3 * triangle + k: its edge from corner k on is the reversed segment
    std::uint32_t partner = 0;
    bool ended = false;
  };
  struct Event {
    std::uint32_t vertex, segment;
    bool start;
  };
  struct Split {
    std::uint32_t neighbour, vertex;
  };

  void find_segments() {
    Array<Triangle> flat;
    for (std::uint32_t t : slivers_) flat.push_back(triangles_[t]);
    for (const OpenEdge& e : open_edges(flat))
      for (std::uint64_t i = 0; i < e.excess; ++i) segments_.push_back({e.from, e.to});
  }

  /// Segments between the same ends run the same way and stand together, ordered by (smaller end, larger end).
  bool find_neighbours() {
    const auto ends = [](std::uint32_t a, std::uint32_t b) { return std::pair{std::min(a, b), std::max(a, b)}; };
    Array<std::uint8_t> is_end(points_.size());
    for (const Segment& s : segments_) is_end[s.from] = is_end[s.to] = 1;

    Array<std::uint32_t> found(segments_.size());  // at the first of equal segments: how many have a neighbour
    std::size_t missing = segments_.size(), next_sliver = 0;
    for (std::uint32_t t = 0; t < triangles_.size() && missing > 0; ++t) {
      if (next_sliver < slivers_.size() && slivers_[next_sliver] == t) {
        ++next_sliver;
        continue;
      }

      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t a = triangles_[t][k], b = triangles_[t][(k + 1) % 3];
        if (is_end[a] == 0 || is_end[b] == 0) continue;
        const auto first =
            std::lower_bound(segments_.begin(), segments_.end(), ends(a, b),
                             [&](const Segment& s, const auto& wanted) { return ends(s.from, s.to) < wanted; });
        if (first == segments_.end()) continue;
        const auto i = static_cast<std::size_t>(first - segments_.begin());
        const std::size_t j = i + found[i];
        if (j == segments_.size() || segments_[j].from != b || segments_[j].to != a) continue;
        segments_[j].neighbour = 3 * t + k;
        ++found[i];
        --missing;
      }
    }
    return missing == 0;
  }

  bool is_forward(const Segment& s) const { return points_[s.from] < points_[s.to]; }

  void sweep_all_lines() {
    Array<std::pair<Line, std::uint32_t>> order;
    for (std::uint32_t i = 0; i < segments_.size(); ++i)
      order.emplace_back(line_through(points_[segments_[i].from], points_[segments_[i].to]), i);
    std::sort(order.begin(), order.end());

    Array<Event> events;
    for (std::size_t i = 0; i < order.size();) {
      events.clear();
      for (const Line& line = order[i].first; i < order.size() && order[i].first == line; ++i) {
        const Segment& s = segments_[order[i].second];
        events.push_back({s.from, order[i].second, is_forward(s)});
        events.push_back({s.to, order[i].second, !is_forward(s)});
      }
      // Along a line points are in lexicographic order.
      std::sort(events.begin(), events.end(), [&](const Event& e, const Event& f) {
        return e.vertex != f.vertex ? points_[e.vertex] < points_[f.vertex] : e.segment < f.segment;
      });
      sweep(events);
    }
  }

  void sweep(const Array<Event>& events) {
    std::array<Array<std::uint32_t>, 2> single;  // backward, forward: without a partner beyond this vertex
    for (std::size_t begin = 0, end = 0; begin < events.size(); begin = end) {
      const std::uint32_t vertex = events[begin].vertex;
      single[0].clear();
      single[1].clear();
      for (end = begin; end < events.size() && events[end].vertex == vertex; ++end) {
        Segment& s = segments_[events[end].segment];
        s.ended = !events[end].start;
        if (events[end].start) single[is_forward(s) ? 1 : 0].push_back(events[end].segment);
      }

      for (std::size_t i = begin; i < end; ++i) {
        if (events[i].start) continue;
        const std::uint32_t widow = segments_[events[i].segment].partner;
        if (segments_[widow].ended) continue;
        single[is_forward(segments_[widow]) ? 1 : 0].push_back(widow);
        splits_.push_back({segments_[widow].neighbour, vertex});
      }

      assert(single[0].size() == single[1].size());
      for (std::size_t i = 0; i < single[0].size(); ++i) {
        segments_[single[0][i]].partner = single[1][i];
        segments_[single[1][i]].partner = single[0][i];
      }
    }
  }

  /// A neighbour with points on its edges is a convex polygon with collinear corners.
  void cut_neighbours() {
    const auto start = [&](std::uint32_t half) { return points_[triangles_[half / 3][half % 3]]; };
    const auto stop = [&](std::uint32_t half) { return points_[triangles_[half / 3][(half + 1) % 3]]; };
    std::sort(splits_.begin(), splits_.end(), [&](const Split& s, const Split& t) {
      if (s.neighbour != t.neighbour) return s.neighbour < t.neighbour;
      const GridPoint &p = points_[s.vertex], &q = points_[t.vertex];
      return start(s.neighbour) < stop(s.neighbour) ? p < q : q < p;
    });

    Cutter cutter(points_);
    Array<std::uint32_t> loop;
    Array<Triangle> pieces;
    for (std::size_t i = 0; i < splits_.size();) {
      const std::uint32_t t = splits_[i].neighbour / 3;
      loop.clear();
      pieces.clear();
      for (std::uint32_t k = 0; k < 3; ++k) {
        loop.push_back(triangles_[t][k]);
        for (; i < splits_.size() && splits_[i].neighbour == 3 * t + k; ++i) loop.push_back(splits_[i].vertex);
      }

      cutter.cut(loop, pieces);
      triangles_[t] = pieces[0];
      triangles_.insert(triangles_.end(), pieces.begin() + 1, pieces.end());
    }
  }

  const Array<GridPoint>& points_;
  Array<Triangle>& triangles_;
  const Array<std::uint32_t>& slivers_;
  Array<Segment> segments_;
  Array<Split> splits_;
};

}  // namespace

bool collinear(const GridPoint& p, const GridPoint& q, const GridPoint& r) {
  // Differences are at most 2^30, products at most 2^60.
  const std::int64_t ex = std::int64_t{q[0]} - p[0], ey = std::int64_t{q[1]} - p[1], ez = std::int64_t{q[2]} - p[2];
  const std::int64_t fx = std::int64_t{r[0]} - p[0], fy = std::int64_t{r[1]} - p[1], fz = std::int64_t{r[2]} - p[2];
  return ey * fz == ez * fy && ez * fx == ex * fz && ex * fy == ey * fx;
}

bool seal(const Array<GridPoint>& points, Array<Triangle>& triangles, const Array<std::uint32_t>& slivers) {
  return slivers.empty() || Sealer(points, triangles, slivers).run();
}

}  // namespace quoin::grid
