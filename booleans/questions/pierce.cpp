#include "booleans/questions/pierce.h"

#include <algorithm>

#include "exact/predicates.h"

namespace quoin::booleans {
namespace {

using exact::Integer;
using exact::Rational;
using Kind = Piercing::Kind;
using Integers = std::array<Integer, 3>;
using Signs = std::array<int, 3>;

constexpr int undecided = 2;

std::size_t after(std::size_t k) { return k < 2 ? k + 1 : 0; }

/// A vertex seen from the line's start.
IntervalPoint near_offset(const Body& body, std::uint32_t v, const IntervalPoint& p) {
  const auto a = body.approximation(v);
  IntervalPoint r{0, 0, 0};
  for (std::size_t k = 0; k < 3; ++k) r[k] = (body.is_grid(v) ? Interval(a[k]) : Interval::around(a[k])) - p[k];
  return r;
}

int sign_of(const Interval& x) { return x.low > 0 ? 1 : x.high < 0 ? -1 : undecided; }

/// d . (u x v), terms of components of d that are 0 left out.
Interval near_volume(const IntervalPoint& d, const IntervalPoint& u, const IntervalPoint& v) {
  Interval sum = 0;
  bool is_first = true;
  for (std::size_t k = 0; k < 3; ++k) {
    if (d[k].low == 0 && d[k].high == 0) continue;
    const std::size_t i = after(k), j = after(i);
    const Interval term = d[k] * (u[i] * v[j] - u[j] * v[i]);
    sum = is_first ? term : sum + term;
    is_first = false;
  }
  return sum;
}

bool disagree(const Signs& s) {
  const auto has = [&](int sign) { return s[0] == sign || s[1] == sign || s[2] == sign; };
  return has(1) && has(-1);
}
bool are_all(const Signs& s, int sign) { return s[0] == sign && s[1] == sign && s[2] == sign; }

/// On which sides of the triangle's edges the line passes, as far as intervals tell.
Signs near_sides(const Index& index, const Line& line, std::uint32_t t) {
  const auto& c = index.corners(t);
  const IntervalPoint& p = line.start().near();
  const std::array<IntervalPoint, 3> seen{near_offset(index.body(), c[0], p), near_offset(index.body(), c[1], p),
                                          near_offset(index.body(), c[2], p)};
  Signs signs{undecided, undecided, undecided};
  for (std::size_t i = 0; i < 3 && !disagree(signs); ++i)
    signs[i] = sign_of(near_volume(line.near_direction(), seen[i], seen[after(i)]));
  return signs;
}

/// w W (u / w - p / W).
Integers offset(const Homogeneous& u, const Homogeneous& p) {
  Integers r;
  for (std::size_t k = 0; k < 3; ++k) r[k] = u.x[k] * p.w - p.x[k] * u.w;
  return r;
}
Integers cross(const Integers& u, const Integers& v) {
  Integers r;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = after(k), j = after(i);
    r[k] = u[i] * v[j] - u[j] * v[i];
  }
  return r;
}
int dot_sign(const Integers& u, const Integers& v) { return Integer(u[0] * v[0] + u[1] * v[1] + u[2] * v[2]).sign(); }

/// The side of an edge from u to v that the shifted line passes, which the line meets: d . (u x v) changes by
/// -shift . ((v - u) x d).
int shifted_side(const Homogeneous& u, const Homogeneous& v, const Integers& d) {
  for (const Integer& w : cross(offset(v, u), d))
    if (w != 0) return -w.sign();
  return 0;  // the line runs along the edge: in the plane
}

Piercing pierce_exactly(const Index& index, const Line& line, std::uint32_t t) {
  ++exact::counters().rational;
  const auto& c = index.corners(t);
  const Integers& d = line.direction().x;
  std::array<Homogeneous, 3> v;
  std::array<Integers, 3> seen;
  for (std::size_t i = 0; i < 3; ++i) {
    v[i] = homogeneous(index.body().point(c[i]));
    seen[i] = offset(v[i], line.start().exact());
  }

  Signs signs{};
  for (std::size_t i = 0; i < 3; ++i) signs[i] = dot_sign(d, cross(seen[i], seen[after(i)]));
  if (disagree(signs)) return {};
  // Their sum, each over its denominators, is d . normal: all are 0 in the plane alone.
  if (are_all(signs, 0)) return {Kind::along};

  const int facing = *std::max_element(signs.begin(), signs.end()) > 0 ? 1 : -1;
  const bool is_inside = are_all(signs, facing);
  for (std::size_t i = 0; i < 3; ++i)
    if (signs[i] == 0) signs[i] = shifted_side(v[i], v[after(i)], d);
  return {Kind::point, facing, are_all(signs, facing) ? facing : 0, is_inside};
}

/// The plane's value at a point, times its denominator.
Integer value(const exact::Plane& plane, const Homogeneous& p) {
  return plane.n[0] * p.x[0] + plane.n[1] * p.x[1] + plane.n[2] * p.x[2] + exact::to_integer(plane.d) * p.w;
}

/// The plane's value at the line's start.
int near_side(const Index& index, const Line& line, std::uint32_t t, const exact::Plane& plane) {
  const IntervalPoint seen = near_offset(index.body(), index.corners(t)[0], line.start().near());
  const auto n = [&](std::size_t k) { return Interval::around(static_cast<double>(plane.n[k])); };
  return sign_of(-(n(0) * seen[0] + n(1) * seen[1] + n(2) * seen[2]));
}

}  // namespace

Piercing pierce(const Index& index, const Line& line, std::uint32_t t) {
  if (!line.is_tame()) return pierce_exactly(index, line, t);
  const Signs signs = near_sides(index, line, t);
  const bool passes = disagree(signs), crosses = are_all(signs, 1) || are_all(signs, -1);
  if (!passes && !crosses) return pierce_exactly(index, line, t);
  ++exact::counters().filter;
  return passes ? Piercing{} : Piercing{Kind::point, signs[0], signs[0], true};
}

int parameter_sign(const Index& index, const Line& line, std::uint32_t t, int facing) {
  const exact::Plane plane = index.plane(t);
  const int filtered = line.is_tame() ? near_side(index, line, t, plane) : undecided;
  if (filtered != undecided) {
    ++exact::counters().filter;
    return -filtered * facing;
  }
  ++exact::counters().rational;
  return -value(plane, line.start().exact()).sign() * facing;
}

Rational parameter(const Index& index, const Line& line, std::uint32_t t) {
  const exact::Plane plane = index.plane(t);
  const Homogeneous &p = line.start().exact(), &d = line.direction();
  const Integer along = plane.n[0] * d.x[0] + plane.n[1] * d.x[1] + plane.n[2] * d.x[2];
  return Rational(Integer(-value(plane, p) * d.w), Integer(p.w * along));
}

std::optional<std::array<Rational, 2>> parameters_along(const Index& index, const Line& line, std::uint32_t t) {
  const exact::Plane plane = index.plane(t);
  const std::size_t k = exact::longest_component(plane.n), i = after(k), j = after(i);
  const RationalPoint p = line.start().rational();
  const Homogeneous& d = line.direction();
  const Rational di(d.x[i], d.w), dj(d.x[j], d.w);
  const auto& corners = index.corners(t);

  // Left of each edge, seen with the third axis or against it, a + b t >= 0.
  std::optional<Rational> low, high;
  for (std::size_t e = 0; e < 3; ++e) {
    const exact::Point u = index.body().point(corners[e]), v = index.body().point(corners[after(e)]);
    const auto at = [&](const exact::Point& q, std::size_t axis) {
      return exact::coordinate(q, static_cast<int>(axis));
    };
    const Rational ui = at(u, i), uj = at(u, j), ei = at(v, i) - ui, ej = at(v, j) - uj;
    Rational a = ei * (p[j] - uj) - ej * (p[i] - ui), b = ei * dj - ej * di;
    if (plane.n[k] < 0) a = -a, b = -b;
    if (b == 0) {
      if (a < 0) return std::nullopt;
      continue;
    }
    const Rational crossing = -a / b;
    auto& bound = b > 0 ? low : high;
    if (!bound || (b > 0 ? crossing > *bound : crossing < *bound)) bound = crossing;
  }
  // A line parallel to one edge at most meets the lines of two others, on the way in and on the way out.
  if (*low > *high) return std::nullopt;
  return std::array{*low, *high};
}

}  // namespace quoin::booleans
