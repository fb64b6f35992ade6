#include "booleans/body/stars.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "booleans/body/fans.h"
#include "grid/balance.h"

namespace quoin::booleans {
namespace {

using Vector = std::array<std::int64_t, 3>;  // differences of grid points, at most 2^30

Vector difference(const exact::GridPoint& a, const exact::GridPoint& b) {
  return {std::int64_t{a[0]} - b[0], std::int64_t{a[1]} - b[1], std::int64_t{a[2]} - b[2]};
}

/// The k-th component of u x v: at most 2^61.
std::int64_t cross(const Vector& u, const Vector& v, std::size_t k) {
  const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
  return u[i] * v[j] - u[j] * v[i];
}

/// Bit 2k: seen against +k the triangle turns counter-clockwise; bit 2k + 1: against -k. 0 only where it has no area.
std::uint8_t views(const Body& body, const std::array<std::uint32_t, 3>& t) {
  const auto& p = body.grid_points;
  const Vector u = difference(p[t[1]], p[t[0]]), v = difference(p[t[2]], p[t[0]]);
  unsigned r = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::int64_t n = cross(u, v, k);
    r |= static_cast<unsigned>(n > 0) << (2 * k) | static_cast<unsigned>(n < 0) << (2 * k + 1);
  }
  return static_cast<std::uint8_t>(r);
}

/// From a grid point to a vertex, times its denominator.
using WideVector = std::array<exact::Int<exact::Numerator::bits + 1>, 3>;

WideVector wide_difference(const exact::Point& to, const exact::GridPoint& from) {
  WideVector r;
  for (std::size_t k = 0; k < 3; ++k) r[k] = to.x[k] - to.w * exact::Coefficient(from[k]);
  return r;
}

/// The corner v of a polygon between its next corner a and the one before, b, as a sector that the polygon fills.
struct Wedge {
  std::uint32_t v, a, b;
  std::uint8_t views;                     // as of a triangle (v, a, b)
  std::array<std::int8_t, 3> to_a, to_b;  // signs of the coordinates of a and b less those of v

  Wedge(const Body& body, std::uint32_t at, std::uint32_t next, std::uint32_t previous)
      : v(at), a(next), b(previous), views(0) {
    const WideVector p = wide_difference(body.point(a), body.grid_points[v]),
                     q = wide_difference(body.point(b), body.grid_points[v]);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      const int turn = (p[i] * q[j] - p[j] * q[i]).sign();
      views |= static_cast<std::uint8_t>((turn > 0) << (2 * k) | (turn < 0) << (2 * k + 1));
      to_a[k] = static_cast<std::int8_t>(p[k].sign());
      to_b[k] = static_cast<std::int8_t>(q[k].sign());
    }
  }
};

/// The wedges of all polygons at grid points that have triangles, too.
struct Wedges {
  Array<Wedge> list;
  /// By vertex: a wedge ends at a derived point or is none, as where the polygon touches the vertex or has a straight
  /// angle. Empty without polygons.
  Array<std::uint8_t> is_special;

  explicit Wedges(const Body& body) {
    if (body.polygon_count() == 0) return;
    Array<std::uint8_t> has_triangle(body.grid_points.size());
    for (const auto& t : body.triangles)
      for (const std::uint32_t v : t) has_triangle[v] = 1;

    is_special.resize(body.grid_points.size());
    for (std::size_t j = 0; j < body.polygons.loop_count(); ++j) {
      const auto loop = body.polygons.loop(j);
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const std::uint32_t v = loop[i];
        if (!body.is_grid(v) || !has_triangle[v]) continue;
        const Wedge w(body, v, loop[grid::next_in_loop(i, loop.size())], loop[grid::previous_in_loop(i, loop.size())]);
        if (w.views == 0 || !body.is_grid(w.a) || !body.is_grid(w.b)) is_special[v] = 1;
        list.push_back(w);
      }
    }
  }
  bool are_plain(std::uint32_t v) const { return is_special.empty() || !is_special[v]; }
};

/// The stars that are proved embedded along an axis; all others are `other`.
Array<Star> seen_along_axes(const Body& mesh, const Wedges& wedges) {
  Array<std::uint8_t> common(mesh.grid_points.size(), 63);  // views that all triangles of the star allow
  for (const auto& t : mesh.triangles) {
    const std::uint8_t allowed = views(mesh, t);
    for (std::uint32_t v : t) common[v] &= allowed;
  }
  for (const Wedge& w : wedges.list) common[w.v] &= w.views;

  // The ray runs along the axis that follows k: a counter-clockwise triangle (v, a, b) has it in its sector when a is
  // on or below it and b above, in the axis after that.
  Array<std::uint8_t> over(mesh.grid_points.size());  // sectors over the ray, at most 2
  const auto count = [&](std::uint32_t v, std::uint32_t a, std::uint32_t b, auto&& is_below_or_on) {
    if (common[v] == 0) return;
    const auto view = static_cast<std::size_t>(std::countr_zero(common[v]));
    if (view & 1) std::swap(a, b);  // seen from the other side, mirrored
    const std::size_t up = (view / 2 + 2) % 3;
    if (is_below_or_on(a, up) && !is_below_or_on(b, up)) over[v] |= static_cast<std::uint8_t>(over[v] + 1);
  };
  const auto& p = mesh.grid_points;
  for (const auto& t : mesh.triangles)
    for (std::size_t c = 0; c < 3; ++c) {
      const exact::GridPoint& at = p[t[c]];
      count(t[c], t[(c + 1) % 3], t[(c + 2) % 3],
            [&](std::uint32_t w, std::size_t up) { return p[w].c[up] <= at.c[up]; });
    }
  for (const Wedge& w : wedges.list)
    count(w.v, w.a, w.b, [&](std::uint32_t x, std::size_t up) { return (x == w.a ? w.to_a : w.to_b)[up] <= 0; });

  Array<Star> star_of(mesh.grid_points.size());
  for (std::uint32_t v = 0; v < star_of.size(); ++v) {
    const bool proved = common[v] == 63 || (common[v] != 0 && over[v] == 1);
    star_of[v] = proved ? Star::embedded : Star::other;
  }
  return star_of;
}

/// A direction against which the star is likely to be seen as a fan: the sum of the unit normals of its triangles, each
/// as long as the triangle's angle at the vertex, so that it does not matter into how many triangles a flat part is
/// cut. Components of at most 2^8; zero where none stands out.
Vector outward(const Body& mesh, std::uint32_t v, std::span<const Spoke> star) {
  const auto& p = mesh.grid_points;
  std::array<double, 3> sum{};
  for (const Spoke& s : star) {
    const Vector a = difference(p[s.a], p[v]), b = difference(p[s.b], p[v]);
    std::array<double, 3> n{};
    double along = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      n[k] = static_cast<double>(cross(a, b, k));
      along += static_cast<double>(a[k]) * static_cast<double>(b[k]);
    }
    const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]), angle = std::atan2(length, along);
    for (std::size_t k = 0; k < 3; ++k) sum[k] += n[k] / length * angle;
  }

  const double largest = std::max({std::fabs(sum[0]), std::fabs(sum[1]), std::fabs(sum[2])});
  Vector d{};
  if (largest > 1e-6)
    for (std::size_t k = 0; k < 3; ++k) d[k] = std::lround(sum[k] / largest * 256);
  return d;
}

/// Is the star seen as a fan against the direction d? Normals are below 2^62, so n . d is below 2^72; projected
/// differences are at most 2^39.
bool is_fan_against(const Vector& d, const Body& mesh, std::uint32_t v, std::span<const Spoke> star) {
  const auto& p = mesh.grid_points;
  const std::size_t k = exact::longest_component(d), up = (k + 2) % 3;
  const std::int64_t sign = d[k] < 0 ? -1 : 1;
  int over = 0;
  for (const Spoke& s : star) {
    const Vector a = difference(p[s.a], p[v]), b = difference(p[s.b], p[v]);
    exact::int128 turn = 0;
    for (std::size_t i = 0; i < 3; ++i) turn += exact::int128(cross(a, b, i)) * d[i];
    if (turn <= 0) return false;

    // Height over the ray in the view against d, times |d_k|; the view is mirrored where d_k < 0.
    const std::int64_t above_a = sign * (a[up] * d[k] - a[k] * d[up]), above_b = sign * (b[up] * d[k] - b[k] * d[up]);
    over += d[k] < 0 ? (above_b <= 0 && above_a > 0) : (above_a <= 0 && above_b > 0);
  }
  return over == 1;
}

/// What the axes left open.
void look_at_the_rest(const Body& mesh, const Wedges& wedges, Array<Star>& star_of) {
  const auto is_wanted = [&](std::uint32_t v) { return star_of[v] == Star::other && wedges.are_plain(v); };
  Array<std::uint32_t> rest;
  for (std::uint32_t v = 0; v < star_of.size(); ++v)
    if (is_wanted(v)) rest.push_back(v);
  if (rest.empty()) return;

  grid::Buckets<Spoke> spokes_of(star_of.size(), [&](auto&& visit) {
    for_spokes(grid::corners_of(mesh.triangles), [&](std::uint32_t v, const Spoke& s) {
      if (is_wanted(v)) visit(v, s);
    });
    for (const Wedge& w : wedges.list)
      if (is_wanted(w.v)) visit(w.v, Spoke{w.a, w.b});
  });
  for (const std::uint32_t v : rest) {
    const std::span<Spoke> star = spokes_of[v];
    if (!is_one_fan(star)) continue;
    const bool proved = is_fan_against(outward(mesh, v, star), mesh, v, star);
    star_of[v] = proved ? Star::embedded : Star::ring;
  }
}

}  // namespace

Array<Star> stars(const Body& body) {
  const Wedges wedges(body);
  Array<Star> star_of = seen_along_axes(body, wedges);
  look_at_the_rest(body, wedges, star_of);
  return star_of;
}

}  // namespace quoin::booleans
