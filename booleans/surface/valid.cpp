#include "booleans/surface/valid.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <optional>
#include <tuple>

#include "booleans/pairs/box_tree.h"
#include "exact/filter_bounds.h"
#include "grid/lists/partition.h"
#include "grid/lists/stretches.h"

namespace quoin::booleans {

using exact::Rational;

namespace {

using Vector = std::array<double, 3>;

Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

double largest(const Vector& v) { return std::max({std::fabs(v[0]), std::fabs(v[1]), std::fabs(v[2])}); }

/// A rounded triangle. `place`: equal where the exact corners are. Corners may be anywhere within `error` of `at`.
struct MovingTriangle {
  std::array<std::uint32_t, 3> place;
  std::array<Vector, 3> at;
  double error;
};

/// Makes the shared corners of two triangles the first ones of both, in the same order; returns how many they are.
std::size_t align(MovingTriangle& t, MovingTriangle& u) {
  std::size_t shared = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = shared; j < 3; ++j) {
      if (t.place[i] != u.place[j]) continue;
      std::swap(t.place[i], t.place[shared]);
      std::swap(t.at[i], t.at[shared]);
      std::swap(u.place[j], u.place[shared]);
      std::swap(u.at[j], u.at[shared]);
      ++shared;
      break;
    }
  return shared;
}

/// Planes that part two triangles as long as all corners are within an error of where they are.
class MovingPlanes {
 public:
  explicit MovingPlanes(double error) : error_(2 * error) {}

  /// The sign of a determinant, whose rows are differences of corners or exact, wherever the corners are; 0 if unknown.
  /// Each component is off by the two corners' errors and by its own rounding, at most d = 2 error + 2 u |row|. So the
  /// product of the largest components grows by no more than `growth`, and each of the determinant's six terms with it.
  /// Rows within the range below keep all from overflow, and what underflows far below the bound.
  int sign(const Vector& a, const Vector& b, const Vector& c) const {
    const double x = largest(a), y = largest(b), z = largest(c), size = x * y * z;
    const auto ordinary = [](double v) { return v > 0x1p-200 && v < 0x1p200; };
    if (!ordinary(x) || !ordinary(y) || !ordinary(z)) return 0;

    const double value =
        a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
    const double dx = off(x), dy = off(y), dz = off(z);
    const double growth = dx * y * z + (x + dx) * (dy * z + (y + dy) * dz);
    const double bound = 6 * growth * (1 + 0x1p-40) + exact::moving_bound * exact::unit_roundoff * size;
    return value > bound ? 1 : value < -bound ? -1 : 0;
  }

  /// Whether a plane through `base` with two directions has `own` strictly on one side and the others on the other one.
  bool part(const Vector& base, const Vector& a, const Vector& b, const Vector& own,
            std::initializer_list<const Vector*> others) const {
    const int side = sign(a, b, own - base);
    return side != 0 && all_on(base, a, b, others, -side);
  }
  /// Whether it has all of them strictly on one side.
  bool bound(const Vector& base, const Vector& a, const Vector& b, std::initializer_list<const Vector*> others) const {
    const int side = sign(a, b, **others.begin() - base);
    return side != 0 && all_on(base, a, b, others, side);
  }

 private:
  double off(double size) const { return error_ + 2 * exact::unit_roundoff * size; }
  bool all_on(const Vector& base, const Vector& a, const Vector& b, std::initializer_list<const Vector*> others,
              int side) const {
    return std::all_of(others.begin(), others.end(), [&](const Vector* p) { return sign(a, b, *p - base) == side; });
  }

  double error_;
};

constexpr std::array<Vector, 3> axes{Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}};

/// Do boxes part them?
bool boxes_part(const MovingTriangle& t, const MovingTriangle& u, double error) {
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [a, b] = std::minmax({t.at[0][k], t.at[1][k], t.at[2][k]});
    const auto [c, d] = std::minmax({u.at[0][k], u.at[1][k], u.at[2][k]});
    if (c - b > 4 * error || a - d > 4 * error) return true;
  }
  return false;
}

/// Triangles without a common corner.
bool strangers_part(const MovingPlanes& planes, const MovingTriangle& t, const MovingTriangle& u) {
  const auto &p = t.at, &q = u.at;
  if (planes.bound(p[0], p[1] - p[0], p[2] - p[0], {&q[0], &q[1], &q[2]})) return true;
  if (planes.bound(q[0], q[1] - q[0], q[2] - q[0], {&p[0], &p[1], &p[2]})) return true;

  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    for (const Vector& axis : axes) {
      if (planes.part(p[i], p[j] - p[i], axis, p[k], {&q[0], &q[1], &q[2]})) return true;
      if (planes.part(q[i], q[j] - q[i], axis, q[k], {&p[0], &p[1], &p[2]})) return true;
    }
    for (std::size_t l = 0; l < 3; ++l)
      if (planes.part(p[i], p[j] - p[i], q[(l + 1) % 3] - q[l], p[k], {&q[0], &q[1], &q[2]})) return true;
  }
  return false;
}

/// Triangles whose first corner is the same.
bool part_at_corner(const MovingPlanes& planes, const MovingTriangle& t, const MovingTriangle& u) {
  const auto &p = t.at, &q = u.at;
  const Vector& base = p[0];
  if (planes.bound(base, p[1] - base, p[2] - base, {&q[1], &q[2]})) return true;
  if (planes.bound(base, q[1] - base, q[2] - base, {&p[1], &p[2]})) return true;

  for (std::size_t i = 1; i < 3; ++i) {
    for (const Vector& axis : axes) {
      if (planes.part(base, p[i] - base, axis, p[3 - i], {&q[1], &q[2]})) return true;
      if (planes.part(base, q[i] - base, axis, q[3 - i], {&p[1], &p[2]})) return true;
    }
    for (std::size_t j = 1; j < 3; ++j)
      if (planes.part(base, p[i] - base, q[j] - base, p[3 - i], {&q[3 - j]})) return true;
  }
  return false;
}

/// Triangles whose first two corners are the same.
bool part_at_edge(const MovingPlanes& planes, const MovingTriangle& t, const MovingTriangle& u) {
  const auto &p = t.at, &q = u.at;
  const Vector edge = p[1] - p[0];
  if (planes.bound(p[0], edge, p[2] - p[0], {&q[2]})) return true;
  return std::any_of(axes.begin(), axes.end(),
                     [&](const Vector& axis) { return planes.part(p[0], edge, axis, p[2], {&q[2]}); });
}

/// Do aligned triangles meet in their shared corners and edges only, all the way? False if that is not seen.
bool part_all_the_way(const MovingTriangle& t, const MovingTriangle& u, std::size_t shared) {
  const double error = std::max(t.error, u.error);
  const MovingPlanes planes(error);
  switch (shared) {
    case 0:
      return boxes_part(t, u, error) || strangers_part(planes, t, u);
    case 1:
      return part_at_corner(planes, t, u);
    case 2:
      return part_at_edge(planes, t, u);
    default:
      return false;
  }
}

/// Does the triangle keep an area all the way?
bool keeps_area(const MovingTriangle& t) {
  const MovingPlanes planes(t.error);
  const Vector a = t.at[1] - t.at[0], b = t.at[2] - t.at[0];
  return std::any_of(axes.begin(), axes.end(), [&](const Vector& axis) { return planes.sign(a, b, axis) != 0; });
}

// The same of points that stay where they are, exactly.

RationalPoint rational(const Vector& p) {
  return {exact::to_rational(p[0]), exact::to_rational(p[1]), exact::to_rational(p[2])};
}

using RationalTriangle = std::array<RationalPoint, 3>;

RationalTriangle rational(const std::array<Vector, 3>& t) { return {rational(t[0]), rational(t[1]), rational(t[2])}; }

int sign_of(const Rational& x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

RationalPoint normal(const RationalTriangle& t) {
  RationalPoint n;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    n[k] = (t[1][i] - t[0][i]) * (t[2][j] - t[0][j]) - (t[1][j] - t[0][j]) * (t[2][i] - t[0][i]);
  }
  return n;
}

int side(const RationalTriangle& t, const RationalPoint& p) {
  const RationalPoint n = normal(t);
  Rational dot = 0;
  for (std::size_t k = 0; k < 3; ++k) dot += n[k] * (p[k] - t[0][k]);
  return sign_of(dot);
}

/// The turn a, b, c seen along axis k.
int turn(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c, std::size_t k) {
  const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
  return sign_of((b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]));
}

/// Is c, collinear with a and b, between them, seen along axis k?
bool is_between(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c, std::size_t k) {
  const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
  return std::min(a[i], b[i]) <= c[i] && c[i] <= std::max(a[i], b[i]) && std::min(a[j], b[j]) <= c[j] &&
         c[j] <= std::max(a[j], b[j]);
}

/// Do closed segments of one plane meet? Seen along an axis that is not in the plane.
bool segments_meet(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c, const RationalPoint& d,
                   std::size_t k) {
  const int abc = turn(a, b, c, k), abd = turn(a, b, d, k), cda = turn(c, d, a, k), cdb = turn(c, d, b, k);
  if (abc * abd < 0 && cda * cdb < 0) return true;
  return (abc == 0 && is_between(a, b, c, k)) || (abd == 0 && is_between(a, b, d, k)) ||
         (cda == 0 && is_between(c, d, a, k)) || (cdb == 0 && is_between(c, d, b, k));
}

/// Do a closed segment and a closed triangle of their plane meet?
bool meet_in_plane(const RationalPoint& p, const RationalPoint& q, const RationalTriangle& t) {
  const RationalPoint n = normal(t);
  const std::size_t k = n[0] != 0 ? 0 : n[1] != 0 ? 1 : 2;
  bool inside = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const RationalPoint &a = t[i], &b = t[(i + 1) % 3];
    if (segments_meet(p, q, a, b, k)) return true;
    inside = inside && turn(a, b, p, k) == sign_of(n[k]);
  }
  return inside;
}

/// Do a closed segment and a closed triangle share a point? Precondition: the triangle has an area.
bool meet(const RationalPoint& p, const RationalPoint& q, const RationalTriangle& t) {
  const int at_p = side(t, p), at_q = side(t, q);
  if (at_p == 0 && at_q == 0) return meet_in_plane(p, q, t);
  if (at_p * at_q > 0) return false;

  int lowest = 1, highest = -1;
  for (std::size_t i = 0; i < 3; ++i) {
    const int s = side({p, t[i], t[(i + 1) % 3]}, q);
    lowest = std::min(lowest, s);
    highest = std::max(highest, s);
  }
  return lowest >= 0 || highest <= 0;
}

/// Do aligned triangles that have areas meet anywhere else than in their shared corners and edges?
bool meet_out_of_place(const RationalTriangle& t, const RationalTriangle& u, std::size_t shared) {
  if (shared == 0) {
    for (std::size_t i = 0; i < 3; ++i)
      if (meet(t[i], t[(i + 1) % 3], u) || meet(u[i], u[(i + 1) % 3], t)) return true;
    return false;
  }
  // What they have in common is convex: it reaches a side opposite to the corner.
  if (shared == 1) return meet(t[1], t[2], u) || meet(u[1], u[2], t);

  if (shared == 3) return true;
  if (side(t, u[2]) != 0) return false;
  const RationalPoint n = normal(t);
  const std::size_t k = n[0] != 0 ? 0 : n[1] != 0 ? 1 : 2;
  return turn(t[0], t[1], t[2], k) == turn(t[0], t[1], u[2], k);
}

/// The proof for one mesh.
class Proof {
 public:
  Proof(const Body& body, const Triangulated& mesh, Floats floats, const std::vector<double>& points,
        const Moves& moves, std::int32_t pad)
      : body_(body), mesh_(mesh), points_(points), moves_(moves), pad_(pad) {
    unit_ = floats == Floats::float32 ? 0x1p-24 : 0x1p-53;
    floor_ = floats == Floats::float32 ? 0x1p-150 : std::numeric_limits<double>::denorm_min();
    number_added();
  }

  bool holds() {
    find_moved();
    if (!pairs_are_proper()) return false;
    return doubtful_.empty() || windings_are_right();
  }

 private:
  /// Copies of a vertex that `separated` added have one place.
  void number_added() {
    const auto first = static_cast<std::uint32_t>(body_.vertex_count());
    std::vector<std::uint32_t> order(mesh_.added.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
      return mesh_.added[i] != mesh_.added[j] ? mesh_.added[i] < mesh_.added[j] : i < j;
    });
    added_place_.resize(order.size());
    std::uint32_t place = first;
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (i > 0 && mesh_.added[order[i]] != mesh_.added[order[i - 1]]) ++place;
      added_place_[order[i]] = place;
    }
  }

  std::uint32_t place(std::uint32_t v) const {
    return v < mesh_.source.size() ? mesh_.source[v] : added_place_[v - mesh_.source.size()];
  }
  bool has_moved(std::size_t t) const {
    const auto c = mesh_.triangle(t);
    return (moves_.moved[c[0]] | moves_.moved[c[1]] | moves_.moved[c[2]]) != 0;
  }

  MovingTriangle triangle(std::uint32_t t) const {
    MovingTriangle r{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t v = mesh_.corners[3 * std::size_t{t} + i];
      r.place[i] = place(v);
      for (std::size_t k = 0; k < 3; ++k) r.at[i][k] = points_[3 * std::size_t{v} + k];
      if (moves_.moved[v]) r.error = std::max(r.error, largest(r.at[i]) * unit_ + floor_);
    }
    return r;
  }

  /// Holds the triangle wherever it is on its way, grid steps.
  Box box(std::uint32_t t) const {
    Box b;
    for (const std::uint32_t v : mesh_.triangle(t)) {
      if (v < mesh_.source.size()) {
        body_.add_to(b, mesh_.source[v]);
        continue;
      }
      const RationalPoint& p = mesh_.added[v - mesh_.source.size()];
      b.add_around({exact::to_double(p[0]), exact::to_double(p[1]), exact::to_double(p[2])});
    }
    return b;
  }
  /// Of a raw triangle that did not move.
  WideBox raw_box(std::uint32_t t) const {
    const auto& c = body_.triangles[mesh_.face[t]];
    WideBox b(body_.grid_points[c[0]]);
    b.add(body_.grid_points[c[1]]);
    b.add(body_.grid_points[c[2]]);
    return b;
  }
  Box moving_box(std::uint32_t t) const {
    Box b = box(t);
    for (std::size_t k = 0; k < 3; ++k) {
      b.low[k] -= pad_;
      b.high[k] += pad_;
    }
    return b;
  }

  void find_moved() {
    const auto count = static_cast<std::uint32_t>(mesh_.triangle_count());
    for (auto t = static_cast<std::uint32_t>(moves_.first); t < count; ++t) {
      if (!has_moved(t)) continue;
      const Box own = moving_box(t);
      moved_.push_back({own, t, 0});
      reach_.add(own);
    }
  }

  /// Adds triangles to `doubtful` where a pair is not seen to part all the way. False where they meet out of place.
  bool is_proper(std::uint32_t f, std::uint32_t g, Array<std::uint32_t>& doubtful) const {
    MovingTriangle t = triangle(f), u = triangle(g);
    const std::size_t shared = align(t, u);
    if (part_all_the_way(t, u, shared)) return true;

    doubtful.insert(doubtful.end(), {f, g});
    return !meet_out_of_place(rational(t.at), rational(u.at), shared);
  }

  /// Adds a triangle to `doubtful` where it may lose its area on its way.
  void examine(std::uint32_t t, Array<std::uint32_t>& doubtful) const {
    if (!keeps_area(triangle(t))) doubtful.push_back(t);
  }

  /// Of two triangles that moved.
  bool moved_are_proper(const BoxTree& tree) {
    Array<std::array<std::uint32_t, 2>> blocks;
    const auto never = [](std::size_t, std::uint32_t, std::uint32_t) { return false; };
    tree.block_pairs(BoxTree::Pairs::all, never, [&](std::uint32_t x, std::uint32_t y) { blocks.push_back({x, y}); });

    std::atomic<bool> proper = true;
    const std::size_t batch = grid::long_stretch(blocks.size(), 64);
    Array<Array<std::uint32_t>> doubtful(blocks.size() / batch + 1);
    grid::in_stretches(blocks.size(), batch, [&](std::size_t s, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end && proper; ++i) {
        const auto [x, y] = blocks[i];
        BoxTree::for_lane_pairs(tree.lane_pairs(BoxTree::Pairs::all, x, y), x, y,
                                [&](std::uint32_t f, std::uint32_t g) {
                                  if (!is_proper(tree.ids()[f], tree.ids()[g], doubtful[s])) proper = false;
                                });
      }
    });
    if (proper) doubtful_ = grid::joined(doubtful);
    return proper;
  }

  /// Of a triangle that did not move and one that did.
  bool others_are_proper(const BoxTree& tree) {
    std::atomic<bool> proper = true;
    const WideBox reach(reach_);
    const std::size_t count = mesh_.triangle_count(), batch = grid::long_stretch(count, 1024);
    Array<Array<std::uint32_t>> doubtful(count / batch + 1);
    grid::in_stretches(count, batch, [&](std::size_t s, std::size_t begin, std::size_t end) {
      for (auto t = static_cast<std::uint32_t>(begin); t < end && proper; ++t) {
        if (t >= moves_.first && has_moved(t)) {
          examine(t, doubtful[s]);
          continue;
        }
        if (t < moves_.first && !raw_box(t).meets(reach)) continue;
        const Box own = box(t);
        if (!own.meets(reach_)) continue;
        tree.meeting(own, [&](std::uint32_t u) {
          if (proper && !is_proper(t, u, doubtful[s])) proper = false;
        });
      }
    });
    for (const auto& part : doubtful) doubtful_.insert(doubtful_.end(), part.begin(), part.end());
    return proper;
  }

  bool pairs_are_proper() {
    const BoxTree tree(moved_);
    return moved_are_proper(tree) && others_are_proper(tree);
  }

  /// Triangles of one component, joined by edges of two triangles.
  grid::Partition components() const {
    struct Edge {
      std::uint32_t low, high, triangle;
    };
    Array<Edge> edges;
    edges.reserve(mesh_.corners.size());
    for (std::uint32_t t = 0; t < mesh_.triangle_count(); ++t) {
      const auto c = mesh_.triangle(t);
      grid::for_loop_edges(c, [&](std::uint32_t u, std::uint32_t v) {
        const auto [low, high] = std::minmax(place(u), place(v));
        edges.push_back({low, high, t});
      });
    }
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
      return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
    });

    grid::Partition parts(mesh_.triangle_count());
    for (std::size_t i = 0, j = 0; i < edges.size(); i = j) {
      while (j < edges.size() && edges[j].low == edges[i].low && edges[j].high == edges[i].high) ++j;
      if (j - i == 2) parts.unite(edges[i].triangle, edges[i + 1].triangle);
    }
    return parts;
  }

  bool windings_are_right() {
    grid::Partition parts = components();
    for (std::uint32_t& t : doubtful_) t = parts.find(t);
    std::sort(doubtful_.begin(), doubtful_.end());
    doubtful_.erase(std::unique(doubtful_.begin(), doubtful_.end()), doubtful_.end());

    Array<BoxTree::Item> items(mesh_.triangle_count());
    for (std::uint32_t t = 0; t < items.size(); ++t) items[t] = {moving_box(t), t, 0};
    const BoxTree tree(items);
    return std::all_of(doubtful_.begin(), doubtful_.end(),
                       [&](std::uint32_t t) { return winding_outside(t, tree) == 0; });
  }

  /// The winding number just outside a triangle, by a ray along an axis from a point inside it.
  int winding_outside(std::uint32_t t, const BoxTree& tree) const {
    const RationalTriangle own = rational(triangle(t).at);
    const RationalPoint n = normal(own);
    const std::size_t k = n[0] != 0 ? 0 : n[1] != 0 ? 1 : 2;
    const bool up = n[k] > 0;
    Box ray = moving_box(t);
    (up ? ray.high : ray.low)[k] = up ? INT32_MAX : INT32_MIN;
    Array<std::uint32_t> others;
    tree.meeting(ray, [&](std::uint32_t u) {
      if (u != t) others.push_back(u);
    });

    // Another point where the ray meets an edge: each edge rules out two points of a parabola at most.
    for (std::size_t attempt = 1; attempt <= 6 * others.size() + 1; ++attempt) {
      const Rational s(1, attempt + 2), weights[3] = {s, s * s, 1 - s - s * s};
      RationalPoint from{};
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) from[j] += weights[i] * own[i][j];

      int winding = 0;
      const bool is_clear = std::all_of(others.begin(), others.end(), [&](std::uint32_t u) {
        const auto step = passage(from, k, up, rational(triangle(u).at));
        if (step) winding += *step;
        return step.has_value();
      });
      if (is_clear) return winding;
    }
    return 1;  // faces that are trusted, and overlap
  }

  /// 1 where a ray leaves through a triangle, -1 where it enters, 0 where it misses; nothing where it meets an edge.
  static std::optional<int> passage(const RationalPoint& from, std::size_t k, bool up, const RationalTriangle& t) {
    const std::array<int, 3> turns{turn(t[0], t[1], from, k), turn(t[1], t[2], from, k), turn(t[2], t[0], from, k)};
    const auto [least, most] = std::minmax({turns[0], turns[1], turns[2]});
    if (least < 0 && most > 0) return 0;
    if (least == 0 || most == 0) return std::nullopt;

    const int looks = most;  // along +k
    const int at = side(t, from);
    const bool is_ahead = at == (up == (looks > 0) ? -1 : 1);
    if (at == 0) return std::nullopt;
    return is_ahead ? (up ? looks : -looks) : 0;
  }

  const Body& body_;
  const Triangulated& mesh_;
  const std::vector<double>& points_;
  const Moves& moves_;
  const std::int32_t pad_;
  double unit_, floor_;
  Array<std::uint32_t> added_place_;
  Array<BoxTree::Item> moved_;     // triangles of which a corner moved, ascending
  Box reach_;                      // of these
  Array<std::uint32_t> doubtful_;  // triangles whose way is not known
};

}  // namespace

bool is_valid(const Body& body, const Triangulated& mesh, Floats floats, const grid::Lattice& lattice,
              const std::vector<double>& points, const Moves& moves) {
  if (moves.moved.empty()) return true;
  const RoundingEffects effects = rounding_effects(body, mesh, lattice, floats, points);
  if (effects != RoundingEffects{}) return false;

  // What moves by as much as the whole world has lost its shape.
  const double steps = moves.most / exact::to_double(lattice.step) * (1 + 0x1p-40);
  if (!(steps < exact::world)) return false;
  return Proof(body, mesh, floats, points, moves, static_cast<std::int32_t>(steps) + 1).holds();
}

}  // namespace quoin::booleans
