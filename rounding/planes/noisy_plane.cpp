#include "rounding/planes/noisy_plane.h"

#include <algorithm>
#include <cassert>

namespace quoin::rounding {
namespace {

using Normal = std::array<Integer, 3>;

/// Whether the sine of their angle is at most 2^-50, and it is no flat angle.
bool is_close(const Normal& a, const Normal& b) {
  return dot(a, b) > 0 && Integer(squared_cross(a, b) << 100u) <= Integer(dot(a, a) * dot(b, b));
}

/// Of a canonical plane.
Normal short_direction(const Normal& n) {
  for (const unsigned bits : {1u, 2u, 4u, 8u, 16u, 32u}) {
    const Integer bound = (Integer(1) << bits) - 1;
    const auto p = PlaneRounder(bound, exact::to_integer(exact::offset_limit)).round({n, 0}, Method::best);
    if (!p) continue;
    const Normal direction{p->n[0], p->n[1], p->n[2]};
    if (is_close(direction, n)) return direction;
  }
  return n;
}

/// A lower bound of the square root.
Rational root_below(const Integer& v) {
  constexpr unsigned bits = 32;
  return Rational(sqrt(Integer(v << (2 * bits))), Integer(1) << bits);
}

}  // namespace

std::optional<exact::Plane> plane_from_noise(const WidePlane& plane) {
  const PlaneRounder rounder;
  if (rounder.fits(plane)) return rounder.round(plane, Method::best);
  if (!is_canonical(plane)) {
    const auto p = plane_from_noise(plane.opposite());
    return p ? std::optional(p->opposite()) : std::nullopt;
  }

  // The point of the plane nearest to the origin stays on it.
  const Normal n = primitive(plane.n), direction = short_direction(n);
  const Vector normal{direction[0], direction[1], direction[2]};
  const Rational offset(plane.d * dot(direction, plane.n), dot(plane.n, plane.n));
  return rounder.round(wide_plane(normal, offset), Method::best);
}

// For x on a, with b - s a without the component k: |b(x)| = |(b - s a)(x)|, and over the norm of b that is x's
// distance from b; for x on b likewise, over the norm of s a.
Rational distance_within(const WidePlane& a, const exact::Plane& b, const Vector& low, const Vector& high) {
  const Normal n{b.n[0], b.n[1], b.n[2]};
  const std::size_t k = longest_component(a.n);
  const Rational s(n[k], a.n[k]);
  assert(s > 0);

  Rational least = exact::to_integer(b.d) - s * a.d, most = least;
  for (std::size_t i = 0; i < 3; ++i) {
    const Rational c = n[i] - s * a.n[i];
    least += c * (c > 0 ? low : high)[i];
    most += c * (c > 0 ? high : low)[i];
  }

  const Rational norm = std::min<Rational>(root_below(dot(n, n)), s * root_below(dot(a.n, a.n)));
  return std::max<Rational>(magnitude(least), magnitude(most)) / norm;
}

}  // namespace quoin::rounding
