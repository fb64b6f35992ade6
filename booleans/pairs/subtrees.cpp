#include "booleans/pairs/subtrees.h"

#include <cmath>

#include "booleans/pairs/directions.h"
#include "exact/predicates.h"

namespace quoin::booleans {
namespace {

using Vector = std::array<double, 3>;
using exact::GridPoint;
using exact::int128;

Vector sum(const Vector& u, const Vector& v, double times = 1) {
  return {u[0] + times * v[0], u[1] + times * v[1], u[2] + times * v[2]};
}

/// Unit vectors along the axes of a symmetric matrix, by Jacobi's rotations.
std::array<Vector, 3> principal_axes(std::array<Vector, 3> m) {
  std::array<Vector, 3> axes{Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}};
  constexpr int sweeps = 6;
  for (int i = 0; i < 3 * sweeps; ++i) {
    const std::size_t p = static_cast<std::size_t>(i) % 3, q = (p + 1) % 3;
    if (m[p][q] == 0) continue;
    const double theta = (m[q][q] - m[p][p]) / (2 * m[p][q]);
    const double t = std::copysign(1 / (std::fabs(theta) + std::hypot(theta, 1.0)), theta);
    const double c = 1 / std::hypot(t, 1.0), s = t * c;

    for (std::size_t k = 0; k < 3; ++k) {
      const double a = m[k][p], b = m[k][q];
      m[k][p] = c * a - s * b;
      m[k][q] = s * a + c * b;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const double a = m[p][k], b = m[q][k];
      m[p][k] = c * a - s * b;
      m[q][k] = s * a + c * b;
      const double u = axes[p][k], v = axes[q][k];
      axes[p][k] = c * u - s * v;
      axes[q][k] = s * u + c * v;
    }
  }
  return axes;
}

}  // namespace

/// A box around points, along the principal axes of where they lie. for_points(visit): visit(point).
template <class ForPoints>
Subtrees::OrientedBox Subtrees::around(ForPoints for_points) {
  Vector mean{};
  double count = 0;
  for_points([&](const Vector& p) {
    mean = sum(mean, p);
    ++count;
  });
  if (count == 0) return {};
  mean = {mean[0] / count, mean[1] / count, mean[2] / count};

  std::array<Vector, 3> moments{};
  for_points([&](const Vector& p) {
    const Vector d = sum(p, mean, -1);
    for (std::size_t i = 0; i < 3; ++i) moments[i] = sum(moments[i], d, d[i]);
  });

  OrientedBox box{{}, {}, principal_axes(moments)};
  Vector low{HUGE_VAL, HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  for_points([&](const Vector& p) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double along = dot(box.axes[k], sum(p, mean, -1));
      low[k] = std::min(low[k], along);
      high[k] = std::max(high[k], along);
    }
  });
  box.centre = mean;
  for (std::size_t k = 0; k < 3; ++k) {
    box.centre = sum(box.centre, box.axes[k], (low[k] + high[k]) / 2);
    box.half[k] = (high[k] - low[k]) / 2;
  }
  return box;
}

/// A plane between two oriented boxes, the first one on its positive side: if there is one, a plane along two of their
/// axes is.
/// Source: S. Gottschalk, M. Lin, D. Manocha, OBBTree: a hierarchical structure for rapid interference detection, 1996.
std::optional<Subtrees::Cut> Subtrees::cut_between(const OrientedBox& a, const OrientedBox& b) {
  const Vector between = sum(a.centre, b.centre, -1);
  const auto half_width = [](const OrientedBox& box, const Vector& n) {
    double width = 0;
    for (std::size_t k = 0; k < 3; ++k) width += box.half[k] * std::fabs(dot(box.axes[k], n));
    return width;
  };

  double widest = 0;
  std::optional<Cut> best;
  const auto look_along = [&](Vector n) {
    const double length = std::sqrt(dot(n, n));
    constexpr double parallel = 1e-6;
    if (length < parallel) return;
    const double along = dot(n, between), wa = half_width(a, n), wb = half_width(b, n);
    const double gap = (std::fabs(along) - wa - wb) / length;
    if (gap <= widest) return;
    widest = gap;
    if (along < 0) n = {-n[0], -n[1], -n[2]};
    best = Cut{n, (dot(n, a.centre) - wa + dot(n, b.centre) + wb) / 2};
  };
  for (const Vector& n : a.axes) look_along(n);
  for (const Vector& n : b.axes) look_along(n);
  for (const Vector& u : a.axes)
    for (const Vector& v : b.axes) look_along(cross(u, v));
  return best;
}

bool Subtrees::has_grid_corners(std::uint32_t i) const {
  const auto& [body, face] = faces_[i];
  if (faces_[i].is_raw()) return true;
  const auto corners = body->corners_of(face);
  return corners.size() <= grid::thresholds().large_face &&
         std::all_of(corners.begin(), corners.end(), [&, b = body](std::uint32_t v) { return b->is_grid(v); });
}

template <class Visit>
void Subtrees::for_corners(std::uint32_t i, Visit&& visit) const {
  const auto& [body, face] = faces_[i];
  for (const std::uint32_t v : body->corners_of(face)) visit(body->grid_points[v]);
}

/// visit(point) for the corners of a face; where a polygon has others than grid points, for those of its box.
template <class Visit>
void Subtrees::for_points(std::uint32_t i, Visit&& visit) const {
  if (has_grid_corners(i)) return for_corners(i, visit);
  const Box box = tree_.box(i);
  for (int corner = 0; corner < 8; ++corner)
    visit(GridPoint{{corner & 1 ? box.high[0] : box.low[0], corner & 2 ? box.high[1] : box.low[1],
                     corner & 4 ? box.high[2] : box.low[2]}});
}

/// The same, for faces at even distances.
template <class Visit>
void Subtrees::for_some_points(const Node& node, Visit&& visit) const {
  constexpr std::uint32_t most = 32;
  const std::uint32_t stride = (node.end - node.begin + most - 1) / most;
  for (std::uint32_t i = node.begin; i < node.end; i += stride) for_points(i, visit);
}

Subtrees::Node& Subtrees::node(std::size_t level, std::uint32_t x) {
  if (number_.size() <= level) number_.resize(level + 1);
  auto& numbers = number_[level];
  if (numbers.empty()) numbers.resize(((faces_.size() - 1) >> (3 * level)) + 1, none);
  if (numbers[x] == none) {
    numbers[x] = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({begin(level, x), end(level, x), {}, {}, {}, {}, {}});
    look_at(nodes_.back());
  }
  return nodes_[numbers[x]];
}

bool Subtrees::has_corner(std::uint32_t i, const GridPoint& p) const {
  if (const auto& [body, face] = faces_[i]; faces_[i].is_raw()) {
    const auto& t = body->triangles[face];
    return body->grid_points[t[0]] == p || body->grid_points[t[1]] == p || body->grid_points[t[2]] == p;
  }
  bool found = false;
  if (has_grid_corners(i)) for_corners(i, [&](const GridPoint& q) { found = found || p == q; });
  return found;
}

void Subtrees::find_hubs(Node& node) const {
  const auto first_without = [&](const GridPoint& p, const GridPoint& q) {
    std::uint32_t i = node.begin;
    while (i < node.end && (has_corner(i, p) || (q != p && has_corner(i, q)))) ++i;
    return i;
  };
  for_corners(node.begin, [&](const GridPoint& p) {
    const bool is_new = std::find(node.hubs.begin(), node.hubs.end(), p) == node.hubs.end();
    if (is_new && node.hubs.size() < 2 && first_without(p, p) == node.end) node.hubs.push_back(p);
  });
  if (node.hubs.empty())
    for_corners(node.begin, [&](const GridPoint& p) {
      const std::uint32_t i = first_without(p, p);
      if (!node.hubs.empty() || !has_grid_corners(i)) return;
      for_corners(i, [&](const GridPoint& q) {
        if (node.hubs.empty() && first_without(p, q) == node.end) node.hubs = {p, q};
      });
    });
  std::sort(node.hubs.begin(), node.hubs.end());
}

/// The corner of most faces but the hub, if about a quarter of them have it.
void Subtrees::find_second_corner(Node& node) const {
  std::vector<GridPoint> others;
  for_some_points(node, [&](const GridPoint& p) {
    if (p != node.hubs[0]) others.push_back(p);
  });
  std::sort(others.begin(), others.end());

  std::size_t most = others.size() / 8;  // of two others a face
  for (std::size_t i = 0, j = 0; i < others.size(); i = j) {
    while (j < others.size() && others[j] == others[i]) ++j;
    if (j - i > most) most = j - i, node.many = others[i];
  }
}

void Subtrees::look_at(Node& node) const {
  if (!has_grid_corners(node.begin)) return;
  find_hubs(node);
  if (node.hubs.size() == 1) find_second_corner(node);

  if (!are_foreign_) return;
  const exact::Plane plane = faces_[node.begin].body->sign_plane(faces_[node.begin].face);
  bool is_flat = true;
  for (std::uint32_t i = node.begin + 1; i < node.end && is_flat; ++i)
    if (is_flat = has_grid_corners(i); is_flat)
      for_corners(i, [&](const GridPoint& p) { is_flat = is_flat && exact::side(plane, p) == 0; });
  if (is_flat) node.plane = plane;
}

const Subtrees::OrientedBox& Subtrees::place(Node& node) const {
  if (!node.place)
    node.place = around([&](auto&& visit) { for_some_points(node, [&](const GridPoint& p) { visit(doubles(p)); }); });
  return *node.place;
}

/// The other hub, or a corner that many faces have beside the only one.
std::optional<GridPoint> Subtrees::second(const Node& node, const GridPoint& hub) {
  if (node.hubs.size() == 2) return node.hubs[node.hubs[0] == hub];
  return node.many;
}

/// Of unit vectors from a hub to all corners but the second.
const Subtrees::OrientedBox& Subtrees::directions(Node& node, const GridPoint& hub) const {
  auto& box = node.directions[hub != node.hubs[0]];
  if (!box)
    box = around([&, also = second(node, hub)](auto&& visit) {
      for_some_points(node, [&](const GridPoint& p) {
        if (p == hub || p == also) return;
        const Vector d = sum(doubles(p), doubles(hub), -1);
        visit(sum({}, d, 1 / std::sqrt(dot(d, d))));
      });
    });
  return *box;
}

bool Subtrees::on_one_plane(const Node& a, const Node& b) const {
  if (!a.plane || !b.plane) return false;
  bool is_same = true;
  for_corners(b.begin, [&](const GridPoint& p) { is_same = is_same && exact::side(*a.plane, p) == 0; });
  return is_same;
}

bool Subtrees::apart(const Node& a, const Node& b, const Cut& cut) const {
  const auto n = scaled(cut.normal, (1 << 30) - 1);
  std::int64_t low = INT64_MAX, high = INT64_MIN;
  for (std::uint32_t i = a.begin, j = b.begin; i < a.end || j < b.end; ++i, ++j) {
    if (i < a.end) for_points(i, [&](const GridPoint& p) { low = std::min(low, value(n, p)); });
    if (j < b.end) for_points(j, [&](const GridPoint& p) { high = std::max(high, value(n, p)); });
    if (high >= low) return false;
  }
  return true;
}

/// A plane through a common hub c, and through a second point that many faces have, separates what is seen from c.
/// Components of its normal are below 2^61, differences of points below 2^31.
bool Subtrees::in_common_parts(Node& a, Node& b, const GridPoint& c) {
  const std::optional<Cut> cut = cut_between(directions(a, c), directions(b, c));
  if (!cut) return false;
  const Vector middle = sum(directions(a, c).centre, directions(b, c).centre);
  constexpr double opposite = 1e-3;  // what is seen lies on both sides of the hub
  const double length = dot(middle, middle);
  const Vector normal = length < opposite ? cut->normal : sum(cut->normal, middle, -2 * cut->offset / length);

  const auto from_corner = [&](const GridPoint& p) {
    return std::array{std::int64_t{p[0]} - c[0], std::int64_t{p[1]} - c[1], std::int64_t{p[2]} - c[2]};
  };
  std::optional<GridPoint> also = second(a, c);
  if (const auto of_b = second(b, c); !also)
    also = of_b;
  else if (of_b && of_b != also)
    also.reset();
  std::array<std::int64_t, 3> n = scaled(normal, (1 << 30) - 1);
  if (also) {
    const auto edge = from_corner(*also);
    n = cross(edge, scaled(cross(normal, doubles(edge)), (1 << 28) - 1));
  }

  const auto all_on = [&](const Node& node, int side) {
    bool good = true;
    for (std::uint32_t i = node.begin; i < node.end && good; ++i) {
      int on_plane = 0;
      for_points(i, [&](const GridPoint& p) {
        const auto d = from_corner(p);
        const int128 along = int128{n[0]} * d[0] + int128{n[1]} * d[1] + int128{n[2]} * d[2];
        good = good && (along == 0 ? p == c || p == also : (along > 0) == (side > 0));
        on_plane += along == 0;
      });
      good = good && (on_plane < 2 || !faces_[i].is_raw());
    }
    return good;
  };
  if (!all_on(a, 1) || !all_on(b, -1)) return false;
  hubs_.push_back(c);
  if (also) hubs_.push_back(*also);
  return true;
}

Relation Subtrees::relation(std::size_t level, std::uint32_t x, std::uint32_t y, bool is_crowded) {
  assert(x != y);
  Node &a = node(level, x), &b = node(level, y);
  if (on_one_plane(a, b)) return Relation::in_parts;
  for (const GridPoint& c : a.hubs)
    if (std::find(b.hubs.begin(), b.hubs.end(), c) != b.hubs.end())
      return in_common_parts(a, b, c) ? Relation::in_parts : Relation::unknown;
  if (!is_crowded) return Relation::unknown;
  const std::optional<Cut> cut = cut_between(place(a), place(b));
  return cut && apart(a, b, *cut) ? Relation::apart : Relation::unknown;
}

}  // namespace quoin::booleans
