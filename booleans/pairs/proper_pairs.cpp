#include "booleans/pairs/proper_pairs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "booleans/pairs/directions.h"
#include "exact/predicates.h"
#include "grid/lists/thresholds.h"

namespace quoin::booleans {
namespace {

/// On which side of a plane vertices lie.
class Sides {
 public:
  Sides(const Body& body, const exact::Plane& plane)
      : body_(body), plane_(plane), approximation_(exact::approximation(plane)) {}

  int operator()(std::uint32_t v) const {
    if (body_.is_grid(v)) return exact::side(plane_, body_.grid_points[v]);
    const exact::Point& p = body_.derived(v);
    const int filtered = exact::side_filter(approximation_, p.approximation);
    return filtered != 2 ? filtered : exact::side_exact(plane_, p);
  }
  const exact::PlaneApproximation& approximation() const { return approximation_; }

 private:
  const Body& body_;
  const exact::Plane& plane_;
  const exact::PlaneApproximation approximation_;
};

/// Bounds of a coordinate, correctly rounded: where those of two points differ, the points' order is theirs.
struct Place {
  double low, high;
};

/// The size of a plane's value at a vertex, and its error, as of `exact::side_filter`.
struct Value {
  double size, error;

  Value(const exact::PlaneApproximation& p, const std::array<double, 3>& u) {
    const double x = p.n[0] * u[0], y = p.n[1] * u[1], z = p.n[2] * u[2];
    size = std::fabs((x + y) + (z + p.d));
    error =
        exact::side_bound * exact::unit_roundoff * ((std::fabs(x) + std::fabs(y)) + (std::fabs(z) + std::fabs(p.d)));
  }
};

/// Where an edge from a to b crosses a plane, along an axis. Precondition: a and b lie on both sides.
///
/// The crossing is at a + t (b - a), t = n / (n + m) for values n and -m. Where both are off by e at most, t is off by
/// q = e / (n + m - 2 e) at most: |n' m - n m'| <= e (n + m) for n' and m' that close, and n' + m' >= n + m - 2 e. The
/// rest is rounding, line_slack; it is proved by docs/proofs/line_place.g. The bound is doubled: for what rounding does
/// to q <= 1 / 2, to b - a and to the sum.
Place place_of_crossing(const exact::PlaneApproximation& plane, const std::array<double, 3>& a,
                        const std::array<double, 3>& b, std::size_t axis) {
  const auto [low, high] = std::minmax(a[axis], b[axis]);
  const Value n(plane, a), m(plane, b);
  const double e = std::max(n.error, m.error), sum = n.size + m.size;
  if (std::min(n.size, m.size) <= e || sum < 4 * e) return {low, high};

  const double place = a[axis] + n.size / sum * (b[axis] - a[axis]);
  const double bound = 2 * ((high - low) * (e / (sum - 2 * e)) + exact::line_slack);
  return {std::max(low, place - bound), std::min(high, place + bound)};
}

/// What the boundary of a face has on another plane, along an axis in which the line of both planes runs: what the face
/// has there lies between.
class OnLine {
 public:
  OnLine(const Body& body, std::uint32_t f, const exact::Plane& plane, int axis)
      : axis_(static_cast<std::size_t>(axis)) {
    const Sides side(body, plane);
    body.for_corners(f, [&](std::uint32_t v) {
      if (side(v) == 0) add_corner(body, v);
    });
    body.for_edges(f, [&](std::uint32_t u, std::uint32_t v) {
      if (side(u) * side(v) < 0)
        add(crossings, place_of_crossing(side.approximation(), body.approximation(u), body.approximation(v), axis_));
    });
  }

  bool is_empty() const { return crossings.low > crossings.high && corners.low > corners.high; }
  double low() const { return std::min(crossings.low, corners.low); }
  double high() const { return std::max(crossings.high, corners.high); }

  Place crossings = nowhere, corners = nowhere;  // of edges that cross the plane; of corners on it
  std::array<std::uint32_t, 2> corner = {none, none};
  bool has_more_corners = false;

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr Place nowhere = {infinity, -infinity};

  static void add(Place& all, const Place& one) {
    all.low = std::min(all.low, one.low);
    all.high = std::max(all.high, one.high);
  }
  void add_corner(const Body& body, std::uint32_t v) {
    const double x = body.approximation(v)[axis_];
    add(corners, {x, x});
    if (corner[0] == none || corner[0] == v)
      corner[0] = v;
    else if (corner[1] == none || corner[1] == v)
      corner[1] = v;
    else
      has_more_corners = true;
  }

  const std::size_t axis_;
};

/// Does the first end before the second begins, or have they one corner or edge in common between?
/// both_list(u), both_list(u, v): do both faces list that corner, that edge?
template <class BothList>
bool follow_each_other(const OnLine& first, const OnLine& second, BothList both_list) {
  if (first.high() < second.low()) return true;

  const auto [u, v] = first.corner;
  if (u == none || first.has_more_corners || second.has_more_corners || !both_list(u)) return false;
  if (v != none && !both_list(u, v)) return false;
  // The second has these corners, and no others.
  if ((second.corner[1] == none) != (v == none)) return false;
  return first.crossings.high < first.corners.low && first.corners.high < second.crossings.low;
}

}  // namespace

ProperPairs::ProperPairs(const Body& body) : body_(body) {
  for (auto f = static_cast<std::uint32_t>(body.triangles.size()); f < body.face_count(); ++f) {
    if (is_small(f)) continue;
    for (const std::uint32_t v : body.corners_of(f)) corners_.push_back({v, f});
    body.for_edges(f, [&](std::uint32_t u, std::uint32_t v) { edges_.push_back({std::min(u, v), std::max(u, v), f}); });
  }
  std::sort(corners_.begin(), corners_.end());
  std::sort(edges_.begin(), edges_.end());
}

bool ProperPairs::proved(std::uint32_t f, std::uint32_t g) const {
  if (body_.corner_count(f) > body_.corner_count(g)) std::swap(f, g);
  if (meets_on_one_side(f, g)) return true;
  return is_small(g) && (meets_on_one_side(g, f) || meet_on_line(f, g));
}

bool ProperPairs::is_small(std::uint32_t face) const {
  return face < body_.triangles.size() || body_.corner_count(face) <= grid::thresholds().small_face;
}

bool ProperPairs::lists(std::uint32_t face, std::uint32_t v) const {
  if (!is_small(face)) return std::binary_search(corners_.begin(), corners_.end(), std::array{v, face});
  const auto corners = body_.corners_of(face);
  return std::find(corners.begin(), corners.end(), v) != corners.end();
}

bool ProperPairs::lists(std::uint32_t face, std::uint32_t u, std::uint32_t v) const {
  if (!is_small(face))
    return std::binary_search(edges_.begin(), edges_.end(), std::array{std::min(u, v), std::max(u, v), face});
  bool found = false;
  body_.for_edges(face, [&](std::uint32_t from, std::uint32_t to) {
    found = found || (from == u && to == v) || (from == v && to == u);
  });
  return found;
}

/// Does f lie on one closed side of g's plane, and does g list all that f has on it? A face that a plane does not
/// cross meets it in corners and edges only.
bool ProperPairs::meets_on_one_side(std::uint32_t f, std::uint32_t g) const {
  const exact::Plane plane = body_.sign_plane(g);
  const Sides side(body_, plane);
  int seen = 0;
  bool good = true, on_plane = false;
  body_.for_corners(f, [&](std::uint32_t v) {
    if (!good) return;
    const int s = side(v);
    good = s * seen >= 0 && (s != 0 || lists(g, v));
    seen = s != 0 ? s : seen;
    on_plane = on_plane || s == 0;
  });
  if (!good || seen == 0) return false;
  if (!on_plane) return true;

  body_.for_edges(f, [&](std::uint32_t u, std::uint32_t v) {
    if (good && side(u) == 0 && side(v) == 0) good = lists(g, u, v);
  });
  return good;
}

/// Faces of planes that are not parallel meet on the line of these only. What a face has on it ends in its boundary.
bool ProperPairs::meet_on_line(std::uint32_t f, std::uint32_t g) const {
  const exact::Plane p = body_.sign_plane(f), q = body_.sign_plane(g);
  const int axis = axis_of_line(p, q);
  if (axis < 0) return false;

  const OnLine of_f(body_, f, q, axis), of_g(body_, g, p, axis);
  if (of_f.is_empty() || of_g.is_empty()) return true;
  const auto both_list = [&](auto... part) { return lists(f, part...) && lists(g, part...); };
  return follow_each_other(of_f, of_g, both_list) || follow_each_other(of_g, of_f, both_list);
}

}  // namespace quoin::booleans
