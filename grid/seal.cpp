#include "grid/seal.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <numeric>
#include <tuple>

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
  Sealer(const Array<GridPoint>& points, Array<Triangle>& triangles, Sources& sources)
      : points_(points), triangles_(triangles), sources_(sources) {}

  bool seal_slivers(const Array<std::uint32_t>& slivers) {
    find_segments(slivers);
    if (!find_neighbours(slivers)) return false;
    sweep_all_lines(Pairing::opposite);
    assert(waiting_[0].empty() && waiting_[1].empty());
    for (std::uint32_t t : slivers) triangles_[t] = {0, 0, 0};
    cut_neighbours();
    drop_triangles(triangles_, sources_, [](const Triangle& t) { return t[0] == t[1]; });
    return true;
  }

  std::uint64_t seal_open_edges(Pairing pairing) {
    find_open_segments(pairing);
    sweep_all_lines(pairing);
    cut_neighbours();
    return splits_.size();
  }

 private:
  static constexpr std::uint32_t none = UINT32_MAX;

  struct Segment {
    std::uint32_t from, to;
    std::uint32_t neighbour = 0;  // 3 * triangle + k: its edge from corner k on is the reversed segment
    std::uint32_t partner = none;
    std::uint32_t since = none;  // the vertex at which its last piece begins
    bool ended = false;
  };
  struct Event {
    std::uint32_t vertex, segment;
    bool start;
  };
  struct Split {
    std::uint32_t neighbour, vertex;
  };

  void find_segments(const Array<std::uint32_t>& slivers) {
    Array<Triangle> flat;
    for (std::uint32_t t : slivers) flat.push_back(triangles_[t]);
    for (const OpenEdge& e : open_edges(flat))
      for (std::uint64_t i = 0; i < e.excess; ++i) segments_.push_back({e.from, e.to});
  }

  /// Segments between the same ends run the same way and stand together, ordered by (smaller end, larger end).
  bool find_neighbours(const Array<std::uint32_t>& slivers) {
    const auto ends = [](std::uint32_t a, std::uint32_t b) { return std::pair{std::min(a, b), std::max(a, b)}; };
    Array<std::uint8_t> is_end(points_.size());
    for (const Segment& s : segments_) is_end[s.from] = is_end[s.to] = 1;

    Array<std::uint32_t> found(segments_.size());  // at the first of equal segments: how many have a neighbour
    std::size_t missing = segments_.size(), next_sliver = 0;
    for (std::uint32_t t = 0; t < triangles_.size() && missing > 0; ++t) {
      if (next_sliver < slivers.size() && slivers[next_sliver] == t) {
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

  /// The reverses of all open edges, each with the triangle that it is open at; in an order of the positions alone.
  void find_open_segments(Pairing pairing) {
    struct Use {
      std::uint32_t low, high, half;
      bool forward;
    };
    Array<Use> uses;
    uses.reserve(3 * triangles_.size());
    for (std::uint32_t t = 0; t < triangles_.size(); ++t)
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t a = triangles_[t][k], b = triangles_[t][(k + 1) % 3];
        uses.push_back({std::min(a, b), std::max(a, b), 3 * t + k, a < b});
      }
    std::sort(uses.begin(), uses.end(), [](const Use& a, const Use& b) {
      return std::tie(a.low, a.high, a.half) < std::tie(b.low, b.high, b.half);
    });

    for (std::size_t i = 0, j = 0; i < uses.size(); i = j) {
      std::int64_t sum = 0;
      for (; j < uses.size() && uses[j].low == uses[i].low && uses[j].high == uses[i].high; ++j)
        sum += uses[j].forward ? 1 : -1;
      std::int64_t open = pairing == Pairing::any ? static_cast<std::int64_t>((j - i) % 2) : std::abs(sum);
      for (std::size_t u = i; u < j && open > 0; ++u) {
        if (uses[u].forward != (sum > 0)) continue;
        const auto [from, to] = sum > 0 ? std::pair{uses[u].high, uses[u].low} : std::pair{uses[u].low, uses[u].high};
        segments_.push_back({from, to, uses[u].half});
        --open;
      }
    }
    std::sort(segments_.begin(), segments_.end(), [&](const Segment& s, const Segment& t) {
      return std::tie(points_[s.from], points_[s.to], s.neighbour) <
             std::tie(points_[t.from], points_[t.to], t.neighbour);
    });
  }

  bool is_forward(const Segment& s) const { return points_[s.from] < points_[s.to]; }

  void sweep_all_lines(Pairing pairing) {
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
      sweep(events, pairing);
    }
  }

  void sweep(const Array<Event>& events, Pairing pairing) {
    const auto wait = [&](std::uint32_t i) {
      waiting_[pairing == Pairing::opposite && is_forward(segments_[i]) ? 1 : 0].push_back(i);
    };
    for (std::size_t begin = 0, end = 0; begin < events.size(); begin = end) {
      const std::uint32_t vertex = events[begin].vertex;
      for (end = begin; end < events.size() && events[end].vertex == vertex; ++end) {
        Segment& s = segments_[events[end].segment];
        s.ended = !events[end].start;
        if (!events[end].start) continue;
        s.since = vertex;
        wait(events[end].segment);
      }

      for (std::size_t i = begin; i < end; ++i) {
        if (events[i].start) continue;
        const std::uint32_t widow = segments_[events[i].segment].partner;
        if (widow == none || segments_[widow].ended) continue;
        segments_[widow].partner = none;
        split(widow, vertex);
        wait(widow);
      }
      pair_waiting(vertex, pairing);
    }
    waiting_[0].clear();
    waiting_[1].clear();
  }

  /// What waits longest stays; ended segments are dropped where they come up.
  void pair_waiting(std::uint32_t vertex, Pairing pairing) {
    auto &first = waiting_[0], &second = waiting_[pairing == Pairing::opposite ? 1 : 0];
    const auto take = [&](Array<std::uint32_t>& from) {
      while (!from.empty() && segments_[from.back()].ended) from.pop_back();
      if (from.empty()) return none;
      const std::uint32_t last = from.back();
      from.pop_back();
      return last;
    };

    for (;;) {
      const std::uint32_t a = take(first);
      if (a == none) return;
      const std::uint32_t b = take(second);
      if (b == none) return first.push_back(a);
      split(a, vertex);
      split(b, vertex);
      segments_[a].partner = b;
      segments_[b].partner = a;
    }
  }

  /// Lets a new piece of a segment begin at a vertex inside.
  void split(std::uint32_t segment, std::uint32_t vertex) {
    Segment& s = segments_[segment];
    if (s.since == vertex) return;
    s.since = vertex;
    splits_.push_back({s.neighbour, vertex});
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
      replace_triangle(triangles_, sources_, t, pieces);
    }
  }

  const Array<GridPoint>& points_;
  Array<Triangle>& triangles_;
  Sources& sources_;
  Array<Segment> segments_;
  Array<Split> splits_;
  std::array<Array<std::uint32_t>, 2> waiting_;  // backward, forward: without a partner as yet
};

}  // namespace

bool collinear(const GridPoint& p, const GridPoint& q, const GridPoint& r) {
  // Differences are at most 2^30, products at most 2^60.
  const std::int64_t ex = std::int64_t{q[0]} - p[0], ey = std::int64_t{q[1]} - p[1], ez = std::int64_t{q[2]} - p[2];
  const std::int64_t fx = std::int64_t{r[0]} - p[0], fy = std::int64_t{r[1]} - p[1], fz = std::int64_t{r[2]} - p[2];
  return ey * fz == ez * fy && ez * fx == ex * fz && ex * fy == ey * fx;
}

bool seal(const Array<GridPoint>& points, Array<Triangle>& triangles, Sources& sources,
          const Array<std::uint32_t>& slivers) {
  return slivers.empty() || Sealer(points, triangles, sources).seal_slivers(slivers);
}

std::uint64_t seal_t_junctions(const Array<GridPoint>& points, Array<Triangle>& triangles, Sources& sources,
                               Pairing pairing) {
  return Sealer(points, triangles, sources).seal_open_edges(pairing);
}

}  // namespace quoin::grid
