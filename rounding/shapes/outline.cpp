#include "rounding/shapes/outline.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "grid/lists/loops.h"
#include "rounding/shapes/polyhedron.h"

namespace quoin::rounding {

Rational cross(const PlanePoint& a, const PlanePoint& b) { return a[0] * b[1] - a[1] * b[0]; }
PlanePoint operator-(const PlanePoint& a, const PlanePoint& b) { return {a[0] - b[0], a[1] - b[1]}; }

Rational doubled_area(std::span<const PlanePoint> outline) {
  Rational sum = 0;
  grid::for_loop_edges(outline, [&](const PlanePoint& a, const PlanePoint& b) { sum += cross(a, b); });
  return sum;
}

namespace {

/// Without repeated corners and those on a straight side; nothing where the outline runs back on itself.
std::optional<Outline> without_straight_corners(Outline loop) {
  loop.erase(std::unique(loop.begin(), loop.end()), loop.end());
  while (loop.size() > 1 && loop.back() == loop.front()) loop.pop_back();

  Outline r;
  const std::size_t n = loop.size();
  for (std::size_t i = 0; i < n; ++i) {
    const PlanePoint in = loop[i] - loop[grid::previous_in_loop(i, n)], out = loop[grid::next_in_loop(i, n)] - loop[i];
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

  const auto precedes = [](const Side& s, const Side& t) { return grid::next_in_loop(s.at, s.count) == t.at; };
  if (a.loop == b.loop && (precedes(a, b) || precedes(b, a))) return false;

  const int p = orientation(a.from, a.to, b.from), q = orientation(a.from, a.to, b.to);
  const int r = orientation(b.from, b.to, a.from), s = orientation(b.from, b.to, a.to);
  if (p == 0 && q == 0) return std::max(a.low(), b.low()) <= std::min(a.high(), b.high());
  return p * q <= 0 && r * s <= 0;
}

/// Where two outlines meet or one meets itself; by a sweep over the sides' extents along x.
std::optional<Error> crossing_fault(const std::vector<Outline>& loops) {
  std::vector<Side> sides;
  for (std::size_t l = 0; l < loops.size(); ++l) {
    const Outline& loop = loops[l];
    const std::size_t n = loop.size();
    for (std::size_t i = 0; i < n; ++i) sides.push_back({loop[i], loop[grid::next_in_loop(i, n)], l, i, n});
  }

  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.low() < b.low(); });
  std::vector<const Side*> active;
  for (const Side& side : sides) {
    std::erase_if(active, [&](const Side* other) { return other->high() < side.low(); });
    for (const Side* other : active)
      if (meet(*other, side))
        return bad_primitive("the outlines of an extrusion cross or touch near " + text(side.from) + " to " +
                             text(side.to));
    active.push_back(&side);
  }
  return std::nullopt;
}

/// Precondition: p is on no side.
bool is_inside(const PlanePoint& p, const Outline& loop) {
  bool inside = false;
  grid::for_loop_edges(loop, [&](const PlanePoint& a, const PlanePoint& b) {
    if ((a[1] > p[1]) != (b[1] > p[1])) inside ^= (orientation(a, b, p) > 0) == (b[1] > a[1]);
  });
  return inside;
}

/// One outline of a region: the first counter-clockwise, the others clockwise.
Result<Outline> turned(const Outline& given, bool is_hole) {
  auto loop = without_straight_corners(given);
  if (!loop) return bad_primitive("an outline of an extrusion runs back on itself, or encloses no area");
  const Rational area = doubled_area(*loop);
  if (loop->size() < 3 || area == 0) return bad_primitive("an outline of an extrusion encloses no area");

  if ((area > 0) == is_hole) std::reverse(loop->begin(), loop->end());
  return std::move(*loop);
}

/// A hole that is not inside its outline, or is inside another hole. Precondition: no two outlines meet.
std::optional<Error> hole_fault(const Region& region) {
  for (std::size_t h = 1; h < region.size(); ++h) {
    const PlanePoint& p = region[h][0];
    bool fits = is_inside(p, region[0]);
    for (std::size_t g = 1; g < region.size(); ++g) fits = fits && (g == h || !is_inside(p, region[g]));
    if (!fits) return bad_primitive("a hole of an extrusion does not lie inside its outline alone, at " + text(p));
  }
  return std::nullopt;
}

/// A region that begins inside another one and not in a hole of it. Precondition: no two outlines meet.
std::optional<Error> overlap_fault(const Region& region, const Region& other) {
  const PlanePoint& p = region[0][0];
  if (!is_inside(p, other[0])) return std::nullopt;
  for (std::size_t g = 1; g < other.size(); ++g)
    if (is_inside(p, other[g])) return std::nullopt;
  return bad_primitive("polygons of an extrusion overlap at " + text(p));
}

}  // namespace

Result<std::vector<Region>> oriented(const std::vector<Region>& regions) {
  std::vector<Region> result;
  std::vector<Outline> all;
  for (const Region& region : regions) {
    if (region.empty()) return bad_primitive("a polygon of an extrusion has no outline");
    Region& out = result.emplace_back();
    for (const Outline& given : region) {
      auto outline = turned(given, !out.empty());
      if (!outline) return outline.error();
      all.push_back(outline.value());
      out.push_back(std::move(outline).value());
    }
  }

  if (auto fault = crossing_fault(all)) return *fault;
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (auto fault = hole_fault(result[i])) return *fault;
    for (std::size_t j = 0; j < result.size(); ++j)
      if (j != i)
        if (auto fault = overlap_fault(result[i], result[j])) return *fault;
  }
  return result;
}

}  // namespace quoin::rounding
