#include "rounding/primitives.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include "rounding/enclosure.h"

namespace quoin::rounding {
namespace {

using Index = std::uint32_t;

Error bad(std::string message) { return {"bad-primitive", std::move(message)}; }

/// The highest number of sides: more would be millions of faces.
constexpr Index most_sides = 1 << 16;

std::optional<Error> sides_fault(Index sides, Index least) {
  if (sides >= least && sides <= most_sides) return std::nullopt;
  return bad("the number of sides must be between " + std::to_string(least) + " and " + std::to_string(most_sides) +
             ", not " + std::to_string(sides));
}

std::optional<Error> positive_fault(const Rational& v, const char* what) {
  if (v > 0) return std::nullopt;
  return bad(std::string("the ") + what + " must be positive, not " + exact::to_string(v));
}

Rational cross(const PlanePoint& a, const PlanePoint& b) { return a[0] * b[1] - a[1] * b[0]; }
using rounding::operator-;
PlanePoint operator-(const PlanePoint& a, const PlanePoint& b) { return {a[0] - b[0], a[1] - b[1]}; }

/// Twice the signed area.
Rational doubled_area(std::span<const PlanePoint> loop) {
  Rational sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) sum += cross(loop[i], loop[(i + 1) % loop.size()]);
  return sum;
}

std::vector<Index> run(Index begin, Index count) {
  std::vector<Index> r(count);
  std::iota(r.begin(), r.end(), begin);
  return r;
}

std::vector<Index> backward(std::vector<Index> v) {
  std::reverse(v.begin(), v.end());
  return v;
}

/// The ring of points i, i + 1, .. at a height; returns the index of its first point.
Index add_ring(Polyhedron& p, std::span<const PlanePoint> ring, const Rational& height) {
  const auto first = static_cast<Index>(p.points.size());
  for (const PlanePoint& v : ring) p.add_point({v[0], v[1], height});
  return first;
}

/// Four-sided faces between two rings of `count` points, counter-clockwise seen from outside.
void add_band(Polyhedron& p, Index low, Index high, Index count) {
  for (Index i = 0; i < count; ++i) {
    const Index j = (i + 1) % count;
    p.add_face(std::array{low + i, low + j, high + j, high + i});
  }
}

/// Triangles between a ring and a point above (+1) or below (-1).
void add_fan(Polyhedron& p, Index ring, Index apex, Index count, int side) {
  for (Index i = 0; i < count; ++i) {
    const Index j = (i + 1) % count;
    p.add_face(side > 0 ? std::array{ring + i, ring + j, apex} : std::array{ring + j, ring + i, apex});
  }
}

const Integer circle_precision = Integer(1) << 20;

}  // namespace

namespace {

/// The point at an angle from 0 to 45 degrees.
PlanePoint octant_point(const Rational& degrees, const Integer& precision) {
  if (degrees == 0) return {1, 0};
  Rational error;
  const Rational t =
      best_approximation([&](unsigned bits) { return enclosed_tangent(degrees / 2, bits); }, precision, error);
  return {(1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)};
}

/// The point at any angle, mirrored from that of an angle from 0 to 45 degrees.
template <class Octant>
PlanePoint mirrored(const Rational& degrees, Octant&& octant) {
  const Rational a = degrees - 360 * Rational(floor_of((degrees + 180) / 360));  // -180 <= a < 180
  if (a < 0 && a > -180) {
    const PlanePoint p = mirrored(-a, octant);
    return {p[0], -p[1]};
  }
  const Rational b = magnitude(a);
  if (b > 90) {
    const PlanePoint p = mirrored(180 - b, octant);
    return {-p[0], p[1]};
  }
  if (b > 45) {
    const PlanePoint p = mirrored(90 - b, octant);
    return {p[1], p[0]};
  }
  return octant(b);
}

}  // namespace

PlanePoint circle_point(const Rational& degrees, const Integer& precision) {
  return mirrored(degrees, [&](const Rational& b) { return octant_point(b, precision); });
}

std::vector<PlanePoint> circle_polygon(std::uint32_t sides, const Rational& radius, Fit fit) {
  assert(sides >= 3 && radius > 0);
  std::map<Rational, PlanePoint> known;
  const auto octant = [&](const Rational& b) {
    const auto [at, fresh] = known.try_emplace(b);
    if (fresh) at->second = octant_point(b, circle_precision);
    return at->second;
  };
  std::vector<PlanePoint> p;
  for (Index i = 0; i < sides; ++i) p.push_back(mirrored(Rational(360) * i / sides, octant));
  Rational scale = radius;
  if (fit == Fit::equal_area) {
    const Rational area = doubled_area(p) / 2;
    const Enclosure pi = enclosed_pi(64);
    scale *= best_approximation(root_above((pi.low + pi.high) / 2 / area), Integer(1) << 24);
  }
  if (fit == Fit::circumscribed) {
    // The tangents in a and b meet in (a + b) / (1 + a . b).
    const std::vector<PlanePoint> touching = p;
    for (Index i = 0; i < sides; ++i) {
      const PlanePoint &a = touching[i], &b = touching[(i + 1) % sides];
      const Rational divisor = 1 + a[0] * b[0] + a[1] * b[1];
      p[i] = {(a[0] + b[0]) / divisor, (a[1] + b[1]) / divisor};
    }
  }
  for (PlanePoint& v : p) v = {v[0] * scale, v[1] * scale};
  return p;
}

Result<Polyhedron> block(const Vector& size) {
  for (const Rational& x : size)
    if (auto fault = positive_fault(x, "size of a block")) return *fault;
  return extrusion({{{{0, 0}, {size[0], 0}, {size[0], size[1]}, {0, size[1]}}}}, {0, 0, size[2]});
}

Result<Polyhedron> wedge(const Vector& size, const Rational& top) {
  for (const Rational& x : size)
    if (auto fault = positive_fault(x, "size of a wedge")) return *fault;
  if (auto fault = positive_fault(top, "top edge of a wedge")) return *fault;
  Polyhedron p;
  add_ring(p, std::array<PlanePoint, 4>{{{0, 0}, {size[0], 0}, {size[0], size[1]}, {0, size[1]}}}, 0);
  p.add_point({(size[0] - top) / 2, size[1] / 2, size[2]});
  p.add_point({(size[0] + top) / 2, size[1] / 2, size[2]});
  p.add_face(std::array<Index, 4>{3, 2, 1, 0});
  p.add_face(std::array<Index, 4>{0, 1, 5, 4});
  p.add_face(std::array<Index, 4>{2, 3, 4, 5});
  p.add_face(std::array<Index, 3>{1, 2, 5});
  p.add_face(std::array<Index, 3>{3, 0, 4});
  return p;
}

Result<Polyhedron> frustum(std::uint32_t sides, const Rational& bottom, const Rational& top, const Rational& height,
                           Fit fit) {
  if (auto fault = sides_fault(sides, 3)) return *fault;
  if (auto fault = positive_fault(height, "height")) return *fault;
  if (bottom < 0 || top < 0 || (bottom == 0 && top == 0)) return bad("a radius is negative, or both are 0");
  const std::vector<PlanePoint> unit = circle_polygon(sides, 1, fit);
  Polyhedron p;
  const auto add_end = [&](const Rational& radius, const Rational& z) {
    if (radius == 0) return p.add_point({0, 0, z});
    std::vector<PlanePoint> ring = unit;
    for (PlanePoint& v : ring) v = {v[0] * radius, v[1] * radius};
    return add_ring(p, ring, z);
  };
  const Index low = add_end(bottom, 0), high = add_end(top, height);
  if (bottom > 0) p.add_face(backward(run(low, sides)));
  if (top > 0) p.add_face(run(high, sides));
  if (bottom == 0)
    add_fan(p, high, low, sides, -1);
  else if (top == 0)
    add_fan(p, low, high, sides, 1);
  else
    add_band(p, low, high, sides);
  return p;
}

Result<Polyhedron> sphere(const Rational& radius, std::uint32_t sides) {
  if (auto fault = sides_fault(sides, 4)) return *fault;
  if (auto fault = positive_fault(radius, "radius")) return *fault;
  if (sides % 2 != 0) return bad("a sphere must have an even number of sides, not " + std::to_string(sides));
  if (sides > 4096) return bad("a sphere of more than 4096 sides has too many faces");
  const std::vector<PlanePoint> unit = circle_polygon(sides, 1, Fit::inscribed);
  Polyhedron p;
  const Index south = p.add_point({0, 0, -radius}), bands = sides / 2;
  Index ring = 0;
  for (Index k = 1; k < bands; ++k) {
    // Of a half turn from south to north.
    const PlanePoint at = circle_point(Rational(180) * k / bands - 90, circle_precision);
    std::vector<PlanePoint> points = unit;
    for (PlanePoint& v : points) v = {v[0] * at[0] * radius, v[1] * at[0] * radius};
    const Index next = add_ring(p, points, at[1] * radius);
    if (k == 1)
      add_fan(p, next, south, sides, -1);
    else
      add_band(p, ring, next, sides);
    ring = next;
  }
  add_fan(p, ring, p.add_point({0, 0, radius}), sides, 1);
  return p;
}

Result<std::vector<WidePlane>> tangent_sphere(const Rational& radius, std::uint32_t planes) {
  if (auto fault = sides_fault(planes, 4)) return *fault;
  if (auto fault = positive_fault(radius, "radius")) return *fault;
  std::vector<WidePlane> r;
  for (Index k = 0; k < planes; ++k) {
    // Equal steps of height, each turned by the golden angle; (s, t) is the point seen from the south pole.
    const Rational z = 1 - Rational(2 * k + 1, planes);
    const Rational distance = best_approximation(root_above((1 - z) / (1 + z)), 1 << 10);
    const PlanePoint turn = circle_point(Rational(137508, 1000) * k, 1 << 8);
    const Rational s = distance * turn[0], t = distance * turn[1];
    r.push_back(wide_plane({2 * s, 2 * t, 1 - s * s - t * t}, -radius * (1 + s * s + t * t)));
  }
  return r;
}

Result<Polyhedron> torus(const Rational& major, const Rational& minor, std::uint32_t sides, std::uint32_t minor_sides) {
  for (const Index n : {sides, minor_sides})
    if (auto fault = sides_fault(n, 3)) return *fault;
  if (std::uint64_t{sides} * minor_sides > 1 << 22) return bad("a torus of more than 2^22 faces is too large");
  if (auto fault = positive_fault(minor, "minor radius")) return *fault;
  if (major <= minor) return bad("the major radius of a torus must exceed its minor radius");
  const std::vector<PlanePoint> turn = circle_polygon(sides, 1, Fit::inscribed);
  const std::vector<PlanePoint> section = circle_polygon(minor_sides, minor, Fit::inscribed);
  Polyhedron p;
  for (const PlanePoint& v : section) {
    std::vector<PlanePoint> ring = turn;
    for (PlanePoint& q : ring) q = {q[0] * (major + v[0]), q[1] * (major + v[0])};
    add_ring(p, ring, v[1]);
  }
  for (Index k = 0; k < minor_sides; ++k) add_band(p, k * sides, (k + 1) % minor_sides * sides, sides);
  return p;
}

namespace {

using Loop = std::vector<PlanePoint>;

/// Without repeated corners and those on a straight side; nothing where the outline runs back on itself.
std::optional<Loop> without_straight_corners(Loop loop) {
  loop.erase(std::unique(loop.begin(), loop.end()), loop.end());
  while (loop.size() > 1 && loop.back() == loop.front()) loop.pop_back();
  Loop r;
  const std::size_t n = loop.size();
  for (std::size_t i = 0; i < n; ++i) {
    const PlanePoint in = loop[i] - loop[(i + n - 1) % n], out = loop[(i + 1) % n] - loop[i];
    if (cross(in, out) != 0)
      r.push_back(loop[i]);
    else if (in[0] * out[0] + in[1] * out[1] <= 0)
      return std::nullopt;
  }
  return r;
}

std::string text(const PlanePoint& p) { return "(" + exact::to_string(p[0]) + ", " + exact::to_string(p[1]) + ")"; }

struct Side {
  PlanePoint from, to;
  std::size_t loop, at, count;
  const Rational& low() const { return std::min(from[0], to[0]); }
  const Rational& high() const { return std::max(from[0], to[0]); }
};

int orientation(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) { return cross(b - a, c - a).sign(); }

/// Whether two sides meet, but for neighbours in their common corner.
bool meet(const Side& a, const Side& b) {
  if (std::max(a.from[1], a.to[1]) < std::min(b.from[1], b.to[1]) ||
      std::max(b.from[1], b.to[1]) < std::min(a.from[1], a.to[1]))
    return false;
  if (a.loop == b.loop && ((a.at + 1) % a.count == b.at || (b.at + 1) % b.count == a.at)) return false;
  const int p = orientation(a.from, a.to, b.from), q = orientation(a.from, a.to, b.to);
  const int r = orientation(b.from, b.to, a.from), s = orientation(b.from, b.to, a.to);
  if (p == 0 && q == 0) return std::max(a.low(), b.low()) <= std::min(a.high(), b.high());
  return p * q <= 0 && r * s <= 0;
}

/// Where two outlines meet or one meets itself; by a sweep over the sides' extents along x.
std::optional<Error> crossing_fault(const std::vector<Loop>& loops) {
  std::vector<Side> sides;
  for (std::size_t l = 0; l < loops.size(); ++l)
    for (std::size_t i = 0; i < loops[l].size(); ++i)
      sides.push_back({loops[l][i], loops[l][(i + 1) % loops[l].size()], l, i, loops[l].size()});
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.low() < b.low(); });
  std::vector<const Side*> active;
  for (const Side& side : sides) {
    std::erase_if(active, [&](const Side* other) { return other->high() < side.low(); });
    for (const Side* other : active)
      if (meet(*other, side))
        return bad("the outlines of an extrusion cross or touch near " + text(side.from) + " to " + text(side.to));
    active.push_back(&side);
  }
  return std::nullopt;
}

/// Precondition: p is on no side.
bool is_inside(const PlanePoint& p, const Loop& loop) {
  bool inside = false;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const PlanePoint &a = loop[i], &b = loop[(i + 1) % loop.size()];
    if ((a[1] > p[1]) != (b[1] > p[1])) inside ^= (orientation(a, b, p) > 0) == (b[1] > a[1]);
  }
  return inside;
}

/// Outlines turned counter-clockwise, holes clockwise.
Result<std::vector<std::vector<Loop>>> oriented(const std::vector<std::vector<Loop>>& polygons) {
  std::vector<std::vector<Loop>> result;
  std::vector<Loop> all;
  for (const auto& polygon : polygons) {
    if (polygon.empty()) return bad("a polygon of an extrusion has no outline");
    auto& out = result.emplace_back();
    for (const Loop& given : polygon) {
      auto straightened = without_straight_corners(given);
      if (!straightened) return bad("an outline of an extrusion runs back on itself, or encloses no area");
      Loop loop = std::move(*straightened);
      const Rational area = doubled_area(loop);
      if (loop.size() < 3 || area == 0) return bad("an outline of an extrusion encloses no area");
      if ((area > 0) != out.empty()) std::reverse(loop.begin(), loop.end());
      all.push_back(loop);
      out.push_back(std::move(loop));
    }
  }
  if (auto fault = crossing_fault(all)) return *fault;
  for (std::size_t i = 0; i < result.size(); ++i) {
    for (std::size_t h = 1; h < result[i].size(); ++h) {
      bool fits = is_inside(result[i][h][0], result[i][0]);
      for (std::size_t g = 1; g < result[i].size(); ++g)
        fits = fits && (g == h || !is_inside(result[i][h][0], result[i][g]));
      if (!fits)
        return bad("a hole of an extrusion does not lie inside its outline alone, at " + text(result[i][h][0]));
    }
    for (std::size_t j = 0; j < result.size(); ++j) {
      if (j == i || !is_inside(result[i][0][0], result[j][0])) continue;
      bool in_hole = false;
      for (std::size_t g = 1; g < result[j].size(); ++g) in_hole = in_hole || is_inside(result[i][0][0], result[j][g]);
      if (!in_hole) return bad("polygons of an extrusion overlap at " + text(result[i][0][0]));
    }
  }
  return result;
}

}  // namespace

Result<Polyhedron> extrusion(const std::vector<std::vector<Loop>>& polygons, const Vector& along) {
  if (along[2] == 0)
    return bad("an extrusion along a vector parallel to the plane of its polygons has an area, no volume");
  const auto loops = oriented(polygons);
  if (!loops) return loops.error();
  Polyhedron p;
  for (const auto& polygon : loops.value()) {
    std::vector<std::vector<Index>> low, high;
    for (const Loop& loop : polygon) {
      const auto count = static_cast<Index>(loop.size());
      Loop shifted = loop;
      for (PlanePoint& v : shifted) v = {v[0] + along[0], v[1] + along[1]};
      low.push_back(run(add_ring(p, loop, 0), count));
      high.push_back(run(add_ring(p, shifted, along[2]), count));
      if (along[2] < 0) std::swap(low.back(), high.back());
    }
    for (std::vector<std::vector<Index>>* end : {&low, &high}) {
      // The cap's plane is horizontal, whatever its first corners turn.
      const int up = end == &high ? 1 : -1;
      p.planes.push_back(wide_plane({0, 0, up}, -up * p.points[end->front()[0]][2]));
      p.face_loops.push_back(p.face_loops.back());
      for (const auto& loop : *end) p.add_loop(up > 0 ? loop : backward(loop));
    }
    for (std::size_t l = 0; l < low.size(); ++l) add_band(p, low[l][0], high[l][0], static_cast<Index>(low[l].size()));
  }
  return p;
}

}  // namespace quoin::rounding
