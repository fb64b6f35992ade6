#include "booleans/questions/planar_region.h"

#include <algorithm>
#include <optional>

namespace quoin::booleans {
namespace {

using exact::Rational;
using Loop = std::vector<std::uint32_t>;

/// The sign of the turn from u to v.
int turn_sign(const PlanarPoint& u, const PlanarPoint& v) { return Rational(u[0] * v[1] - u[1] * v[0]).sign(); }
PlanarPoint direction(const PlanarPoint& from, const PlanarPoint& to) {
  return {Rational(to[0] - from[0]), Rational(to[1] - from[1])};
}
int turn_at(const PlanarPoint& a, const PlanarPoint& b, const PlanarPoint& c) {
  return turn_sign(direction(a, b), direction(a, c));
}

/// Whether v comes before w clockwise from a direction, which itself comes last.
class Clockwise {
 public:
  explicit Clockwise(const PlanarPoint& from) : from_(from) {}
  bool operator()(const PlanarPoint& v, const PlanarPoint& w) const {
    const int p = half(v), q = half(w);
    return p != q ? p < q : turn_sign(v, w) < 0;
  }

 private:
  /// 0 right of the direction, 1 behind, 2 left of it, 3 along it.
  int half(const PlanarPoint& v) const {
    if (const int turn = turn_sign(from_, v)) return turn < 0 ? 0 : 2;
    return Rational(from_[0] * v[0] + from_[1] * v[1]) < 0 ? 1 : 3;
  }
  const PlanarPoint& from_;
};

/// The arcs and which of them follow each other.
class Tracer {
 public:
  Tracer(const std::vector<PlanarPoint>& points, std::vector<PlanarArc> arcs)
      : points_(points), arcs_(std::move(arcs)), first_(points.size() + 1) {
    std::sort(arcs_.begin(), arcs_.end());
    for (const PlanarArc& a : arcs_) ++first_[a[0] + 1];
    for (std::size_t v = 0; v < points.size(); ++v) first_[v + 1] += first_[v];
  }

  std::vector<Loop> loops() const {
    std::vector<Loop> r;
    std::vector<bool> is_done(arcs_.size());
    for (std::uint32_t start = 0; start < arcs_.size(); ++start) {
      if (is_done[start]) continue;
      Loop loop;
      for (std::uint32_t a = start; !is_done[a]; a = next(a)) {
        is_done[a] = true;
        loop.push_back(arcs_[a][0]);
      }
      loop = without_straight(loop);
      if (loop.size() > 2) r.push_back(std::move(loop));
    }
    return r;
  }

  bool are_balanced() const {
    std::vector<std::uint32_t> arriving(points_.size());
    for (const PlanarArc& a : arcs_) ++arriving[a[1]];
    for (std::uint32_t v = 0; v < points_.size(); ++v)
      if (arriving[v] != leaving(v)) return false;
    return true;
  }

 private:
  std::uint32_t leaving(std::uint32_t v) const { return first_[v + 1] - first_[v]; }

  /// The first arc clockwise from the reversed one: what lies between is the region.
  std::uint32_t next(std::uint32_t arc) const {
    const auto [from, at] = arcs_[arc];
    if (leaving(at) == 1) return first_[at];
    const PlanarPoint back = direction(points_[at], points_[from]);
    const Clockwise before(back);
    std::uint32_t best = first_[at];
    for (std::uint32_t a = best + 1; a < first_[at + 1]; ++a)
      if (before(direction(points_[at], points_[arcs_[a][1]]), direction(points_[at], points_[arcs_[best][1]])))
        best = a;
    return best;
  }

  /// From its smallest pair of a point and the next one on. A point where one loop passes straight is not needed.
  Loop without_straight(const Loop& loop) const {
    Loop r;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::uint32_t u = loop[grid::previous_in_loop(i, loop.size())], v = loop[i],
                          w = loop[grid::next_in_loop(i, loop.size())];
      if (leaving(v) > 1 || turn_at(points_[u], points_[v], points_[w]) != 0) r.push_back(v);
    }
    std::size_t best = 0;
    const auto pair = [&](std::size_t i) { return std::pair(r[i], r[grid::next_in_loop(i, r.size())]); };
    for (std::size_t i = 1; i < r.size(); ++i)
      if (pair(i) < pair(best)) best = i;
    std::rotate(r.begin(), r.begin() + static_cast<std::ptrdiff_t>(best), r.end());
    return r;
  }

  const std::vector<PlanarPoint>& points_;
  std::vector<PlanarArc> arcs_;       // by their beginnings
  std::vector<std::uint32_t> first_;  // the arcs that leave point v are first_[v] .. first_[v + 1] - 1
};

Rational signed_area(const std::vector<PlanarPoint>& points, const Loop& loop) {
  Rational twice = 0;
  grid::for_loop_edges(loop, [&](std::uint32_t u, std::uint32_t v) {
    twice += points[u][0] * points[v][1] - points[u][1] * points[v][0];
  });
  return twice / 2;
}

/// Finds the loops around a point.
class Nesting {
 public:
  Nesting(const std::vector<PlanarPoint>& points, const std::vector<Loop>& loops) : points_(points), loops_(loops) {
    for (const PlanarPoint& p : points) rounded_.push_back(exact::to_double(p[1]));
  }

  /// Whether a loop goes round the places just before a point in the first direction: it is met an odd number of times
  /// on the way there from infinity.
  bool goes_round(std::size_t loop, std::uint32_t p) const {
    bool odd = false;
    grid::for_loop_edges(loops_[loop], [&](std::uint32_t u, std::uint32_t v) {
      const bool u_above = is_above(u, p), v_above = is_above(v, p);
      if (u_above == v_above) return;
      const int turn = turn_at(points_[u], points_[v], points_[p]);
      if (v_above ? turn < 0 : turn > 0) odd = !odd;
    });
    return odd;
  }
  /// Of a loop: that of least coordinates.
  std::uint32_t least(std::size_t loop) const {
    return *std::min_element(loops_[loop].begin(), loops_[loop].end(),
                             [&](std::uint32_t u, std::uint32_t v) { return points_[u] < points_[v]; });
  }

 private:
  bool is_above(std::uint32_t u, std::uint32_t p) const {
    return rounded_[u] != rounded_[p] ? rounded_[u] > rounded_[p] : points_[u][1] > points_[p][1];
  }
  const std::vector<PlanarPoint>& points_;
  const std::vector<Loop>& loops_;
  std::vector<double> rounded_;
};

/// Polygons of loops, by number: the loop around each first, then its holes. Nothing where a hole has none.
std::optional<std::vector<std::vector<std::uint32_t>>> nested(const std::vector<PlanarPoint>& points,
                                                              const std::vector<Loop>& loops,
                                                              const std::vector<Rational>& areas) {
  std::vector<std::vector<std::uint32_t>> polygons;
  for (std::uint32_t i = 0; i < loops.size(); ++i)
    if (areas[i] > 0) polygons.push_back({i});
  const Nesting nesting(points, loops);
  for (std::uint32_t hole = 0; hole < loops.size(); ++hole) {
    if (areas[hole] > 0) continue;
    // The region lies just before the hole's least point; of the loops around that the smallest bounds it.
    const std::uint32_t p = nesting.least(hole);
    std::vector<std::uint32_t>* best = nullptr;
    for (auto& polygon : polygons)
      if ((best == nullptr || areas[polygon[0]] < areas[(*best)[0]]) && nesting.goes_round(polygon[0], p))
        best = &polygon;
    if (best == nullptr) return std::nullopt;
    best->push_back(hole);
  }
  return polygons;
}

}  // namespace

std::optional<PlanarRegion> planar_region(const std::vector<PlanarPoint>& points, const std::vector<PlanarArc>& arcs) {
  const Tracer tracer(points, arcs);
  if (!tracer.are_balanced()) return std::nullopt;
  const std::vector<Loop> loops = tracer.loops();
  std::vector<Rational> areas;
  PlanarRegion r;
  for (const Loop& loop : loops) {
    areas.push_back(signed_area(points, loop));
    r.area += areas.back();
    r.points.insert(r.points.end(), loop.begin(), loop.end());
  }
  std::sort(r.points.begin(), r.points.end());
  r.points.erase(std::unique(r.points.begin(), r.points.end()), r.points.end());

  auto polygons = nested(points, loops, areas);
  const auto before = [&](std::uint32_t a, std::uint32_t b) { return loops[a] < loops[b]; };
  if (!polygons) return std::nullopt;
  for (auto& polygon : *polygons) std::sort(polygon.begin() + 1, polygon.end(), before);
  std::sort(polygons->begin(), polygons->end(), [&](const auto& a, const auto& b) { return before(a[0], b[0]); });
  for (const auto& polygon : *polygons) {
    for (const std::uint32_t loop : polygon) {
      for (const std::uint32_t v : loops[loop])
        r.polygons.corners.push_back(
            static_cast<std::uint32_t>(std::lower_bound(r.points.begin(), r.points.end(), v) - r.points.begin()));
      r.polygons.end_loop();
    }
    r.polygons.end_face();
  }
  return r;
}

}  // namespace quoin::booleans
