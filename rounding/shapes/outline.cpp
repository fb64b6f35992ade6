#include "rounding/shapes/outline.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "grid/lists/loops.h"
#include "rounding/shapes/outline_sweep.h"
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

int orientation(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) { return cross(b - a, c - a).sign(); }

/// The corners of outlines, one after the other.
struct OutlineCorners {
  std::vector<const PlanePoint*> at;
  std::vector<std::uint32_t> starts{0};

  void add(const Outline& outline) {
    for (const PlanePoint& p : outline) at.push_back(&p);
    starts.push_back(static_cast<std::uint32_t>(at.size()));
  }
  int compare(std::uint32_t a, std::uint32_t b) const {
    const int x = (*at[a])[0].compare((*at[b])[0]), order = x != 0 ? x : (*at[a])[1].compare((*at[b])[1]);
    return (order > 0) - (order < 0);
  }
  int orientation(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return rounding::orientation(*at[a], *at[b], *at[c]);
  }
};

/// The first corner in lexicographic order is one of the convex hull. Precondition: the outline turns there.
bool is_counter_clockwise(const Outline& loop) {
  const auto first = static_cast<std::size_t>(std::min_element(loop.begin(), loop.end()) - loop.begin());
  const std::size_t n = loop.size();
  return orientation(loop[grid::previous_in_loop(first, n)], loop[first], loop[grid::next_in_loop(first, n)]) > 0;
}

/// One outline of a region: the first counter-clockwise, the others clockwise.
Result<Outline> turned(const Outline& given, bool is_hole) {
  auto loop = without_straight_corners(given);
  if (!loop) return bad_primitive("an outline of an extrusion runs back on itself, or encloses no area");
  if (loop->size() < 3) return bad_primitive("an outline of an extrusion encloses no area");
  if (is_counter_clockwise(*loop) == is_hole) std::reverse(loop->begin(), loop->end());
  return std::move(*loop);
}

/// Each hole lies in its own outline alone, and each first outline outside of all, or in a hole.
std::optional<Error> nesting_fault(const std::vector<Region>& regions) {
  OutlineCorners corners;
  std::vector<bool> is_hole;
  for (const Region& region : regions)
    for (const Outline& outline : region) {
      is_hole.push_back(&outline != &region[0]);
      corners.add(outline);
    }

  const Nesting nesting = OutlineSweep(corners, corners.starts).run();
  if (const std::uint32_t side = nesting.meeting; side != Nesting::none) {
    const auto begin = std::upper_bound(corners.starts.begin(), corners.starts.end(), side);
    const std::uint32_t next = side + 1 == *begin ? *(begin - 1) : side + 1;
    return bad_primitive("the outlines of an extrusion cross or touch near " + text(*corners.at[side]) + " to " +
                         text(*corners.at[next]));
  }

  std::uint32_t first = 0;
  for (const Region& region : regions) {
    for (std::uint32_t h = 1; h < region.size(); ++h)
      if (nesting.around[first + h] != first)
        return bad_primitive("a hole of an extrusion does not lie inside its outline alone, at " + text(region[h][0]));
    const std::uint32_t around = nesting.around[first];
    if (around != Nesting::none && !is_hole[around])
      return bad_primitive("polygons of an extrusion overlap at " + text(region[0][0]));
    first += static_cast<std::uint32_t>(region.size());
  }
  return std::nullopt;
}

}  // namespace

Result<std::vector<Region>> oriented(const std::vector<Region>& regions) {
  std::vector<Region> result;
  for (const Region& region : regions) {
    if (region.empty()) return bad_primitive("a polygon of an extrusion has no outline");
    Region& out = result.emplace_back();
    for (const Outline& given : region) {
      auto outline = turned(given, !out.empty());
      if (!outline) return outline.error();
      out.push_back(std::move(outline).value());
    }
  }
  if (auto fault = nesting_fault(result)) return *fault;
  return result;
}

}  // namespace quoin::rounding
